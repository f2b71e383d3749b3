/* The pixels of a PNG of eight bits RGB, read from its format's description, without VTK and libpng. */
#ifndef AOB_TESTS_PNG_PIXELS_H
#define AOB_TESTS_PNG_PIXELS_H
#include "check.h"
#include <stdlib.h>
#include <zlib.h>

struct png {
    size_t width, height;
    unsigned char *pixels; /* 3 a pixel, row 0 at the top; free() it */
};

static size_t png_number(const unsigned char *b)
{
    return (size_t)b[0] << 24 | (size_t)b[1] << 16 | (size_t)b[2] << 8 | b[3];
}

static int png_guess(int left, int up, int corner)
{
    int p = left + up - corner, a = abs(p - left), b = abs(p - up), c = abs(p - corner);
    return a <= b && a <= c ? left : b <= c ? up : corner;
}

/* Undoes a row's filter; `above` is the row before it, or zeros. */
static void png_undo(int filter, unsigned char *row, const unsigned char *above, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        int left = i >= 3 ? row[i - 3] : 0, up = above[i], corner = i >= 3 ? above[i - 3] : 0;
        const int guesses[] = {0, left, up, (left + up) / 2, png_guess(left, up, corner)};
        row[i] = (unsigned char)(row[i] + guesses[filter]);
    }
}

static struct png png_read(const unsigned char *bytes, size_t size)
{
    struct png png = {png_number(bytes + 16), png_number(bytes + 20), NULL};
    size_t packed_size = 0, stride = 3 * png.width;
    uLongf room = (stride + 1) * png.height;
    unsigned char *packed = malloc(size), *rows = malloc(room), *zeros = calloc(stride, 1);
    assert_memory_equal(bytes + 24, "\x08\x02\0\0\0", 5); /* 8 bits, RGB, not interlaced */
    for (size_t at = 8; at + 8 < size; at += 12 + png_number(bytes + at))
        if (memcmp(bytes + at + 4, "IDAT", 4) == 0) {
            memcpy(packed + packed_size, bytes + at + 8, png_number(bytes + at));
            packed_size += png_number(bytes + at);
        }
    assert_int_equal(uncompress(rows, &room, packed, packed_size), Z_OK);
    png.pixels = malloc(stride * png.height);
    for (size_t y = 0; y < png.height; y++) {
        unsigned char *row = png.pixels + y * stride;
        memcpy(row, rows + y * (stride + 1) + 1, stride);
        assert_in_range(rows[y * (stride + 1)], 0, 4);
        png_undo(rows[y * (stride + 1)], row, y ? row - stride : zeros, stride);
    }
    free(packed);
    free(rows);
    free(zeros);
    return png;
}

static unsigned png_colour(const struct png *png, size_t x, size_t y)
{
    assert_true(x < png->width && y < png->height);
    const unsigned char *p = png->pixels + 3 * (y * png->width + x);
    return (unsigned)p[0] << 16 | (unsigned)p[1] << 8 | p[2];
}
#endif
