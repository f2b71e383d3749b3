/* Distant light against quadrature, and against the radiances that it was projected from. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "scene/light.h"

static double draw(void)
{
    return 2 * drand48() - 1;
}

static struct aob_vec3 draw_direction(void)
{
    for (;;) {
        struct aob_vec3 d = aob_vec(draw(), draw(), draw());
        double length = aob_vec_length(d);
        if (length > 0.1 && length < 1)
            return aob_vec_scale(d, 1 / length);
    }
}

static struct aob_light draw_light(void)
{
    struct aob_light light;
    for (int i = 0; i < 27; i++)
        light.sh[i / 3][i % 3] = draw();
    return light;
}

/* The middle of each of 600 x 1200 cells about +Z, with its exact solid angle. */
enum { ROWS = 600, COLUMNS = 1200, CELLS = ROWS * COLUMNS };
static struct aob_vec3 cell(int i, double *angle)
{
    double polar = M_PI * (i / COLUMNS + 0.5) / ROWS, turn = 2 * M_PI * (i % COLUMNS + 0.5) / COLUMNS;
    *angle = 2 * sin(polar) * sin(M_PI / 2 / ROWS) * 2 * M_PI / COLUMNS;
    return aob_vec(sin(polar) * cos(turn), sin(polar) * sin(turn), cos(polar));
}

static void the_basis_is_orthonormal(void **state)
{
    (void)state;
    double sums[9][9] = {{0}};
    for (int i = 0; i < CELLS; i++) {
        double angle, basis[9];
        aob_light_basis(cell(i, &angle), basis);
        for (int a = 0; a < 9; a++)
            for (int b = 0; b < 9; b++)
                sums[a][b] += angle * basis[a] * basis[b];
    }
    for (int a = 0; a < 9; a++)
        for (int b = 0; b < 9; b++)
            assert_near(sums[a][b], a == b, 1e-4);
}

static void the_basis_has_positive_signs(void **state)
{
    (void)state;
    double basis[9];
    aob_light_basis(aob_vec(2.0 / 3, 1.0 / 3, 2.0 / 3), basis);
    for (int i = 0; i < 9; i++)
        assert_true(basis[i] > 0);
    assert_near(basis[1] * 2, basis[3], 1e-15);
    assert_near(basis[2], basis[3], 1e-15);
    assert_near(basis[4], basis[5], 1e-15);
    assert_near(basis[7], 2 * basis[5], 1e-15);
}

static void uniform_light_is_1_everywhere(void **state)
{
    (void)state;
    for (int i = 0; i < 100; i++) {
        struct aob_vec3 d = draw_direction();
        double radiance[3], irradiance[3];
        aob_light_radiance(&aob_light_uniform, d, radiance);
        aob_light_irradiance(&aob_light_uniform, d, irradiance);
        for (int c = 0; c < 3; c++) {
            assert_near(radiance[c], 1, 1e-15);
            assert_near(irradiance[c], 1, 1e-15);
        }
    }
}

static void irradiance_is_the_integral_over_the_hemisphere(void **state)
{
    (void)state;
    for (int trial = 0; trial < 3; trial++) {
        struct aob_light light = draw_light();
        struct aob_vec3 normal = draw_direction();
        double sums[3] = {0}, closed[3];
        for (int i = 0; i < CELLS; i++) {
            double angle, rgb[3];
            struct aob_vec3 d = cell(i, &angle);
            aob_light_radiance(&light, d, rgb);
            for (int c = 0; c < 3; c++)
                sums[c] += angle * fmax(0, aob_vec_dot(normal, d)) * rgb[c] / M_PI;
        }
        aob_light_irradiance(&light, normal, closed);
        for (int c = 0; c < 3; c++)
            assert_near(sums[c], closed[c], 1e-4);
    }
}

