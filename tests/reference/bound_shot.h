/* The kinds of the screen-space bound, traced for one picture. */
#ifndef AOB_TESTS_REFERENCE_BOUND_SHOT_H
#define AOB_TESTS_REFERENCE_BOUND_SHOT_H
#include "reference/bound.h"
#include "shot.h"

enum { INFINITE, SLAB, THIN, KINDS };
static const char *const kind_names[KINDS] = {"infinite", "slab", "thin"};

static inline void bound_shot(const struct shot *shot, const struct aob_bound_desc *desc,
                              const struct aob_visibility_term *terms, size_t count, int spp,
                              struct aob_visibility *result)
{
    struct aob_error error = {""};
    struct aob_bound *bound = aob_bound_create(&shot->camera, &shot->projection, &shot->hits, desc, &error);
    assert_string_equal(error.text, "");
    struct aob_visibility_desc trace = {.terms = terms, .term_count = count, .spp = spp, .seed = 7};
    assert_true(aob_bound_visibility(bound, &trace, result, &error));
    aob_bound_destroy(bound);
}

static inline void bound_kinds(const struct shot *shot, double thickness,
                               const struct aob_visibility_term *term, int spp,
                               struct aob_visibility bound[KINDS])
{
    const struct aob_bound_desc descs[KINDS] = {
        {0}, {.kind = AOB_BOUND_SLAB, .thickness = thickness}, {.kind = AOB_BOUND_THIN}};
    for (int k = 0; k < KINDS; k++)
        bound_shot(shot, &descs[k], term, 1, spp, &bound[k]);
}

static inline void finish_kinds(struct aob_visibility bound[KINDS])
{
    for (int k = 0; k < KINDS; k++)
        aob_visibility_finish(&bound[k]);
}

static inline void scene_shot(struct shot *shot, const char *scene, struct aob_camera camera, int width,
                              int height)
{
    struct aob_mesh mesh = {0};
    aob_scene_find(scene)->build(&mesh);
    cast_shot(shot, &mesh, camera, width, height);
}

#endif
