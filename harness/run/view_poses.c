#include <stdlib.h>
#include "base/memory.h"
#include "view.h"

/* Each in a job of its own, unless all of it is there. */
static bool make_pose(struct aob_measurement *m, const struct aob_case *c, const struct aob_view_files *files,
                      struct aob_view_pose *pose, struct aob_error *error)
{
    const struct aob_view_moment moment = {pose->camera, pose->frame, pose->seed};
    struct aob_view_missing missing = {.terms = json_array(), .known = json_object()};
    struct aob_job_view view = aob_job_view_of(c, files);
    bool has, ok;
    pose->gbuffer = aob_view_gbuffer_path(m, c, &moment);
    for (size_t t = 0; t < files->target_count; t++)
        pose->truth[t] = aob_view_want_truth(
            m, c, &moment, &(struct aob_view_truth){&c->scene->targets[t], false}, &missing);
    view.camera = pose->camera;
    view.frame = pose->frame;
    view.seed = pose->seed;
    view.gbuffer = pose->gbuffer;
    ok =
        aob_cache_has(pose->gbuffer, &has, error) &&
        (!*missing.shut.text || aob_fail(error, "%s", missing.shut.text)) &&
        ((has && !json_array_size(missing.terms)) || aob_view_trace(m, c, &view, !has, missing.terms, error));
    json_decref(missing.terms);
    json_decref(missing.known);
    return ok;
}

bool aob_view_prepare_poses(struct aob_measurement *m, const struct aob_case *c, struct aob_view_files *files,
                            struct aob_error *error)
{
    const struct aob_plan_scene *scene = c->scene;
    if (!scene->motion.frames)
        return true;
    files->poses = AOB_NEW_ARRAY(struct aob_view_pose, (size_t)scene->motion.frames);
    for (int t = 0; t < scene->motion.frames - 1; t++) {
        const struct aob_view_moment moment = aob_view_moment_of(scene, t);
        struct aob_view_pose *pose = &files->poses[files->pose_count++];
        *pose = (struct aob_view_pose){.camera = moment.camera,
                                       .frame = moment.frame,
                                       .seed = moment.seed,
                                       .truth = AOB_NEW_ARRAY(char *, files->target_count)};
        if (!make_pose(m, c, files, pose, error))
            return aob_fail_in(error, "frame %d of %d", t, scene->motion.frames);
    }
    return true;
}

void aob_view_poses_finish(struct aob_view_files *files)
{
    for (size_t p = 0; p < files->pose_count; p++) {
        for (size_t t = 0; t < files->target_count; t++)
            free(files->poses[p].truth[t]);
        free(files->poses[p].truth);
        free(files->poses[p].gbuffer);
    }
    free(files->poses);
}
