#include "capture_file.h"
#include <unistd.h>
#include "base/file.h"
#include "job/capture_job.h"
#include "run/dispatch.h"

/* Damaged captures, through the worker that reads them: the harness stays up, and every refusal is one line. */

enum { W = 61, H = 47, VARIANTS = 20 };
static unsigned seed = 1;

static size_t below(size_t n)
{
    seed = seed * 1664525u + 1013904223u;
    return (size_t)(((uint64_t)seed * n) >> 32);
}

/* Cut off; a bit turned anywhere; four bytes of the header, where the sizes are, set to extremes. */
static size_t damage(char *bytes, size_t size, int variant)
{
    static const uint32_t extremes[] = {0xffffffffu, 0x7fffffffu, 0x80000000u, 0, 16383};
    if (variant % 3 == 0)
        return below(size);
    if (variant % 3 == 1)
        bytes[below(size)] ^= (char)(1 << below(8));
    else
        memcpy(bytes + 8 + below(500), &extremes[below(5)], 4);
    return size;
}

static void count_answer(void *user, const json_t *answer)
{
    *(int *)user += json_is_integer(json_object_get(answer, "width"));
}

/* 1: read; 0: refused in one line. */
static int load(const struct aob_dispatch *dispatch, const char *file, const char *out)
{
    struct aob_error error = {{0}};
    int answers = 0;
    unlink(out);
    struct aob_job_desc desc = {
        .job = aob_capture_job_to_json(&(struct aob_capture_job){.file = file, .out = out, .fov_deg = 50}),
        .timeout_s = 10,
        .memory_limit = (size_t)4 << 30,
        .on_answer = count_answer,
        .user = &answers};
    bool ok = aob_dispatch_job(dispatch, &desc, &error);
    assert_int_equal(answers, ok);
    assert_true(ok || *error.text);
    assert_null(strchr(error.text, '\n'));
    assert_null(strstr(error.text, "crashed")); /* this reader is ours */
    assert_int_equal(aob_file_exists(out), ok);
    return ok;
}

static void check_file(const char *file, const char *out, const char *what)
{
    char *program = aob_path_join(getenv("AOBUDGET_BUILD"), "aobudget");
    struct aob_dispatch dispatch = {.program = program};
    size_t size;
    char *bytes = aob_file_read(file, 1 << 24, &size, NULL), *copy = aob_alloc(size, 1);
    assert_non_null(bytes);
    assert_int_equal(load(&dispatch, file, out), 1);
    int loaded = 0;
    for (int v = 0; v < VARIANTS; v++) {
        memcpy(copy, bytes, size);
        size_t left = damage(copy, size, v);
        assert_true(aob_file_write(file, copy, left, NULL));
        loaded += load(&dispatch, file, out);
    }
    printf("%s: of %d damaged files %d are read, %d are refused in one line\n", what, VARIANTS, loaded,
           VARIANTS - loaded);
    unlink(file);
    unlink(out);
    free(copy);
    free(bytes);
    free(program);
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
        planes[i] = i < W * H ? 1 + (float)below(1000) / 100 : i / (W * H) == 3;
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
