#include "match.h"
#include <math.h>

const struct aob_motion aob_motion_none = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};

/* Rodrigues' formula, of each axis. */
static struct aob_vec3 turned(struct aob_vec3 p, struct aob_vec3 axis, double angle)
{
    struct aob_vec3 along = aob_vec_scale(axis, aob_vec_dot(axis, p) * (1 - cos(angle)));
    struct aob_vec3 across = aob_vec_scale(aob_vec_cross(axis, p), sin(angle));
    return aob_vec_add(aob_vec_add(aob_vec_scale(p, cos(angle)), across), along);
}

struct aob_motion aob_motion_turn(struct aob_vec3 centre, struct aob_vec3 axis, double deg)
{
    double angle = deg * M_PI / 180;
    return (struct aob_motion){turned(aob_vec(1, 0, 0), axis, angle), turned(aob_vec(0, 1, 0), axis, angle),
                               turned(aob_vec(0, 0, 1), axis, angle),
                               aob_vec_sub(centre, turned(centre, axis, angle))};
}

struct aob_motion aob_motion_mirror(void)
{
    struct aob_motion mirror = aob_motion_none;
    mirror.x.x = -1;
    return mirror;
}

struct aob_vec3 aob_motion_of(const struct aob_motion *motion, struct aob_vec3 point)
{
    struct aob_vec3 xy = aob_vec_add(aob_vec_scale(motion->x, point.x), aob_vec_scale(motion->y, point.y));
    return aob_vec_add(aob_vec_add(xy, aob_vec_scale(motion->z, point.z)), motion->by);
}

void aob_motion_apply(const struct aob_motion *motion, struct aob_mesh *mesh)
{
    bool mirrors = aob_vec_dot(aob_vec_cross(motion->x, motion->y), motion->z) < 0;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        mesh->positions[i] = aob_motion_of(motion, mesh->positions[i]);
    for (size_t i = 0; mirrors && i < mesh->triangle_count; i++) {
        uint32_t second = mesh->triangles[i][1];
        mesh->triangles[i][1] = mesh->triangles[i][2];
        mesh->triangles[i][2] = second;
    }
}

/* The pixel of the image, without the guard band, in which a point lies; false if none. */
static bool pixel_of(const struct aob_exhibit *exhibit, struct aob_vec3 point, size_t *pixel)
{
    double q[2];
    struct aob_vec3 from_eye = aob_vec_sub(point, exhibit->camera.eye);
    if (!aob_camera_project(&exhibit->camera, &exhibit->gbuffer.projection, from_eye, q))
        return false;
    double x = floor(q[0]) - exhibit->guard, y = floor(q[1]) - exhibit->guard;
    if (!(x >= 0 && y >= 0 && x < exhibit->width && y < exhibit->height))
        return false;
    *pixel = (size_t)y * (size_t)exhibit->width + (size_t)x;
    return true;
}

static bool shows(const struct aob_exhibit *exhibit, size_t pixel, struct aob_vec3 point)
{
    if (!aob_exhibit_is_surface(exhibit, pixel))
        return false;
    const struct aob_projection *projection = &exhibit->gbuffer.projection;
    double scale = projection->perspective ? (double)aob_exhibit_depth(exhibit, pixel) : 1;
    struct aob_vec3 off = aob_vec_sub(aob_exhibit_position(exhibit, pixel), point);
    return aob_vec_length(off) <= 3 * projection->sy * scale;
}

void aob_match_fetch(const struct aob_match *match, const float *other_image, float *image, bool *seen)
{
    for (size_t i = 0; i < aob_exhibit_pixels(match->exhibit); i++) {
        size_t there;
        seen[i] = false;
        if (!aob_exhibit_is_surface(match->exhibit, i))
            continue;
        struct aob_vec3 point = aob_motion_of(&match->motion, aob_exhibit_position(match->exhibit, i));
        if (pixel_of(match->other, point, &there) && shows(match->other, there, point)) {
            image[i] = other_image[there];
            seen[i] = true;
        }
    }
}

/* Difference of the means of one block; NAN where too little of it is seen. */
static double block_of(const struct aob_exhibit *exhibit, const float *image, const float *wanted,
                       const bool *seen, int size, size_t first)
{
    double sum = 0;
    int count = 0;
    for (int y = 0; y < size; y++)
        for (int x = 0; x < size; x++) {
            size_t i = first + (size_t)y * (size_t)exhibit->width + (size_t)x;
            sum += seen[i] ? (double)image[i] - (double)wanted[i] : 0;
            count += seen[i];
        }
    return 4 * count >= 3 * size * size ? sum / count : NAN;
}

double aob_match_blocks(const struct aob_exhibit *exhibit, const float *image, const float *wanted,
                        const bool *seen, int size, size_t *at)
{
    double most = NAN;
    *at = 0;
    for (int y = 0; y + size <= exhibit->height; y += size)
        for (int x = 0; x + size <= exhibit->width; x += size) {
            size_t first = (size_t)y * (size_t)exhibit->width + (size_t)x;
            double e = fabs(block_of(exhibit, image, wanted, seen, size, first));
            if (isnan(e) || most >= e)
                continue;
            most = e;
            *at = first;
        }
    return most;
}
