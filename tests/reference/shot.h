/* One picture by the ray tracer, as several tests need it. */
#ifndef AOB_TESTS_REFERENCE_SHOT_H
#define AOB_TESTS_REFERENCE_SHOT_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "base/memory.h"
#include "reference/tracer.h"
#include "scene/scene.h"

enum { MAX_TERMS = 8 };

struct shot {
    struct aob_camera camera;
    struct aob_projection projection;
    struct aob_tracer *tracer;
    struct aob_hits hits;
    struct aob_visibility visibility[MAX_TERMS];
    size_t term_count;
};

/* Takes the mesh over. */
static inline void cast_shot(struct shot *shot, struct aob_mesh *mesh, struct aob_camera camera, int width,
                             int height)
{
    struct aob_error error = {""};
    *shot = (struct shot){.camera = camera, .projection = aob_camera_projection(&camera, width, height, 0)};
    shot->tracer = aob_tracer_create(mesh, &error);
    aob_mesh_finish(mesh);
    assert_string_equal(error.text, "");
    assert_non_null(shot->tracer);
    aob_tracer_cast(shot->tracer, &shot->camera, &shot->projection, &shot->hits);
}

static inline void trace_shot(struct shot *shot, const struct aob_visibility_term *terms, size_t count,
                              int spp)
{
    struct aob_error error = {""};
    struct aob_visibility_desc desc = {.terms = terms, .term_count = count, .spp = spp, .seed = 7};
    shot->term_count = count;
    assert_true(
        aob_tracer_visibility(shot->tracer, &shot->camera, &shot->hits, &desc, shot->visibility, &error));
}

static inline void finish_shot(struct shot *shot)
{
    for (size_t i = 0; i < shot->term_count; i++)
        aob_visibility_finish(&shot->visibility[i]);
    aob_hits_finish(&shot->hits);
    aob_tracer_destroy(shot->tracer);
}

static inline size_t pixel_count(const struct shot *shot)
{
    return (size_t)shot->hits.width * (size_t)shot->hits.height;
}

static inline struct aob_vec3 pixel_point(const struct shot *shot, size_t pixel)
{
    struct aob_vec3 origin, direction;
    size_t width = (size_t)shot->hits.width;
    aob_camera_ray(&shot->camera, &shot->projection, (double)(pixel % width) + 0.5,
                   (double)(pixel / width) + 0.5, &origin, &direction);
    return aob_vec_add(origin, aob_vec_scale(direction, shot->hits.depth[pixel]));
}

static inline void corner_shot(struct shot *shot, const char *view, int width, int height)
{
    const struct aob_scene_info *scene = aob_scene_find("corner");
    struct aob_mesh mesh = {0};
    scene->build(&mesh);
    cast_shot(shot, &mesh, aob_scene_view(scene, view)->camera, width, height);
}
#endif