static void a_turned_light_is_the_same_light(void **state)
{
    (void)state;
    for (int trial = 0; trial < 50; trial++) {
        struct aob_light light = draw_light(), turned;
        struct aob_frame_axes axes = {.right = draw_direction()};
        axes.up = aob_vec_normalize(aob_vec_cross(axes.right, draw_direction()));
        axes.back = aob_vec_cross(axes.right, axes.up);
        aob_light_turn(&light, &axes, &turned);
        for (int i = 0; i < 20; i++) {
            struct aob_vec3 d = draw_direction();
            struct aob_vec3 world =
                aob_vec_add(aob_vec_scale(axes.right, d.x),
                            aob_vec_add(aob_vec_scale(axes.up, d.y), aob_vec_scale(axes.back, d.z)));
            double here[3], there[3];
            aob_light_radiance(&turned, d, here);
            aob_light_radiance(&light, world, there);
            for (int c = 0; c < 3; c++)
                assert_near(here[c], there[c], 1e-12);
        }
        aob_light_turn(&light, &axes, &light);
        assert_memory_equal(&light, &turned, sizeof light);
    }
}

static void the_least_radiance_is_found(void **state)
{
    (void)state;
    for (int trial = 0; trial < 20; trial++) {
        struct aob_light light = draw_light();
        if (trial % 4 == 0) /* no band 1, or about one axis */
            memset(light.sh[1], 0, (trial % 8 ? 8 : 3) * sizeof light.sh[1]);
        double seen[3] = {INFINITY, INFINITY, INFINITY}, angle, rgb[3];
        for (int i = 0; i < CELLS; i += 7) {
            aob_light_radiance(&light, cell(i, &angle), rgb);
            for (int c = 0; c < 3; c++)
                seen[c] = fmin(seen[c], rgb[c]);
        }
        for (int c = 0; c < 3; c++) {
            double least = aob_light_least(&light, c);
            assert_true(least <= seen[c] + 1e-12);
            assert_near(least, seen[c], 1e-3);
        }
    }
}

/* Against normals all over the sphere. */
static void the_exposure_is_that_of_the_brightest_normal(void **state)
{
    static const char *const names[] = {"uniform", "sky", "window"};
    (void)state;
    for (size_t l = 0; l < AOB_COUNT(names); l++) {
        struct aob_light_projection projection;
        double largest = 0, rgb[3];
        aob_light_make(aob_light_find(names[l]), &projection);
        for (int i = 0; i < 100000; i++) {
            double y = 1 - 2 * (i + 0.5) / 100000, r = sqrt(1 - y * y), a = 2.39996322972865332 * i;
            aob_light_irradiance(&projection.light, aob_vec(r * cos(a), y, r * sin(a)), rgb);
            largest = fmax(largest, fmax(rgb[0], fmax(rgb[1], rgb[2])));
        }
        double exposure = aob_light_exposure(&projection.light);
        assert_near(exposure * largest, 1, 2e-5);
        assert_true(exposure * largest <= 1 + 1e-9);
    }
    assert_near(aob_light_exposure(&aob_light_uniform), 1, 1e-12);
    assert_near(aob_light_exposure(&(struct aob_light){{{0}}}), 1, 0);
}

static void of_coefficients(void *user, struct aob_vec3 direction, double rgb[3])
{
    aob_light_radiance(user, direction, rgb);
}

static void nine_coefficients_come_back(void **state)
{
    (void)state;
    struct aob_light light = draw_light();
    struct aob_light_projection projection;
    for (int c = 0; c < 3; c++)
        light.sh[0][c] = 8;
    /* The second channel touches 0: (1 + x) / 2. */
    for (int i = 0; i < 9; i++)
        light.sh[i][1] = i == 0 ? sqrt(M_PI) : i == 3 ? sqrt(M_PI / 3) : 0;
    aob_light_project(of_coefficients, &light, &projection);
    for (int i = 0; i < 27; i++)
        assert_near(projection.light.sh[i / 3][i % 3], light.sh[i / 3][i % 3], 1e-11);
    assert_true(projection.factors[0] == 1 && projection.factors[1] == 1);
    assert_near(projection.held, 1, 1e-12);
}

static void check_not_negative(const struct aob_light *light)
{
    double angle, rgb[3];
    for (int i = 0; i < CELLS; i++) {
        aob_light_radiance(light, cell(i, &angle), rgb);
        for (int c = 0; c < 3; c++)
            if (!(rgb[c] >= -1e-12 * light->sh[0][c]) || !isfinite(rgb[c]))
                fail_msg("cell %d, channel %d: radiance %g", i, c, rgb[c]);
    }
}

