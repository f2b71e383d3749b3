/* The truth of the lit image: Fresnel's factor against a quadrature, and the sum against its parts. */
#include "incident_shot.h"
#include "reference/lit.h"
#include "specular_shot.h"

static const struct aob_material copper = {
    .base_colour = {0.9f, 0.5f, 0.2f}, .roughness = 0.5f, .metalness = 1};
static const struct aob_material lacquer = {
    .base_colour = {0.3f, 0.1f, 0.6f}, .roughness = 0.4f, .metalness = 0.25f};

static void floor_shot(struct shot *shot, struct aob_material material, int width, int height)
{
    struct aob_mesh mesh = {0};
    aob_mesh_paint(&mesh, material);
    aob_mesh_add_quad(&mesh, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
    cast_shot(shot, &mesh, (struct aob_camera){.eye = {0.2, 0.8, 2}, .target = {0, 0.1, 0}, .fov_deg = 60},
              width, height);
}

/* L f cos over the hemisphere above a floor, Schlick's factor in it. */
static void quadrature(struct aob_vec3 v, struct aob_material material, double rgb[3])
{
    enum { RINGS = 400, STEPS = 800 };
    double alpha = (double)material.roughness * (double)material.roughness;
    for (int c = 0; c < 3; c++)
        rgb[c] = 0;
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < STEPS; k++) {
            double theta = M_PI / 2 * (i + 0.5) / RINGS, phi = 2 * M_PI * (k + 0.5) / STEPS, light[3];
            struct aob_vec3 l = {sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi)};
            double area = M_PI / 2 / RINGS * (2 * M_PI / STEPS) * sin(theta);
            double edge = pow(1 - aob_vec_dot(aob_vec_normalize(aob_vec_add(v, l)), v), 5);
            aob_light_radiance(slanted_light(), l, light);
            for (int c = 0; c < 3; c++) {
                double metal = (double)material.metalness, base = (double)material.base_colour[c];
                double f0 = (1 - metal) * 0.04 + metal * base;
                rgb[c] += light[c] * (f0 + (1 - f0) * edge) * ggx_lobe(aob_vec(0, 1, 0), v, l, alpha) * area;
            }
        }
}

static void check_floor(struct aob_material material)
{
    struct shot shot;
    floor_shot(&shot, material, 6, 5);
    struct aob_specular mirrored = specular_shot(&shot, (struct aob_specular_desc){.radius = 1,
                                                                                   .roughness = -1,
                                                                                   .radiance = true,
                                                                                   .fresnel = true,
                                                                                   .light = slanted_light(),
                                                                                   .spp = 16384});
    double worst = 0, least = 1e9, most = 0;
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        double rgb[3];
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        quadrature(aob_vec_normalize(aob_vec_sub(shot.camera.eye, pixel_point(&shot, i))), material, rgb);
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs((double)mirrored.rgb[i][c] - rgb[c]) / rgb[c]);
        least = fmin(least, rgb[0]);
        most = fmax(most, rgb[0]);
    }
    print_message("           metalness %g: red %.4f..%.4f, worst error %.4f of it\n",
                  (double)material.metalness, least, most, worst);
    assert_true(worst < 0.006);
    assert_true(most > 1.1 * least);
    aob_specular_finish(&mirrored);
    finish_shot(&shot);
}

static void floors_have_the_quadrature(void **state)
{
    (void)state;
    check_floor(copper);
    check_floor(lacquer);
}

/* A white metal reflects all at every angle, so the factor is 1. */
static void white_metal_has_no_fresnel(void **state)
{
    (void)state;
    struct shot shot;
    struct aob_specular_desc desc = {
        .radius = 1, .roughness = -1, .radiance = true, .light = slanted_light(), .spp = 64};
    floor_shot(&shot, (struct aob_material){{1, 1, 1}, 0.3f, 1}, 16, 9);
    struct aob_specular without = specular_shot(&shot, desc);
    desc.fresnel = true;
    struct aob_specular with = specular_shot(&shot, desc);
    for (size_t i = 0; i < 3 * pixel_count(&shot); i++)
        assert_near(with.rgb[i / 3][i % 3], without.rgb[i / 3][i % 3], 1e-6);
    aob_specular_finish(&without);
    aob_specular_finish(&with);
    finish_shot(&shot);
}

enum { WIDTH = 40, HEIGHT = 30, LEFT = 5, TOP = 3, CUT_WIDTH = 31, CUT_HEIGHT = 22 };

static void corner_of_two(struct shot *shot)
{
    struct aob_mesh mesh = {0};
    aob_mesh_paint(&mesh, copper);
    aob_mesh_add_quad(&mesh, aob_vec(-3, 0, 0), aob_vec(0, 0, 3), aob_vec(6, 0, 0));
    aob_mesh_paint(&mesh, lacquer);
    aob_mesh_add_quad(&mesh, aob_vec(-3, 0, 0), aob_vec(6, 0, 0), aob_vec(0, 1, 0));
    cast_shot(shot, &mesh, (struct aob_camera){.eye = {0.4, 1, 2.4}, .target = {0, 0.5, 0}, .fov_deg = 60},
              WIDTH, HEIGHT);
}

