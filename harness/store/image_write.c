#include "image.h"
#include "base/memory.h"
#include "base/sealed.h"
#include <OpenEXR/openexr.h>
#include <stdlib.h>
#include <string.h>

enum { SHORT_NAME = 31 }; /* longer names need a flag in the file */

struct writer {
    const struct aob_image *image;
    exr_context_t file;
    exr_encode_pipeline_t pipeline;
    int part;
    bool encoding; /* the pipeline is initialised */
};

/* The file's bytes. The library would create a file by its name, through whatever link lies there. */
struct bytes {
    char *data;
    size_t size, room;
};

static int64_t write_bytes(exr_const_context_t context, void *user, const void *from, uint64_t size,
                           uint64_t offset, exr_stream_error_func_ptr_t fail)
{
    struct bytes *bytes = user;
    (void)context;
    (void)fail;
    if (offset + size > bytes->room) {
        bytes->room = 2 * (offset + size);
        bytes->data = aob_realloc(bytes->data, bytes->room, 1);
    }
    if (offset > bytes->size) /* the table of places is filled in at the end */
        memset(bytes->data + bytes->size, 0, offset - bytes->size);
    memcpy(bytes->data + offset, from, size);
    if (offset + size > bytes->size)
        bytes->size = offset + size;
    return (int64_t)size;
}

/* OpenEXRCore prints to standard error unless it has a handler, and an error must be one line of ours. */
static void ignore_message(exr_const_context_t context, exr_result_t code, const char *message)
{
    (void)context;
    (void)code;
    (void)message;
}

static bool has_long_name(const struct aob_image *image)
{
    bool found = false;
    for (size_t i = 0; i < image->channel_count; i++)
        found = found || strlen(image->channels[i].name) > SHORT_NAME;
    for (size_t i = 0; i < image->attribute_count; i++)
        found = found || strlen(image->attributes[i].name) > SHORT_NAME;
    return found;
}

static exr_result_t write_attribute(struct writer *w, const struct aob_attribute *a)
{
    if (a->count == 1)
        return exr_attr_set_double(w->file, w->part, a->name, a->values[0]);
    if (a->count == 3) {
        exr_attr_v3d_t v = {.x = a->values[0], .y = a->values[1], .z = a->values[2]};
        return exr_attr_set_v3d(w->file, w->part, a->name, &v);
    }
    return exr_attr_set_string(w->file, w->part, a->name, a->text ? a->text : "");
}

static exr_result_t write_header(struct writer *w)
{
    const struct aob_image *image = w->image;
    exr_attr_box2i_t window = {.min = {.x = 0, .y = 0},
                               .max = {.x = image->width - 1, .y = image->height - 1}};
    exr_attr_v2f_t centre = {.x = 0, .y = 0};
    exr_result_t rc = exr_set_longname_support(w->file, has_long_name(image));
    if (rc == EXR_ERR_SUCCESS)
        rc = exr_add_part(w->file, "aobudget", EXR_STORAGE_SCANLINE, &w->part);
    if (rc == EXR_ERR_SUCCESS)
        rc = exr_initialize_required_attr(w->file, w->part, &window, &window, 1.0f, &centre, 1.0f,
                                          EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_ZIP);
    for (size_t i = 0; i < image->channel_count && rc == EXR_ERR_SUCCESS; i++)
        rc = exr_add_channel(w->file, w->part, image->channels[i].name, EXR_PIXEL_FLOAT,
                             EXR_PERCEPTUALLY_LINEAR, 1, 1);
    for (size_t i = 0; i < image->attribute_count && rc == EXR_ERR_SUCCESS; i++)
        rc = write_attribute(w, &image->attributes[i]);
    return rc == EXR_ERR_SUCCESS ? exr_write_header(w->file) : rc;
}

/* The library sorts the channels by name, so each is found again by its own. */
static void point_channels_at(struct writer *w, int row)
{
    size_t width = (size_t)w->image->width;
    for (int c = 0; c < w->pipeline.channel_count; c++) {
        exr_coding_channel_info_t *channel = &w->pipeline.channels[c];
        const float *pixels = aob_image_channel(w->image, channel->channel_name);
        channel->encode_from_ptr = (const uint8_t *)(pixels + (size_t)row * width);
        channel->user_pixel_stride = sizeof(float);
        channel->user_line_stride = (int32_t)(sizeof(float) * width);
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = sizeof(float);
    }
}

static exr_result_t write_chunk(struct writer *w, int row)
{
    exr_chunk_info_t chunk;
    exr_result_t rc = exr_write_scanline_chunk_info(w->file, w->part, row, &chunk);
    if (rc != EXR_ERR_SUCCESS)
        return rc;
    bool first = !w->encoding;
    rc = first ? exr_encoding_initialize(w->file, w->part, &chunk, &w->pipeline)
               : exr_encoding_update(w->file, w->part, &chunk, &w->pipeline);
    if (rc != EXR_ERR_SUCCESS)
        return rc;
    w->encoding = true;
    point_channels_at(w, row);
    if (first)
        rc = exr_encoding_choose_default_routines(w->file, w->part, &w->pipeline);
    return rc == EXR_ERR_SUCCESS ? exr_encoding_run(w->file, w->part, &w->pipeline) : rc;
}

static exr_result_t write_pixels(struct writer *w)
{
    int32_t lines = 0;
    exr_result_t rc = exr_get_scanlines_per_chunk(w->file, w->part, &lines);
    for (int row = 0; row < w->image->height && rc == EXR_ERR_SUCCESS; row += lines)
        rc = write_chunk(w, row);
    return rc;
}

static exr_result_t encode(const struct aob_image *image, const char *name, struct bytes *bytes)
{
    struct writer w = {.image = image};
    exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
    init.error_handler_fn = ignore_message;
    init.user_data = bytes;
    init.write_fn = write_bytes;
    init.zip_level = 1; /* level 1 gives files as small as level 9 on such data, in two thirds of the time */
    exr_result_t rc = exr_start_write(&w.file, name, EXR_WRITE_FILE_DIRECTLY, &init);
    if (rc != EXR_ERR_SUCCESS)
        return rc;
    rc = write_header(&w);
    if (rc == EXR_ERR_SUCCESS)
        rc = write_pixels(&w);
    if (w.encoding)
        exr_encoding_destroy(w.file, &w.pipeline);
    exr_result_t end = exr_finish(&w.file);
    return rc == EXR_ERR_SUCCESS ? end : rc;
}

bool aob_image_write(const struct aob_image *image, const char *path, struct aob_error *error)
{
    struct bytes bytes = {0};
    if (image->width < 1 || image->height < 1 || image->channel_count == 0)
        return aob_fail(error, "%s: cannot write an image without pixels or channels", path);
    exr_result_t rc = encode(image, path, &bytes);
    bool ok =
        rc == EXR_ERR_SUCCESS
            ? aob_sealed_write(path, &(struct aob_piece){bytes.data, bytes.size}, 1, error)
            : aob_fail(error, "%s: cannot encode the image: %s", path, exr_get_default_error_message(rc));
    free(bytes.data);
    return ok;
}
