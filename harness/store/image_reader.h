/* An OpenEXR file while it is read, for image_read.c and image_layers.c. */
#ifndef AOB_STORE_IMAGE_READER_H
#define AOB_STORE_IMAGE_READER_H
#include <OpenEXR/openexr.h>
#include "image.h"

struct aob_image_reader {
    const char *path;
    const char *bytes; /* the file's content; NULL: it is read from the file */
    size_t size;       /* of that */
    struct aob_image *image;
    struct aob_error *error;
    exr_context_t file;
    int part;
    const bool *wanted; /* which channels of the part; NULL: all */
    exr_decode_pipeline_t pipeline;
    bool decoding;           /* the pipeline is initialised */
    exr_attr_box2i_t window; /* of the pixels; its corner need not be 0, 0 */
    exr_storage_t storage;
    float **planes; /* one for each channel of the part, in the file's order; NULL where it is not wanted */
};

bool aob_image_reader_open(
    struct aob_image_reader *r); /* `path`, `bytes` and `error` set; close by exr_finish(&r->file) */

/* False after a line "PATH: cannot read the WHAT: ..." unless rc is success. */
bool aob_image_reader_check(struct aob_image_reader *r, exr_result_t rc, const char *what);

/* False after a line where `image`, whose size is known, would have no channels, or more pixels x channels than are
 * read. */
bool aob_image_reader_fits(struct aob_image_reader *r, size_t channels);

/* Reads the wanted channels of part `part`, in the file's order, and its attributes into `image`, which takes its
 * size from the part. */
bool aob_image_reader_part(struct aob_image_reader *r);
bool aob_image_reader_attributes(struct aob_image_reader *r);
#endif
