/* Specular occlusion against a quadrature whose GGX is written anew here, against a mirror, and where it is 1. */
#include "specular_shot.h"
#include <omp.h>

static void open_planes_are_one(void **state)
{
    (void)state;
    static const double roughness[] = {0, 0.3, 1, -1};
    for (size_t r = 0; r < AOB_COUNT(roughness); r++)
        for (int low = 0; low < 2; low++) {
            struct aob_mesh mesh = {0};
            struct shot shot;
            size_t seen = 0;
            aob_mesh_add_quad(&mesh, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
            cast_shot(&shot, &mesh, (struct aob_camera){.eye = {0, low ? 1e-3 : 2, 3}, .fov_deg = 60}, 64,
                      36);
            struct aob_specular open = specular_shot(
                &shot, (struct aob_specular_desc){.radius = INFINITY, .roughness = roughness[r], .spp = 64});
            for (size_t i = 0; i < pixel_count(&shot); i++) {
                assert_true(open.so[i] == 1 && open.se[i] == 0);
                seen += shot.hits.primitive[i] != AOB_NO_PRIMITIVE;
            }
            assert_true(seen > pixel_count(&shot) / 4);
            aob_specular_finish(&open);
            finish_shot(&shot);
        }
}

static double quadrature(struct aob_vec3 p, struct aob_vec3 n, struct aob_vec3 v, double alpha, double radius)
{
    enum { RINGS = 600, STEPS = 1200 };
    struct aob_vec3 t = aob_vec(1, 0, 0), s = aob_vec_cross(n, t);
    double open = 0, all = 0;
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < STEPS; k++) {
            double theta = M_PI / 2 * (i + 0.5) / RINGS, phi = 2 * M_PI * (k + 0.5) / STEPS;
            struct aob_vec3 l =
                aob_vec_add(aob_vec_scale(n, cos(theta)),
                            aob_vec_scale(aob_vec_add(aob_vec_scale(t, cos(phi)), aob_vec_scale(s, sin(phi))),
                                          sin(theta)));
            double weight = ggx_lobe(n, v, l, alpha) * sin(theta);
            all += weight;
            open += is_blocked(p, n, l, radius) ? 0 : weight;
        }
    return open / all;
}

static void corners_have_the_quadrature(void **state)
{
    (void)state;
    static const double roughness[] = {0.2, 0.4, 0.6, 1};
    const double radius = 1;
    struct shot shot;
    slanted_corner_shot(&shot, 7, 5);
    for (size_t r = 0; r < AOB_COUNT(roughness); r++) {
        struct aob_specular traced = specular_shot(
            &shot, (struct aob_specular_desc){.radius = radius, .roughness = roughness[r], .spp = 16384});
        double worst = 0, least = 1, most = 0;
        for (size_t i = 0; i < pixel_count(&shot); i += 2) {
            struct aob_vec3 p = pixel_point(&shot, i), v = aob_vec_normalize(aob_vec_sub(shot.camera.eye, p));
            if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
                continue;
            double wanted = quadrature(p, pixel_normal(p), v, roughness[r] * roughness[r], radius);
            worst = fmax(worst, fabs((double)traced.so[i] - wanted));
            least = fmin(least, wanted);
            most = fmax(most, wanted);
        }
        print_message("           roughness %g: %.3f..%.3f, worst error %.5f\n", roughness[r], least, most,
                      worst);
        assert_true(worst <= 0.004);
        assert_true(least < 0.6 && most > 0.9);
        aob_specular_finish(&traced);
    }
    finish_shot(&shot);
}

