#include "image_reader.h"
#include "base/memory.h"
#include "base/sealed.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Pixels x channels: 40 million of a G-buffer with materials, which has 13. */
static const size_t VALUE_LIMIT = (size_t)1 << 29;

static void ignore_message(exr_const_context_t context, exr_result_t code, const char *message)
{
    (void)context;
    (void)code;
    (void)message;
}

bool aob_image_reader_check(struct aob_image_reader *r, exr_result_t rc, const char *what)
{
    if (rc == EXR_ERR_SUCCESS)
        return true;
    return aob_fail(r->error, "%s: cannot read the %s: %s", r->path, what, exr_get_default_error_message(rc));
}

static bool read_window(struct aob_image_reader *r)
{
    if (!aob_image_reader_check(r, exr_get_data_window(r->file, r->part, &r->window), "image size"))
        return false;
    int64_t width = (int64_t)r->window.max.x - r->window.min.x + 1;
    int64_t height = (int64_t)r->window.max.y - r->window.min.y + 1;
    if (width < 1 || height < 1 || width > (int64_t)VALUE_LIMIT || height > (int64_t)VALUE_LIMIT ||
        (uint64_t)(width * height) > VALUE_LIMIT)
        return aob_fail(r->error, "%s: refused: the image is %lld x %lld pixels", r->path, (long long)width,
                        (long long)height);
    r->image->width = (int)width;
    r->image->height = (int)height;
    return true;
}

static bool read_storage(struct aob_image_reader *r)
{
    if (!aob_image_reader_check(r, exr_get_storage(r->file, r->part, &r->storage), "storage"))
        return false;
    return r->storage == EXR_STORAGE_SCANLINE || r->storage == EXR_STORAGE_TILED ||
           aob_fail(r->error, "%s: refused: deep images are not supported: flatten it first", r->path);
}

/* OpenEXRCore 3.1 has no decoder of DWAA and DWAB. That of B44 and B44A writes beyond its buffer, and mixes up channels
 * that are not half, so no such file may reach it. */
static bool judge_compression(struct aob_image_reader *r)
{
    static const char *const unread[] = {[EXR_COMPRESSION_B44] = "B44",
                                         [EXR_COMPRESSION_B44A] = "B44A",
                                         [EXR_COMPRESSION_DWAA] = "DWAA",
                                         [EXR_COMPRESSION_DWAB] = "DWAB"};
    exr_compression_t compression;
    if (!aob_image_reader_check(r, exr_get_compression(r->file, r->part, &compression), "compression"))
        return false;
    const char *name = (size_t)compression < AOB_COUNT(unread) ? unread[compression] : "unknown";
    return !name ||
           aob_fail(r->error, "%s: refused: its compression (%s) is not read: save it with ZIP, PIZ or none",
                    r->path, name);
}

bool aob_image_reader_fits(struct aob_image_reader *r, size_t channels)
{
    size_t pixels = (size_t)r->image->width * (size_t)r->image->height;
    return (channels > 0 && channels <= VALUE_LIMIT / pixels) ||
           aob_fail(r->error, "%s: refused: %zu channels of %zu pixels", r->path, channels, pixels);
}

static bool add_channels(struct aob_image_reader *r)
{
    const exr_attr_chlist_t *list = NULL;
    if (!aob_image_reader_check(r, exr_get_channels(r->file, r->part, &list), "channels"))
        return false;
    size_t count = list && list->num_channels > 0 ? (size_t)list->num_channels : 0;
    size_t wanted = count;
    for (size_t i = 0; r->wanted && i < count; i++)
        wanted -= !r->wanted[i];
    if (!aob_image_reader_fits(r, wanted))
        return false;
    r->planes = AOB_NEW_ARRAY(float *, count);
    for (size_t i = 0; i < count; i++) {
        if (r->wanted && !r->wanted[i])
            continue;
        const exr_attr_chlist_entry_t *entry = &list->entries[i];
        const char *name = entry->name.str;
        if (entry->x_sampling != 1 || entry->y_sampling != 1)
            return aob_fail(r->error, "%s: refused: channel %s is subsampled", r->path, name);
        if (strlen(name) >= sizeof r->image->channels->name || aob_image_channel(r->image, name))
            return aob_fail(r->error, "%s: refused: channel name %s is too long or there twice", r->path,
                            name);
        r->planes[i] = aob_image_add(r->image, name);
    }
    return true;
}