static struct aob_incident_desc cut_desc(void)
{
    return (struct aob_incident_desc){.radius = 0.8,
                                      .bounces = 3,
                                      .light = slanted_light(),
                                      .x0 = LEFT,
                                      .y0 = TOP,
                                      .width = CUT_WIDTH,
                                      .height = CUT_HEIGHT,
                                      .spp = 64,
                                      .seed = 5};
}

/* The two parts, as they are traced alone. */
static struct aob_specular mirrored_alone(const struct shot *shot)
{
    const struct aob_incident_desc desc = cut_desc();
    return specular_shot(shot, (struct aob_specular_desc){.radius = desc.radius,
                                                          .roughness = -1,
                                                          .radiance = true,
                                                          .fresnel = true,
                                                          .bounces = desc.bounces,
                                                          .light = desc.light,
                                                          .x0 = desc.x0,
                                                          .y0 = desc.y0,
                                                          .width = desc.width,
                                                          .height = desc.height,
                                                          .spp = desc.spp,
                                                          .seed = desc.seed ^ 0x9e3779b9u});
}

static void the_sum_is_that_of_its_parts(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_incident_desc desc = cut_desc();
    struct aob_incident lit;
    struct shot shot;
    int seen[3] = {0, 0, 0};
    corner_of_two(&shot);
    struct aob_incident diffuse = light_shot(&shot, desc);
    struct aob_specular mirrored = mirrored_alone(&shot);
    assert_true(aob_tracer_lit(shot.tracer, &shot.camera, &shot.hits, &desc, &lit, &error));
    for (size_t i = 0; i < CUT_WIDTH * CUT_HEIGHT; i++) {
        size_t pixel = (i / CUT_WIDTH + TOP) * WIDTH + i % CUT_WIDTH + LEFT;
        uint32_t triangle = shot.hits.primitive[pixel];
        bool sky = triangle == AOB_NO_PRIMITIVE;
        struct aob_vec3 p = pixel_point(&shot, pixel);
        const struct aob_material *m = !sky && p.y < p.z ? &copper : &lacquer;
        seen[sky ? 2 : m == &lacquer]++;
        for (int c = 0; c < 3; c++) {
            double share = (1 - (double)m->metalness) * (double)m->base_colour[c];
            double sum = sky ? 0 : share * (double)diffuse.rgb[i][c] + (double)mirrored.rgb[i][c];
            double se = sky ? 0 : hypot(share * (double)diffuse.se[i][c], (double)mirrored.rgb_se[i][c]);
            assert_near(lit.rgb[i][c], sum, 2e-6);
            assert_near(lit.se[i][c], se, 2e-6);
        }
    }
    assert_true(seen[0] > 50 && seen[1] > 50 && seen[2] > 50);
    aob_incident_finish(&lit);
    aob_incident_finish(&diffuse);
    aob_specular_finish(&mirrored);
    finish_shot(&shot);
}

/* The standard error is that of the image over many seeds, so the two parts err apart. */
static void the_standard_error_is_that_of_many_seeds(void **state)
{
    enum { SEEDS = 60, SIDE = 12, PIXELS = SIDE * SIDE };
    static double sum[PIXELS], square[PIXELS];
    struct shot shot;
    double variance = 0, stated = 0;
    (void)state;
    floor_shot(&shot, (struct aob_material){{0.5f, 0.5f, 0.5f}, 0.2f, 0.5f}, SIDE, SIDE);
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        struct aob_incident lit;
        const struct aob_incident_desc desc = {
            .radius = 1, .light = slanted_light(), .spp = 16, .seed = 1000 * seed};
        assert_true(aob_tracer_lit(shot.tracer, &shot.camera, &shot.hits, &desc, &lit, NULL));
        for (size_t i = 0; i < PIXELS; i++) {
            sum[i] += (double)lit.rgb[i][2];
            square[i] += (double)lit.rgb[i][2] * (double)lit.rgb[i][2];
            stated += (double)lit.se[i][2] * (double)lit.se[i][2] / SEEDS;
        }
        aob_incident_finish(&lit);
    }
    for (size_t i = 0; i < PIXELS; i++)
        variance += (square[i] - sum[i] * sum[i] / SEEDS) / (SEEDS - 1);
    print_message("           variance %.4f of what is stated\n", variance / stated);
    /* 144 pixels of 60 seeds: the quotient's own standard error is about .03. */
    assert_true(variance > 0.9 * stated && variance < 1.1 * stated);
    finish_shot(&shot);
}

static void bad_descriptions_are_refused(void **state)
{
    (void)state;
    struct shot shot;
    struct aob_incident lit;
    corner_of_two(&shot);
    for (int fault = 0; fault < 3; fault++) {
        struct aob_error error = {{0}};
        struct aob_incident_desc desc = cut_desc();
        desc.radius = fault == 0 ? 0 : desc.radius;
        desc.spp = fault == 1 ? 63 : desc.spp;
        desc.bounces = fault == 2 ? -1 : desc.bounces;
        assert_false(aob_tracer_lit(shot.tracer, &shot.camera, &shot.hits, &desc, &lit, &error));
        assert_true(*error.text);
    }
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floors_have_the_quadrature),
        cmocka_unit_test(white_metal_has_no_fresnel),
        cmocka_unit_test(the_sum_is_that_of_its_parts),
        cmocka_unit_test(the_standard_error_is_that_of_many_seeds),
        cmocka_unit_test(bad_descriptions_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
