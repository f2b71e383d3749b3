/* Light probes: which texel is which direction, and each refusal. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/memory.h"
#include "gbuffer/probe.h"
#include "store/image.h"

static char path[64];

/* An image of 16 x 8 unless a test says else, every texel of `value`. */
static struct aob_image make(int width, int height, float value)
{
    struct aob_image image = {.width = width, .height = height};
    const char *const names[] = {"R", "G", "B"};
    for (int c = 0; c < 3; c++) {
        float *pixels = aob_image_add(&image, names[c]);
        for (int i = 0; i < width * height; i++)
            pixels[i] = value;
    }
    return image;
}

static bool read_back(struct aob_image *image, struct aob_light_projection *projection,
                      struct aob_error *error)
{
    assert_true(aob_image_write(image, path, error));
    aob_image_finish(image);
    return aob_probe_read(path, projection, error);
}

static void a_constant_probe_is_uniform_light(void **state)
{
    (void)state;
    static const int heights[] = {1, 2, 8, 257};
    for (size_t i = 0; i < AOB_COUNT(heights); i++) {
        struct aob_image image = make(2 * heights[i], heights[i], 1);
        struct aob_light_projection projection;
        struct aob_error error = {""};
        assert_true(read_back(&image, &projection, &error));
        for (int k = 0; k < 27; k++)
            assert_near(projection.light.sh[k / 3][k % 3], aob_light_uniform.sh[k / 3][k % 3], 1e-12);
        assert_near(projection.held, 1, 1e-12);
        assert_true(projection.factors[0] == 1 && projection.factors[1] == 1);
    }
}

/* The texels are those about the direction in an image of 16 x 8; the edges between four of them lie in it. */
static void a_bright_spot_is_where_it_should_be(void **state)
{
    (void)state;
    static const struct row {
        int column, row, columns;
        struct aob_vec3 direction;
    } rows[] = {
        {7, 3, 2, {0, 0, -1}}, {11, 3, 2, {1, 0, 0}},  {3, 3, 2, {-1, 0, 0}},
        {0, 0, 16, {0, 1, 0}}, {0, 6, 16, {0, -1, 0}},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_image image = make(16, 8, 0);
        for (int y = 0; y < 2; y++)
            for (int x = 0; x < rows[i].columns; x++)
                for (int c = 0; c < 3; c++)
                    image.channels[c].pixels[16 * (rows[i].row + y) + rows[i].column + x] = (float)(c + 1);
        struct aob_light_projection projection;
        struct aob_error error = {""};
        assert_true(read_back(&image, &projection, &error));
        double(*sh)[3] = projection.light.sh;
        for (int c = 0; c < 3; c++) {
            struct aob_vec3 towards = aob_vec(sh[3][c], sh[1][c], sh[2][c]);
            assert_true(aob_vec_dot(aob_vec_normalize(towards), rows[i].direction) > 1 - 1e-12);
            assert_near(sh[0][c], (c + 1) * sh[0][0], 1e-12);
        }
    }
}

/* One texel against quadrature over it, in an image so coarse that its middle would not do. */
static void a_texel_is_integrated_exactly(void **state)
{
    (void)state;
    enum { FINE = 400 };
    struct aob_image image = make(8, 4, 0);
    image.channels[0].pixels[8 * 1 + 6] = 1e5f;
    struct aob_light_projection projection;
    struct aob_error error = {""};
    double sums[9] = {0}, basis[9];
    assert_true(read_back(&image, &projection, &error));
    for (int i = 0; i < FINE * FINE; i++) {
        double azimuth = 2 * M_PI * (6 + (i % FINE + 0.5) / FINE) / 8 - M_PI;
        double polar = M_PI * (1 + (i / FINE + 0.5) / FINE) / 4;
        double angle = 2 * sin(polar) * sin(M_PI / 8 / FINE) * 2 * M_PI / 8 / FINE;
        aob_light_basis(aob_vec(sin(polar) * sin(azimuth), cos(polar), -sin(polar) * cos(azimuth)), basis);
        for (int k = 0; k < 9; k++)
            sums[k] += 1e5 * angle * basis[k];
    }
    assert_true(projection.factors[0] < 1 && projection.held < 1);
    for (int k = 0; k < 9; k++) {
        double factor = k == 0 ? 1 : projection.factors[k < 4 ? 0 : 1];
        assert_near(projection.light.sh[k][0], factor * sums[k], 1e-5 * sums[0]);
        assert_true(projection.light.sh[k][1] == 0);
    }
    assert_true(aob_light_least(&projection.light, 0) >= 0);
}

static void refuse(struct aob_image *image, const char *line)
{
    struct aob_light_projection projection;
    struct aob_error error = {""};
    char whole[512];
    assert_false(read_back(image, &projection, &error));
    snprintf(whole, sizeof whole, "%s: no light probe: %s", path, line);
    assert_string_equal(error.text, whole);
}

static void what_is_no_probe_is_refused(void **state)
{
    (void)state;
    struct aob_image image = make(16, 8, 1);
    snprintf(image.channels[1].name, sizeof image.channels[1].name, "Y");
    refuse(&image, "it has no channel G; store the radiance as R, G and B");
    image = make(16, 9, 1);
    refuse(&image, "it is 16 x 9 texels; an equirectangular image is twice as wide as high");
    image = make(8194, 1, 1);
    refuse(&image, "8194 x 1 texels are too many; scale it down to 8192 x 4096 at most");
    image = make(16, 8, 0);
    refuse(&image, "every texel is black; take an image that gives light");
}

static void a_bad_texel_is_refused_with_its_place(void **state)
{
    (void)state;
    static const struct row {
        float value;
        const char *text;
    } rows[] = {{NAN, "nan"}, {INFINITY, "inf"}, {-0.5f, "-0.5"}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_image image = make(16, 8, 1);
        char line[256];
        image.channels[2].pixels[16 * 5 + 9] = rows[i].value;
        snprintf(line, sizeof line,
                 "B is %s at column 9, row 5 (from 0, at the top left); a radiance is finite and not "
                 "negative: mend that texel",
                 rows[i].text);
        refuse(&image, line);
    }
}

static void a_missing_file_is_one_line(void **state)
{
    (void)state;
    struct aob_light_projection projection;
    struct aob_error error = {""};
    assert_false(aob_probe_read("/nonexistent/probe.exr", &projection, &error));
    assert_contains(error.text, "/nonexistent/probe.exr");
    assert_null(strchr(error.text, '\n'));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_constant_probe_is_uniform_light),
        cmocka_unit_test(a_bright_spot_is_where_it_should_be),
        cmocka_unit_test(a_texel_is_integrated_exactly),
        cmocka_unit_test(what_is_no_probe_is_refused),
        cmocka_unit_test(a_bad_texel_is_refused_with_its_place),
        cmocka_unit_test(a_missing_file_is_one_line),
    };
    snprintf(path, sizeof path, "/tmp/aob_test_probe_%ld.exr", (long)getpid());
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    unlink(path);
    return failed;
}
