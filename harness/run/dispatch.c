#include "dispatch.h"
#include <stdlib.h>
#include <string.h>
#include "base/child.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
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

/* What is no text would be left out of the message without a word. */
static bool check_modules(const struct aob_modules *modules, struct aob_error *error)
{
    for (size_t i = 0; i < modules->count; i++) {
        json_t *path = aob_json_path(modules->paths[i]);
        json_decref(path);
        if (!path)
            return aob_fail(error, "%s: the path of a module must be UTF-8", modules->paths[i]);
    }
    return true;
}

/* Answers have the paths of the message; people know the modules by the names that they gave. */
static void name_modules(struct aob_technique_list *list, const struct aob_modules *modules)
{
    json_t *files = aob_modules_to_json(modules), *file;
    size_t i;
    for (size_t t = 0; t < list->count; t++) {
        struct aob_technique_info *info = &list->items[t];
        json_array_foreach(files, i, file)
        {
            if (!info->file || strcmp(info->file, json_string_value(file)) != 0)
                continue;
            free(info->module);
            info->module = aob_strdup(modules->names[i]);
            info->offered = i < modules->offered;
            break;
        }
    }
    json_decref(files);
}

bool aob_dispatch_describe(const struct aob_dispatch *dispatch, const struct aob_modules *modules,
                           struct aob_technique_list *list, struct aob_error *error)
{
    *list = (struct aob_technique_list){0};
    if (!check_modules(modules, error))
        return false;
    struct aob_job_desc desc = {
        .job = json_pack("{s:s, s:o}", "job", "describe", "modules", aob_modules_to_json(modules)),
        .timeout_s = 60,
        .memory_limit = (size_t)4 << 30,
        .on_answer = add_technique,
        .user = list};
    if (aob_dispatch_job(dispatch, &desc, error) && list->count) {
        name_modules(list, modules);
        return true;
    }
    if (!*error->text)
        aob_fail(error, "the worker describes no technique");
    bool named = !modules->count;
    for (size_t i = 0; i < modules->count; i++)
        named = named || strstr(error->text, modules->paths[i]);
    if (!named)
        aob_fail_in(error, "loading modules (%s%s)", modules->paths[0], modules->count > 1 ? ", ..." : "");
    aob_technique_list_finish(list);
    return false;
}

struct devices {
    json_t *list;
    struct aob_error *none;
};

static void add_device(void *user, const json_t *answer)
{
    struct devices *devices = user;
    const char *none = json_string_value(json_object_get(answer, "none"));
    if (none)
        aob_fail(devices->none, "%s", none);
    else
        json_array_append_new(devices->list, json_deep_copy(answer));
}

json_t *aob_dispatch_devices(const struct aob_dispatch *dispatch, const char *backend,
                             struct aob_error *error)
{
    struct devices devices = {json_array(), error};
    struct aob_job_desc desc = {.job = json_pack("{s:s, s:s, s:s?}", "job", "devices", "backend", backend,
                                                 "device", dispatch->device),
                                .env = aob_gpu_find(backend)->environment,
                                .timeout_s = 30,
                                .on_answer = add_device,
                                .user = &devices};
    if (aob_dispatch_job(dispatch, &desc, error))
        return devices.list;
    json_decref(devices.list);
    return NULL;
}

static void take_answer(void *user, const json_t *answer)
{
    json_t **kept = user;
    json_decref(*kept);
    *kept = json_deep_copy(answer);
}

/* The one answer of a job about a backend's device. */
static json_t *ask_device(const struct aob_dispatch *dispatch, const char *backend, const char *job,
                          double timeout_s, struct aob_error *error)
{
    json_t *answer = NULL;
    struct aob_job_desc desc = {
        .job = json_pack("{s:s, s:s, s:s?}", "job", job, "backend", backend, "device", dispatch->device),
        .env = aob_gpu_find(backend)->environment,
        .timeout_s = timeout_s,
        .on_answer = take_answer,
        .user = &answer};
    bool ok = aob_dispatch_job(dispatch, &desc, error);
    if (ok && answer)
        return answer;
    if (ok)
        aob_fail(error, "%s: the worker says nothing of its device", backend);
    json_decref(answer);
    return NULL;
}

json_t *aob_dispatch_probe(const struct aob_dispatch *dispatch, const char *backend, struct aob_error *error)
{
    return ask_device(dispatch, backend, "probe", 30, error);
}

json_t *aob_dispatch_timer(const struct aob_dispatch *dispatch, const char *backend, struct aob_error *error)
{
    return ask_device(dispatch, backend, "timer", 60, error);
}
