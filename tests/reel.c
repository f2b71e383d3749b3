#include "reel.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "technique/registry.h"

static void judge(bool ok, const struct aob_error *error)
{
    if (ok)
        return;
    fprintf(stderr, "a sequence: %s\n", error->text);
    exit(1);
}

void aob_reel_init(struct aob_reel *reel, const struct aob_rig *rig, struct aob_gpu *gpu,
                   const char *technique, const char *params)
{
    const struct aob_technique *found = NULL;
    struct aob_options options;
    struct aob_error error = {{0}};
    *reel = (struct aob_reel){.gpu = gpu};
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        found = strcmp((*t)->name, technique) == 0 ? *t : found;
    aob_rig_params(found, params, reel->values, &options);
    const struct aob_frame_desc desc = {.technique = found,
                                        .values = reel->values,
                                        .fetch = (enum aob_fetch)options.fetch,
                                        .wanted = aob_options_wanted(&options),
                                        .readable = true};
    judge(aob_screen_init(&reel->screen, gpu, &rig->gbuffer, &options, &error) &&
              aob_frame_init_desc(&reel->frame, &reel->screen, &desc, &error),
          &error);
    aob_reel_show(reel, rig);
}

void aob_reel_show(struct aob_reel *reel, const struct aob_rig *rig)
{
    struct aob_light light;
    struct aob_error error = {{0}};
    const struct aob_frame_axes axes = aob_camera_axes(&rig->camera);
    aob_light_turn(&rig->light, &axes, &light);
    const struct aob_screen_pose pose = {&rig->gbuffer, &light, aob_camera_then(&rig->camera)};
    judge(aob_screen_show(&reel->screen, &pose, &error), &error);
}

void aob_reel_draw(struct aob_reel *reel, float *pixels)
{
    struct aob_error error = {{0}};
    judge(aob_frame_set(&reel->frame, reel->number++, reel->values, &error) &&
              aob_frame_run(&reel->frame, 1, NULL, &error) &&
              (!pixels || aob_frame_read(&reel->frame, AOB_OUT_VISIBILITY, 1, pixels, &error)),
          &error);
}

void aob_reel_finish(struct aob_reel *reel)
{
    aob_frame_finish(&reel->frame);
    aob_screen_finish(&reel->screen);
}
