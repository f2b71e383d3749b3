#include "sets.h"
#include <math.h>

struct aob_exhibit *aob_set_plane(struct aob_trial *trial, const struct aob_plane_desc *plane)
{
    double t = plane->tilt_deg * M_PI / 180, a = plane->azimuth_deg * M_PI / 180;
    double distance = plane->distance > 0 ? plane->distance : 3, size = 400 * distance;
    struct aob_vec3 n = aob_vec(sin(t) * cos(a), sin(t) * sin(a), cos(t));
    struct aob_vec3 up = fabs(n.y) < 0.9 ? aob_vec(0, 1, 0) : aob_vec(1, 0, 0);
    struct aob_vec3 u = aob_vec_normalize(aob_vec_cross(up, n)), v = aob_vec_cross(n, u);
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec_scale(aob_vec_add(u, v), -size / 2), aob_vec_scale(u, size),
                      aob_vec_scale(v, size));
    const struct aob_exhibit_desc desc = {.mesh = &mesh,
                                          .camera = {.eye = {0, 0, distance},
                                                     .fov_deg = plane->fov_deg > 0 ? plane->fov_deg : 60,
                                                     .ortho_height = plane->ortho_height,
                                                     .shift = {plane->shift[0], plane->shift[1]}},
                                          .width = plane->width ? plane->width : 48,
                                          .height = plane->height ? plane->height : 32,
                                          .guard = plane->guard};
    return aob_trial_exhibit(trial, &desc);
}

struct aob_exhibit *aob_set_plane_beside(struct aob_trial *trial, struct aob_vec3 out, double ortho_height)
{
    struct aob_mesh mesh = {0};
    struct aob_vec3 front = aob_vec_scale(out, -1), u = aob_vec(0, 0, -400), v = aob_vec_cross(front, u);
    if (out.z != 0) {
        u = aob_vec(400, 0, 0);
        v = aob_vec(0, 400, 0);
    }
    aob_mesh_add_quad(&mesh, aob_vec_sub(out, aob_vec_scale(aob_vec_add(u, v), 0.5)), u, v);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh,
        .camera = {.target = {0, 0, -1}, .fov_deg = 90, .ortho_height = ortho_height},
        .width = 64,
        .height = 48,
        .guard = 16};
    return aob_trial_exhibit(trial, &desc);
}

static void place(struct aob_mesh *mesh, size_t first, double scale, struct aob_vec3 move)
{
    for (size_t i = first; i < mesh->vertex_count; i++)
        mesh->positions[i] = aob_vec_add(aob_vec_scale(mesh->positions[i], scale), move);
}

void aob_set_still_life(struct aob_mesh *mesh, double scale, struct aob_vec3 move)
{
    size_t first = mesh->vertex_count;
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, 20), aob_vec(40, 0, 0), aob_vec(0, 0, -21));
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, -1), aob_vec(40, 0, 0), aob_vec(0, 20, 0));
    aob_mesh_add_box(mesh, aob_vec(-1.4, 0, -0.5), aob_vec(-0.5, 0.9, 0.4), 25);
    aob_mesh_add_sphere(mesh, aob_vec(0.4, 0.45, 0.2), 0.45, 32);
    aob_mesh_add_box(mesh, aob_vec(1.3, 0, 0), aob_vec(1.4, 1.6, 0.1), 0);
    place(mesh, first, scale, move);
}

struct aob_camera aob_still_life_camera(double scale, struct aob_vec3 move)
{
    return (struct aob_camera){.eye = aob_vec_add(aob_vec_scale(aob_vec(1.2, 1.7, 3.6), scale), move),
                               .target = aob_vec_add(aob_vec_scale(aob_vec(0, 0.4, 0), scale), move),
                               .fov_deg = 50};
}

struct aob_exhibit *aob_set_still_life_at(struct aob_trial *trial, double scale, struct aob_vec3 move,
                                          int width, int height)
{
    struct aob_mesh mesh = {0};
    aob_set_still_life(&mesh, scale, move);
    return aob_trial_exhibit(trial, &(struct aob_exhibit_desc){.mesh = &mesh,
                                                               .camera = aob_still_life_camera(scale, move),
                                                               .width = width,
                                                               .height = height});
}

struct aob_exhibit *aob_set_default(struct aob_trial *trial)
{
    return aob_set_still_life_at(trial, 1, aob_vec(0, 0, 0), 96, 64);
}

void aob_set_turn_faces(struct aob_mesh *mesh)
{
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t b = mesh->triangles[i][1];
        mesh->triangles[i][1] = mesh->triangles[i][2];
        mesh->triangles[i][2] = b;
    }
}

void aob_set_corner(struct aob_mesh *mesh, double size)
{
    aob_mesh_add_quad(mesh, aob_vec(-size, 0, size), aob_vec(2 * size, 0, 0), aob_vec(0, 0, -size));
    aob_mesh_add_quad(mesh, aob_vec(-size, 0, 0), aob_vec(2 * size, 0, 0), aob_vec(0, size, 0));
}
