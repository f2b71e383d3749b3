#include "job/check_job.h"
#include "reference/backs.h"
#include "scene/mesh_double.h"
#include "worker.h"

static bool check_mesh(const struct aob_check_job *job, const struct aob_mesh *mesh,
                       struct aob_check_answer *answer, struct aob_error *error)
{
    const struct aob_job_view *view = &job->view;
    struct aob_hits hits;
    struct aob_projection projection = aob_camera_projection(&view->camera, view->width, view->height, 0);
    struct aob_tracer *tracer = aob_tracer_create(mesh, error);
    if (!tracer)
        return false;
    aob_tracer_cast(tracer, &view->camera, &projection, &hits);
    *answer = (struct aob_check_answer){.triangles = mesh->triangle_count,
                                        .doubled = aob_mesh_double_count(mesh),
                                        .backs = aob_tracer_backs(tracer, &view->camera, &hits, job->radius)};
    aob_hits_finish(&hits);
    aob_tracer_destroy(tracer);
    return true;
}

static bool check(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_check_job job;
    struct aob_check_answer answer;
    struct aob_mesh mesh = {0};
    if (!aob_check_job_from_json(worker->job, &job, error) || !aob_worker_load(&job.view, &mesh, error))
        return false;
    bool ok = check_mesh(&job, &mesh, &answer, error);
    if (ok)
        aob_worker_reply(worker, aob_check_answer_to_json(&answer));
    aob_mesh_finish(&mesh);
    return ok;
}

const struct aob_worker_job aob_worker_check = {"check", check};
