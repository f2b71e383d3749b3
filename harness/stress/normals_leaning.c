#include "normals.h"
#include <math.h>
#include "base/memory.h"
#include "sets.h"

/* A corridor of square section along the view axis, closed at its end. In view space its walls' normals are the axes. Each
 * wall is the one before it, turned by 90 degrees about the axis, its triangles too. */
static struct aob_exhibit *make_corridor(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    const double far = -4, near = 1;
    struct aob_vec3 u = aob_vec(2, 0, 0), corner = aob_vec(-1, -1, near);
    for (int wall = 0; wall < 4; wall++) {
        aob_mesh_add_quad(&mesh, corner, u, aob_vec(0, 0, far - near));
        u = aob_vec(-u.y, u.x, 0);
        corner = aob_vec(-corner.y, corner.x, near);
    }
    aob_mesh_add_quad(&mesh, aob_vec(-1, -1, far), aob_vec(2, 0, 0), aob_vec(0, 2, 0));
    struct aob_exhibit *exhibit = aob_trial_exhibit(
        trial,
        &(struct aob_exhibit_desc){
            .mesh = &mesh, .camera = {.target = {0, 0, -1}, .fov_deg = 75}, .width = 96, .height = 96});
    for (size_t i = 0; exhibit && i < 4 * aob_exhibit_pixels(exhibit); i++)
        exhibit->gbuffer.normal[i] = roundf(exhibit->gbuffer.normal[i]);
    return exhibit;
}

void aob_ask_axial_normals(struct aob_trial *trial)
{
    struct aob_shot shot = {.exhibit = make_corridor(trial), .radius = 1.5};
    const float *image = aob_trial_draw(trial, &shot);
    double low = INFINITY, high = -INFINITY;
    for (uint32_t wall = 0; image && wall < 4; wall++) {
        bool *mask = aob_trial_mask(trial, shot.exhibit);
        for (size_t i = 0; i < aob_exhibit_pixels(shot.exhibit); i++)
            mask[i] = shot.exhibit->hits.primitive[i] / 2 == wall;
        double mean = aob_mean_of(shot.exhibit, image, mask);
        low = fmin(low, mean);
        high = isnan(mean) ? INFINITY : fmax(high, mean); /* a wall that is not seen */
    }
    if (image)
        aob_trial_take(trial, high - low, &(struct aob_seen){&shot, image, NULL},
                       "means of the four walls from %.4f to %.4f", low, high);
}

/* Turns the shading normals of a plane that faces the camera by an angle, every pixel towards another azimuth, but no
 * farther than they may lean (AOB_LEAST_FACING). Returns the mean angle, radians. */
static double lean(struct aob_exhibit *exhibit, double degrees, bool wobble)
{
    double sum = 0;
    size_t count = aob_exhibit_pixels(exhibit);
    for (size_t i = 0; i < count; i++) {
        double azimuth = 2.4 * (double)i, x = (double)(i % (size_t)exhibit->width);
        double angle = degrees * M_PI / 180 * (wobble ? fabs(sin(0.7 * x)) : 1);
        struct aob_vec3 p = aob_exhibit_position(exhibit, i);
        struct aob_vec3 to_camera = aob_vec_normalize(aob_vec_sub(exhibit->camera.eye, p));
        struct aob_vec3 n = aob_vec(sin(angle) * cos(azimuth), sin(angle) * sin(azimuth), cos(angle));
        n = aob_vec_bend(n, to_camera, fmin(AOB_LEAST_FACING, to_camera.z));
        const float shading[3] = {(float)n.x, (float)n.y, (float)n.z};
        for (size_t c = 0; c < 3; c++)
            exhibit->gbuffer.shading[4 * i + c] = shading[c];
        sum += acos(fmin(1, n.z));
    }
    return sum / (double)count;
}

void aob_ask_leaning_normals(struct aob_trial *trial)
{
    static const double angles[] = {10, 30, 60, 80, 89.9};
    struct aob_exhibit *exhibit = aob_set_plane(trial, &(struct aob_plane_desc){0});
    struct aob_shot shot = {.exhibit = exhibit, .radius = 0.5};
    const float *upright = aob_trial_draw(trial, &shot);
    shot.set = "normals=shading";
    for (size_t a = 0; upright && a < AOB_COUNT(angles); a++) {
        double angle = lean(exhibit, angles[a], false);
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_difference_of(exhibit, image, upright, NULL).mean;
        aob_trial_take(trial, aob_worse(aob_over(mean), -mean - 4 / M_PI * angle),
                       &(struct aob_seen){&shot, image, upright},
                       "normals that lean %g degrees: the mean is off by %.4f", angles[a], mean);
    }
}

void aob_ask_mapped_plane(struct aob_trial *trial)
{
    struct aob_exhibit *exhibit = aob_set_plane(trial, &(struct aob_plane_desc){0});
    struct aob_shot shot = {.exhibit = exhibit, .radius = 0.5};
    const float *flat = aob_trial_draw(trial, &shot);
    if (!flat)
        return;
    double angle = lean(exhibit, 10, true);
    shot.set = "normals=shading";
    const float *image = aob_trial_draw(trial, &shot);
    if (!image)
        return;
    double mean = aob_difference_of(exhibit, image, flat, NULL).mean;
    aob_trial_take(trial, fabs(mean) / (4 / M_PI * angle), &(struct aob_seen){&shot, image, flat},
                   "normals that lean %.2f degrees on average: the mean is off by %.4f", angle * 180 / M_PI,
                   mean);
}

/* A ball of so many segments whose normals are those of the sphere. */
static struct aob_exhibit *make_ball(struct aob_trial *trial, int segments)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, segments);
    mesh.normals = AOB_NEW_ARRAY(struct aob_vec3, mesh.vertex_count);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        mesh.normals[i] = aob_vec_normalize(mesh.positions[i]);
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){
                   .mesh = &mesh, .camera = {.eye = {0, 0, 3}, .fov_deg = 50}, .width = 64, .height = 64});
}

/* Its middle: what faces the camera within 60 degrees. */
static const bool *middle(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    bool *mask = aob_trial_mask(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        mask[i] = exhibit->gbuffer.shading[4 * i + 2] > 0.5f;
    return mask;
}

void aob_ask_coarse_normals(struct aob_trial *trial)
{
    struct aob_shot fine = {.exhibit = make_ball(trial, 192), .radius = 0.5, .set = "normals=shading"},
                    coarse = {.exhibit = make_ball(trial, 24), .radius = 0.5, .set = "normals=shading"};
    const float *wanted = aob_trial_draw(trial, &fine), *image = aob_trial_draw(trial, &coarse);
    if (!image || !wanted)
        return;
    double open = aob_mean_of(fine.exhibit, wanted, middle(trial, fine.exhibit)),
           mean = aob_mean_of(coarse.exhibit, image, middle(trial, coarse.exhibit));
    aob_trial_take(trial, fabs(mean - open), &(struct aob_seen){&coarse, image, wanted},
                   "the mean is %.4f with 24 segments, %.4f with 192", mean, open);
}
