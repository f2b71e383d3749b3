/* What the camera sees, and what must not change the ray tracer's answer: threads, place, scale, the part
 * asked for. */
#include "shot.h"
#include <omp.h>
#include <stdlib.h>
#include <string.h>

static void spheres_shot(struct shot *shot, struct aob_vec3 move, double scale, int spp)
{
    const struct aob_scene_info *scene = aob_scene_find("spheres");
    struct aob_mesh mesh = {0};
    scene->build(&mesh);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        mesh.positions[i] = aob_vec_scale(aob_vec_add(mesh.positions[i], move), scale);
    struct aob_camera camera = scene->views[0].camera;
    camera.eye = aob_vec_scale(aob_vec_add(camera.eye, move), scale);
    camera.target = aob_vec_scale(aob_vec_add(camera.target, move), scale);
    struct aob_visibility_term terms[] = {{.radius = 0.5 * scale}, {.radius = 0.7 * scale, .uniform = true}};
    cast_shot(shot, &mesh, camera, 80, 45);
    trace_shot(shot, terms, 2, spp);
}

static void threads_do_not_show(void **state)
{
    (void)state;
    struct shot one, many;
    int before = omp_get_max_threads();
    omp_set_num_threads(1);
    spheres_shot(&one, aob_vec(0, 0, 0), 1, 66);
    omp_set_num_threads(3);
    spheres_shot(&many, aob_vec(0, 0, 0), 1, 66);
    omp_set_num_threads(before);
    for (size_t i = 0; i < 2; i++) {
        assert_memory_equal(one.visibility[i].ao, many.visibility[i].ao, pixel_count(&one) * sizeof(float));
        assert_memory_equal(one.visibility[i].se, many.visibility[i].se, pixel_count(&one) * sizeof(float));
    }
    finish_shot(&one);
    finish_shot(&many);
}

static void place_and_scale_do_not_show(void **state)
{
    (void)state;
    static const struct {
        struct aob_vec3 move;
        double scale;
    } variants[] = {{{4e5, -4e5, 4e5}, 1}, {{0, 0, 0}, 1e-3}, {{0, 0, 0}, 1e3}, {{4e5, 0, 0}, 1e3}};
    struct shot here, there;
    spheres_shot(&here, aob_vec(0, 0, 0), 1, 128);
    for (size_t v = 0; v < AOB_COUNT(variants); v++) {
        spheres_shot(&there, variants[v].move, variants[v].scale, 128);
        double square = 0;
        for (size_t i = 0; i < pixel_count(&here); i++) {
            assert_int_equal(here.hits.primitive[i], there.hits.primitive[i]);
            assert_true(fabs(there.hits.depth[i] / variants[v].scale - here.hits.depth[i]) < 1e-5);
            square += pow(here.visibility[0].ao[i] - there.visibility[0].ao[i], 2);
        }
        assert_true(sqrt(square / (double)pixel_count(&here)) < 1e-3);
        finish_shot(&there);
    }
    finish_shot(&here);
}

static void a_part_equals_the_whole(void **state)
{
    (void)state;
    struct shot shot;
    corner_shot(&shot, "front", 40, 24);
    const struct aob_visibility_term term = {.radius = 1};
    trace_shot(&shot, &term, 1, 34);
    struct aob_visibility_desc desc = {
        .terms = &term, .term_count = 1, .x0 = 5, .y0 = 3, .width = 30, .height = 17, .spp = 34, .seed = 7};
    struct aob_visibility part;
    assert_true(aob_tracer_visibility(shot.tracer, &shot.camera, &shot.hits, &desc, &part, NULL));
    for (int y = 0; y < desc.height; y++)
        assert_memory_equal(part.ao + y * desc.width, shot.visibility[0].ao + (y + 3) * 40 + 5,
                            30 * sizeof(float));
    aob_visibility_finish(&part);
    finish_shot(&shot);
}

