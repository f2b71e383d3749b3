/* The scale of the errors that figures of one group share: the pictures are those that are drawn with the scale
 * given. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/child.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/image.h"

enum { SIDE = 20, IMAGES = 3 };

static char folder[128], *plotter;

static char *place(const char *format, int number)
{
    struct aob_text text = {0};
    aob_text_add(&text, format, folder, number);
    return text.data;
}

/* Errors of both signs up to `most` but for some larger ones, and one pixel without a number. */
static void write_image(int number, float most, int larger)
{
    struct aob_image image = {.width = SIDE, .height = SIDE + 1};
    float *ao = aob_image_add(&image, "technique.AO"), *truth = aob_image_add(&image, "reference.AO"),
          *error = aob_image_add(&image, "error.AO");
    for (int i = 0; i < SIDE * (SIDE + 1); i++) {
        truth[i] = 0.5f;
        error[i] = i >= SIDE * SIDE ? NAN : i < larger ? 0.45f : i % 2 ? most : -most;
        ao[i] = truth[i] + error[i];
    }
    char *path = place("%s/%d.exr", number);
    assert_true(aob_image_write(&image, path, NULL));
    aob_image_finish(&image);
    free(path);
}

/* The map of image 0 in a job of `count` images, each with `more`. */
static char *draw(int count, const char *more, size_t *size)
{
    struct aob_text job = {0};
    struct aob_child_result result;
    struct aob_error error = {{0}};
    const char *const argv[] = {plotter, NULL};
    aob_text_add(&job, "{\"figures\":[");
    for (int i = 0; i < count; i++)
        aob_text_add(&job,
                     "%s{\"kind\":\"map\",\"out\":\"%s/%d.png\",\"image\":\"%s/%d.exr\",\"title\":\"t\",%s}",
                     i ? "," : "", folder, i, folder, i, more);
    aob_text_add(&job, "]}");
    if (!aob_child_run(
            &(struct aob_child_desc){
                .argv = argv, .input = job.data, .input_size = job.size, .timeout_s = 60},
            &result, &error) ||
        result.exit_code != 0)
        fail_msg("%s", error.text);
    aob_text_finish(&job);
    char *path = place("%s/%d.png", 0), *bytes = aob_file_read(path, (size_t)1 << 26, size, &error);
    assert_non_null(bytes);
    free(path);
    return bytes;
}

static void expect_limit(int count, const char *limit)
{
    size_t size[2];
    char *bytes[2] = {draw(count, "\"limit_group\":\"g\"", &size[0]), draw(count, limit, &size[1])};
    if (size[0] != size[1] || memcmp(bytes[0], bytes[1], size[0]) != 0)
        fail_msg("the pictures are not those of %s", limit);
    free(bytes[0]);
    free(bytes[1]);
}

/* Of 400 pixels the 99.5th percentile is the third largest: two errors of .45 do not show, three do. */
static void test_a_few_pixels_do_not_bleach_an_image(void **state)
{
    (void)state;
    write_image(0, 0.06f, 2);
    expect_limit(1, "\"limit\":0.06");
    write_image(0, 0.06f, 3);
    expect_limit(1, "\"limit\":0.5"); /* the next round number */
    write_image(0, 0.001f, 0);
    expect_limit(1, "\"limit\":0.01"); /* at least */
}

static void test_the_group_has_the_median(void **state)
{
    (void)state;
    write_image(0, 0.06f, 0);
    write_image(1, 0.45f, 0);
    write_image(2, 0.21f, 0);
    expect_limit(IMAGES, "\"limit\":0.25");
}

static int set_up(void **state)
{
    const char *build = getenv("AOBUDGET_BUILD");
    (void)state;
    plotter = aob_path_join(build ? build : ".", "aobudget-plot");
    snprintf(folder, sizeof folder, "/tmp/aob-test-plot-limit-%ld", (long)getpid());
    return aob_file_exists(plotter) && aob_folder_create(folder, NULL) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    for (int i = 0; i < 2 * IMAGES; i++) {
        char *path = place(i < IMAGES ? "%s/%d.exr" : "%s/%d.png", i % IMAGES);
        unlink(path);
        free(path);
    }
    free(plotter);
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_few_pixels_do_not_bleach_an_image),
                                       cmocka_unit_test(test_the_group_has_the_median)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
