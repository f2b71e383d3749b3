/* Captures are found in files of every form, or refused. */
#include "capture_plane.h"

static const struct {
    const char *depth, *normal[3];
} names[] = {
    {"Z", {"N.X", "N.Y", "N.Z"}},
    {"z", {"Nn.r", "Nn.g", "Nn.b"}},
    {"depth.Z", {"normal.R", "normal.G", "normal.B"}},
    {"Depth.V", {"Normal.X", "Normal.Y", "Normal.Z"}},
    {"ViewLayer.Depth.Z", {"ViewLayer.Normal.X", "ViewLayer.Normal.Y", "ViewLayer.Normal.Z"}},
    {"View Layer.Depth.Z", {"View Layer.Normal.X", "View Layer.Normal.Y", "View Layer.Normal.Z"}},
    {"RenderLayer.Depth.Z", {"RenderLayer.Normal.X", "RenderLayer.Normal.Y", "RenderLayer.Normal.Z"}},
    {"VRayZDepth", {"normals.X", "normals.Y", "normals.Z"}},
    {"FinalImageSceneDepth.R",
     {"FinalImageWorldNormal.R", "FinalImageWorldNormal.G", "FinalImageWorldNormal.B"}},
    {"SceneDepth.X",
     {"a.layer.with.a.long.path.Normal.X", "a.layer.with.a.long.path.Normal.Y",
      "a.layer.with.a.long.path.Normal.Z"}},
    {"Image.Depth", {"N.R", "N.G", "N.B"}},
};

static void test_names(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    set_z(p, 1e10f);
    float *other = AOB_NEW_ARRAY(float, COUNT);
    for (size_t k = 0; k < AOB_COUNT(names); k++) {
        struct sheet_file file = one_part(p, names[k].depth, EXR_PIXEL_FLOAT);
        add_normals(&file.sheets[0], p, names[k].normal);
        file.sheets[0].channels[4] = (struct sheet_channel){"Combined.R", other, EXR_PIXEL_HALF};
        file.sheets[0].channels[5] = (struct sheet_channel){"Denoising Normal.X", other, EXR_PIXEL_HALF};
        struct aob_capture_desc desc = plain();
        struct aob_capture capture = read_back(&file, &desc);
        check_depth(&capture, p, 0x1p-24, 0);
        check_normals(&capture, p, 1e-5);
        assert_int_equal(capture.derived, 0);
        bool mixed = k >= AOB_COUNT(names) - 2;
        assert_int_equal(capture.warning_count, mixed);
        if (mixed)
            assert_contains(capture.warnings[0].text, "are of different layers");
        aob_capture_finish(&capture);
    }
    free(other);
    free(p);
}

static void test_forms_of_files(void **state)
{
    static const exr_compression_t methods[] = {EXR_COMPRESSION_NONE, EXR_COMPRESSION_RLE,
                                                EXR_COMPRESSION_ZIPS, EXR_COMPRESSION_ZIP,
                                                EXR_COMPRESSION_PIZ};
    static const int tiles[] = {0, 16, 64};
    static const char *const normal[3] = {"N.X", "N.Y", "N.Z"};
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    set_z(p, 65504);
    for (size_t m = 0; m < AOB_COUNT(methods); m++)
        for (size_t t = 0; t < AOB_COUNT(tiles); t++)
            for (int half = 0; half < 2; half++) {
                struct sheet_file file = one_part(p, "Z", half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT);
                add_normals(&file.sheets[0], p, normal);
                file.sheets[0].tile = tiles[t];
                file.sheets[0].compression = methods[m];
                struct aob_capture_desc desc = plain();
                struct aob_capture capture = read_back(&file, &desc);
                check_depth(&capture, p, half ? 0x1p-11 : 0x1p-24, 0);
                check_normals(&capture, p, 1e-5);
                aob_capture_finish(&capture);
            }
    free(p);
}

