/* A second reader of the EXR files that the program writes, from the format's description alone and without OpenEXR: one
 * part of scan lines, ZIP or none, 32-bit floats. Anything else ends the program. */
#ifndef AOB_TESTS_EXR_READER_H
#define AOB_TESTS_EXR_READER_H
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { EXR_CHANNELS_MAX = 32, EXR_LINES = 16 };

struct exr_file {
    int width, height, count, compression; /* compression: 0 none, 3 ZIP of 16 lines */
    char names[EXR_CHANNELS_MAX][64];      /* as in the file, which sorts them */
    float *pixels[EXR_CHANNELS_MAX];       /* row 0 at the top */
};

static inline void exr_need(int condition, const char *what)
{
    if (!condition) {
        printf("exr_reader: %s\n", what);
        exit(2);
    }
}

static inline int32_t exr_int(const unsigned char *at)
{
    return (int32_t)((uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24);
}

static inline void exr_channels(struct exr_file *file, const unsigned char *at)
{
    for (; *at; at += strlen((const char *)at) + 1 + 16) {
        const unsigned char *kind = at + strlen((const char *)at) + 1;
        exr_need(file->count < EXR_CHANNELS_MAX && strlen((const char *)at) < 64, "too many channels");
        exr_need(exr_int(kind) == 2, "a channel that is no 32-bit float");
        exr_need(exr_int(kind + 8) == 1 && exr_int(kind + 12) == 1, "a subsampled channel");
        strcpy(file->names[file->count++], (const char *)at);
    }
}

/* Returns the first byte behind the header. */
static inline const unsigned char *exr_header(struct exr_file *file, const unsigned char *at)
{
    exr_need(exr_int(at) == 20000630 && exr_int(at + 4) == 2, "no file of one part of scan lines");
    for (at += 8; *at;) {
        const char *name = (const char *)at, *type = name + strlen(name) + 1;
        const unsigned char *size = (const unsigned char *)type + strlen(type) + 1, *value = size + 4;
        if (strcmp(name, "channels") == 0)
            exr_channels(file, value);
        if (strcmp(name, "compression") == 0)
            file->compression = *value;
        if (strcmp(name, "dataWindow") == 0) {
            exr_need(exr_int(value) == 0 && exr_int(value + 4) == 0, "a window that begins elsewhere");
            file->width = exr_int(value + 8) + 1;
            file->height = exr_int(value + 12) + 1;
        }
        at = value + exr_int(size);
    }
    exr_need(file->compression == 0 || file->compression == 3, "another compression");
    return at + 1;
}

/* The bytes are differences from the one before, the even ones of the block first. */
static inline void exr_unpack(const unsigned char *data, int size, unsigned char *block, size_t bytes)
{
    unsigned char *mixed = malloc(bytes);
    uLongf got = bytes;
    exr_need(uncompress(mixed, &got, data, (uLong)size) == Z_OK && got == bytes, "a damaged block");
    for (size_t i = 1; i < bytes; i++)
        mixed[i] = (unsigned char)(mixed[i] + mixed[i - 1] - 128);
    for (size_t i = 0; i < bytes; i++)
        block[i] = mixed[i % 2 ? (bytes + 1) / 2 + i / 2 : i / 2];
    free(mixed);
}

static inline void exr_block(struct exr_file *file, const unsigned char *chunk)
{
    int y0 = exr_int(chunk), size = exr_int(chunk + 4), most = file->compression ? EXR_LINES : 1;
    int lines = file->height - y0 < most ? file->height - y0 : most;
    size_t row = (size_t)file->width * 4, bytes = row * (size_t)(lines * file->count);
    unsigned char *block = malloc(bytes);
    if ((size_t)size == bytes)
        memcpy(block, chunk + 8, bytes);
    else
        exr_unpack(chunk + 8, size, block, bytes);
    for (int y = 0; y < lines; y++)
        for (int c = 0; c < file->count; c++)
            memcpy(file->pixels[c] + (size_t)(y0 + y) * (size_t)file->width,
                   block + row * (size_t)(y * file->count + c), row);
    free(block);
}

static inline struct exr_file exr_read(const char *path)
{
    struct exr_file file = {0};
    FILE *stream = fopen(path, "rb");
    exr_need(stream && fseek(stream, 0, SEEK_END) == 0, "cannot open the file");
    size_t size = (size_t)ftell(stream);
    unsigned char *bytes = malloc(size);
    rewind(stream);
    exr_need(fread(bytes, 1, size, stream) == size, "cannot read the file");
    fclose(stream);
    const unsigned char *table = exr_header(&file, bytes);
    for (int c = 0; c < file.count; c++)
        file.pixels[c] = calloc((size_t)file.width * (size_t)file.height, 4);
    int lines = file.compression ? EXR_LINES : 1;
    for (int i = 0; i < (file.height + lines - 1) / lines; i++)
        exr_block(&file, bytes + exr_int(table + 8 * i)); /* these files are below 2 GB */
    free(bytes);
    return file;
}

static inline const float *exr_channel(const struct exr_file *file, const char *name)
{
    for (int c = 0; c < file->count; c++)
        if (strcmp(file->names[c], name) == 0)
            return file->pixels[c];
    return NULL;
}

static inline void exr_free(struct exr_file *file)
{
    for (int c = 0; c < file->count; c++)
        free(file->pixels[c]);
}
#endif
