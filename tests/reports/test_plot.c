/* aobudget-plot: every product, as a report's readers get it. */
#include "base/child.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/image.h"
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>

enum { WIDTH = 96, HEIGHT = 54 };
static const size_t LIMIT = (size_t)1 << 26;

struct fixture {
    char *plotter, folder[128], image[160], split[160]; /* images without and with the parts of the error */
    char truth[160], small[160];                        /* another truth, and one of another size */
};

/* A split image has sky in its top row, and there definition and screen far from the truth. */
static bool write_image(const char *path, bool split)
{
    struct aob_image image = {.width = WIDTH, .height = HEIGHT};
    static const char *const names[] = {"technique.AO",  "reference.AO", "error.AO",
                                        "definition.AO", "screen.AO",    "Z"};
    for (size_t c = 0; c < (split ? AOB_COUNT(names) : 3); c++)
        aob_image_add(&image, names[c]);
    float *ao = aob_image_channel(&image, names[0]), *truth = aob_image_channel(&image, names[1]),
          *error = aob_image_channel(&image, names[2]);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        int x = i % WIDTH, y = i / WIDTH;
        truth[i] = 0.5f + 0.4f * sinf(0.1f * (float)x) * cosf(0.13f * (float)y);
        ao[i] = truth[i] + 0.05f * sinf(0.9f * (float)x) + 0.01f * (float)(i * 7 % 11) / 11;
        error[i] = i == 5 ? NAN : ao[i] - truth[i];
        if (!split)
            continue;
        aob_image_channel(&image, "Z")[i] = y ? 3 : INFINITY;
        aob_image_channel(&image, "definition.AO")[i] = truth[i] + (y ? 0.03125f : 5);
        aob_image_channel(&image, "screen.AO")[i] = truth[i] + (y ? -0.0625f : -5);
    }
    bool ok = aob_image_write(&image, path, NULL);
    aob_image_finish(&image);
    return ok;
}

/* A flat truth of 0.5. */
static bool write_truth(const char *path, int width)
{
    struct aob_image image = {.width = width, .height = HEIGHT};
    float *pixels = aob_image_add(&image, "AO");
    for (int i = 0; i < width * HEIGHT; i++)
        pixels[i] = 0.5f;
    bool ok = aob_image_write(&image, path, NULL);
    aob_image_finish(&image);
    return ok;
}

/* One run of the helper; returns its exit code. */
static int plot(const struct fixture *f, const char *job)
{
    const char *const argv[] = {f->plotter, NULL};
    struct aob_child_desc desc = {.argv = argv, .input = job, .input_size = strlen(job), .timeout_s = 60};
    struct aob_child_result result;
    struct aob_error error = {0};
    if (!aob_child_run(&desc, &result, &error))
        fail_msg("%s", error.text);
    return result.exit_code;
}

/* A job of one figure of `kind` from the image, into `name` in the folder. */
static int plot_one(const struct fixture *f, const char *kind, const char *name, const char *more)
{
    struct aob_text job = {0};
    aob_text_add(&job,
                 "{\"figures\":[{\"kind\":\"%s\",\"out\":\"%s/%s\",\"image\":\"%s\",\"title\":\"gtao $x$ "
                 "\u00b7 <b>\"%s}]}",
                 kind, f->folder, name, f->image, more);
    int code = plot(f, job.data);
    aob_text_finish(&job);
    return code;
}

static char *product(const struct fixture *f, const char *name, size_t *size)
{
    char *path = aob_path_join(f->folder, name);
    struct aob_error error = {0};
    char *bytes = aob_file_read(path, LIMIT, size, &error);
    if (!bytes)
        fail_msg("%s", error.text);
    unlink(path);
    free(path);
    return bytes;
}

static unsigned big_endian(const char *bytes)
{
    const unsigned char *b = (const unsigned char *)bytes;
    return (unsigned)b[0] << 24 | (unsigned)b[1] << 16 | (unsigned)b[2] << 8 | b[3];
}

/* A picture of one colour packs to a thousandth; a drawn one to no less than a hundredth. */
static void assert_picture(const char *bytes, size_t size, unsigned width, unsigned height)
{
    assert_true(size > 33 && memcmp(bytes, "\x89PNG\r\n\x1a\n", 8) == 0);
    assert_int_equal(big_endian(bytes + 16), width);
    assert_int_equal(big_endian(bytes + 20), height);
    assert_true(size > (size_t)width * height * 3 / 150);
    assert_memory_equal(bytes + size - 8, "IEND", 4);
}

