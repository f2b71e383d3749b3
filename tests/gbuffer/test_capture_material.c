/* Materials of captures: what a file of another renderer says of them reaches the texels; what is no share is refused or clamped. */
#include "capture_plane.h"
#include "base/memory.h"
#include "gbuffer/gbuffer.h"
#include "gbuffer/material_texels.h"

static const char *const channels[5] = {"albedo.R", "albedo.G", "albedo.B", "roughness", "metalness"};

/* Values of its own in each pixel; each is one of 256 texels exactly, of the base colour by its square. */
struct painted {
    struct plane plane;
    float values[5][COUNT];
};

static int byte_at(int c, int i)
{
    return (37 * c + 7 * i) % 256;
}

static struct painted *make_painted(void)
{
    struct painted *p = AOB_NEW(struct painted);
    make_plane(&p->plane);
    set_z(&p->plane, 1e10f);
    for (int c = 0; c < 5; c++)
        for (int i = 0; i < COUNT; i++) {
            float share = (float)byte_at(c, i) / 255;
            p->values[c][i] = c < 3 ? share * share : share;
        }
    return p;
}

/* The bits of `which` choose from the five. */
static struct sheet_file make_file(const struct painted *p, unsigned which)
{
    struct sheet_file file = one_part(&p->plane, "Z", EXR_PIXEL_FLOAT);
    int at = 1;
    for (int c = 0; c < 5; c++)
        if (which >> c & 1)
            file.sheets[0].channels[at++] =
                (struct sheet_channel){channels[c], p->values[c], EXR_PIXEL_FLOAT};
    return file;
}

/* Through the file of a G-buffer, as a worker hands it on. */
static struct aob_gbuffer store_and_load(const struct aob_capture *capture)
{
    struct aob_gbuffer gbuffer;
    struct aob_error error = {{0}};
    const struct aob_gbuffer_desc desc = {&capture->camera, W, H, 0, false};
    if (!aob_gbuffer_store_capture(&capture->hits, capture->albedo, capture->shine, path, &error) ||
        !aob_gbuffer_load(&gbuffer, path, &desc, &error))
        fail_msg("%s", error.text);
    return gbuffer;
}

static void check_texels(const struct aob_capture *capture, unsigned which)
{
    static const unsigned char plain[5] = {228, 228, 228, 255, 0}; /* sqrt(.8), 1 and 0 */
    struct aob_gbuffer gbuffer = store_and_load(capture);
    unsigned char *albedo = aob_material_albedo_texels(&gbuffer),
                  *shine = aob_material_shine_texels(&gbuffer);
    for (int i = 0; i < COUNT; i++)
        for (int c = 0; c < 5; c++) {
            int got = c < 3 ? albedo[4 * i + c] : shine[2 * i + c - 3];
            int wanted = i % W == 0 ? 0 : which >> c & 1 ? byte_at(c, i) : plain[c];
            if (got != wanted)
                fail_msg("texel %d of %s is %d, not %d", i, channels[c], got, wanted);
        }
    free(albedo);
    free(shine);
    aob_gbuffer_finish(&gbuffer);
}

static void test_texels(void **state)
{
    static const struct {
        unsigned which, materials;
        size_t warnings;
    } files[] = {{31, 7, 0}, {7, 1, 0}, {8, 2, 0}, {16, 4, 0}, {15, 3, 1}};
    struct painted *p = make_painted();
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(files); k++) {
        struct sheet_file file = make_file(p, files[k].which);
        struct aob_capture_desc desc = plain();
        struct aob_capture capture = read_back(&file, &desc);
        assert_int_equal(capture.materials, files[k].materials);
        assert_int_equal(capture.warning_count, files[k].warnings);
        if (files[k].warnings)
            assert_contains(capture.warnings[0].text,
                            "it has no metalness, so all of it is taken for no metal");
        check_texels(&capture, files[k].which);
        aob_capture_finish(&capture);
    }
    free(p);
}

static void test_none(void **state)
{
    struct painted *p = make_painted();
    struct sheet_file without = make_file(p, 0), with = make_file(p, 31);
    struct aob_capture_desc desc = plain();
    (void)state;
    for (int k = 0; k < 2; k++) {
        desc.convention.no_materials = k;
        struct aob_capture capture = read_back(k ? &with : &without, &desc);
        assert_int_equal(capture.materials, 0);
        assert_null(capture.albedo);
        assert_null(capture.shine);
        aob_capture_finish(&capture);
    }
    free(p);
}

/* What lies beyond 0..1 in a few pixels is clamped, what rounding adds without a word. */
static void test_clamped(void **state)
{
    struct painted *p = make_painted();
    struct aob_capture_desc desc = plain();
    (void)state;
    p->values[1][2] = -0.5f;
    p->values[0][3] = 7;
    p->values[3][4] = 1.0005f;
    struct sheet_file file = make_file(p, 31);
    struct aob_capture capture = read_back(&file, &desc);
    assert_int_equal(capture.warning_count, 1);
    assert_contains(capture.warnings[0].text,
                    "2 of 5772 numbers of its base colour lie beyond 0..1 (-0.5 to 7), and are clamped");
    assert_true(capture.albedo[3 * 2 + 1] == 0 && capture.albedo[3 * 3] == 1 && capture.shine[2 * 4] == 1);
    assert_true(capture.albedo[3 * 2] == p->values[0][2]);
    aob_capture_finish(&capture);
    free(p);
}

static void test_refused(void **state)
{
    struct painted *p = make_painted();
    struct aob_capture_desc desc = plain();
    (void)state;
    p->values[4][W + 5] = NAN;
    p->values[4][W] = NAN; /* the sky has no material */
    struct sheet_file file = make_file(p, 31);
    expect_refusal(&file, &desc, "pixel (5, 1) has a surface, and its metalness is nan: write a number");
    p->values[4][W + 5] = INFINITY;
    expect_refusal(&file, &desc, "its metalness is inf");
    file = make_file(p, 31 - 4);
    expect_refusal(&file, &desc,
                   "its base colour has albedo.R, and not all of .R .G .B: write the three, or");
    p->values[4][W + 5] = 0;
    for (int i = 0; i < COUNT; i++)
        p->values[3][i] = (float)(i % 256);
    file = make_file(p, 31);
    expect_refusal(&file, &desc, "of 1924 numbers of its roughness lie beyond 0..1 (2 to 255): write shares");
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_texels),
        cmocka_unit_test(test_none),
        cmocka_unit_test(test_clamped),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, name_file, remove_file);
}
