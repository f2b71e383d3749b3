/* Images for tests of the store: where they lie, and what they hold. */
#ifndef AOB_TESTS_STORE_IMAGE_SAMPLE_H
#define AOB_TESTS_STORE_IMAGE_SAMPLE_H
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/memory.h"
#include "check.h"
#include "random.h"
#include "store/image.h"

enum { PATH_SIZE = 256 };

static inline void test_path(char path[PATH_SIZE], const char *name)
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, PATH_SIZE, "%s/aob-test-image-%ld-%s", folder ? folder : "/tmp", (long)getpid(), name);
}

/* Smooth waves with noise, and the values that a careless path would change. */
static inline void fill(float *pixels, size_t count, uint32_t seed)
{
    static const uint32_t special[] = {0x7f800000u, 0xff800000u, 0x7fc12345u, 0x80000000u, 1u, 0x7f7fffffu};
    for (size_t i = 0; i < count; i++)
        pixels[i] = sinf(0.01f * (float)i) + (float)(random_next(&seed) >> 8 & 255) / 4096.0f;
    for (size_t i = 0; i < AOB_COUNT(special) && i < count; i++)
        memcpy(&pixels[count - 1 - i], &special[i], sizeof special[i]);
}

static inline struct aob_image sample_image(int width, int height)
{
    static const char *const names[] = {"technique.AO", "Z", "N.X",
                                        "a.channel.with.a.name.over.31.characters"};
    struct aob_image image = {.width = width, .height = height};
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        fill(aob_image_add(&image, names[i]), (size_t)width * (size_t)height, (uint32_t)i);
    aob_image_set_number(&image, "aobudget.fov_deg", 60.25);
    aob_image_set_vec3(&image, "aobudget.eye", (double[3]){0.1, -2, 4e-7});
    aob_image_set_text(&image, "aobudget.technique", "gtao \"x\" \xc3\xbc");
    return image;
}

static inline const struct aob_attribute *find_attribute(const struct aob_image *image, const char *name)
{
    for (size_t i = 0; i < image->attribute_count; i++)
        if (strcmp(image->attributes[i].name, name) == 0)
            return &image->attributes[i];
    return NULL;
}

static inline bool choose_all(void *user, const char *const *names, size_t count, bool *wanted,
                              struct aob_error *error)
{
    (void)user;
    (void)names;
    (void)error;
    memset(wanted, true, count * sizeof *wanted);
    return true;
}
#endif
