/* The mean open direction against closed forms, in view space, at 1024 rays a pixel. */
#include "shot.h"

static const struct aob_visibility_term terms[] = {{.radius = INFINITY, .bent = true},
                                                   {.radius = INFINITY, .uniform = true, .bent = true},
                                                   {.radius = INFINITY}};

static struct aob_vec3 to_world(const struct shot *shot, const float v[3])
{
    struct aob_frame_axes axes = aob_camera_axes(&shot->camera);
    return aob_vec_add(aob_vec_add(aob_vec_scale(axes.right, v[0]), aob_vec_scale(axes.up, v[1])),
                       aob_vec_scale(axes.back, v[2]));
}

static void trace_one(struct shot *shot, struct aob_mesh *mesh, const struct aob_visibility_term *term)
{
    struct aob_camera camera = {.eye = {3, 5, 4}, .target = {0, 0, 0.5}, .fov_deg = 30};
    cast_shot(shot, mesh, camera, 48, 32);
    trace_shot(shot, term, 1, 1024);
}

/* On an open plane the mean is the normal times 2/3 with the cosine, times 1/2 without. The sampler is stratified, so each
 * pixel is within a thousandth or two; a wrong axis, sign or weight is not. */
static void open_plane(void **state)
{
    (void)state;
    static const double lengths[] = {2.0 / 3, 0.5};
    for (int t = 0; t < 2; t++) {
        struct aob_mesh mesh = {0};
        struct shot shot;
        aob_mesh_add_quad(&mesh, aob_vec(-500, 0, -500), aob_vec(0, 0, 1000), aob_vec(1000, 0, 0));
        trace_one(&shot, &mesh, &terms[t]);
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
                continue;
            struct aob_vec3 b = to_world(&shot, shot.visibility[0].bent[i]);
            assert_float_equal(b.x, 0, 0.004);
            assert_float_equal(b.y, lengths[t], 0.004);
            assert_float_equal(b.z, 0, 0.004);
        }
        finish_shot(&shot);
    }
}

/* At the foot of an endless wall half the hemisphere is open: its mean is 1/3 up, 2/(3 pi) away from the wall, by
 * integrating direction times cosine / pi over azimuths of half a turn. */
static void foot_of_a_wall(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct shot shot;
    double x = 0, y = 0, z = 0, count = 0;
    aob_mesh_add_quad(&mesh, aob_vec(-5000, 0, 0), aob_vec(0, 0, 10000), aob_vec(10000, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-5000, 0, 0), aob_vec(10000, 0, 0), aob_vec(0, 10000, 0));
    trace_one(&shot, &mesh, &terms[0]);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i);
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE || p.y > 1e-3)
            continue;
        struct aob_vec3 b = to_world(&shot, shot.visibility[0].bent[i]);
        x += b.x;
        y += b.y;
        z += b.z;
        count++;
    }
    assert_true(count > 300);
    assert_float_equal(x / count, 0, 0.002);
    assert_float_equal(y / count, 1.0 / 3, 0.002);
    assert_float_equal(z / count, 2 / (3 * M_PI), 0.002);
    finish_shot(&shot);
}

/* What asks for no direction gets none, and its visibility is the same. */
static void asking_changes_nothing(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0}, again = {0};
    struct shot with, without;
    aob_mesh_add_box(&mesh, aob_vec(-1, 0, -1), aob_vec(1, 1, 1), 2);
    aob_mesh_add_quad(&mesh, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
    aob_mesh_add_box(&again, aob_vec(-1, 0, -1), aob_vec(1, 1, 1), 2);
    aob_mesh_add_quad(&again, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
    trace_one(&with, &mesh, &terms[0]);
    trace_one(&without, &again, &terms[2]);
    assert_null(without.visibility[0].bent);
    assert_memory_equal(with.visibility[0].ao, without.visibility[0].ao, pixel_count(&with) * sizeof(float));
    for (size_t i = 0; i < pixel_count(&with); i++) {
        const float *b = with.visibility[0].bent[i];
        double length = sqrt((double)(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]));
        assert_true(length <= (double)with.visibility[0].ao[i] + 1e-5); /* no longer than the openness */
        if (with.hits.primitive[i] == AOB_NO_PRIMITIVE)
            assert_true(length == 0);
    }
    finish_shot(&with);
    finish_shot(&without);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(open_plane), cmocka_unit_test(foot_of_a_wall),
                                       cmocka_unit_test(asking_changes_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