static void test_parts_and_windows(void **state)
{
    static const char *const names[3] = {"X", "Y", "Z"};
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    float *cut = AOB_NEW_ARRAY(float, COUNT), *big = AOB_NEW_ARRAY(float, (W + 8) * (H + 6));
    make_plane(p);
    set_z(p, 0);
    /* The depth's part lacks the first column, that of the normals is larger than what is shown. */
    for (int i = 0; i < COUNT; i++)
        if (i % W)
            cut[i / W * (W - 1) + i % W - 1] = p->z[i];
    struct sheet_file file = {.width = W, .height = H, .count = 3};
    file.sheets[0] =
        (struct sheet){.name = "rgba", .width = 3, .height = 2, .channels = {{"R", big, EXR_PIXEL_HALF}}};
    file.sheets[1] = (struct sheet){.name = "depth",
                                    .width = W - 1,
                                    .height = H,
                                    .left = 1,
                                    .tile = 16,
                                    .channels = {{"Z", cut, EXR_PIXEL_FLOAT}}};
    file.sheets[2] = (struct sheet){.name = "normal", .width = W + 8, .height = H + 6, .left = -3, .top = -2};
    float *planes = AOB_NEW_ARRAY(float, 3 * (W + 8) * (H + 6));
    for (int c = 0; c < 3; c++) {
        float *plane = planes + c * (W + 8) * (H + 6);
        for (int i = 0; i < (W + 8) * (H + 6); i++)
            plane[i] = p->normal[c][0];
        file.sheets[2].channels[c] = (struct sheet_channel){names[c], plane, EXR_PIXEL_FLOAT};
    }
    struct aob_capture_desc desc = plain();
    desc.convention.depth = AOB_DEPTH_PLANAR;
    struct aob_capture capture = read_back(&file, &desc);
    check_depth(&capture, p, 0x1p-24, 0);
    check_normals(&capture, p, 1e-5);
    assert_int_equal(capture.derived, 0);
    assert_int_equal(capture.warning_count, 0);
    aob_capture_finish(&capture);
    free(cut);
    free(big);
    free(planes);
    free(p);
}

static void test_several_candidates(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    float *other = AOB_NEW_ARRAY(float, COUNT);
    make_plane(p);
    set_z(p, 0);
    for (int i = 0; i < COUNT; i++)
        other[i] = 7;
    struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    file.sheets[0].channels[1] = (struct sheet_channel){"ViewLayer.Depth.Z", other, EXR_PIXEL_FLOAT};
    struct aob_capture_desc desc = plain();
    struct aob_capture capture = read_back(&file, &desc);
    check_depth(&capture, p, 0x1p-24, 0);
    assert_int_equal(capture.warning_count, 1);
    assert_contains(capture.warnings[0].text, "reads Z as depth; ViewLayer.Depth.Z would do as well");
    aob_capture_finish(&capture);
    strcpy(desc.convention.depth_channel, "ViewLayer.Depth.Z");
    capture = read_back(&file, &desc);
    assert_true(capture.hits.depth[0] == 7);
    assert_int_equal(capture.warning_count, 0);
    aob_capture_finish(&capture);
    free(other);
    free(p);
}

static void test_refusals(void **state)
{
    static const char *const normal[3] = {"N.X", "N.Y", "N.Z"};
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    set_z(p, 0);
    struct aob_capture_desc desc = plain();
    struct sheet_file file = one_part(p, "R", EXR_PIXEL_FLOAT);
    expect_refusal(&file, &desc, "name one by depth_channel; it has R");
    file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    file.aspect = 2;
    expect_refusal(&file, &desc, "not square");
    file.aspect = 0;
    strcpy(desc.convention.normal_channel, "Nowhere");
    expect_refusal(&file, &desc, "no channels 'Nowhere'");
    desc = plain();
    desc.fov_deg = 0;
    expect_refusal(&file, &desc, "state fov_deg");
    desc = plain();
    desc.convention = (struct aob_convention){.depth = AOB_DEPTH_DEVICE, .near = NEAR, .far = FAR};
    expect_refusal(&file, &desc, "is it planar?");
    desc = plain();
    desc.convention.far = 0.5;
    expect_refusal(&file, &desc, "all depths are sky");
    desc = plain();
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < COUNT; i++)
            p->normal[c][i] = p->normal[c][i] * 0.5f + 0.5f;
    add_normals(&file.sheets[0], p, normal);
    expect_refusal(&file, &desc, "state normals derived");
    free(p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_forms_of_files),
        cmocka_unit_test(test_parts_and_windows),
        cmocka_unit_test(test_several_candidates),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, name_file, remove_file);
}
