/* The radiance that a rough mirror reflects, against a quadrature over a GGX of the test's own. */
#include "incident_shot.h"
#include "specular_shot.h"
#include "reference/oracle.h"

/* A point, how it is seen, and the light on it. */
struct place {
    struct aob_vec3 p, n, v;
    double alpha, radius; /* radius 0: nothing blocks */
    const struct aob_light *light;
    const float *albedo; /* of the other plane of the corner; NULL: black */
};

/* What comes from `l`: of the corner's other plane, what is open of it at the height where it is met. */
static void light_from(const struct place *place, struct aob_vec3 l, double rgb[3])
{
    bool on_floor = place->n.y > 0.5;
    double distance = on_floor ? place->p.z : place->p.y, towards = on_floor ? -l.z : -l.y;
    aob_light_radiance(place->light, l, rgb);
    if (place->radius == 0 || !is_blocked(place->p, place->n, l, place->radius))
        return;
    double height = distance / towards * (on_floor ? l.y : l.z);
    for (int c = 0; c < 3; c++)
        rgb[c] = place->albedo ? (double)place->albedo[c] * aob_oracle_corner(height, place->radius) : 0;
}

static void quadrature(const struct place *place, double sum[3])
{
    enum { RINGS = 600, STEPS = 1200 };
    const double cell = M_PI / 2 / RINGS * 2 * M_PI / STEPS;
    struct aob_vec3 t = aob_vec_normalize(aob_vec_cross(place->n, aob_vec(0.3, 0.2, 1))),
                    s = aob_vec_cross(place->n, t);
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < STEPS; k++) {
            double theta = M_PI / 2 * (i + 0.5) / RINGS, phi = 2 * M_PI * (k + 0.5) / STEPS, rgb[3];
            struct aob_vec3 across = aob_vec_add(aob_vec_scale(t, cos(phi)), aob_vec_scale(s, sin(phi)));
            struct aob_vec3 l =
                aob_vec_add(aob_vec_scale(place->n, cos(theta)), aob_vec_scale(across, sin(theta)));
            double weight = ggx_lobe(place->n, place->v, l, place->alpha) * sin(theta) * cell;
            light_from(place, l, rgb);
            for (int c = 0; c < 3; c++)
                sum[c] += weight * rgb[c];
        }
}

/* The worst error of the pixels 3, 10, 17 and so on. `place` says all but where they are. */
static double worst_error(const struct shot *shot, const struct aob_specular *traced, struct place place,
                          bool corner, const float *const albedo[2])
{
    double worst = 0;
    for (size_t i = 3; i < pixel_count(shot); i += 7) {
        double wanted[3];
        if (shot->hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        place.p = pixel_point(shot, i);
        place.v = aob_vec_normalize(aob_vec_sub(shot->camera.eye, place.p));
        if (corner)
            place.n = pixel_normal(place.p);
        place.albedo = albedo ? albedo[place.n.y > 0.5] : NULL;
        quadrature(&place, wanted);
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs((double)traced->rgb[i][c] - wanted[c]));
    }
    return worst;
}

static const double roughness[] = {0.2, 0.5, 1};

