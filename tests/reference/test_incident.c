/* Incident light where it is known without a bounce: beside the visibility, on open planes, in closed rooms; its standard
 * error; what is refused. */
#include "incident_shot.h"
#include <omp.h>

/* The first rays are those of the visibility, so this holds pixel by pixel. */
static void check_visibility(const struct shot *shot, double radius)
{
    struct aob_incident light =
        light_shot(shot, (struct aob_incident_desc){.radius = radius, .spp = 256, .seed = 7});
    for (size_t i = 0; i < pixel_count(shot); i++)
        for (int c = 0; c < 3; c++) {
            bool sky = shot->hits.primitive[i] == AOB_NO_PRIMITIVE;
            assert_near(light.rgb[i][c], sky ? 0 : shot->visibility[0].ao[i], 1e-6);
            assert_near(light.se[i][c], shot->visibility[0].se[i], 1e-6);
        }
    aob_incident_finish(&light);
}

static void without_bounces_it_is_visibility(void **state)
{
    (void)state;
    static const double radii[] = {0.3, 1, INFINITY};
    static const char *const scenes[] = {"corner", "spheres"};
    for (size_t s = 0; s < AOB_COUNT(scenes); s++)
        for (size_t r = 0; r < AOB_COUNT(radii); r++) {
            const struct aob_scene_info *scene = aob_scene_find(scenes[s]);
            struct aob_mesh mesh = {0};
            struct shot shot;
            scene->build(&mesh);
            cast_shot(&shot, &mesh, scene->views[0].camera, 96, 54);
            trace_shot(&shot, &(struct aob_visibility_term){.radius = radii[r]}, 1, 256);
            check_visibility(&shot, radii[r]);
            finish_shot(&shot);
        }
}

static void plane_shot(struct shot *shot, struct aob_vec3 n)
{
    struct aob_vec3 u = aob_vec_normalize(aob_vec_cross(aob_vec(0.3, 1, 0.2), n)), v = aob_vec_cross(n, u);
    struct aob_vec3 corner = aob_vec_scale(aob_vec_add(u, v), -20);
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, corner, aob_vec_scale(u, 40), aob_vec_scale(v, 40));
    struct aob_vec3 eye = aob_vec_add(aob_vec_scale(n, 4), u);
    cast_shot(shot, &mesh, (struct aob_camera){.eye = eye, .fov_deg = 60}, 40, 24);
}

static void open_planes_have_the_closed_form(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        double tilt = i * 16 * M_PI / 180, turn = i * 67 * M_PI / 180, wanted[3];
        struct aob_vec3 n = aob_vec(sin(tilt) * cos(turn), cos(tilt), sin(tilt) * sin(turn));
        struct shot shot;
        plane_shot(&shot, n);
        struct aob_incident plain =
            light_shot(&shot, (struct aob_incident_desc){.radius = INFINITY, .bounces = 8, .spp = 16});
        struct aob_incident light = light_shot(
            &shot,
            (struct aob_incident_desc){.radius = 2, .bounces = 8, .light = slanted_light(), .spp = 256});
        struct light_mean mean = mean_light(&shot, &light, NULL);
        aob_light_irradiance(slanted_light(), n, wanted);
        assert_true(mean.pixels == pixel_count(&shot));
        for (int c = 0; c < 3; c++) {
            for (size_t p = 0; p < pixel_count(&shot); p++) {
                assert_true(plain.rgb[p][c] == 1 && plain.se[p][c] == 0);
                assert_near(light.rgb[p][c], wanted[c], 6 * mean.se[c] + 1e-6);
            }
            assert_near(mean.rgb[c], wanted[c], 4 * mean.se[c] / sqrt(mean.pixels) + 1e-6);
            assert_true(mean.se[c] < 0.01);
        }
        aob_incident_finish(&plain);
        aob_incident_finish(&light);
        finish_shot(&shot);
    }
}

