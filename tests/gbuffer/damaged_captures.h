/* Captures of every layout and compression, damaged and brought to the worker that reads them. What it loads is read by
 * OpenEXR's C++ library as well: the two agree in every pixel. */
#ifndef AOB_TESTS_GBUFFER_DAMAGED_CAPTURES_H
#define AOB_TESTS_GBUFFER_DAMAGED_CAPTURES_H
#include "capture_file.h"
#include "damaged.h"
#include "exr_compare.h"
#include "job/capture_job.h"
#include "random.h"

enum { DAMAGED_W = 61, DAMAGED_H = 47, DAMAGED_COUNT = DAMAGED_W * DAMAGED_H };

struct damaged_kind {
    const char *name, *compression;
    const char *types; /* of Z and the normal's X, Y, Z */
    int tile, parts;
    bool mipmap, downwards;
    exr_compression_t of_parts;
};

static const struct damaged_kind damaged_kinds[] = {
    {.name = "scan lines, raw", .compression = "none", .types = "ffff"},
    {.name = "scan lines, RLE", .compression = "RLE", .types = "hhhh"},
    {.name = "scan lines, ZIPS", .compression = "ZIPS", .types = "fhhh"},
    {.name = "scan lines, ZIP", .compression = "ZIP", .types = "ffff"},
    {.name = "scan lines, PIZ", .compression = "PIZ", .types = "fhhh"},
    {.name = "scan lines, PXR24", .compression = "PXR24", .types = "ffhh"},
    {.name = "whole numbers, ZIP", .compression = "ZIP", .types = "uhhh"},
    {.name = "upwards, ZIP", .compression = "ZIP", .types = "fhhh", .downwards = true},
    {.name = "tiles, raw", .compression = "none", .types = "fhhh", .tile = 16},
    {.name = "tiles, ZIP", .compression = "ZIP", .types = "ffff", .tile = 20},
    {.name = "tiles of levels, PIZ", .compression = "PIZ", .types = "fhhh", .tile = 16, .mipmap = true},
    {.name = "tiles of levels, PXR24", .compression = "PXR24", .types = "ffff", .tile = 32, .mipmap = true},
    {.name = "two parts, RLE", .types = "fhhh", .parts = 2, .of_parts = EXR_COMPRESSION_RLE},
    {.name = "two parts of tiles, ZIP",
     .types = "ffff",
     .parts = 2,
     .tile = 16,
     .of_parts = EXR_COMPRESSION_ZIP},
};

/* Of all kinds together. */
struct damaged_totals {
    struct exr_second_image *whole, *second; /* of the file before and after the damage */
    size_t files, loaded;
    size_t alike;   /* for both readers */
    size_t mended;  /* refused by the second reader, and as they were before the damage */
    size_t other;   /* neither */
    size_t crashes; /* of the program's own reader */
};
static struct damaged_totals damaged_totals;
static uint32_t damaged_seed;

/* Cut off; a bit turned anywhere; four bytes of the header, where the sizes are, set to extremes; a sector of zeros; a
 * byte of the tables behind the header. */
static inline size_t damaged_variant(char *bytes, size_t size, int variant)
{
    static const uint32_t extremes[] = {0xffffffffu, 0x7fffffffu, 0x80000000u, 0, 16383};
    size_t at = random_below(&damaged_seed, size);
    switch (variant % 5) {
    case 0:
        return at;
    case 1:
        bytes[at] ^= (char)(1 << random_below(&damaged_seed, 8));
        break;
    case 2:
        memcpy(bytes + 8 + random_below(&damaged_seed, 500), &extremes[random_below(&damaged_seed, 5)], 4);
        break;
    case 3:
        memset(bytes + at, 0, size - at < 512 ? size - at : 512);
        break;
    default:
        bytes[random_below(&damaged_seed, 1000)] = (char)random_below(&damaged_seed, 256);
    }
    return size;
}

static inline json_t *damaged_job(const struct damaged *d)
{
    return aob_capture_job_to_json(&(struct aob_capture_job){.file = d->file, .out = d->out, .fov_deg = 50});
}

