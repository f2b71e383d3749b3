/* gpu-check-device: one section of gpu-check on one backend (section.h). The program gpu-check starts it. */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/clock.h"
#include "base/json.h"
#include "section.h"

static const struct aob_section *const sections[] = {
    &aob_section_device,     &aob_section_timer, &aob_section_images,
    &aob_section_validation, &aob_section_times, NULL,
};

void aob_section_reply(const struct aob_section_job *job, json_t *item)
{
    if (!aob_json_send(job->reply, item))
        exit(AOB_EXIT_USAGE); /* nobody listens any more */
    json_decref(item);
}

void aob_section_say(const struct aob_section_job *job, const char *item, const char *status,
                     const char *reason)
{
    aob_section_reply(
        job, json_pack("{s:s, s:s, s:o}", "item", item, "status", status, "reason", aob_json_text(reason)));
}

double aob_section_seconds_left(const struct aob_section_job *job)
{
    return (double)(job->end_ns - aob_clock_wall_ns()) * 1e-9;
}

bool aob_section_is_over(const struct aob_section_job *job, const char *item)
{
    if (aob_section_seconds_left(job) > 0)
        return false;
    aob_section_say(job, item, AOB_CHECK_CUT, "no time was left for it");
    return true;
}

struct aob_gpu *aob_section_open(const struct aob_section_job *job, const struct aob_gpu_desc *how,
                                 struct aob_error *error)
{
    struct aob_gpu_desc desc = *how;
    desc.device = job->device;
    return aob_gpu_open(job->backend, &desc, error);
}

/* Drivers read these when they are loaded, which is after this. */
static bool set_environment(const char *backend, struct aob_error *error)
{
    const struct aob_gpu_fns *fns = aob_gpu_find(backend);
    if (!fns)
        return aob_fail(error, "there is no backend '%s'", backend);
    for (const char *const *variable = fns->environment; variable && *variable; variable++)
        putenv((char *)*variable);
    return true;
}

static const struct aob_section *find_section(const char *name, struct aob_error *error)
{
    for (const struct aob_section *const *s = sections; *s; s++)
        if (strcmp((*s)->name, name) == 0)
            return *s;
    aob_fail(error, "there is no section '%s'", name);
    return NULL;
}

static bool run(json_t *document, int reply, struct aob_error *error)
{
    struct aob_section_job job = {.reply = reply};
    const char *name, *folder;
    double seconds, most;
    int trusted;
    job.device = json_string_value(json_object_get(document, "device"));
    if (json_unpack(document, "{s:s, s:s, s:s, s:F, s:F, s:F, s:b}", "section", &name, "backend",
                    &job.backend, "data", &folder, "seconds", &seconds, "most", &most, "precision",
                    &job.precision, "trusted", &trusted) != 0)
        return aob_fail(error, "standard input is no job; this program is gpu-check's own");
    const struct aob_section *section = find_section(name, error);
    if (!section || !set_environment(job.backend, error) || !aob_check_data_load(&job.data, folder, error))
        return false;
    alarm((unsigned)ceil(most)); /* whatever a driver does meanwhile */
    job.trusted = trusted;
    job.end_ns = aob_clock_wall_ns() + (int64_t)(seconds * 1e9);
    bool ok = section->run(&job, error);
    aob_check_data_finish(&job.data);
    return ok;
}

int main(void)
{
    struct aob_error error = {{0}};
    int reply = dup(STDOUT_FILENO); /* what a driver prints goes to standard error */
    dup2(STDERR_FILENO, STDOUT_FILENO);
    signal(SIGPIPE, SIG_IGN);
    json_t *document = json_loadf(stdin, JSON_REJECT_DUPLICATES, NULL);
    bool ok = run(document, reply, &error);
    json_decref(document);
    if (!ok)
        aob_error_print(&error);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