static void named_lights_are_lights(void **state)
{
    (void)state;
    for (const struct aob_light_info *info = aob_lights; info->name; info++) {
        struct aob_light_projection projection, again;
        aob_light_make(info, &projection);
        aob_light_make(aob_light_find(info->name), &again);
        assert_memory_equal(&projection, &again, sizeof projection);
        check_not_negative(&projection.light);
        assert_true(projection.held > 0.1 && projection.held <= 1);
        assert_true(projection.factors[0] > 0 && projection.factors[0] <= 1);
        assert_near(projection.factors[1], pow(projection.factors[0], 3), 1e-12);
        double mean[3] = {0};
        for (int i = 0; i < CELLS; i++) {
            double angle, rgb[3];
            info->radiance(NULL, cell(i, &angle), rgb);
            for (int c = 0; c < 3; c++) {
                assert_true(isfinite(rgb[c]) && rgb[c] >= 0);
                mean[c] += angle * rgb[c] / (4 * M_PI);
            }
        }
        for (int c = 0; c < 3; c++)
            assert_near(projection.light.sh[0][c] / sqrt(4 * M_PI), mean[c], 3e-3 * mean[c]);
    }
    assert_null(aob_light_find("moon"));
}

static void the_window_is_where_its_title_says(void **state)
{
    (void)state;
    static const struct row {
        double across, up; /* degrees from -X */
        bool bright;
    } rows[] = {{0, 0, true},   {24, 0, true},   {26, 0, false}, {-24, 0, true}, {-26, 0, false},
                {0, -19, true}, {0, -21, false}, {0, 39, true},  {0, 41, false}, {180, 10, false}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        double across = rows[i].across * M_PI / 180, up = rows[i].up * M_PI / 180, rgb[3];
        struct aob_vec3 d = aob_vec(-cos(up) * cos(across), sin(up), cos(up) * sin(across));
        aob_light_find("window")->radiance(NULL, d, rgb);
        assert_true((rgb[0] > 1) == rows[i].bright);
    }
}

/* A cap about (0, 0.6, 0.8), all else black. */
static void small_cap(void *user, struct aob_vec3 direction, double rgb[3])
{
    bool within = aob_vec_dot(direction, aob_vec(0, 0.6, 0.8)) > *(const double *)user;
    rgb[0] = within ? 1e6 : 0;
    rgb[1] = rgb[2] = 0;
}

static void a_small_bright_cap_stays_a_light(void **state)
{
    (void)state;
    double cosine = cos(0.15);
    struct aob_light_projection projection;
    aob_light_project(small_cap, &cosine, &projection);
    check_not_negative(&projection.light);
    double cap = 1e6 * 2 * M_PI * (1 - cosine);
    assert_near(projection.light.sh[0][0] * sqrt(4 * M_PI), cap, 0.01 * cap);
    assert_true(projection.held < 0.1 && projection.factors[0] < 1 && projection.factors[0] > 0.5);
    double towards[3], away[3];
    aob_light_radiance(&projection.light, aob_vec(0, 0.6, 0.8), towards);
    aob_light_radiance(&projection.light, aob_vec(0, -0.6, -0.8), away);
    assert_true(towards[0] > 5 * away[0] && towards[1] == 0);
    /* The window is no wider than it must be. */
    assert_true(aob_light_least(&projection.light, 0) < 1e-9 * towards[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_basis_is_orthonormal),
        cmocka_unit_test(the_basis_has_positive_signs),
        cmocka_unit_test(uniform_light_is_1_everywhere),
        cmocka_unit_test(irradiance_is_the_integral_over_the_hemisphere),
        cmocka_unit_test(a_turned_light_is_the_same_light),
        cmocka_unit_test(the_least_radiance_is_found),
        cmocka_unit_test(the_exposure_is_that_of_the_brightest_normal),
        cmocka_unit_test(nine_coefficients_come_back),
        cmocka_unit_test(named_lights_are_lights),
        cmocka_unit_test(the_window_is_where_its_title_says),
        cmocka_unit_test(a_small_bright_cap_stays_a_light),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
