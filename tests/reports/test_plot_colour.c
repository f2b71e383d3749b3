/* Pictures in colour: pixels of a made-up image are the colours that the sRGB curve gives. */
#include "png_pixels.h"
#include <math.h>
#include <unistd.h>
#include "base/child.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/image.h"

/* Each pixel is a square of 140, and a panel begins 580 after the one before it. */
enum { WIDTH = 4, HEIGHT = 2, PIXELS = WIDTH * HEIGHT, SQUARE = 140, STEP = 580, LEFT = 40, TOP = 126 };
enum { SKY = PIXELS - 1, BRIGHT = PIXELS - 2 };
enum { TECHNIQUE, REFERENCE, ERROR };

static char folder[128], *plotter, answer[512];

static void paint(struct aob_image *image, const char *name, const float colour[3], float scale)
{
    for (int c = 0; c < 3; c++) {
        char channel[64];
        snprintf(channel, sizeof channel, "%s.%c", name, "RGB"[c]);
        float *pixels = aob_image_add(image, channel);
        for (int i = 0; i < PIXELS; i++)
            pixels[i] = scale * (i == SKY ? 1000 : i == BRIGHT ? 100 : colour[c]);
    }
}

/* The sky and one pixel of the surface are brighter than all others. */
static void write_image(const char *name, float scale)
{
    struct aob_image image = {.width = WIDTH, .height = HEIGHT};
    paint(&image, "technique.irradiance", (const float[]){0.5f, 0.25f, 1.5f}, scale);
    paint(&image, "reference.irradiance", (const float[]){0.25f, 0.002f, 0.75f}, scale);
    float *z = aob_image_add(&image, "Z"), *error = aob_image_add(&image, "error.irradiance");
    for (int i = 0; i < PIXELS; i++)
        z[i] = i == SKY ? INFINITY : 2;
    error[0] = 0.5f;
    error[1] = -0.5f;
    char *path = aob_path_join(folder, name);
    assert_true(aob_image_write(&image, path, NULL));
    aob_image_finish(&image);
    free(path);
}

static void take_answer(void *user, const char *line)
{
    (void)user;
    snprintf(answer, sizeof answer, "%s", line);
}

/* The exit code of a job of one triptych. */
static int plot(const char *image, const char *more)
{
    struct aob_text job = {0};
    struct aob_child_result result;
    struct aob_error error = {{0}};
    const char *const argv[] = {plotter, NULL};
    aob_text_add(
        &job,
        "{\"figures\":[{\"kind\":\"triptych\",\"out\":\"%s/t.png\",\"image\":\"%s/%s\",\"title\":\"t\","
        "\"technique\":\"technique.irradiance\",\"reference\":\"reference.irradiance\","
        "\"error\":\"error.irradiance\",\"colour\":true%s}]}",
        folder, folder, image, more);
    if (!aob_child_run(&(struct aob_child_desc){.argv = argv,
                                                .input = job.data,
                                                .input_size = job.size,
                                                .timeout_s = 60,
                                                .on_line = take_answer},
                       &result, &error))
        fail_msg("%s", error.text);
    aob_text_finish(&job);
    return result.exit_code;
}

static struct png draw(const char *image, const char *more)
{
    size_t size;
    if (plot(image, more) != 0)
        fail_msg("%s", answer);
    char *path = aob_path_join(folder, "t.png");
    unsigned char *bytes = (unsigned char *)aob_file_read(path, 1 << 24, &size, NULL);
    assert_non_null(bytes);
    struct png png = png_read(bytes, size);
    unlink(path);
    free(path);
    free(bytes);
    return png;
}

/* The colour in the middle of an image's pixel. */
static unsigned colour_of(const struct png *png, int panel, int pixel)
{
    int x = LEFT + panel * STEP + pixel % WIDTH * SQUARE + SQUARE / 2,
        y = TOP + pixel / WIDTH * SQUARE + SQUARE / 2;
    return png_colour(png, (size_t)x, (size_t)y);
}