static void add_attribute(struct aob_image *image, const exr_attribute_t *a)
{
    switch (a->type) {
    case EXR_ATTR_INT:
        aob_image_set_number(image, a->name, a->i);
        break;
    case EXR_ATTR_FLOAT:
        aob_image_set_number(image, a->name, (double)a->f);
        break;
    case EXR_ATTR_DOUBLE:
        aob_image_set_number(image, a->name, a->d);
        break;
    case EXR_ATTR_V3F:
        aob_image_set_vec3(image, a->name,
                           (double[3]){(double)a->v3f->x, (double)a->v3f->y, (double)a->v3f->z});
        break;
    case EXR_ATTR_V3D:
        aob_image_set_vec3(image, a->name, (double[3]){a->v3d->x, a->v3d->y, a->v3d->z});
        break;
    case EXR_ATTR_STRING:
        aob_image_set_text(image, a->name, a->string->str ? a->string->str : "");
        break;
    default:
        break;
    }
}

/* The file format itself needs these attributes, and the writer makes them anew. */
static bool is_structural(const char *name)
{
    static const char *const names[] = {"pixelAspectRatio", "screenWindowWidth",  "name", "type", "version",
                                        "chunkCount",       "maxSamplesPerPixel", NULL};
    for (const char *const *n = names; *n; n++)
        if (strcmp(*n, name) == 0)
            return true;
    return false;
}

bool aob_image_reader_attributes(struct aob_image_reader *r)
{
    int32_t count = 0;
    if (!aob_image_reader_check(r, exr_get_attribute_count(r->file, r->part, &count), "attributes"))
        return false;
    for (int32_t i = 0; i < count; i++) {
        const exr_attribute_t *a = NULL;
        exr_result_t rc = exr_get_attribute_by_index(r->file, r->part, EXR_ATTR_LIST_FILE_ORDER, i, &a);
        if (!aob_image_reader_check(r, rc, "attributes"))
            return false;
        if (strlen(a->name) < sizeof r->image->attributes->name && !is_structural(a->name))
            add_attribute(r->image, a);
    }
    return true;
}

/* The chunk must lie within the image, whatever a damaged file says. Its bytes are never more than its pixels', because
 * what does not shrink is stored as it is; the library takes a chunk without any for one without pixels. */
static bool chunk_fits(const struct aob_image_reader *r, const exr_chunk_info_t *chunk, int x, int y)
{
    bool raw = chunk->compression == EXR_COMPRESSION_NONE;
    if (chunk->packed_size < (raw ? chunk->unpacked_size : 1) || chunk->packed_size > chunk->unpacked_size)
        return false;
    return chunk->width >= 1 && chunk->height >= 1 && x >= 0 && y >= 0 &&
           (int64_t)x + chunk->width <= r->image->width && (int64_t)y + chunk->height <= r->image->height;
}

/* The library turns half into float, but it hands whole numbers over as they are. */
static void point_channels_at(struct aob_image_reader *r, int x, int y)
{
    size_t width = (size_t)r->image->width;
    for (int c = 0; c < r->pipeline.channel_count; c++) {
        exr_coding_channel_info_t *channel = &r->pipeline.channels[c];
        bool whole = channel->data_type == EXR_PIXEL_UINT;
        if (!r->planes[c])
            continue; /* the library skips what has nowhere to go */
        channel->decode_to_ptr = (uint8_t *)(r->planes[c] + (size_t)y * width + (size_t)x);
        channel->user_pixel_stride = sizeof(float);
        channel->user_line_stride = (int32_t)(sizeof(float) * width);
        channel->user_data_type = whole ? EXR_PIXEL_UINT : EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = sizeof(float);
    }
}

static void convert_whole_numbers(struct aob_image_reader *r, const exr_chunk_info_t *chunk, int x, int y)
{
    for (int c = 0; c < r->pipeline.channel_count; c++) {
        if (!r->planes[c] || r->pipeline.channels[c].data_type != EXR_PIXEL_UINT)
            continue;
        for (int j = 0; j < chunk->height; j++) {
            float *row = r->planes[c] + (size_t)(y + j) * (size_t)r->image->width + (size_t)x;
            for (int i = 0; i < chunk->width; i++) {
                uint32_t bits;
                memcpy(&bits, row + i, sizeof bits);
                row[i] = (float)bits;
            }
        }
    }
}

/* x and y say where the chunk belongs in the image. */
static bool read_chunk(struct aob_image_reader *r, const exr_chunk_info_t *chunk, int x, int y)
{
    if (!chunk_fits(r, chunk, x, y))
        return aob_fail(r->error, "%s: damaged: a block has another size than its pixels", r->path);
    exr_result_t rc = r->decoding ? exr_decoding_update(r->file, r->part, chunk, &r->pipeline)
                                  : exr_decoding_initialize(r->file, r->part, chunk, &r->pipeline);
    if (rc == EXR_ERR_SUCCESS) {
        r->decoding = true;
        point_channels_at(r, x, y);
        rc = exr_decoding_choose_default_routines(r->file, r->part, &r->pipeline);
    }
    if (rc == EXR_ERR_SUCCESS)
        rc = exr_decoding_run(r->file, r->part, &r->pipeline);
    if (!aob_image_reader_check(r, rc, "pixels"))
        return false;
    convert_whole_numbers(r, chunk, x, y);
    return true;
}

