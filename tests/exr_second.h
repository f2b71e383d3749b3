/* OpenEXR's C++ library as a second writer and reader of EXR files, beside the C library that the program reads with.
 * For the tests of captures. */
#ifndef AOB_TESTS_EXR_SECOND_H
#define AOB_TESTS_EXR_SECOND_H
#include <stdbool.h>
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

enum { EXR_SECOND_CHANNELS = 32, EXR_SECOND_NAME = 128 };

struct exr_second_channel {
    char name[EXR_SECOND_NAME]; /* PART.CHANNEL in a file of several parts, as aob_image_read_layers has it */
    int left, top, width, height; /* the data window, from the corner of the first part's display window */
    size_t first;                 /* of its pixels, row by row */
};
struct exr_second_image {
    int width, height; /* of the first part's display window */
    int count;
    struct exr_second_channel channels[EXR_SECOND_CHANNELS];
    size_t used, capacity; /* floats */
    float pixels[];
};

/* Reads every channel of every part; half and whole numbers become float. False: the library refuses the file, or it
 * does not fit. A damaged file may bring the library down, so it is called in a process of its own. */
bool exr_second_read(struct exr_second_image *image, const char *path);

struct exr_second_desc {
    const char *names[8];    /* ended by NULL */
    const float *pixels[8];  /* width x height each */
    char types[8];           /* 'h' half, 'f' float, 'u' whole numbers */
    const char *compression; /* "ZIP", "B44", "DWAA" ... */
    int width, height, tile; /* tile 0: scan lines */
    bool mipmap, downwards;  /* tiles of several levels; the lines lie from the bottom to the top */
    int sampling;            /* of the last channel, both ways; 0: 1 */
    const char *views[2];    /* the attribute multiView; NULL: it is not there */
};
/* False, and no file, if the library does not write that. */
bool exr_second_write(const char *path, const struct exr_second_desc *desc);

/* A deep file of one channel Z. */
bool exr_second_write_deep(const char *path, int width, int height);

#ifdef __cplusplus
}
#endif
#endif