/* A smooth surface is a mirror: what its reflected ray meets or does not meet decides alone, but near the edge. */
static void smooth_surfaces_are_mirrors(void **state)
{
    (void)state;
    const double radius = 1;
    size_t blocked = 0, open = 0;
    struct shot shot;
    slanted_corner_shot(&shot, 96, 72);
    struct aob_specular traced =
        specular_shot(&shot, (struct aob_specular_desc){.radius = radius, .roughness = 0.05, .spp = 64});
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i), n = pixel_normal(p);
        struct aob_vec3 v = aob_vec_normalize(aob_vec_sub(shot.camera.eye, p));
        struct aob_vec3 l = aob_vec_sub(aob_vec_scale(n, 2 * aob_vec_dot(n, v)), v);
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE ||
            is_blocked(p, n, l, 0.9 * radius) != is_blocked(p, n, l, 1.1 * radius))
            continue;
        bool closed = is_blocked(p, n, l, radius);
        assert_near(traced.so[i], closed ? 0 : 1, 0.03);
        blocked += closed;
        open += !closed;
    }
    assert_true(blocked > 500 && open > 500);
    aob_specular_finish(&traced);
    finish_shot(&shot);
}

/* Each half of the picture has its own material, and is as if all were of that roughness. */
static void materials_have_their_own_roughness(void **state)
{
    (void)state;
    static const double roughness[2] = {0.2, 0.7};
    struct aob_mesh mesh = {0};
    struct shot shot;
    for (int k = 0; k < 2; k++) {
        struct aob_material material = aob_material_default;
        material.roughness = (float)roughness[k];
        aob_mesh_paint(&mesh, material);
        aob_mesh_add_quad(&mesh, k ? aob_vec(0, 0, 0) : aob_vec(-5, 0, 0), aob_vec(0, 0, 5),
                          aob_vec(5, 0, 0));
        aob_mesh_add_quad(&mesh, k ? aob_vec(0, 0, 0) : aob_vec(-5, 0, 0), aob_vec(5, 0, 0),
                          aob_vec(0, 5, 0));
    }
    cast_shot(&shot, &mesh, (struct aob_camera){.eye = {0.2, 1, 2}, .target = {0, 0.3, 0}, .fov_deg = 60}, 64,
              48);
    struct aob_specular own =
        specular_shot(&shot, (struct aob_specular_desc){.radius = 1, .roughness = -1, .spp = 64});
    for (int k = 0; k < 2; k++) {
        struct aob_specular all = specular_shot(
            &shot,
            (struct aob_specular_desc){.radius = 1, .roughness = (double)(float)roughness[k], .spp = 64});
        size_t same = 0, other = 0;
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            bool here = (pixel_point(&shot, i).x > 0) == (k == 1);
            if (here)
                assert_true(own.so[i] == all.so[i] && own.se[i] == all.se[i]);
            same += here;
            other += !here && own.so[i] != all.so[i];
        }
        assert_true(same > 500 && other > 100);
        aob_specular_finish(&all);
    }
    aob_specular_finish(&own);
    finish_shot(&shot);
}

/* Cameras a millimetre above a plane, and along it; few directions, of which none may be above the surface. */
static void grazing_views_stay_within_bounds(void **state)
{
    (void)state;
    static const double roughness[] = {0, 0.5, 1};
    for (int spp = 2; spp <= 64; spp *= 32)
        for (size_t r = 0; r < AOB_COUNT(roughness); r++)
            for (int ortho = 0; ortho < 2; ortho++) {
                const struct aob_scene_info *scene = aob_scene_find("spheres");
                struct aob_mesh mesh = {0};
                struct shot shot;
                scene->build(&mesh);
                struct aob_camera camera = {.eye = {0, 1e-3, 3}, .target = {0, 1e-3, 0}, .fov_deg = 60};
                if (ortho)
                    camera = (struct aob_camera){.eye = {0, 1e-4, 3}, .target = {0, 0, 0}, .ortho_height = 1};
                cast_shot(&shot, &mesh, camera, 96, 54);
                struct aob_specular traced = specular_shot(
                    &shot, (struct aob_specular_desc){.radius = 1, .roughness = roughness[r], .spp = spp});
                for (size_t i = 0; i < pixel_count(&shot); i++)
                    assert_true(traced.so[i] >= 0 && traced.so[i] <= 1 && traced.se[i] >= 0 &&
                                traced.se[i] <= 0.5f);
                aob_specular_finish(&traced);
                finish_shot(&shot);
            }
}

