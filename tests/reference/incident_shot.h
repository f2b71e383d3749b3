/* The incident light of one picture, as several tests need it, and rooms that are seen from inside. */
#ifndef AOB_TESTS_REFERENCE_INCIDENT_SHOT_H
#define AOB_TESTS_REFERENCE_INCIDENT_SHOT_H
#include "check.h"
#include "reference/incident.h"
#include "shot.h"

static inline struct aob_incident light_shot(const struct shot *shot, struct aob_incident_desc desc)
{
    struct aob_error error = {""};
    struct aob_incident incident;
    bool done = aob_tracer_incident(shot->tracer, &shot->camera, &shot->hits, &desc, &incident, &error);
    assert_string_equal(error.text, "");
    assert_true(done);
    return incident;
}

/* Positive everywhere, and of another direction in each channel. */
static inline const struct aob_light *slanted_light(void)
{
    static const struct aob_light light = {{{2, 1.5, 3},
                                            {0.5, -0.2, 0.1},
                                            {-0.3, 0.4, 0.2},
                                            {0.2, 0.3, -0.9},
                                            {0.1, -0.1, 0.3},
                                            {-0.2, 0.1, 0.2},
                                            {0.2, 0.2, -0.3},
                                            {0.1, -0.2, 0.1},
                                            {-0.1, 0.1, 0.4}}};
    return &light;
}

static inline void paint(struct aob_mesh *mesh, float red, float green, float blue)
{
    aob_mesh_paint(mesh, (struct aob_material){.base_colour = {red, green, blue}, .roughness = 1});
}

/* A room of 4 m, seen from inside. */
static inline void room_shot(struct shot *shot, const float albedo[3])
{
    struct aob_mesh mesh = {0};
    paint(&mesh, albedo[0], albedo[1], albedo[2]);
    aob_mesh_add_box(&mesh, aob_vec(-2, -2, -2), aob_vec(2, 2, 2), 20);
    struct aob_camera camera = {.eye = {0.9, 0.4, 1.1}, .target = {-1, -1.2, -1.5}, .fov_deg = 90};
    cast_shot(shot, &mesh, camera, 64, 48);
}

/* Means over the pixels that are not sky and, if a mask is given, that it holds. */
struct light_mean {
    double rgb[3], se[3]; /* se: pooled, of a pixel */
    double pixels;
};

static inline struct light_mean mean_light(const struct shot *shot, const struct aob_incident *incident,
                                           const bool *mask)
{
    struct light_mean mean = {{0}, {0}, 0};
    for (size_t i = 0; i < pixel_count(shot); i++) {
        if (shot->hits.primitive[i] == AOB_NO_PRIMITIVE || (mask && !mask[i]))
            continue;
        mean.pixels++;
        for (int c = 0; c < 3; c++) {
            mean.rgb[c] += (double)incident->rgb[i][c];
            mean.se[c] += (double)incident->se[i][c] * (double)incident->se[i][c];
        }
    }
    assert_true(mean.pixels > 0);
    for (int c = 0; c < 3; c++) {
        mean.rgb[c] /= mean.pixels;
        mean.se[c] = sqrt(mean.se[c] / mean.pixels);
    }
    return mean;
}
#endif
