/* EXR files as other renderers write them: parts, tiles, half and whole numbers, windows; for the tests of captures. */
#ifndef AOB_TESTS_GBUFFER_CAPTURE_FILE_H
#define AOB_TESTS_GBUFFER_CAPTURE_FILE_H
#include <OpenEXR/openexr.h>
#include <stdlib.h>
#include "check.h"
#include "base/memory.h"

struct sheet_channel {
    const char *name;
    const float *pixels; /* of the data window; converted as `type` wants it */
    exr_pixel_type_t type;
};
struct sheet { /* one part */
    const char *name;
    struct sheet_channel channels[8]; /* ended by a NULL name */
    int width, height, left, top;     /* of the data window, relative to the display window */
    int tile;                         /* 0: scan lines */
    exr_compression_t compression;
};
struct sheet_file {
    int width, height; /* of the display window, which begins at (5, -7) */
    float aspect;      /* 0: 1 */
    struct sheet sheets[3];
    int count;
};

static inline void sheet_value(exr_pixel_type_t type, float value, uint8_t *into)
{
    _Float16 half = (_Float16)value;
    uint32_t whole = (uint32_t)value;
    if (type == EXR_PIXEL_HALF)
        memcpy(into, &half, 2);
    else
        memcpy(into, type == EXR_PIXEL_UINT ? (void *)&whole : (void *)&value, 4);
}

static inline void sheet_chunk(exr_context_t file, int part, const struct sheet *s,
                               const exr_chunk_info_t *chunk, int x, int y)
{
    exr_encode_pipeline_t pipeline = {0};
    uint8_t *bytes[8] = {NULL};
    assert_int_equal(exr_encoding_initialize(file, part, chunk, &pipeline), 0);
    for (int c = 0; c < pipeline.channel_count; c++) {
        exr_coding_channel_info_t *channel = &pipeline.channels[c];
        const struct sheet_channel *from = s->channels;
        while (strcmp(from->name, channel->channel_name) != 0)
            from++;
        int size = from->type == EXR_PIXEL_HALF ? 2 : 4;
        bytes[c] = aob_alloc((size_t)chunk->width * (size_t)chunk->height, (size_t)size);
        for (int j = 0; j < chunk->height; j++)
            for (int i = 0; i < chunk->width; i++)
                sheet_value(from->type, from->pixels[(y + j) * s->width + x + i],
                            bytes[c] + (size_t)(j * chunk->width + i) * (size_t)size);
        channel->encode_from_ptr = bytes[c];
        channel->user_bytes_per_element = (int16_t)size;
        channel->user_pixel_stride = size;
        channel->user_line_stride = chunk->width * size;
        channel->user_data_type = (uint16_t)from->type;
    }
    assert_int_equal(exr_encoding_choose_default_routines(file, part, &pipeline), 0);
    assert_int_equal(exr_encoding_run(file, part, &pipeline), 0);
    exr_encoding_destroy(file, &pipeline);
    for (int c = 0; c < 8; c++)
        free(bytes[c]);
}

static inline void sheet_header(exr_context_t file, const struct sheet_file *f, const struct sheet *s,
                                int *part)
{
    exr_attr_box2i_t display = {.min = {.x = 5, .y = -7}, .max = {.x = 4 + f->width, .y = f->height - 8}};
    exr_attr_box2i_t data = {.min = {.x = 5 + s->left, .y = s->top - 7}};
    exr_attr_v2f_t centre = {.x = 0, .y = 0};
    data.max.x = data.min.x + s->width - 1;
    data.max.y = data.min.y + s->height - 1;
    assert_int_equal(exr_add_part(file, s->name, s->tile ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, part),
                     0);
    assert_int_equal(exr_initialize_required_attr(file, *part, &display, &data, f->aspect > 0 ? f->aspect : 1,
                                                  &centre, 1, EXR_LINEORDER_INCREASING_Y, s->compression),
                     0);
    if (s->tile)
        assert_int_equal(exr_set_tile_descriptor(file, *part, (uint32_t)s->tile, (uint32_t)s->tile,
                                                 EXR_TILE_ONE_LEVEL, EXR_TILE_ROUND_DOWN),
                         0);
    for (const struct sheet_channel *c = s->channels; c->name; c++)
        assert_int_equal(exr_add_channel(file, *part, c->name, c->type, EXR_PERCEPTUALLY_LINEAR, 1, 1), 0);
}

static inline void sheet_pixels(exr_context_t file, int part, const struct sheet *s)
{
    exr_chunk_info_t chunk;
    int32_t lines = s->tile;
    if (!s->tile)
        assert_int_equal(exr_get_scanlines_per_chunk(file, part, &lines), 0);
    for (int y = 0; y < s->height; y += lines)
        for (int x = 0; x < s->width; x += s->tile ? s->tile : s->width) {
            if (s->tile)
                assert_int_equal(
                    exr_write_tile_chunk_info(file, part, x / s->tile, y / s->tile, 0, 0, &chunk), 0);
            else
                assert_int_equal(exr_write_scanline_chunk_info(file, part, s->top - 7 + y, &chunk), 0);
            sheet_chunk(file, part, s, &chunk, x, y);
        }
}

static inline void sheet_write(const char *path, const struct sheet_file *f)
{
    exr_context_t file = NULL;
    int part;
    assert_int_equal(exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, NULL), 0);
    exr_set_longname_support(file, 1);
    for (int p = 0; p < f->count; p++)
        sheet_header(file, f, &f->sheets[p], &part);
    assert_int_equal(exr_write_header(file), 0);
    for (int p = 0; p < f->count; p++)
        sheet_pixels(file, p, &f->sheets[p]);
    assert_int_equal(exr_finish(&file), 0);
}
#endif
