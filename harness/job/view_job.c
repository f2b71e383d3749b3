#include "view_job.h"
#include <stdint.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "scene/camera_json.h"
#include "scene/light_json.h"

void aob_job_view_to_json(const struct aob_job_view *view, json_t *job)
{
    if (view->mesh)
        json_object_set_new(job, "mesh", aob_json_path(view->mesh));
    else
        json_object_set_new(job, "scene", json_string(view->scene));
    json_object_set_new(job, "captured", json_boolean(view->captured));
    json_object_set_new(job, "camera", aob_camera_to_json(&view->camera));
    json_object_set_new(job, "frame", json_integer(view->frame));
    json_object_set_new(job, "seed", json_integer(view->seed));
    json_object_set_new(job, "width", json_integer(view->width));
    json_object_set_new(job, "height", json_integer(view->height));
    json_object_set_new(job, "guard", json_integer(view->guard));
    json_object_set_new(job, "gbuffer", aob_json_path(view->gbuffer));
    json_object_set_new(job, "light", aob_light_to_json(&view->light));
}

bool aob_job_view_from_json(const json_t *job, struct aob_job_view *view, struct aob_error *error)
{
    int captured;
    json_int_t seed;
    *view = (struct aob_job_view){.mesh = json_string_value(json_object_get(job, "mesh")),
                                  .scene = json_string_value(json_object_get(job, "scene"))};
    if (json_unpack((json_t *)(uintptr_t)job, "{s:i, s:I, s:i, s:i, s:i, s:b, s:s}", "frame", &view->frame,
                    "seed", &seed, "width", &view->width, "height", &view->height, "guard", &view->guard,
                    "captured", &captured, "gbuffer", &view->gbuffer) != 0)
        return aob_fail(error, "a job's view lacks a field");
    view->captured = captured;
    view->seed = (unsigned)seed;
    if (!aob_light_from_json(json_object_get(job, "light"), &view->light))
        return aob_fail(error, "a job's view has no light");
    return aob_camera_from_json(json_object_get(job, "camera"), &view->camera, error);
}

json_t *aob_view_job_to_json(const struct aob_job_view *view, int spp, bool cast, json_t *terms)
{
    json_t *job = json_pack("{s:s, s:i, s:b, s:o}", "job", "view", "spp", spp, "cast", cast, "terms", terms);
    aob_job_view_to_json(view, job);
    return job;
}

static bool read_terms(const json_t *array, struct aob_view_job *job, struct aob_error *error)
{
    job->terms = AOB_NEW_ARRAY(struct aob_view_term, json_array_size(array));
    for (size_t i = 0; i < json_array_size(array); i++) {
        const json_t *object = json_array_get(array, i);
        struct aob_view_term *term = &job->terms[job->term_count];
        if (!aob_term_from_json(object, &term->term, error))
            return false;
        job->term_count++;
        term->out = json_string_value(json_object_get(object, "out"));
        if (!term->out)
            return aob_fail(error, "term %zu of a view job has no file", i);
    }
    return true;
}

bool aob_view_job_from_json(const json_t *object, struct aob_view_job *job, struct aob_error *error)
{
    *job = (struct aob_view_job){.spp = (int)json_integer_value(json_object_get(object, "spp")),
                                 .cast = json_is_true(json_object_get(object, "cast"))};
    if (aob_job_view_from_json(object, &job->view, error) &&
        read_terms(json_object_get(object, "terms"), job, error))
        return true;
    aob_view_job_finish(job);
    return false;
}

void aob_view_job_finish(struct aob_view_job *job)
{
    for (size_t i = 0; i < job->term_count; i++)
        aob_term_finish(&job->terms[i].term);
    free(job->terms);
    *job = (struct aob_view_job){0};
}
