#include "screen.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "screen_mesh.h"

const char aob_screen_version[] = "1";

struct aob_screen {
    struct aob_camera camera;
    struct aob_tracer *tracer;
    struct aob_hits hits; /* the pixels' points as hits of the rebuilt mesh */
};

static void copy_hits(struct aob_hits *hits, const struct aob_hits *from)
{
    size_t pixels = (size_t)from->width * (size_t)from->height;
    hits->width = from->width;
    hits->height = from->height;
    hits->primitive = aob_alloc(pixels, sizeof *hits->primitive);
    hits->u = aob_alloc(pixels, sizeof *hits->u);
    hits->v = aob_alloc(pixels, sizeof *hits->v);
    hits->normal = aob_alloc(pixels, sizeof *hits->normal);
    memcpy(hits->normal, from->normal, pixels * sizeof *hits->normal);
    for (size_t i = 0; i < pixels; i++)
        hits->primitive[i] = from->depth[i] > 0 ? (uint32_t)i : AOB_NO_PRIMITIVE;
}

static struct aob_tracer *create_tracer(const struct aob_camera *camera,
                                        const struct aob_projection *projection, const struct aob_hits *hits,
                                        const struct aob_screen_desc *desc, struct aob_error *error)
{
    struct aob_mesh mesh = {0};
    if (!aob_screen_mesh(camera, projection, hits, desc, &mesh)) {
        aob_fail(error, "screen-space bound: the picture shows sky only: nothing can be rebuilt");
        return NULL;
    }
    struct aob_tracer *tracer = aob_tracer_create(&mesh, error);
    if (!tracer)
        aob_fail_in(error, "screen-space bound of %dx%d pixels", hits->width, hits->height);
    aob_mesh_finish(&mesh);
    return tracer;
}

struct aob_screen *aob_screen_create(const struct aob_camera *camera, const struct aob_projection *projection,
                                     const struct aob_hits *hits, const struct aob_screen_desc *desc,
                                     struct aob_error *error)
{
    if (desc->kind == AOB_SCREEN_SLAB && !(desc->thickness > 0)) {
        aob_fail(error, "screen-space bound: thickness %g: must be more than 0", desc->thickness);
        return NULL;
    }
    struct aob_tracer *tracer = create_tracer(camera, projection, hits, desc, error);
    if (!tracer)
        return NULL;
    struct aob_screen *screen = AOB_NEW(struct aob_screen);
    screen->camera = *camera;
    screen->tracer = tracer;
    copy_hits(&screen->hits, hits);
    return screen;
}

void aob_screen_destroy(struct aob_screen *screen)
{
    if (!screen)
        return;
    aob_tracer_destroy(screen->tracer);
    aob_hits_finish(&screen->hits);
    free(screen);
}

bool aob_screen_visibility(const struct aob_screen *screen, const struct aob_visibility_desc *desc,
                           struct aob_visibility *result, struct aob_error *error)
{
    return aob_tracer_visibility(screen->tracer, &screen->camera, &screen->hits, desc, result, error);
}