static void open_planes_reflect_the_light(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct shot shot;
    aob_mesh_add_quad(&mesh, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
    cast_shot(&shot, &mesh, (struct aob_camera){.eye = {1, 1, 3}, .fov_deg = 20}, 5, 3);
    for (size_t r = 0; r < AOB_COUNT(roughness); r++) {
        struct aob_specular traced =
            specular_shot(&shot, (struct aob_specular_desc){.radius = 1,
                                                            .roughness = roughness[r],
                                                            .radiance = true,
                                                            .bounces = 8,
                                                            .light = slanted_light(),
                                                            .spp = 16384});
        struct place place = {.n = {0, 1, 0}, .alpha = roughness[r] * roughness[r], .light = slanted_light()};
        double worst = worst_error(&shot, &traced, place, false, NULL);
        print_message("           roughness %g: worst error %.5f\n", roughness[r], worst);
        assert_true(worst <= 0.002);
        aob_specular_finish(&traced);
    }
    finish_shot(&shot);
}

static void corners_reflect_what_blocks(void **state)
{
    (void)state;
    static const float floor_colour[3] = {1, 0.8f, 0.6f}, wall_colour[3] = {0.9f, 0.2f, 0.05f};
    static const float *const albedo[2] = {floor_colour, wall_colour};
    struct aob_mesh mesh = {0};
    struct shot shot;
    paint(&mesh, floor_colour[0], floor_colour[1], floor_colour[2]);
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(0, 0, 20), aob_vec(40, 0, 0));
    paint(&mesh, wall_colour[0], wall_colour[1], wall_colour[2]);
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(40, 0, 0), aob_vec(0, 20, 0));
    cast_shot(&shot, &mesh,
              (struct aob_camera){.eye = {1.5, 0.9, 1.2}, .target = {0, 0.2, 0.2}, .fov_deg = 60}, 9, 7);
    for (int bounces = 0; bounces < 2; bounces++)
        for (size_t r = 0; r < AOB_COUNT(roughness); r++) {
            struct aob_specular traced =
                specular_shot(&shot, (struct aob_specular_desc){.radius = 1,
                                                                .roughness = roughness[r],
                                                                .radiance = true,
                                                                .bounces = bounces,
                                                                .spp = 16384});
            struct place place = {
                .alpha = roughness[r] * roughness[r], .radius = 1, .light = &aob_light_uniform};
            double worst = worst_error(&shot, &traced, place, true, bounces ? albedo : NULL);
            print_message("           %d bounces, roughness %g: worst error %.5f\n", bounces, roughness[r],
                          worst);
            assert_true(worst <= 0.006);
            aob_specular_finish(&traced);
        }
    finish_shot(&shot);
}

/* A white room under even light looks as if it were not there. */
static void white_rooms_reflect_as_if_open(void **state)
{
    (void)state;
    static const float white[3] = {1, 1, 1};
    struct shot shot;
    room_shot(&shot, white);
    struct aob_specular_desc desc = {
        .radius = 1, .roughness = 0.5, .radiance = true, .bounces = AOB_MOST_BOUNCES, .spp = 64};
    struct aob_specular room = specular_shot(&shot, desc);
    desc.radius = 1e-6;
    struct aob_specular open = specular_shot(&shot, desc);
    double least = 1;
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        assert_near(room.rgb[i][0], open.rgb[i][0], 1e-4);
        assert_true(open.rgb[i][0] <= 1 && open.rgb[i][0] > 0.8f);
        least = fmin(least, (double)room.so[i]);
    }
    assert_true(least < 0.5);
    aob_specular_finish(&room);
    aob_specular_finish(&open);
    finish_shot(&shot);
}

/* What does not ask for the radiance gets none, and the occlusion is the same. */
static void asking_changes_nothing(void **state)
{
    (void)state;
    struct shot shot;
    corner_shot(&shot, "front", 64, 36);
    struct aob_specular_desc desc = {.radius = 1, .roughness = 0.4, .bounces = 99, .spp = 64};
    struct aob_specular without = specular_shot(&shot, desc);
    desc.radiance = true;
    desc.bounces = 8;
    struct aob_specular with = specular_shot(&shot, desc);
    assert_null(without.rgb);
    assert_null(without.rgb_se);
    assert_memory_equal(with.so, without.so, pixel_count(&shot) * sizeof *with.so);
    assert_memory_equal(with.se, without.se, pixel_count(&shot) * sizeof *with.se);
    for (size_t i = 0; i < pixel_count(&shot); i++)
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
            assert_true(with.rgb[i][0] == 0 && with.rgb_se[i][0] == 0);
    aob_specular_finish(&with);
    aob_specular_finish(&without);
    struct aob_error error = {""};
    desc.bounces = 99;
    assert_false(aob_tracer_specular(shot.tracer, &shot.camera, &shot.hits, &desc, &with, &error));
    assert_string_equal(error.text, "specular occlusion: 99 bounces: must be 0 to 64");
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(open_planes_reflect_the_light),
        cmocka_unit_test(corners_reflect_what_blocks),
        cmocka_unit_test(white_rooms_reflect_as_if_open),
        cmocka_unit_test(asking_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