/* The light that is lost after 8 reflections is that of nine blocked rays in a row. */
static void white_rooms_keep_their_light(void **state)
{
    (void)state;
    static const double radii[] = {0.5, 1, 1.5};
    static const double colour[3] = {0.4, 1, 2.5};
    static const float white[3] = {1, 1, 1};
    struct aob_light light = {{{0}}};
    struct shot shot;
    for (int c = 0; c < 3; c++)
        light.sh[0][c] = colour[c] / (0.5 / sqrt(M_PI));
    room_shot(&shot, white);
    for (size_t r = 0; r < AOB_COUNT(radii); r++) {
        struct aob_incident_desc desc = {.radius = radii[r], .bounces = 8, .light = &light, .spp = 256};
        struct aob_incident eight = light_shot(&shot, desc);
        desc.bounces = AOB_MOST_BOUNCES;
        struct aob_incident all = light_shot(&shot, desc);
        struct light_mean mean = mean_light(&shot, &eight, NULL);
        print_message("           r %g: 8 bounces keep %.5f of the light\n", radii[r],
                      mean.rgb[0] / colour[0]);
        for (int c = 0; c < 3; c++) {
            assert_true(mean.rgb[c] <= colour[c] * (1 + 1e-6) && mean.rgb[c] >= 0.99 * colour[c]);
            for (size_t i = 0; i < pixel_count(&shot); i++)
                assert_near(all.rgb[i][c], colour[c], 1e-5 * colour[c]);
        }
        aob_incident_finish(&eight);
        aob_incident_finish(&all);
    }
    finish_shot(&shot);
}

/* Nothing leaks through an edge or a wall, however often it is reflected. */
static void closed_rooms_are_dark(void **state)
{
    (void)state;
    static const float white[3] = {1, 1, 1}, grey[3] = {0.5f, 0.5f, 0.5f};
    for (int w = 0; w < 2; w++) {
        struct shot shot;
        room_shot(&shot, w ? white : grey);
        struct aob_incident dark = light_shot(
            &shot, (struct aob_incident_desc){
                       .radius = INFINITY, .bounces = AOB_MOST_BOUNCES, .light = slanted_light(), .spp = 64});
        for (size_t i = 0; i < pixel_count(&shot); i++)
            for (int c = 0; c < 3; c++)
                assert_true(dark.rgb[i][c] == 0 && dark.se[i][c] == 0);
        aob_incident_finish(&dark);
        finish_shot(&shot);
    }
}

static void black_walls_and_metal_reflect_nothing(void **state)
{
    (void)state;
    for (int metal = 0; metal < 2; metal++) {
        struct aob_mesh mesh = {0};
        struct shot shot;
        struct aob_material made = {.roughness = 1};
        if (metal)
            made = (struct aob_material){{0.9f, 0.8f, 0.7f}, 0.3f, 1};
        aob_mesh_paint(&mesh, made);
        aob_mesh_add_box(&mesh, aob_vec(-2, -2, -2), aob_vec(2, 2, 2), 0);
        cast_shot(&shot, &mesh,
                  (struct aob_camera){.eye = {1, 1, 1}, .target = {-2, -2, -1.5}, .fov_deg = 90}, 48, 32);
        trace_shot(&shot, &(struct aob_visibility_term){.radius = 1}, 1, 256);
        struct aob_incident light =
            light_shot(&shot, (struct aob_incident_desc){.radius = 1, .bounces = 8, .spp = 256, .seed = 7});
        for (size_t i = 0; i < pixel_count(&shot); i++)
            for (int c = 0; c < 3; c++)
                assert_near(light.rgb[i][c], shot.visibility[0].ao[i], 1e-6);
        aob_incident_finish(&light);
        finish_shot(&shot);
    }
}

/* Sixteen seeds spread as the standard error says, and their mean is that of many more rays. */
static void standard_errors_are_honest(void **state)
{
    (void)state;
    enum { SEEDS = 16 };
    struct shot shot;
    corner_shot(&shot, "front", 64, 36);
    struct aob_incident_desc desc = {.radius = 1, .bounces = 8, .light = slanted_light(), .spp = 4096};
    struct aob_incident fine = light_shot(&shot, desc);
    double square[3] = {0}, claimed[3] = {0}, bias[3] = {0};
    desc.spp = 64;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        desc.seed = seed;
        struct aob_incident light = light_shot(&shot, desc);
        for (size_t i = 0; i < pixel_count(&shot); i++)
            for (int c = 0; c < 3; c++) {
                double off = (double)light.rgb[i][c] - (double)fine.rgb[i][c];
                square[c] += off * off;
                bias[c] += off;
                claimed[c] += (double)light.se[i][c] * (double)light.se[i][c];
            }
        aob_incident_finish(&light);
    }
    double values = SEEDS * (double)pixel_count(&shot);
    for (int c = 0; c < 3; c++) {
        double spread = sqrt(square[c] / values), se = sqrt(claimed[c] / values);
        print_message("           channel %d: spread %.5f, se %.5f, mean off by %+.6f\n", c, spread, se,
                      bias[c] / values);
        assert_true(spread < 1.5 * se && se < 1.5 * spread);
        assert_true(fabs(bias[c] / values) <= 4 * se / sqrt(values) * 1.5);
    }
    aob_incident_finish(&fine);
    finish_shot(&shot);
}

