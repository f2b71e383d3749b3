/* OpenEXR images: sealed here as our own, and as they are as those of other programs. */
#include "store/image.h"
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

enum {
    MOST = 3,
    LARGEST = 1 << 20
}; /* channels that are asked for; pixels of a display window, which take time */

static bool choose_first(void *user, const char *const *names, size_t count, bool *wanted,
                         struct aob_error *error)
{
    (void)user;
    for (size_t i = 0; i < count; i++)
        wanted[i] = *names[i] && i < MOST;
    return count || aob_fail(error, "%s: no channels", (const char *)user);
}

static void check_image(const struct aob_image *image)
{
    fuzz_require(image->width > 0 && image->height > 0, "an image has pixels");
    for (size_t i = 0; i < image->channel_count; i++)
        fuzz_require(aob_image_channel(image, image->channels[i].name) == image->channels[i].pixels,
                     "no two channels have one name");
    for (size_t i = 0; i < image->attribute_count; i++) {
        const struct aob_attribute *a = &image->attributes[i];
        fuzz_require(a->count == 1 || a->count == 3 || (a->count == 0 && a->text), "an attribute is a value");
    }
}

static const struct aob_attribute *find_attribute(const struct aob_image *image, const char *name)
{
    for (size_t i = 0; i < image->attribute_count; i++)
        if (strcmp(image->attributes[i].name, name) == 0)
            return &image->attributes[i];
    return NULL;
}

static void check_same(const struct aob_image *a, const struct aob_image *b)
{
    size_t bytes = (size_t)a->width * (size_t)a->height * sizeof(float);
    fuzz_require(a->width == b->width && a->height == b->height && a->channel_count == b->channel_count &&
                     a->attribute_count == b->attribute_count,
                 "an image that is read again has its size, channels and attributes");
    for (size_t i = 0; i < a->channel_count; i++) {
        const float *pixels = aob_image_channel(b, a->channels[i].name);
        fuzz_require(pixels && memcmp(pixels, a->channels[i].pixels, bytes) == 0,
                     "an image that is read again has its pixels");
    }
    for (size_t i = 0; i < a->attribute_count; i++) {
        const struct aob_attribute *mine = &a->attributes[i], *other = find_attribute(b, mine->name);
        fuzz_require(other && other->count == mine->count &&
                         (mine->count ? memcmp(mine->values, other->values, sizeof mine->values) == 0
                                      : strcmp(mine->text, other->text) == 0),
                     "an image that is read again has its attributes");
    }
}

static void check_again(const struct aob_image *image)
{
    struct aob_image again;
    struct aob_error error = {{0}};
    char *path = fuzz_path("again");
    fuzz_require(aob_image_write(image, path, &error), "an image can be written");
    fuzz_require(aob_image_read(&again, path, &error), "an image can be read again");
    check_same(image, &again);
    aob_image_finish(&again);
    free(path);
}

static void read_own(const uint8_t *bytes, size_t size)
{
    struct aob_image image;
    struct aob_error error = {{0}};
    char *path = fuzz_sealed_file("input", bytes, size);
    if (fuzz_answer(aob_image_read(&image, path, &error), &error, path)) {
        check_image(&image);
        check_again(&image);
        aob_image_finish(&image);
    }
    free(path);
}

static bool is_large(const uint8_t *bytes, size_t size)
{
    static const char name[] = "displayWindow\0box2i\0\020\0\0"; /* and the NUL is the size's last byte */
    int32_t box[4];                                              /* left, top, right, bottom */
    const uint8_t *at = memmem(bytes, size, name, sizeof name), *end = bytes + size;
    if (!at || (size_t)(end - at) < sizeof name + sizeof box)
        return false;
    memcpy(box, at + sizeof name, sizeof box);
    return ((double)box[2] - box[0] + 1) * ((double)box[3] - box[1] + 1) > LARGEST;
}

static void read_foreign(const uint8_t *bytes, size_t size)
{
    struct aob_image image;
    struct aob_error error = {{0}};
    char *path = fuzz_file("input", bytes, size);
    if (fuzz_answer(aob_image_read_layers(&image, path, choose_first, path, &error), &error, path)) {
        check_image(&image);
        aob_image_finish(&image);
    }
    free(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (!is_large(bytes, size))
        read_foreign(bytes, size);
    read_own(bytes, size);
    return 0;
}
