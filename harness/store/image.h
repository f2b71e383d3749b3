/* Images of named float channels, and OpenEXR files of them (OpenEXRCore, ZIP level 1, 32-bit float). */
#ifndef AOB_STORE_IMAGE_H
#define AOB_STORE_IMAGE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_channel {
    char name[64]; /* "technique.AO" */
    float *pixels; /* width * height, row 0 at the top; owned by the image */
};
struct aob_attribute {
    char name[64]; /* "aobudget.fov_deg" */
    double values[3];
    int count;  /* 1 or 3 numbers; 0: `text` */
    char *text; /* owned */
};
struct aob_image {
    int width, height;
    struct aob_channel *channels;
    size_t channel_count, channel_capacity;
    struct aob_attribute *attributes;
    size_t attribute_count, attribute_capacity;
};

/* aob_image_add returns a new zeroed channel. aob_image_channel returns the channel of that name, or NULL if there is
 * none. */
float *aob_image_add(struct aob_image *image, const char *name);
float *aob_image_channel(const struct aob_image *image, const char *name);
void aob_image_set_number(struct aob_image *image, const char *name, double value);
void aob_image_set_vec3(struct aob_image *image, const char *name, const double value[3]);
void aob_image_set_text(struct aob_image *image, const char *name, const char *text);
void aob_image_finish(struct aob_image *image);

/* Writes the file whole or not at all: it is written beside its place and renamed. */
bool aob_image_write(const struct aob_image *image, const char *path, struct aob_error *error);

/* Reads all channels as float (half and uint are converted) of a scan-line or tiled file (its first level), and
 * attributes of one or three numbers and strings. It refuses more than 2^28 pixels x channels, deep files,
 * the compressions B44, B44A, DWAA and DWAB, and damaged files, with one line. If a file has several parts, it reads the first. */
bool aob_image_read(struct aob_image *image, const char *path, struct aob_error *error);

/* Reads some channels of another program's file, from any of its parts. `choose` marks what it wants among all names,
 * or fails with a line. A name in a file with several parts is PART.CHANNEL, unless it begins with its part's name
 * already. The image is the display window of the first part, and NAN where a channel has no pixels; attributes are
 * the first part's. It refuses what aob_image_read refuses of the chosen channels, pixels that are not square, and
 * sizes beyond these. */
enum { AOB_LAYERS_MAX_SIDE = 16384, AOB_LAYERS_MAX_PIXELS = 40000000 };
typedef bool aob_image_choose(void *user, const char *const *names, size_t count, bool *wanted,
                              struct aob_error *error);
bool aob_image_read_layers(struct aob_image *image, const char *path, aob_image_choose *choose, void *user,
                           struct aob_error *error);
#endif