static void neither_threads_nor_the_part_show(void **state)
{
    (void)state;
    struct shot shot;
    corner_shot(&shot, "front", 64, 36);
    struct aob_incident_desc desc = {.radius = 1, .bounces = 8, .light = slanted_light(), .spp = 66};
    int before = omp_get_max_threads();
    omp_set_num_threads(1);
    struct aob_incident one = light_shot(&shot, desc);
    omp_set_num_threads(3);
    struct aob_incident many = light_shot(&shot, desc);
    omp_set_num_threads(before);
    assert_memory_equal(one.rgb, many.rgb, pixel_count(&shot) * sizeof *one.rgb);
    assert_memory_equal(one.se, many.se, pixel_count(&shot) * sizeof *one.se);
    desc.x0 = 5, desc.y0 = 20, desc.width = 30, desc.height = 11;
    struct aob_incident part = light_shot(&shot, desc);
    for (int y = 0; y < desc.height; y++)
        assert_memory_equal(part.rgb[y * desc.width], one.rgb[(y + desc.y0) * 64 + desc.x0],
                            (size_t)desc.width * sizeof *one.rgb);
    aob_incident_finish(&one);
    aob_incident_finish(&many);
    aob_incident_finish(&part);
    finish_shot(&shot);
}

static void bad_requests_are_refused(void **state)
{
    (void)state;
    struct aob_light broken = *slanted_light();
    struct shot shot;
    broken.sh[4][1] = NAN;
    const struct {
        struct aob_incident_desc desc;
        const char *line;
    } bad[] = {
        {{.spp = 64}, "incident light: radius 0: must be above 0"},
        {{.radius = NAN, .spp = 64}, "incident light: radius nan: must be above 0"},
        {{.radius = 1, .bounces = 65, .spp = 64}, "incident light: 65 bounces: must be 0 to 64"},
        {{.radius = 1, .bounces = -1, .spp = 64}, "incident light: -1 bounces: must be 0 to 64"},
        {{.radius = 1, .spp = 3}, "incident light: 3 rays a pixel: must be even, 2 to 65536"},
        {{.radius = 1, .spp = 65538}, "incident light: 65538 rays a pixel: must be even, 2 to 65536"},
        {{.radius = 1, .spp = 2, .light = &broken},
         "incident light: coefficient 4 of channel 1 is not finite"},
        {{.radius = 1, .spp = 2, .x0 = 9, .width = 8, .height = 2},
         "incident light: part 8x2 at (9, 0) is not within the image of 16x9"},
    };
    corner_shot(&shot, "front", 16, 9);
    for (size_t i = 0; i < AOB_COUNT(bad); i++) {
        struct aob_error error = {""};
        struct aob_incident incident = {0};
        assert_false(
            aob_tracer_incident(shot.tracer, &shot.camera, &shot.hits, &bad[i].desc, &incident, &error));
        assert_string_equal(error.text, bad[i].line);
        assert_null(incident.rgb);
    }
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_bounces_it_is_visibility),
        cmocka_unit_test(open_planes_have_the_closed_form),
        cmocka_unit_test(white_rooms_keep_their_light),
        cmocka_unit_test(closed_rooms_are_dark),
        cmocka_unit_test(black_walls_and_metal_reflect_nothing),
        cmocka_unit_test(standard_errors_are_honest),
        cmocka_unit_test(neither_threads_nor_the_part_show),
        cmocka_unit_test(bad_requests_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