static void assert_same_twice(const struct fixture *f, const char *kind, const char *name, const char *more,
                              unsigned width, unsigned height)
{
    size_t size[2];
    char *bytes[2];
    for (int i = 0; i < 2; i++) {
        assert_int_equal(plot_one(f, kind, name, more), 0);
        bytes[i] = product(f, name, &size[i]);
    }
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(bytes[0], bytes[1], size[0]);
    if (width)
        assert_picture(bytes[0], size[0], width, height);
    free(bytes[0]);
    free(bytes[1]);
}

static const char CHART[] =
    ",\"subtitle\":\"s\",\"x\":{\"label\":\"radius\",\"log\":true},\"y\":{\"label\":\"ms\",\"log\":true},"
    "\"series\":["
    "{\"name\":\"gtao\",\"colour\":0,\"x\":[0.25,0.5,1],\"y\":[1,2,4],\"low\":[0.9,null,3.9],\"high\":[1.2,"
    "null,4.2]},"
    "{\"name\":\"<hbao>\",\"style\":\"points\",\"colour\":9,\"x\":[0.25,-1,1],\"y\":[2,3,null]},"
    "{\"name\":\"front\",\"style\":\"front\",\"x\":[0.25,0.5],\"y\":[4,1]}]";

static void test_map(void **state)
{
    /* 96 x 15 = 1440, 54 x 15 = 810, and the margins. */
    assert_same_twice(*state, "map", "map.png", ",\"limit\":0.1", 40 + 1440 + 26 + 22 + 116, 96 + 810 + 36);
}

static void test_triptych(void **state)
{
    assert_same_twice(*state, "triptych", "t.png", ",\"limit_group\":\"a\"",
                      40 + 3 * 480 + 40 + 26 + 22 + 116, 126 + 270 + 32);
}

static void test_height(void **state)
{
    assert_same_twice(*state, "height", "h.png", ",\"limit\":0.1", 1280, 720);
}

static void test_chart_png(void **state)
{
    assert_same_twice(*state, "chart", "c.png", CHART, 960, 560);
}

static size_t count_text(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

/* Well-formed as far as it can be seen without a parser: every element that is opened is closed. */
static void test_chart_svg(void **state)
{
    size_t size;
    assert_same_twice(*state, "chart", "c.svg", CHART, 0, 0);
    assert_int_equal(plot_one(*state, "chart", "c.svg", CHART), 0);
    char *text = product(*state, "c.svg", &size);
    assert_non_null(strstr(text, "viewBox=\"0 0 960 560\""));
    assert_null(strstr(text, "clip-path"));
    assert_null(strstr(text, "nan"));
    assert_null(strstr(text, "hbao"));
    assert_int_equal(count_text(text, "<g"), count_text(text, "</g>") + count_text(text, "<glyph"));
    assert_int_equal(count_text(text, "<svg"), count_text(text, "</svg>"));
    assert_true(count_text(text, "<poly") > 10);
    free(text);
}

static double attribute_of(const char *text, const char *array, const char *name)
{
    char key[64];
    double value = NAN;
    snprintf(key, sizeof key, "Name=\"%s\"", array);
    const char *at = strstr(text, key);
    assert_non_null(at);
    at = strstr(at, name);
    assert_non_null(at);
    assert_int_equal(sscanf(at + strlen(name), "=\"%lf\"", &value), 1);
    return value;
}

static void test_vti(void **state)
{
    size_t size;
    assert_int_equal(plot_one(*state, "vti", "d.vti", ""), 0);
    char *text = product(*state, "d.vti", &size);
    assert_non_null(strstr(text, "compressor=\"vtkZLibDataCompressor\""));
    assert_non_null(strstr(text, "encoding=\"raw\""));
    assert_non_null(strstr(text, "WholeExtent=\"0 95 0 53 0 0\""));
    assert_true(fabs(attribute_of(text, "reference", "RangeMin") - 0.1) < 0.01);
    assert_true(fabs(attribute_of(text, "reference", "RangeMax") - 0.9) < 0.01);
    assert_true(attribute_of(text, "AO", "RangeMax") > 0.9);
    assert_true(attribute_of(text, "error", "RangeMin") < -0.04);
    assert_true(size > WIDTH * HEIGHT);
    assert_null(strstr(text, "error_"));
    free(text);
}

/* As plot_one, of the image that has the parts. */
static int plot_split(struct fixture *f, const char *kind, const char *name, const char *more)
{
    struct fixture other = *f;
    memcpy(other.image, f->split, sizeof other.image);
    return plot_one(&other, kind, name, more);
}

static void test_split(void **state)
{
    size_t size[2];
    char *bytes[2];
    const char *const more[2] = {",\"limit\":0.1,\"parts\":[\"Definition: RMS 0.0313\",\"Missing\"]",
                                 ",\"limit_group\":\"a\""};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(plot_split(*state, "split", "s.png", more[i]), 0);
        bytes[i] = product(*state, "s.png", &size[i]);
        /* The triptych's size: three panels of 480 x 270 and one bar. */
        assert_picture(bytes[i], size[i], 40 + 3 * 480 + 40 + 26 + 22 + 116, 126 + 270 + 32);
    }
    assert_false(size[0] == size[1] && memcmp(bytes[0], bytes[1], size[0]) == 0);
    free(bytes[0]);
    free(bytes[1]);
    assert_int_equal(plot_split(*state, "split", "s.png", ""), 3);
    assert_int_equal(plot_one(*state, "split", "s.png", ",\"limit\":0.1"), 3);
}

