/* Every form of an EXR file that OpenEXR's C++ library writes: the program reads it as that library does, or refuses it
 * by what it is. */
#include <math.h>
#include "exr_compare.h"
#include "random.h"

enum { W = 61, H = 47, COUNT = W * H };
static char path[64];
static float planes[4][COUNT];

static void make_planes(void)
{
    uint32_t seed = 7;
    for (int c = 0; c < 4; c++)
        for (int i = 0; i < COUNT; i++)
            planes[c][i] = (float)(c * 20 + i % W * 0.25 + i / W) + (float)random_below(&seed, 1000) / 500;
}

/* 1: read, and alike; 0: refused with a line that says `refusal`. */
static bool check_form(const struct exr_second_desc *desc, const char *what, const char *refusal)
{
    struct exr_second_image *second = exr_compare_create();
    struct aob_image image;
    struct aob_error error = {{0}};
    if (!exr_second_write(path, desc))
        fail_msg("%s: not written", what);
    if (!exr_compare_second(second, path) && !refusal)
        fail_msg("%s: the second reader refuses it", what);
    bool read = aob_image_read_layers(&image, path, exr_compare_want_all, NULL, &error);
    if (read == (refusal != NULL))
        fail_msg("%s: %s", what, read ? "read" : error.text);
    if (read && exr_compare(second, &image) != 0)
        fail_msg("%s: %zu pixels differ", what, exr_compare(second, &image));
    if (!read) {
        assert_contains(error.text, refusal);
        assert_contains(error.text, path);
    }
    aob_image_finish(&image);
    exr_compare_destroy(second);
    unlink(path);
    return read;
}

static void test_compressions(void **state)
{
    static const char *const names[] = {"none",  "RLE", "ZIPS", "ZIP",  "PIZ",
                                        "PXR24", "B44", "B44A", "DWAA", "DWAB"};
    static const char *const types[] = {"ffff", "hhhh", "uuuu", "fhuf", "hfhf", "uffh", "f", "h", "u"};
    static const int tiles[] = {0, 16, 64};
    (void)state;
    for (size_t n = 0; n < AOB_COUNT(names); n++)
        for (size_t t = 0; t < AOB_COUNT(types); t++)
            for (size_t k = 0; k < AOB_COUNT(tiles); k++)
                for (int order = 0; order < 2; order++) {
                    struct exr_second_desc desc = {.compression = names[n],
                                                   .width = W,
                                                   .height = H,
                                                   .tile = tiles[k],
                                                   .mipmap = order,
                                                   .downwards = order};
                    static const char *const channels[4] = {"A", "N.X", "R", "Z"};
                    char what[64], refusal[64];
                    for (size_t c = 0; c < strlen(types[t]); c++) {
                        desc.names[c] = channels[c];
                        desc.pixels[c] = planes[c];
                        desc.types[c] = types[t][c];
                    }
                    snprintf(what, sizeof what, "%s %s tile %d, %d", names[n], types[t], tiles[k], order);
                    snprintf(refusal, sizeof refusal, "its compression (%s)", names[n]);
                    check_form(&desc, what, n < 6 ? NULL : refusal);
                }
}

int main(void)
{
    make_planes();
    snprintf(path, sizeof path, "/tmp/aobudget-forms-%ld.exr", (long)getpid());
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_compressions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
