/* A technique on a device twice, plain and counted, for tests of the count. */
#ifndef AOB_TESTS_FRAME_COUNTED_H
#define AOB_TESTS_FRAME_COUNTED_H
#include "check.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "frame/count.h"
#include "rig.h"
#include "technique/registry.h"

struct counted {
    struct aob_gpu *gpu;
    struct aob_geometry geometry;
    struct aob_screen screen;
    struct aob_count count; /* has run */
};
struct counted_desc {
    const struct aob_technique *technique;
    const void *values;
    const struct aob_options *options;
    uint64_t limit;
};

static inline const struct aob_technique *counted_find(const char *name)
{
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (strcmp((*t)->name, name) == 0)
            return *t;
    fail_msg("no technique %s", name);
    return NULL;
}

static inline void counted_init(struct counted *counted, const struct aob_rig *rig, struct aob_gpu *gpu,
                                const struct counted_desc *desc)
{
    struct aob_error error = {""};
    *counted = (struct counted){.gpu = gpu, .geometry = rig->geometry};
    bool ok = aob_geometry_upload(&counted->geometry, gpu, &error) &&
              aob_screen_init(&counted->screen, gpu, &rig->gbuffer, desc->options, &error);
    counted->screen.geometry = &counted->geometry;
    const struct aob_count_desc count = {.screen = &counted->screen,
                                         .technique = desc->technique,
                                         .values = desc->values,
                                         .fetch = (enum aob_fetch)desc->options->fetch,
                                         .limit = desc->limit};
    if (!ok || !aob_count_init(&counted->count, &count, &error) || !aob_count_run(&counted->count, &error))
        fail_msg("%s", error.text);
}

static inline void counted_finish(struct counted *counted)
{
    aob_count_finish(&counted->count);
    aob_screen_finish(&counted->screen);
    aob_gpu_texture_destroy(counted->gpu, counted->geometry.texture);
}
#endif
