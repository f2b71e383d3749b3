/* What the program reads of an EXR file against what the second reader reads of it. */
#ifndef AOB_TESTS_EXR_COMPARE_H
#define AOB_TESTS_EXR_COMPARE_H
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/memory.h"
#include "check.h"
#include "exr_second.h"
#include "store/image.h"

enum { EXR_COMPARE_FLOATS = 1 << 22 };

static inline struct exr_second_image *exr_compare_create(void)
{
    size_t size = sizeof(struct exr_second_image) + EXR_COMPARE_FLOATS * sizeof(float);
    void *memory = mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(memory != MAP_FAILED);
    return memory;
}

static inline void exr_compare_destroy(struct exr_second_image *image)
{
    munmap(image, sizeof *image + EXR_COMPARE_FLOATS * sizeof(float));
}

/* Runs `read` in a process of its own, with a ceiling of time; its answer, or -1 where it crashed or had to be
 * stopped. */
static inline int exr_compare_apart(int (*read)(struct exr_second_image *image, const char *path),
                                    struct exr_second_image *image, const char *path)
{
    enum { FIRST = 10 }; /* above the exit codes of sanitizers */
    int status;
    fflush(stdout);
    pid_t child = fork();
    assert_true(child >= 0);
    if (!child) {
        alarm(120);
        _exit(FIRST + read(image, path));
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) && WEXITSTATUS(status) >= FIRST ? WEXITSTATUS(status) - FIRST : -1;
}

static inline int exr_compare_read_second(struct exr_second_image *image, const char *path)
{
    image->capacity = EXR_COMPARE_FLOATS;
    return exr_second_read(image, path);
}

/* False as well where the library crashes. */
static inline bool exr_compare_second(struct exr_second_image *image, const char *path)
{
    return exr_compare_apart(exr_compare_read_second, image, path) == 1;
}

static inline bool exr_compare_want_all(void *user, const char *const *names, size_t count, bool *wanted,
                                        struct aob_error *error)
{
    (void)user;
    (void)names;
    (void)error;
    for (size_t i = 0; i < count; i++)
        wanted[i] = true;
    return true;
}

/* Values beyond the data window are NAN in the program's image. */
static inline size_t exr_compare_channel(const struct exr_second_image *second,
                                         const struct exr_second_channel *channel,
                                         const struct aob_image *image)
{
    const float *pixels = aob_image_channel(image, channel->name);
    size_t differ = 0;
    if (!pixels)
        return 1;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            int u = x - channel->left, v = y - channel->top;
            bool inside = u >= 0 && v >= 0 && u < channel->width && v < channel->height;
            float a = pixels[(size_t)y * (size_t)image->width + (size_t)x], b = a;
            if (inside)
                b = second->pixels[channel->first + (size_t)v * (size_t)channel->width + (size_t)u];
            differ += inside ? !(a == b || (a != a && b != b)) : a == a;
        }
    return differ;
}

/* Pixels in which the two differ; one at least where names or sizes do. */
static inline size_t exr_compare(const struct exr_second_image *second, const struct aob_image *image)
{
    size_t differ = 0;
    if (image->width != second->width || image->height != second->height ||
        image->channel_count != (size_t)second->count)
        return 1;
    for (int c = 0; c < second->count; c++)
        differ += exr_compare_channel(second, &second->channels[c], image);
    return differ;
}

enum exr_compare_answer { EXR_COMPARE_REFUSED, EXR_COMPARE_ALIKE, EXR_COMPARE_OTHER };

static inline int exr_compare_read_first(struct exr_second_image *second, const char *path)
{
    struct aob_image image;
    if (!aob_image_read_layers(&image, path, exr_compare_want_all, NULL, NULL))
        return EXR_COMPARE_REFUSED;
    size_t differ = exr_compare(second, &image);
    aob_image_finish(&image);
    return differ ? EXR_COMPARE_OTHER : EXR_COMPARE_ALIKE;
}

/* What the program makes of all channels of the file, beside what the second reader made of them; -1: it crashed. */
static inline int exr_compare_first(struct exr_second_image *second, const char *path)
{
    return exr_compare_apart(exr_compare_read_first, second, path);
}
#endif