static inline const char *damaged_compare(const struct damaged *d)
{
    struct damaged_totals *totals = &damaged_totals;
    bool both = exr_compare_second(totals->second, d->file);
    int answer = exr_compare_first(both ? totals->second : totals->whole, d->file);
    totals->loaded++;
    totals->alike += both && answer == EXR_COMPARE_ALIKE;
    totals->mended += !both && answer == EXR_COMPARE_ALIKE;
    totals->other += answer == EXR_COMPARE_OTHER;
    totals->crashes += answer < 0;
    if (answer == EXR_COMPARE_OTHER)
        return both ? "other pixels than the second reader's" : "other pixels than before the damage";
    return answer < 0 ? "the reader crashed" : both ? "" : NULL;
}

static inline void damaged_write_parts(const char *file, const struct damaged_kind *kind, const float *planes)
{
    static const char *const names[4] = {"ViewLayer.Depth.Z", "ViewLayer.Normal.X", "ViewLayer.Normal.Y",
                                         "ViewLayer.Normal.Z"};
    struct sheet_file sheets = {.width = DAMAGED_W, .height = DAMAGED_H, .count = kind->parts};
    for (int c = 0; c < 4; c++) {
        struct sheet *s = &sheets.sheets[c > 0];
        s->name = c ? "b" : "a";
        s->width = DAMAGED_W;
        s->height = DAMAGED_H;
        s->tile = kind->tile;
        s->compression = kind->of_parts;
        s->channels[c ? c - 1 : 0] = (struct sheet_channel){
            names[c], planes + c * DAMAGED_COUNT, kind->types[c] == 'h' ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT};
    }
    sheet_write(file, &sheets);
}

static inline void damaged_write(const char *file, const struct damaged_kind *kind, const float *planes)
{
    static const char *const names[4] = {"Z", "N.X", "N.Y", "N.Z"};
    struct exr_second_desc desc = {.compression = kind->compression,
                                   .width = DAMAGED_W,
                                   .height = DAMAGED_H,
                                   .tile = kind->tile,
                                   .mipmap = kind->mipmap,
                                   .downwards = kind->downwards};
    for (int c = 0; c < 4; c++) {
        desc.names[c] = names[c];
        desc.pixels[c] = planes + c * DAMAGED_COUNT;
        desc.types[c] = kind->types[c];
    }
    if (kind->parts)
        damaged_write_parts(file, kind, planes);
    else
        assert_true(exr_second_write(file, &desc));
}

/* `variants` of each kind; adds up what became of them, and what readers say is in damaged_totals. */
static inline void damaged_captures(int variants, uint32_t seed, struct damaged_counts *counts)
{
    char file[64], out[64];
    float *planes = AOB_NEW_ARRAY(float, 4 * DAMAGED_COUNT);
    damaged_seed = seed;
    damaged_totals = (struct damaged_totals){.whole = exr_compare_create(), .second = exr_compare_create()};
    for (int i = 0; i < 4 * DAMAGED_COUNT; i++)
        planes[i] =
            i < DAMAGED_COUNT ? 2 + (float)random_below(&damaged_seed, 1000) / 100 : i >= 3 * DAMAGED_COUNT;
    snprintf(file, sizeof file, "/tmp/aobudget-damaged-%ld.exr", (long)getpid());
    snprintf(out, sizeof out, "/tmp/aobudget-damaged-%ld-out.exr", (long)getpid());
    for (size_t k = 0; k < AOB_COUNT(damaged_kinds); k++) {
        size_t size;
        damaged_write(file, &damaged_kinds[k], planes);
        char *bytes = aob_file_read(file, 1 << 24, &size, NULL);
        assert_non_null(bytes);
        assert_true(exr_compare_second(damaged_totals.whole, file));
        damaged_run(&(struct damaged){.what = damaged_kinds[k].name,
                                      .file = file,
                                      .out = out,
                                      .job = damaged_job,
                                      .answer = "width",
                                      .timeout_s = 30,
                                      .memory_limit = (size_t)4 << 30,
                                      .damage = damaged_variant,
                                      .variants = variants,
                                      .judge = damaged_compare},
                    bytes, size, counts);
        damaged_totals.files += (size_t)variants;
        free(bytes);
    }
    exr_compare_destroy(damaged_totals.whole);
    exr_compare_destroy(damaged_totals.second);
    free(planes);
}
#endif
