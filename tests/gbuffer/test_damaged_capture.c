/* Damaged captures, through the worker that reads them. */
#include "capture_file.h"
#include "damaged.h"
#include "job/capture_job.h"
#include "random.h"

enum { W = 61, H = 47 };
static uint32_t seed = 1;

/* Cut off; a bit turned anywhere; four bytes of the header, where the sizes are, set to extremes. */
static size_t damage(char *bytes, size_t size, int variant)
{
    static const uint32_t extremes[] = {0xffffffffu, 0x7fffffffu, 0x80000000u, 0, 16383};
    if (variant % 3 == 0)
        return random_below(&seed, size);
    if (variant % 3 == 1)
        bytes[random_below(&seed, size)] ^= (char)(1 << random_below(&seed, 8));
    else
        memcpy(bytes + 8 + random_below(&seed, 500), &extremes[random_below(&seed, 5)], 4);
    return size;
}

static json_t *job(const struct damaged *d)
{
    return aob_capture_job_to_json(&(struct aob_capture_job){.file = d->file, .out = d->out, .fov_deg = 50});
}

static void check_file(const char *file, const char *out, const char *what)
{
    size_t size;
    char *bytes = aob_file_read(file, 1 << 24, &size, NULL);
    assert_non_null(bytes);
    damaged_check(&(struct damaged){.what = what,
                                    .file = file,
                                    .out = out,
                                    .job = job,
                                    .answer = "width",
                                    .timeout_s = 10,
                                    .memory_limit = (size_t)4 << 30,
                                    .damage = damage,
                                    .variants = 20},
                  bytes, size);
    free(bytes);
}

static void test_damaged_captures(void **state)
{
    static const char *const names[4] = {"ViewLayer.Depth.Z", "ViewLayer.Normal.X", "ViewLayer.Normal.Y",
                                         "ViewLayer.Normal.Z"};
    static const struct {
        const char *name;
        int tile, parts;
        exr_compression_t compression;
    } kinds[] = {{"scan lines, ZIP", 0, 1, EXR_COMPRESSION_ZIP},
                 {"tiles, PIZ", 16, 1, EXR_COMPRESSION_PIZ},
                 {"two parts, RLE", 0, 2, EXR_COMPRESSION_RLE}};
    (void)state;
    char file[64], out[64];
    float *planes = AOB_NEW_ARRAY(float, 4 * W * H);
    for (int i = 0; i < 4 * W * H; i++)
        planes[i] = i < W * H ? 1 + (float)random_below(&seed, 1000) / 100 : i / (W * H) == 3;
    snprintf(file, sizeof file, "/tmp/aobudget-damaged-%ld.exr", (long)getpid());
    snprintf(out, sizeof out, "/tmp/aobudget-damaged-%ld-out.exr", (long)getpid());
    for (size_t k = 0; k < AOB_COUNT(kinds); k++) {
        struct sheet_file sheets = {.width = W, .height = H, .count = kinds[k].parts};
        for (int c = 0; c < 4; c++) {
            struct sheet *s = &sheets.sheets[c && kinds[k].parts > 1];
            *s = (struct sheet){.name = c ? "b" : "a",
                                .width = W,
                                .height = H,
                                .tile = kinds[k].tile,
                                .compression = kinds[k].compression,
                                .channels = {s->channels[0], s->channels[1], s->channels[2]}};
            int at = 0;
            while (s->channels[at].name)
                at++;
            s->channels[at] =
                (struct sheet_channel){names[c], planes + c * W * H, c ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT};
        }
        sheet_write(file, &sheets);
        check_file(file, out, kinds[k].name);
    }
    free(planes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_damaged_captures)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
