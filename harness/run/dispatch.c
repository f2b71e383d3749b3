#include "dispatch.h"
#include <stdlib.h>
#include <string.h>
#include "base/child.h"
#include "base/file.h"
#include "base/json.h"
#include "gpu/gpu.h"

struct answers {
    const struct aob_job_desc *desc;
    bool garbled;
};

static void pass_on(void *user, const char *line)
{
    struct answers *answers = user;
    json_t *answer = json_loads(line, JSON_REJECT_DUPLICATES, NULL);
    if (!answer)
        answers->garbled = true;
    else if (answers->desc->on_answer)
        answers->desc->on_answer(answers->desc->user, answer);
    json_decref(answer);
}

/* A line that names the file already needs no more. */
static bool fail_in_file(const struct aob_job_desc *desc, struct aob_error *error)
{
    const char *slash = desc->file ? strrchr(desc->file, '/') : NULL; /* a long path is cut in its middle */
    if (!desc->file || strstr(error->text, slash ? slash : desc->file))
        return false;
    return aob_fail_in(error, "%s", desc->file);
}

bool aob_dispatch_job(const struct aob_dispatch *dispatch, const struct aob_job_desc *desc,
                      struct aob_error *error)
{
    char *input = aob_json_line(desc->job, 17), text[700];
    struct answers answers = {.desc = desc};
    struct aob_child_result result = {0};
    struct aob_child_desc child = {.argv = (const char *const[]){dispatch->program, "worker", NULL},
                                   .env = desc->env,
                                   .input = input,
                                   .input_size = strlen(input),
                                   .timeout_s = desc->timeout_s,
                                   .memory_limit = desc->memory_limit,
                                   .output_limit = desc->output_limit,
                                   .on_line = pass_on,
                                   .user = &answers};
    bool ok = aob_child_run(&child, &result, error);
    free(input);
    json_decref(desc->job);
    if (!ok)
        return fail_in_file(desc, error);
    if (result.exit_code == 0 && !result.timed_out && !*result.excess)
        return !answers.garbled || aob_fail(error, "the worker's answer is garbled");
    const char *said = strstr(result.complaint, "aobudget: error: ");
    if (result.exit_code == AOB_EXIT_USAGE && said) {
        aob_fail(error, "%s", said + strlen("aobudget: error: "));
        return fail_in_file(desc, error);
    }
    aob_child_explain(&child, &result, text, sizeof text);
    return desc->file ? aob_file_fail(desc->file, text, error) : aob_fail(error, "%s", text);
}

static void add_technique(void *user, const json_t *answer)
{
    aob_technique_list_add(user, answer);
}

bool aob_dispatch_describe(const struct aob_dispatch *dispatch, struct aob_technique_list *list,
                           struct aob_error *error)
{
    *list = (struct aob_technique_list){0};
    struct aob_job_desc desc = {
        .job = json_pack("{s:s, s:o}", "job", "describe", "modules", aob_modules_to_json(&dispatch->modules)),
        .timeout_s = 60,
        .memory_limit = (size_t)4 << 30,
        .on_answer = add_technique,
        .user = list};
    if (aob_dispatch_job(dispatch, &desc, error) && list->count)
        return true;
    if (!*error->text)
        aob_fail(error, "the worker describes no technique");
    const struct aob_modules *modules = &dispatch->modules;
    if (modules->count && !strstr(error->text, modules->paths[0]))
        aob_fail_in(error, "loading modules (%s%s)", modules->paths[0], modules->count > 1 ? ", ..." : "");
    aob_technique_list_finish(list);
    return false;
}

static void take_device(void *user, const json_t *answer)
{
    json_t **device = user;
    json_decref(*device);
    *device = json_deep_copy(answer);
}

json_t *aob_dispatch_probe(const struct aob_dispatch *dispatch, const char *backend, struct aob_error *error)
{
    json_t *device = NULL;
    struct aob_job_desc desc = {.job = json_pack("{s:s, s:s}", "job", "probe", "backend", backend),
                                .env = aob_gpu_find(backend)->environment,
                                .timeout_s = 30,
                                .on_answer = take_device,
                                .user = &device};
    bool ok = aob_dispatch_job(dispatch, &desc, error);
    if (ok && device)
        return device;
    if (ok)
        aob_fail(error, "%s: the worker says nothing of its device", backend);
    json_decref(device);
    return NULL;
}