static void seeds_and_halves_differ(void **state)
{
    (void)state;
    struct shot shot;
    corner_shot(&shot, "front", 40, 24);
    const struct aob_visibility_term term = {.radius = 1};
    trace_shot(&shot, &term, 1, 34);
    struct aob_visibility_desc desc = {.terms = &term, .term_count = 1, .spp = 34, .seed = 8};
    struct aob_visibility other;
    assert_true(aob_tracer_visibility(shot.tracer, &shot.camera, &shot.hits, &desc, &other, NULL));
    size_t changed = 0, uncertain = 0;
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        changed += other.ao[i] != shot.visibility[0].ao[i];
        uncertain += other.se[i] > 0;
    }
    assert_true(changed > 50 && uncertain > 50);
    aob_visibility_finish(&other);
    finish_shot(&shot);
}

static void hits_are_exact(void **state)
{
    (void)state;
    struct aob_camera cameras[] = {aob_scene_find("corner")->views[0].camera,
                                   {.eye = {2, 3, 9}, .target = {0, 1, 0}, .ortho_height = 6}};
    for (size_t c = 0; c < AOB_COUNT(cameras); c++) {
        struct shot shot;
        struct aob_mesh mesh = {0};
        aob_scene_find("corner")->build(&mesh);
        cast_shot(&shot, &mesh, cameras[c], 64, 36);
        struct aob_frame_axes axes = aob_camera_axes(&cameras[c]);
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            struct aob_vec3 p = pixel_point(&shot, i);
            bool floor = shot.hits.primitive[i] < 2;
            assert_true(fabs(floor ? p.y : p.z) < 2e-6);
            struct aob_vec3 n = floor ? aob_vec(0, 1, 0) : aob_vec(0, 0, 1);
            assert_true(fabs(shot.hits.normal[i][0] - aob_vec_dot(n, axes.right)) < 1e-6);
            assert_true(fabs(shot.hits.normal[i][1] - aob_vec_dot(n, axes.up)) < 1e-6);
            assert_true(fabs(shot.hits.normal[i][2] - aob_vec_dot(n, axes.back)) < 1e-6);
            assert_memory_equal(shot.hits.shading[i], shot.hits.normal[i], sizeof shot.hits.normal[i]);
        }
        finish_shot(&shot);
    }
}

/* A degenerate triangle before the real one, wound away from the camera, with shading normals of its own. */
static void back_faces_and_degenerates_are_handled(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    for (int i = 0; i < 3; i++)
        aob_mesh_add_vertex(&mesh, aob_vec(i == 1 ? 2 : -2, i == 2 ? 2 : -2, 0));
    aob_mesh_add_triangle(&mesh, 0, 1, 1);
    aob_mesh_add_triangle(&mesh, 0, 2, 1);
    mesh.normals = AOB_NEW_ARRAY(struct aob_vec3, 3);
    for (int i = 0; i < 3; i++)
        mesh.normals[i] = aob_vec_normalize(aob_vec(0.1, 0, -1));
    struct aob_camera camera = {
        .eye = aob_vec(-0.5, -0.5, 3), .target = aob_vec(-0.5, -0.5, 0), .fov_deg = 60};
    struct shot shot;
    cast_shot(&shot, &mesh, camera, 20, 20);
    size_t seen = 0;
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE) {
            assert_true(shot.hits.depth[i] == 0);
            continue;
        }
        assert_int_equal(shot.hits.primitive[i], 1);
        assert_true(fabs(shot.hits.normal[i][2] - 1) < 1e-6);
        assert_true(shot.hits.shading[i][2] > 0.99 && shot.hits.shading[i][0] < -0.09);
        seen++;
    }
    assert_true(seen > 50 && seen < 350);
    finish_shot(&shot);
}

/* A level floor, seen at flat angles down to 0.3 degrees: its shading normals lean away by as much as 40 degrees. They
 * are bent to the horizon in the plane of the normal and the direction to the camera; none is turned into the floor. */
