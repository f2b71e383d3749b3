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

/* Adds a channel of every `stride`th float of `from`, one a pixel; aob_image_interleaved goes the other way: `count` channels side
 * by side with `stride` floats a pixel, the rest 0, for the caller to free; NULL unless all of them are there. */
void aob_image_add_part(struct aob_image *image, const char *name, const float *from, size_t stride);
float *aob_image_interleaved(const struct aob_image *image, const char *const *names, size_t count,
                             size_t stride);
void aob_image_set_number(struct aob_image *image, const char *name, double value);
void aob_image_set_vec3(struct aob_image *image, const char *name, const double value[3]);
void aob_image_set_text(struct aob_image *image, const char *name, const char *text);
void aob_image_finish(struct aob_image *image);

/* Writes a sealed file (base/sealed.h) whole or not at all. Other readers of OpenEXR do not see the seal. */
bool aob_image_write(const struct aob_image *image, const char *path, struct aob_error *error);

/* Reads all channels and attributes of a file that aob_image_write wrote under this name; any other is refused with one
 * line, unseen. It refuses more than 2^29 pixels x channels. */
bool aob_image_read(struct aob_image *image, const char *path, struct aob_error *error);

/* Reads some channels of another program's file, scan lines or tiles (their first level), from any of its parts, as
 * float (half and uint are converted), and attributes of one or three numbers and strings. `choose` marks what it wants
 * among all names, or fails with a line. A name in a file with several parts is PART.CHANNEL, unless it begins with its
 * part's name already. The image is the display window of the first part, and NAN where a channel has no pixels;
 * attributes are the first part's. It refuses, with one line, deep and damaged files, the compressions B44, B44A, DWAA
 * and DWAB, more than 2^29 pixels x channels of the chosen ones, pixels that are not square, and sizes beyond these. */
enum { AOB_LAYERS_MAX_SIDE = 16384, AOB_LAYERS_MAX_PIXELS = 40000000 };
typedef bool aob_image_choose(void *user, const char *const *names, size_t count, bool *wanted,
                              struct aob_error *error);
bool aob_image_read_layers(struct aob_image *image, const char *path, aob_image_choose *choose, void *user,
                           struct aob_error *error);
#endif