static bool read_scanlines(struct aob_image_reader *r)
{
    int32_t lines = 0;
    if (!aob_image_reader_check(r, exr_get_scanlines_per_chunk(r->file, r->part, &lines), "pixels"))
        return false;
    if (lines < 1)
        return aob_fail(r->error, "%s: damaged: its blocks have no lines", r->path);
    for (int y = 0; y < r->image->height; y += lines) {
        exr_chunk_info_t chunk;
        if (!aob_image_reader_check(
                r, exr_read_scanline_chunk_info(r->file, r->part, r->window.min.y + y, &chunk), "pixels") ||
            !read_chunk(r, &chunk, 0, y))
            return false;
    }
    return true;
}

static bool read_tiles(struct aob_image_reader *r)
{
    int32_t tile_width = 0, tile_height = 0;
    if (!aob_image_reader_check(r, exr_get_tile_sizes(r->file, r->part, 0, 0, &tile_width, &tile_height),
                                "tiles"))
        return false;
    if (tile_width < 1 || tile_height < 1)
        return aob_fail(r->error, "%s: damaged: its tiles have no pixels", r->path);
    for (int64_t y = 0; y < r->image->height; y += tile_height)
        for (int64_t x = 0; x < r->image->width; x += tile_width) {
            exr_chunk_info_t chunk;
            exr_result_t rc = exr_read_tile_chunk_info(r->file, r->part, (int)(x / tile_width),
                                                       (int)(y / tile_height), 0, 0, &chunk);
            if (!aob_image_reader_check(r, rc, "tiles") || !read_chunk(r, &chunk, (int)x, (int)y))
                return false;
        }
    return true;
}

static bool read_pixels(struct aob_image_reader *r)
{
    return r->storage == EXR_STORAGE_TILED ? read_tiles(r) : read_scanlines(r);
}

static int64_t read_bytes(exr_const_context_t context, void *user, void *into, uint64_t size, uint64_t offset,
                          exr_stream_error_func_ptr_t fail)
{
    const struct aob_image_reader *r = user;
    (void)context;
    (void)fail;
    uint64_t left = offset < r->size ? r->size - offset : 0;
    memcpy(into, r->bytes + (left ? offset : 0), size < left ? size : left);
    return (int64_t)(size < left ? size : left);
}

static int64_t count_bytes(exr_const_context_t context, void *user)
{
    const struct aob_image_reader *r = user;
    (void)context;
    return (int64_t)r->size;
}

bool aob_image_reader_open(struct aob_image_reader *r)
{
    exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
    init.error_handler_fn = ignore_message;
    if (r->bytes) {
        init.user_data = r;
        init.read_fn = read_bytes;
        init.size_fn = count_bytes;
    }
    /* Otherwise the library steps over what it cannot read in a header, and assumes the rest: a window, a
     * compression. */
    init.flags = EXR_CONTEXT_FLAG_STRICT_HEADER;
    exr_result_t rc = exr_start_read(&r->file, r->path, &init);
    return rc == EXR_ERR_SUCCESS ||
           aob_fail(r->error, "%s: cannot read the image: %s", r->path, exr_get_default_error_message(rc));
}

/* The wanted channels of one part, and its attributes. */
bool aob_image_reader_part(struct aob_image_reader *r)
{
    bool ok = read_window(r) && read_storage(r) && judge_compression(r) && add_channels(r) &&
              aob_image_reader_attributes(r) && read_pixels(r);
    if (r->decoding)
        exr_decoding_destroy(r->file, &r->pipeline);
    free(r->planes);
    r->decoding = false;
    r->planes = NULL;
    r->pipeline = (exr_decode_pipeline_t){0};
    return ok;
}

bool aob_image_read(struct aob_image *image, const char *path, struct aob_error *error)
{
    *image = (struct aob_image){0};
    struct aob_image_reader r = {.path = path, .image = image, .error = error};
    char *bytes = aob_sealed_read(path, &r.size, error);
    r.bytes = bytes;
    bool ok = bytes && aob_image_reader_open(&r);
    if (ok) {
        ok = aob_image_reader_part(&r);
        exr_finish(&r.file);
    }
    free(bytes);
    if (!ok)
        aob_image_finish(image);
    return ok;
}
