/* What a surface mirrors, and how far its lobe lies from the cosine's, against sums over fine directions of the lobe as glTF 2.0 and Heitz
 * (2014) write it. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "effects/lobe.h"

static const double pi = 3.14159265358979323846;

static double distribution(double cosine, double alpha)
{
    double d = cosine * cosine * (alpha * alpha - 1) + 1;
    return alpha * alpha / (pi * d * d);
}

static double lambda(double cosine, double alpha)
{
    double tangent = 1 / (cosine * cosine) - 1;
    return (sqrt(1 + alpha * alpha * tangent) - 1) / 2;
}

/* f cos with Fresnel's factor by Schlick. */
static double reflected(struct aob_vec3 l, struct aob_vec3 v, double alpha, double f0)
{
    struct aob_vec3 h = aob_vec_normalize(aob_vec_add(l, v));
    double fresnel = f0 + (1 - f0) * pow(1 - aob_vec_dot(h, v), 5);
    return distribution(h.z, alpha) * fresnel / (1 + lambda(l.z, alpha) + lambda(v.z, alpha)) / (4 * v.z);
}

/* Sums over even elevations and turns about the normal, which is z. */
struct sums {
    double mirror, lobe, apart;
};
static struct sums sum_over(struct aob_vec3 v, double roughness, double f0, const struct aob_light *light)
{
    enum { ROWS = 400, TURNS = 400 };
    double alpha = roughness * roughness;
    struct sums sums = {0};
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < ROWS; i++)
            for (int k = 0; k < TURNS; k++) {
                double down = (i + 0.5) / ROWS * pi / 2, turn = 2 * pi * (k + 0.5) / TURNS, rgb[3],
                       solid = sin(down) * (pi / 2 / ROWS) * (2 * pi / TURNS);
                struct aob_vec3 l = aob_vec(sin(down) * cos(turn), sin(down) * sin(turn), cos(down));
                double whole = reflected(l, v, alpha, 1) * solid;
                if (pass) {
                    sums.apart += fabs(whole / sums.lobe - l.z / pi * solid) / 2;
                    continue;
                }
                aob_light_radiance(light, l, rgb);
                sums.lobe += whole;
                sums.mirror += reflected(l, v, alpha, f0) * rgb[1] * solid;
            }
    return sums;
}

static void test_lobes(void **state)
{
    const struct {
        double roughness, cosine, f0;
    } rows[] = {{1, 0.9, 0.04}, {0.7, 0.5, 0.04}, {0.5, 0.8, 0.9}, {0.4, 0.3, 0.5}, {0.9, 0.2, 0.04}};
    struct aob_lobe_table *table = aob_lobe_table_create();
    struct aob_light light = aob_light_uniform;
    (void)state;
    light.sh[1][1] = 0.5, light.sh[2][1] = 0.9, light.sh[3][1] = -0.7, light.sh[6][1] = 0.4,
    light.sh[8][1] = 0.3;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double z = rows[i].cosine, f0 = rows[i].f0, open[3], even[3];
        struct aob_vec3 v = aob_vec(sqrt(1 - z * z), 0, z);
        struct aob_lobe_surface s = {aob_vec(0, 0, 1), v, rows[i].roughness, {f0, f0, f0}};
        struct sums sums = sum_over(v, rows[i].roughness, f0, &light);
        double apart = aob_lobe_apart(table, rows[i].roughness, z);
        aob_lobe_mirror(table, &s, &light, open, even);
        print_message("           %.1f %.1f: mirrors %.4f of %.4f, lies apart %.3f of %.3f\n",
                      rows[i].roughness, z, open[1], sums.mirror, apart, sums.apart);
        assert_near(open[1], sums.mirror, 0.01);
        assert_near(open[0], even[0], 1e-6); /* channel 0 is the same from everywhere */
        assert_true(apart >= sums.apart - 0.01 &&
                    apart <= sums.apart + 0.12); /* the largest of the entries about it */
    }
    assert_near(aob_lobe_apart(table, 0.2, 0.5), 1, 0);
    free(table);
}

/* Fine in both turns: at a cosine of .02 the lobe is hundredths of a radian wide. */
static double apart_of(double roughness, double cosine)
{
    enum { ROWS = 300, TURNS = 1500 };
    double lobe = 0, apart = 0;
    struct aob_vec3 v = aob_vec(sqrt(1 - cosine * cosine), 0, cosine);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < ROWS; i++)
            for (int k = 0; k < TURNS; k++) {
                double z = pow((i + 0.5) / ROWS, 2), turn = pi * (k + 0.5) / TURNS, s = sqrt(1 - z * z),
                       solid = 2 * sqrt(z) / ROWS * 2 * pi / TURNS;
                struct aob_vec3 l = aob_vec(s * cos(turn), s * sin(turn), z);
                double whole = reflected(l, v, roughness * roughness, 1) * solid;
                lobe += pass ? 0 : whole;
                apart += pass ? fabs(whole / lobe - z / pi * solid) / 2 : 0;
            }
    return apart;
}

/* A bound that is not below what it bounds where the view grazes. */
static void test_grazing(void **state)
{
    static const double cosines[] = {0.02, 0.05, 0.1, 0.3}, roughnesses[] = {0.36, 0.5, 0.7, 1};
    struct aob_lobe_table *table = aob_lobe_table_create();
    (void)state;
    for (size_t c = 0; c < 4; c++)
        for (size_t r = 0; r < 4; r++) {
            double right = apart_of(roughnesses[r], cosines[c]),
                   apart = aob_lobe_apart(table, roughnesses[r], cosines[c]);
            print_message("           %.2f %.2f: lies apart %.4f of %.4f\n", roughnesses[r], cosines[c],
                          apart, right);
            assert_true(apart >= right - 0.003 && apart <= right + 0.12);
        }
    free(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_lobes), cmocka_unit_test(test_grazing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
