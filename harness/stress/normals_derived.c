#include "normals.h"
#include <math.h>
#include "base/memory.h"
#include "sets.h"

/* The same exhibit with normals from the depth against those of the triangles. On flat faces the two are the same vector but
 * for rounding, wherever of a pixel's neighbours one along each axis lies on its own face. */
static void compare(struct aob_trial *trial, const struct aob_exhibit *exhibit, double radius,
                    const bool *mask, const char *where, double degrees)
{
    struct aob_shot shot = {.exhibit = exhibit, .radius = radius};
    const float *wanted = aob_trial_draw(trial, &shot);
    shot.set = "normals=from_depth";
    const float *image = aob_trial_draw(trial, &shot);
    if (!image || !wanted)
        return;
    struct aob_difference d = aob_difference_of(exhibit, image, wanted, mask);
    aob_trial_take(trial, d.rmse, &(struct aob_seen){&shot, image, wanted},
                   "%s, tilt %g degrees: the mean is off by %.4f", where, degrees, d.mean);
}

/* A board before a wall, tilted; behind its outline the depth steps down by about 1. */
static struct aob_exhibit *make_board(struct aob_trial *trial, double degrees)
{
    struct aob_mesh mesh = {0};
    double t = degrees * M_PI / 180;
    struct aob_vec3 u = aob_vec(1.6 * cos(t), 0, -1.6 * sin(t)), v = aob_vec(0, 1.2, 0);
    aob_mesh_add_quad(&mesh, aob_vec(-50, -50, -1), aob_vec(100, 0, 0), aob_vec(0, 100, 0));
    aob_mesh_add_quad(&mesh, aob_vec_scale(aob_vec_add(u, v), -0.5), u, v);
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){
                   .mesh = &mesh, .camera = {.eye = {0, 0, 3}, .fov_deg = 50}, .width = 96, .height = 64});
}

/* The board's pixels beside its outline, up to two away along an axis, but for those of its corners that have no neighbour of
 * the board along one: nothing in the depth tells how the board runs on there. */
static const bool *near_side(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    bool *mask = aob_trial_mask(trial, exhibit);
    const uint32_t *primitive = exhibit->hits.primitive;
    for (int y = 2; y < exhibit->height - 2; y++)
        for (int x = 2; x < exhibit->width - 2; x++) {
            int i = y * exhibit->width + x, aside = 0;
            bool told = primitive[i] >= 2;
            for (int axis = 0; axis < 2; axis++) {
                int step = axis ? exhibit->width : 1;
                bool before = primitive[i - step] >= 2, after = primitive[i + step] >= 2;
                told = told && (before || after);
                aside += !before + !after + (primitive[i - 2 * step] < 2) + (primitive[i + 2 * step] < 2);
            }
            mask[i] = told && aside > 0;
        }
    return mask;
}

void aob_ask_derived_at_step(struct aob_trial *trial)
{
    static const double tilts[] = {0, 30, 60};
    for (size_t t = 0; t < AOB_COUNT(tilts); t++) {
        const struct aob_exhibit *exhibit = make_board(trial, tilts[t]);
        if (!exhibit)
            return;
        compare(trial, exhibit, 0.3, near_side(trial, exhibit), "near side of the step", tilts[t]);
    }
}

/* The outermost pixels. */
static const bool *border(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    bool *mask = aob_trial_mask(trial, exhibit);
    for (int i = 0; i < exhibit->width * exhibit->height; i++) {
        int x = i % exhibit->width, y = i / exhibit->width;
        mask[i] = x == 0 || y == 0 || x == exhibit->width - 1 || y == exhibit->height - 1;
    }
    return mask;
}

void aob_ask_derived_at_border(struct aob_trial *trial)
{
    static const double tilts[] = {0, 40, 70};
    for (size_t t = 0; t < AOB_COUNT(tilts); t++) {
        const struct aob_plane_desc plane = {.tilt_deg = tilts[t], .azimuth_deg = 30};
        const struct aob_exhibit *exhibit = aob_set_plane(trial, &plane);
        if (!exhibit)
            return;
        compare(trial, exhibit, 0.5, border(trial, exhibit), "border", tilts[t]);
    }
}

void aob_ask_derived_plane(struct aob_trial *trial)
{
    static const double tilts[] = {0, 15, 30, 45, 60, 75};
    for (size_t t = 0; t < AOB_COUNT(tilts); t++) {
        const struct aob_plane_desc plane = {.tilt_deg = tilts[t], .azimuth_deg = 70};
        compare(trial, aob_set_plane(trial, &plane), 0.5, NULL, "plane", tilts[t]);
    }
}
