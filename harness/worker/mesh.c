#include "scene/mesh.h"
#include "job/mesh_job.h"
#include "worker.h"

static bool make_mesh(struct aob_mesh *mesh, const struct aob_mesh_job *job, struct aob_error *error)
{
    if (job->cached)
        return aob_mesh_restore(mesh, job->out, error);
    return aob_mesh_import(mesh, job->file, error) && aob_mesh_save(mesh, job->out, error);
}

static bool load_mesh(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_mesh_job job;
    struct aob_mesh mesh = {0};
    struct aob_error warnings[AOB_MESH_WARNINGS];
    if (!aob_mesh_job_from_json(worker->job, &job, error) || !make_mesh(&mesh, &job, error))
        return false;
    struct aob_mesh_answer answer = {.vertices = mesh.vertex_count, .triangles = mesh.triangle_count};
    aob_mesh_bounds(&mesh, &answer.low, &answer.high);
    json_t *lines = json_array();
    size_t count = aob_mesh_suspect(&mesh, job.file, warnings);
    for (size_t i = 0; i < count; i++)
        json_array_append_new(lines, json_string(warnings[i].text));
    answer.warnings = lines;
    aob_worker_reply(worker, aob_mesh_answer_to_json(&answer));
    json_decref(lines);
    aob_mesh_finish(&mesh);
    return true;
}

const struct aob_worker_job aob_worker_mesh = {"mesh", load_mesh};