/* The parts are known: +1/32, -3/32, and what the technique has beyond; the sky has none. */
static void test_vti_of_a_split(void **state)
{
    size_t size;
    assert_int_equal(plot_split(*state, "vti", "d.vti", ""), 0);
    char *text = product(*state, "d.vti", &size);
    assert_true(fabs(attribute_of(text, "error_definition", "RangeMin")) < 1e-6);
    assert_true(fabs(attribute_of(text, "error_definition", "RangeMax") - 0.03125) < 1e-6);
    assert_true(fabs(attribute_of(text, "error_missing", "RangeMin") + 0.09375) < 1e-6);
    assert_true(fabs(attribute_of(text, "error_missing", "RangeMax")) < 1e-6);
    /* sin + saw: -0.05 to 0.06, with 0.0625 on top */
    assert_true(fabs(attribute_of(text, "error_estimator", "RangeMin")) < 0.0025);
    assert_true(fabs(attribute_of(text, "error_estimator", "RangeMax") - 0.1175) < 0.0075);
    assert_non_null(strstr(text, "Scalars=\"error\""));
    free(text);
}

/* The error is the technique's image less 0.5, and nothing in the sky; so are the parts. The image's own truth spans 0.1
 * to 0.9, and 1/32 above it is the definition. */
static void test_truth_of_another_file(void **state)
{
    const struct fixture *f = *state;
    char more[256];
    size_t size;
    snprintf(more, sizeof more, ",\"reference_image\":\"%s\"", f->truth);
    assert_int_equal(plot_split(*state, "vti", "d.vti", more), 0);
    char *text = product(f, "d.vti", &size);
    assert_true(attribute_of(text, "reference", "RangeMin") == 0.5);
    assert_true(attribute_of(text, "reference", "RangeMax") == 0.5);
    assert_true(fabs(attribute_of(text, "error", "RangeMax") - (attribute_of(text, "AO", "RangeMax") - 0.5)) <
                1e-6);
    assert_true(fabs(attribute_of(text, "error_definition", "RangeMax") - 0.43125) < 2e-3);
    assert_true(fabs(attribute_of(text, "error_definition", "RangeMin") + 0.36875) < 2e-3);
    free(text);
    snprintf(more, sizeof more, ",\"limit\":1,\"reference_image\":\"%s\"", f->small);
    assert_int_equal(plot_one(f, "map", "m.png", more), 3);
    snprintf(more, sizeof more, ",\"limit\":1,\"reference_image\":\"%s\"", f->image); /* it has no AO */
    assert_int_equal(plot_one(f, "map", "m.png", more), 3);
    assert_int_equal(plot_one(f, "map", "m.png", ",\"limit\":1,\"reference_image\":\"/none\""), 3);
}

/* The errors end at 0.06 against the image's own truth, at 0.45 against the other one. The limit of a group follows, so
 * the picture is the one that is drawn with 0.5, the next round number. */
static void test_limit_of_another_truth(void **state)
{
    static const char *const limits[] = {"\"limit_group\":\"a\"", "\"limit\":0.5"};
    const struct fixture *f = *state;
    char more[256], *bytes[2];
    size_t size[2];
    for (int i = 0; i < 2; i++) {
        snprintf(more, sizeof more, ",%s,\"reference_image\":\"%s\"", limits[i], f->truth);
        assert_int_equal(plot_one(f, "map", "m.png", more), 0);
        bytes[i] = product(f, "m.png", &size[i]);
    }
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(bytes[0], bytes[1], size[0]);
    free(bytes[0]);
    free(bytes[1]);
}

