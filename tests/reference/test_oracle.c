/* The closed forms against numeric quadrature of their definition: the share of the unit disc (Nusselt) or of
 * the cosine-weighted hemisphere that is occluded. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "base/vec.h"
#include "reference/oracle.h"

/* Distance to the occluder along a direction (y up is the normal), or INFINITY. */
typedef double (*distance_fn)(const double *sizes, struct aob_vec3 direction);

/* Points over the disc that cosine-weighted directions cover evenly; their radii are staggered from sector to
 * sector, so that a round edge does not fall between two rings. */
static double quadrature(distance_fn distance, const double *sizes, double r)
{
    enum { RINGS = 400, SECTORS = 1600 };
    long open = 0;
    for (int i = 0; i < RINGS; i++)
        for (int j = 0; j < SECTORS; j++) {
            double s2 = (i + fmod(j * 0.6180339887, 1)) / RINGS, phi = 2 * M_PI * (j + 0.5) / SECTORS;
            struct aob_vec3 d = aob_vec(sqrt(s2) * cos(phi), sqrt(1 - s2), sqrt(s2) * sin(phi));
            open += !(distance(sizes, d) < r);
        }
    return (double)open / ((double)RINGS * SECTORS);
}

static double corner_distance(const double *sizes, struct aob_vec3 d)
{
    return d.z < 0 ? sizes[0] / -d.z : INFINITY;
}

static double wall_distance(const double *sizes, struct aob_vec3 d)
{
    double t = corner_distance(sizes, d);
    return t * d.y < sizes[1] ? t : INFINITY;
}

/* sizes: height, how far outside of the edge. */
static double sheet_distance(const double *sizes, struct aob_vec3 d)
{
    double t = sizes[0] / d.y;
    return t * d.x < -sizes[1] ? t : INFINITY;
}

/* sizes: radius, height, how far the axis is. */
static double disc_distance(const double *sizes, struct aob_vec3 d)
{
    double t = sizes[1] / d.y;
    return hypot(t * d.x - sizes[2], t * d.z) < sizes[0] ? t : INFINITY;
}

static void near_value(double value, double truth)
{
    assert_true(fabs(value - truth) < 4e-4);
}

static void corner_matches_quadrature(void **state)
{
    (void)state;
    for (double d = 0.05; d < 1.3; d += 0.15) {
        near_value(aob_oracle_corner(d, 1), quadrature(corner_distance, &d, 1));
        near_value(aob_oracle_corner(d * 4, 4), aob_oracle_corner(d, 1));
    }
    assert_true(aob_oracle_corner(0, 1) == 0.5);
    assert_true(aob_oracle_corner(1, 1) == 1);
    assert_true(aob_oracle_corner(7, INFINITY) == 0.5);
}

static void wall_matches_quadrature(void **state)
{
    (void)state;
    static const double radii[] = {1, 1.7, 2.5,
                                   INFINITY}; /* below, about and above the wall's height of 1.5 */
    for (double d = 0.1; d < 4; d *= 3)
        for (size_t i = 0; i < sizeof radii / sizeof *radii; i++) {
            double sizes[] = {d, 1.5};
            near_value(aob_oracle_wall(d, 1.5, radii[i]), quadrature(wall_distance, sizes, radii[i]));
        }
    assert_true(aob_oracle_wall(0, 1, INFINITY) == 0.5);
    assert_true(aob_oracle_wall(1, 0, INFINITY) == 1);
    assert_true(fabs(aob_oracle_wall(2, 1, INFINITY) - (1 - 0.5 * (1 - 2 / sqrt(5)))) < 1e-12);
    assert_true(fabs(aob_oracle_wall(0.4, 1, 1) - aob_oracle_corner(0.4, 1)) < 1e-12);
}

static void sheet_matches_quadrature(void **state)
{
    (void)state;
    static const double offsets[] = {-0.7, -0.1, 0, 0.1, 0.5, 0.95};
    static const double radii[] = {1, INFINITY};
    for (double h = 0.2; h < 1.3; h += 0.6)
        for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++)
            for (size_t k = 0; k < sizeof radii / sizeof *radii; k++) {
                double sizes[] = {h, offsets[i]};
                near_value(aob_oracle_sheet(offsets[i], h, radii[k]),
                           quadrature(sheet_distance, sizes, radii[k]));
            }
    assert_true(aob_oracle_sheet(0, 1, 1) == 1);
    assert_true(fabs(aob_oracle_sheet(0, 1, INFINITY) - 0.5) < 1e-12);
    assert_true(fabs(aob_oracle_sheet(0, 1, 2) - 0.5 * (1 + 0.25)) < 1e-12);
}

static void disc_matches_quadrature(void **state)
{
    (void)state;
    for (double a = 0.2; a < 5; a *= 4)
        for (double x = 0; x < 2; x += 0.6) {
            double sizes[] = {a, 0.8, x};
            near_value(aob_oracle_disc(x, a, 0.8, INFINITY), quadrature(disc_distance, sizes, INFINITY));
            double within = aob_oracle_disc(x, a, 0.8, 1.2);
            if (!isnan(within))
                near_value(within, quadrature(disc_distance, sizes, 1.2));
        }
    assert_true(isnan(aob_oracle_disc(0.8, 0.4, 0.8, 1.2))); /* the ball's edge runs over the disc */
    assert_true(aob_oracle_disc(0, 1, 1, INFINITY) == 0.5);
    assert_true(aob_oracle_disc(0, 1, 0, INFINITY) == 0);
    assert_true(aob_oracle_disc(0, 1, 2, 1.5) == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corner_matches_quadrature),
        cmocka_unit_test(wall_matches_quadrature),
        cmocka_unit_test(sheet_matches_quadrature),
        cmocka_unit_test(disc_matches_quadrature),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
