#include "worker.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/json.h"
#include "scene/scene.h"
#include "technique/param.h"

void aob_worker_reply(struct aob_worker *worker, json_t *answer)
{
    if (!aob_json_send(worker->reply, answer))
        exit(AOB_EXIT_USAGE); /* nobody listens any more */
    json_decref(answer);
}

bool aob_worker_values(const struct aob_technique *technique, const double *params, size_t count,
                       void *values, struct aob_error *error)
{
    if (count != technique->param_count)
        return aob_fail(error, "%s: the job has %zu parameters, the technique %u", technique->name, count,
                        technique->param_count);
    aob_param_pack(technique->params, count, params, values, 4 * AOB_MAX_PARAM);
    return true;
}

bool aob_worker_load(const struct aob_job_view *view, struct aob_mesh *mesh, struct aob_error *error)
{
    const struct aob_scene_info *scene = view->scene ? aob_scene_find(view->scene) : NULL;
    if (view->mesh)
        return aob_mesh_restore(mesh, view->mesh, error);
    if (!scene || !scene->build)
        return aob_fail(error, "the job has no mesh and no procedural scene");
    scene->build(mesh);
    aob_mesh_move(mesh, view->frame);
    return true;
}

static bool do_job(struct aob_worker *worker, const struct aob_worker_job *const *jobs,
                   struct aob_error *error)
{
    const char *name = json_string_value(json_object_get(worker->job, "job"));
    for (; name && *jobs; jobs++)
        if (strcmp((*jobs)->name, name) == 0)
            return (*jobs)->run(worker, error);
    return aob_fail(error, "worker: no such job; this command is the program's own");
}

int aob_worker_main(const struct aob_worker_job *const *jobs)
{
    struct aob_error error = {{0}};
    json_error_t problem;
    struct aob_worker worker = {.reply = dup(STDOUT_FILENO)};
    dup2(STDERR_FILENO, STDOUT_FILENO);
    json_t *job = json_loadf(stdin, JSON_REJECT_DUPLICATES, &problem);
    worker.job = job;
    bool ok = job ? do_job(&worker, jobs, &error) : aob_fail(&error, "worker: standard input is not a job");
    json_decref(job);
    if (!ok)
        aob_error_print(&error);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