static void standard_errors_are_honest(void **state)
{
    (void)state;
    enum { SEEDS = 16 };
    struct shot shot;
    slanted_corner_shot(&shot, 64, 48);
    struct aob_specular_desc desc = {.radius = 1, .roughness = 0.5, .spp = 4096};
    struct aob_specular fine = specular_shot(&shot, desc);
    double square = 0, claimed = 0, bias = 0, values = SEEDS * (double)pixel_count(&shot);
    desc.spp = 64;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        desc.seed = seed;
        struct aob_specular traced = specular_shot(&shot, desc);
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            double off = (double)traced.so[i] - (double)fine.so[i];
            square += off * off;
            bias += off;
            claimed += (double)traced.se[i] * (double)traced.se[i];
        }
        aob_specular_finish(&traced);
    }
    double spread = sqrt(square / values), se = sqrt(claimed / values);
    print_message("           spread %.5f, se %.5f, mean off by %+.6f\n", spread, se, bias / values);
    assert_true(spread < 1.5 * se && se < 1.5 * spread);
    assert_true(fabs(bias / values) <= 5e-4);
    aob_specular_finish(&fine);
    finish_shot(&shot);
}

static void neither_threads_nor_the_part_show(void **state)
{
    (void)state;
    struct shot shot;
    slanted_corner_shot(&shot, 64, 36);
    struct aob_specular_desc desc = {.radius = 1, .roughness = 0.4, .spp = 66};
    int before = omp_get_max_threads();
    omp_set_num_threads(1);
    struct aob_specular one = specular_shot(&shot, desc);
    omp_set_num_threads(3);
    struct aob_specular many = specular_shot(&shot, desc);
    omp_set_num_threads(before);
    assert_memory_equal(one.so, many.so, pixel_count(&shot) * sizeof *one.so);
    assert_memory_equal(one.se, many.se, pixel_count(&shot) * sizeof *one.se);
    desc.x0 = 5, desc.y0 = 20, desc.width = 30, desc.height = 11;
    struct aob_specular part = specular_shot(&shot, desc);
    for (int y = 0; y < desc.height; y++)
        assert_memory_equal(&part.so[y * desc.width], &one.so[(y + desc.y0) * 64 + desc.x0],
                            (size_t)desc.width * sizeof *one.so);
    aob_specular_finish(&one);
    aob_specular_finish(&many);
    aob_specular_finish(&part);
    finish_shot(&shot);
}

static void bad_requests_are_refused(void **state)
{
    (void)state;
    static const struct {
        struct aob_specular_desc desc;
        const char *line;
    } bad[] = {
        {{.spp = 64}, "specular occlusion: radius 0: must be above 0"},
        {{.radius = 1, .roughness = 1.5, .spp = 64}, "specular occlusion: roughness 1.5: must be at most 1"},
        {{.radius = 1, .roughness = NAN, .spp = 64}, "specular occlusion: roughness nan: must be at most 1"},
        {{.radius = 1, .spp = 3}, "specular occlusion: 3 rays a pixel: must be even, 2 to 65536"},
        {{.radius = 1, .spp = 2, .x0 = 9, .width = 8, .height = 2},
         "specular occlusion: part 8x2 at (9, 0) is not within the image of 16x9"},
    };
    struct shot shot;
    corner_shot(&shot, "front", 16, 9);
    for (size_t i = 0; i < AOB_COUNT(bad); i++) {
        struct aob_error error = {""};
        struct aob_specular specular = {0};
        assert_false(
            aob_tracer_specular(shot.tracer, &shot.camera, &shot.hits, &bad[i].desc, &specular, &error));
        assert_string_equal(error.text, bad[i].line);
        assert_null(specular.so);
    }
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(open_planes_are_one),
        cmocka_unit_test(corners_have_the_quadrature),
        cmocka_unit_test(smooth_surfaces_are_mirrors),
        cmocka_unit_test(materials_have_their_own_roughness),
        cmocka_unit_test(grazing_views_stay_within_bounds),
        cmocka_unit_test(standard_errors_are_honest),
        cmocka_unit_test(neither_threads_nor_the_part_show),
        cmocka_unit_test(bad_requests_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