static void shading_normals_that_lean_away_are_bent(void **state)
{
    static const double leans[] = {0, 5, 40};
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(leans); k++) {
        double lean = leans[k] * M_PI / 180;
        const struct aob_vec3 own = aob_vec(0, cos(lean), -sin(lean));
        struct aob_mesh mesh = {0};
        struct shot shot;
        size_t bent = 0;
        aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(40, 0, 0), aob_vec(0, 0, -20));
        mesh.normals = AOB_NEW_ARRAY(struct aob_vec3, mesh.vertex_count);
        for (size_t i = 0; i < mesh.vertex_count; i++)
            mesh.normals[i] = own;
        cast_shot(&shot, &mesh,
                  (struct aob_camera){.eye = {0, 0.1, 0}, .target = {0, 0.1, -1}, .fov_deg = 40}, 80, 60);
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
                continue;
            const float *s = shot.hits.shading[i];
            struct aob_vec3 n = aob_vec(s[0], s[1], s[2]);
            struct aob_vec3 v = aob_vec_normalize(aob_vec_sub(shot.camera.eye, pixel_point(&shot, i)));
            double least = fmin(AOB_LEAST_FACING, v.y);
            assert_true(fabs(shot.hits.normal[i][1] - 1) < 1e-6);
            assert_true(fabs(aob_vec_length(n) - 1) < 1e-6);
            assert_true(fabs(aob_vec_dot(n, v) - fmax(aob_vec_dot(own, v), least)) < 1e-6);
            assert_true(fabs(aob_vec_dot(n, aob_vec_normalize(aob_vec_cross(own, v)))) < 1e-6);
            assert_true(n.y > 0 && aob_vec_dot(n, own) > 0.5);
            bent += aob_vec_dot(own, v) < 0;
        }
        assert_true(leans[k] == 0 ? bent == 0 : bent > 500);
        finish_shot(&shot);
    }
}

static void bad_input_is_refused(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_mesh flat = {0};
    assert_null(aob_tracer_create(&flat, &error));
    assert_true(error.text[0]);
    for (int i = 0; i < 3; i++)
        aob_mesh_add_vertex(&flat, aob_vec(i, 0, 0));
    aob_mesh_add_triangle(&flat, 0, 1, 2);
    assert_null(aob_tracer_create(&flat, &error));
    assert_non_null(strstr(error.text, "area"));
    for (int i = 0; i < 3; i++)
        flat.positions[i] = aob_vec(1, 1, 1);
    assert_null(aob_tracer_create(&flat, &error));
    aob_mesh_finish(&flat);
    struct shot shot;
    corner_shot(&shot, "front", 8, 8);
    const float one = 1, broken = NAN;
    const struct aob_visibility_term good = {.radius = 1},
                                     bad[] = {{.radius = NAN},
                                              {.radius = -1},
                                              {.radius = INFINITY, .falloff = &one, .falloff_count = 1},
                                              {.radius = 1, .falloff = &one},
                                              {.radius = 1, .falloff = &broken, .falloff_count = 1}};
    struct aob_visibility_desc descs[] = {
        {.terms = &good, .term_count = 1, .spp = 7},
        {.terms = &good, .term_count = 1, .spp = 0},
        {.terms = &good, .term_count = 1, .spp = 8, .x0 = 4, .width = 5, .height = 1},
        {.spp = 65538}};
    struct aob_visibility result;
    for (size_t i = 0; i < AOB_COUNT(descs); i++)
        assert_false(
            aob_tracer_visibility(shot.tracer, &shot.camera, &shot.hits, &descs[i], &result, &error));
    for (size_t i = 0; i < AOB_COUNT(bad); i++) {
        struct aob_visibility_desc desc = {.terms = &bad[i], .term_count = 1, .spp = 8};
        assert_false(aob_tracer_visibility(shot.tracer, &shot.camera, &shot.hits, &desc, &result, &error));
    }
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hits_are_exact),
        cmocka_unit_test(back_faces_and_degenerates_are_handled),
        cmocka_unit_test(shading_normals_that_lean_away_are_bent),
        cmocka_unit_test(bad_input_is_refused),
        cmocka_unit_test(threads_do_not_show),
        cmocka_unit_test(place_and_scale_do_not_show),
        cmocka_unit_test(a_part_equals_the_whole),
        cmocka_unit_test(seeds_and_halves_differ),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
