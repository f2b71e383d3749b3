/* Whether backends agree, in the page. */
#include "run_text.h"
#include "store/image.h"

static void write_image(const char *name, float last)
{
    struct aob_image image = {.width = 4, .height = 4};
    float *pixels = aob_image_add(&image, "technique.AO");
    char *images = aob_path_join(folder, "images"), *path = aob_path_join(images, name);
    for (int i = 0; i < 16; i++)
        pixels[i] = i == 15 ? last : 0.5f;
    assert_true(aob_folder_create(images, NULL) && aob_image_write(&image, path, NULL));
    aob_image_finish(&image);
    free(images);
    free(path);
}

static void add_drawn(struct aob_text *journal, const char *backend, int steps, const char *image)
{
    aob_text_add(
        journal,
        "{\"key\":\"%s%d\",\"technique\":\"gtao\",\"params\":{\"steps\":%d},\"backend\":\"%s\",\"width\":4,"
        "\"height\":4,\"status\":\"ok\",\"image\":\"images/%s\"}\n",
        backend, steps, steps, backend, image);
}

static void test_agreement(void **state)
{
    struct aob_text journal = {0};
    (void)state;
    write_image("a.exr", 0.5f);
    write_image("b.exr", 0.25f);
    add_drawn(&journal, "vulkan", 1, "a.exr");
    add_drawn(&journal, "gl-egl", 1, "b.exr"); /* one pixel of 16 by 0.25 */
    add_drawn(&journal, "vulkan", 2, "a.exr");
    add_drawn(&journal, "gl-egl", 3, "b.exr"); /* of another case: no pair */
    add_drawn(&journal, "null", 1, "b.exr");   /* draws nothing */
    put("run.json", "{}");
    put("journal.jsonl", journal.data);
    char *page = make_page();
    assert_non_null(
        strstr(page, "<p>gl-egl and vulkan: 1 pair of images, largest difference 0.25 in any pixel, RMS "
                     "0.0625.</p>"));
    assert_int_equal(count_text(page, "of images"), 1);
    free(page);
    add_drawn(&journal, "vulkan", 4, "a.exr");
    add_drawn(&journal, "gl-egl", 4, "a.exr");
    add_drawn(&journal, "vulkan", 5, "a.exr");
    add_drawn(&journal, "gl-egl", 5, "none.exr");
    put("journal.jsonl", journal.data);
    page = make_page();
    assert_non_null(
        strstr(page, "<p>gl-egl and vulkan: 2 pairs of images, largest difference 0.25 in any pixel, RMS "
                     "0.0442; 1 more could not be read.</p>"));
    free(page);
    aob_text_finish(&journal);
}

/* One case in two runs, each on a backend of its own: a pair all the same. */
static void test_agreement_across_runs(void **state)
{
    struct aob_text first = {0}, second = {0};
    (void)state;
    char *other = aob_path_join(folder, "other"), *out = aob_path_join(folder, "report"),
         *images = aob_path_join(other, "images");
    assert_true(aob_folder_create(other, NULL) && aob_folder_create(images, NULL));
    write_image("a.exr", 0.5f);
    add_drawn(&first, "vulkan", 1, "a.exr");
    add_drawn(&second, "gl-egl", 1, "../../images/a.exr");
    put("run.json", "{}");
    put("journal.jsonl", first.data);
    put("other/journal.jsonl", second.data);
    const char *const folders[] = {folder, other, NULL};
    assert_true(aob_page_write(&(struct aob_page_desc){.folders = folders, .out = out}, NULL));
    char *page = get("report/index.html");
    assert_non_null(
        strstr(page, "<p>gl-egl and vulkan: 1 pair of images, largest difference 0 in any pixel"));
    free(page);
    free(images);
    free(out);
    free(other);
    aob_text_finish(&first);
    aob_text_finish(&second);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_agreement),
        cmocka_unit_test(test_agreement_across_runs),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