static void test_failures_say_so(void **state)
{
    assert_int_equal(plot_one(*state, "map", "no/such/folder/m.png", ",\"limit\":1"), 3);
    assert_int_equal(plot_one(*state, "vti", "no/such/folder/d.vti", ""), 3);
    assert_int_equal(plot_one(*state, "chart", "no/such/folder/c.svg", CHART), 3);
    assert_int_equal(plot_one(*state, "chart", "c.gif", CHART), 3);
    assert_int_equal(plot_one(*state, "chart", "c.svg", ",\"series\":[{\"x\":[1],\"y\":[null]}]"), 3);
    assert_int_equal(plot_one(*state, "pie", "p.png", ""), 3);
    assert_int_equal(plot_one(*state, "map", "m.png", ""), 3);
    assert_int_equal(plot_one(*state, "map", "m.png", ",\"limit\":-1"), 3);
    assert_int_equal(plot_one(*state, "map", "m.png", ",\"limit\":1,\"error\":\"Z\""), 3);
    assert_int_equal(plot(*state, "{\"figures\":[{\"kind\":\"map\",\"out\":\"x\",\"image\":\"/none\"}]}"), 3);
    assert_int_equal(plot(*state, "{\"figures\":[1,null,[],{\"kind\":\"map\"}]}"), 3);
}

static void test_bad_documents(void **state)
{
    static const char *const jobs[] = {"", "{", "[]", "{}", "{\"figures\":3}", "\xff", "null"};
    for (size_t i = 0; i < AOB_COUNT(jobs); i++)
        assert_int_equal(plot(*state, jobs[i]), 2);
    assert_int_equal(plot(*state, "{\"figures\":[]}"), 0);
}

/* Axes of one point, of equal values and of the largest spans. */
static void test_charts_of_odd_data(void **state)
{
    static const char *const series[] = {
        "[1],\"y\":[1]",         "[0],\"y\":[0]",
        "[5,5,5],\"y\":[2,2,2]", "[1e-300,1e300],\"y\":[-1e300,1e300]",
        "[1,2],\"y\":[-3,-3]",   "[1e15,1.000000001e15],\"y\":[1,2]",
    };
    for (size_t i = 0; i < AOB_COUNT(series); i++)
        for (int log = 0; log < 2; log++) {
            char more[256];
            snprintf(more, sizeof more, ",\"x\":{\"log\":%s},\"series\":[{\"x\":%s}]", log ? "true" : "false",
                     series[i]);
            int code = plot_one(*state, "chart", "odd.svg", more);
            assert_true(code == 0 || (code == 3 && log));
        }
    char *path = aob_path_join(((struct fixture *)*state)->folder, "odd.svg");
    unlink(path);
    free(path);
}

static int set_up(void **state)
{
    struct fixture *f = AOB_NEW(struct fixture);
    const char *build = getenv("AOBUDGET_BUILD");
    f->plotter = aob_path_join(build ? build : ".", "aobudget-plot");
    if (!aob_file_exists(f->plotter))
        exit(77);
    snprintf(f->folder, sizeof f->folder, "/tmp/aob-test-plot-%ld", (long)getpid());
    snprintf(f->image, sizeof f->image, "%s/image.exr", f->folder);
    snprintf(f->split, sizeof f->split, "%s/split.exr", f->folder);
    snprintf(f->truth, sizeof f->truth, "%s/truth.exr", f->folder);
    snprintf(f->small, sizeof f->small, "%s/small.exr", f->folder);
    *state = f;
    return aob_folder_create(f->folder, NULL) && write_image(f->image, false) &&
                   write_image(f->split, true) && write_truth(f->truth, WIDTH) &&
                   write_truth(f->small, WIDTH - 1)
               ? 0
               : -1;
}

static int tear_down(void **state)
{
    struct fixture *f = *state;
    unlink(f->image);
    unlink(f->split);
    unlink(f->truth);
    unlink(f->small);
    int left = rmdir(f->folder);
    free(f->plotter);
    free(f);
    return left;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_map),
        cmocka_unit_test(test_triptych),
        cmocka_unit_test(test_height),
        cmocka_unit_test(test_chart_png),
        cmocka_unit_test(test_chart_svg),
        cmocka_unit_test(test_split),
        cmocka_unit_test(test_vti),
        cmocka_unit_test(test_vti_of_a_split),
        cmocka_unit_test(test_truth_of_another_file),
        cmocka_unit_test(test_limit_of_another_truth),
        cmocka_unit_test(test_failures_say_so),
        cmocka_unit_test(test_bad_documents),
        cmocka_unit_test(test_charts_of_odd_data),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