/* What is above 1 is white. 1.055 v^(1/2.4) - 0.055 of 0.5, 0.25 and 0.75 is 0.7354, 0.5371 and 0.8808; 12.92 v of 0.002 is 0.0258. */
static void test_known_pixels(void **state)
{
    (void)state;
    struct png png = draw("plain.exr", ",\"limit\":0.5,\"exposure\":1");
    assert_int_equal(colour_of(&png, TECHNIQUE, 0), 0xbc89ff);
    assert_int_equal(colour_of(&png, REFERENCE, 0), 0x8907e1);
    assert_int_equal(colour_of(&png, TECHNIQUE, BRIGHT), 0xffffff);
    assert_int_equal(colour_of(&png, TECHNIQUE, SKY), 0xc4c4c8);
    assert_int_equal(colour_of(&png, REFERENCE, SKY), 0xc4c4c8);
    free(png.pixels);
}

/* The ends of the colours are the limit's, of either sign. */
static void test_range_of_the_error(void **state)
{
    (void)state;
    struct png png = draw("plain.exr", ",\"limit\":0.5,\"exposure\":1");
    assert_int_equal(colour_of(&png, ERROR, 0), 0x67001f);
    assert_int_equal(colour_of(&png, ERROR, 1), 0x053061);
    assert_int_equal(colour_of(&png, ERROR, 2), 0xf7f7f7);
    free(png.pixels);
}

/* Values four times as large: the largest of a channel, 3, lies below 4, so all are shown at a quarter. The sky and the few
 * brightest pixels do not count. Both pictures have the reference's exposure, though the technique is brighter. */
static void test_exposure(void **state)
{
    (void)state;
    struct png png = draw("bright.exr", ",\"limit\":0.5");
    assert_int_equal(colour_of(&png, TECHNIQUE, 0), 0xbc89ff);
    assert_int_equal(colour_of(&png, REFERENCE, 0), 0x8907e1);
    free(png.pixels);
    png = draw("plain.exr", ",\"limit\":0.5"); /* 0.75 stays below 1 */
    assert_int_equal(colour_of(&png, TECHNIQUE, 0), 0xbc89ff);
    free(png.pixels);
    png = draw("plain.exr", ",\"limit\":0.5,\"exposure\":0.5"); /* 0.25 of the red */
    assert_int_equal(colour_of(&png, TECHNIQUE, 0) >> 16, 0x89);
    free(png.pixels);
}

static void test_what_is_missing_is_said(void **state)
{
    (void)state;
    assert_int_equal(plot("plain.exr", ",\"limit\":0.5,\"exposure\":-1"), 3);
    assert_contains(answer, "the exposure must be positive");
    struct aob_image image = {.width = WIDTH, .height = HEIGHT};
    char *path = aob_path_join(folder, "red.exr");
    aob_image_add(&image, "technique.irradiance.R");
    aob_image_add(&image, "error.irradiance");
    assert_true(aob_image_write(&image, path, NULL));
    assert_int_equal(plot("red.exr", ",\"limit\":0.5"), 3);
    assert_contains(answer, "red.exr: has no channel technique.irradiance.G");
    aob_image_finish(&image);
    unlink(path);
    free(path);
}

static int set_up(void **state)
{
    const char *build = getenv("AOBUDGET_BUILD");
    (void)state;
    plotter = aob_path_join(build ? build : ".", "aobudget-plot");
    snprintf(folder, sizeof folder, "/tmp/aob-test-plot-colour-%ld", (long)getpid());
    if (!aob_file_exists(plotter) || !aob_folder_create(folder, NULL))
        return -1;
    write_image("plain.exr", 1);
    write_image("bright.exr", 4);
    return 0;
}

static int tear_down(void **state)
{
    static const char *const names[] = {"plain.exr", "bright.exr"};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(names); i++) {
        char *path = aob_path_join(folder, names[i]);
        unlink(path);
        free(path);
    }
    free(plotter);
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_pixels), cmocka_unit_test(test_range_of_the_error),
        cmocka_unit_test(test_exposure), cmocka_unit_test(test_what_is_missing_is_said)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
