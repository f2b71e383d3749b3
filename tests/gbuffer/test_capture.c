#include "capture_file.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "gbuffer/capture.h"
#include "store/image.h"

/* A tilted plane n.p = -2 in view space, known in closed form in every convention; its first column is sky. */
enum { W = 53, H = 37, COUNT = W * H };
static const double FOV = 50, NEAR = 0.1, FAR = 200;
static const struct aob_vec3 tilted = {0.2, 0.5, 0.8};

struct plane {
    double depth[COUNT], slant[COUNT];
    float z[COUNT], normal[3][COUNT];
    struct aob_vec3 n;
};

static void make_plane(struct plane *p)
{
    double s = 2 * tan(FOV * M_PI / 360) / H;
    p->n = aob_vec_normalize(tilted);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            double tx = (x + 0.5 - W / 2.0) * s, ty = -(y + 0.5 - H / 2.0) * s;
            int i = y * W + x;
            p->depth[i] = 2 / (p->n.z - p->n.x * tx - p->n.y * ty);
            assert_true(p->depth[i] > 1 && p->depth[i] < 100);
            p->slant[i] = sqrt(tx * tx + ty * ty + 1);
            p->normal[0][i] = (float)p->n.x;
            p->normal[1][i] = (float)p->n.y;
            p->normal[2][i] = (float)p->n.z;
        }
}

static char path[64];

static struct sheet_file one_part(const struct plane *p, const char *depth, exr_pixel_type_t type)
{
    struct sheet_file file = {.width = W, .height = H, .count = 1};
    file.sheets[0] =
        (struct sheet){.name = "main", .width = W, .height = H, .compression = EXR_COMPRESSION_ZIP};
    file.sheets[0].channels[0] = (struct sheet_channel){depth, p->z, type};
    return file;
}

static void add_normals(struct sheet *sheet, const struct plane *p, const char *const names[3])
{
    int at = 0;
    while (sheet->channels[at].name)
        at++;
    for (int c = 0; c < 3; c++)
        sheet->channels[at + c] = (struct sheet_channel){names[c], p->normal[c], EXR_PIXEL_FLOAT};
}

static void set_z(struct plane *p, float sky)
{
    for (int i = 0; i < COUNT; i++)
        p->z[i] = i % W ? (float)p->depth[i] : sky;
}

static struct aob_capture_desc plain(void)
{
    return (struct aob_capture_desc){.file = path, .fov_deg = FOV};
}

static struct aob_capture read_back(const struct sheet_file *file, const struct aob_capture_desc *desc)
{
    struct aob_capture capture;
    struct aob_error error = {{0}};
    sheet_write(path, file);
    if (!aob_capture_read(&capture, desc, &error))
        fail_msg("%s", error.text);
    assert_int_equal(capture.hits.width, W);
    assert_int_equal(capture.hits.height, H);
    return capture;
}

static void expect_refusal(const struct sheet_file *file, const struct aob_capture_desc *desc,
                           const char *text)
{
    struct aob_capture capture;
    struct aob_error error = {{0}};
    sheet_write(path, file);
    assert_false(aob_capture_read(&capture, desc, &error));
    assert_contains(error.text, text);
    assert_contains(error.text, path);
    assert_null(strchr(error.text, '\n'));
}

/* `quantum`: relative error of a stored value; `slope`: by how much it is magnified. */
static void check_depth(const struct aob_capture *capture, const struct plane *p, double quantum, double near)
{
    for (int i = 0; i < COUNT; i++) {
        double d = p->depth[i], got = (double)capture->hits.depth[i];
        double tolerance = d * quantum + (near > 0 ? d * d / near * 0x1p-24 : 0);
        if (i % W == 0 ? got != 0 : !(fabs(got - d) <= tolerance))
            fail_msg("pixel %d is %.9g, not %.9g within %g", i, got, d, tolerance);
    }
}

static double degrees_off(const struct aob_capture *capture, const struct plane *p, int i)
{
    const float *n = capture->hits.normal[i];
    struct aob_vec3 v = aob_vec((double)n[0], (double)n[1], (double)n[2]);
    return asin(fmin(aob_vec_length(aob_vec_cross(v, p->n)), 1)) * 180 / M_PI +
           (aob_vec_dot(v, p->n) > 0 ? 0 : 180);
}

static void check_normals(const struct aob_capture *capture, const struct plane *p, double degrees)
{
    for (int i = 0; i < COUNT; i++) {
        const float *n = capture->hits.normal[i];
        if (i % W == 0)
            assert_true(n[0] == 0 && n[1] == 0 && n[2] == 0);
        else if (!(degrees_off(capture, p, i) <= degrees))
            fail_msg("normal of pixel %d is %g degrees off", i, degrees_off(capture, p, i));
    }
}

static void test_names(void **state)
{
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

static void test_depth_conventions(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    for (int k = 0; k < 6; k++) {
        struct aob_capture_desc desc = plain();
        for (int i = 0; i < COUNT; i++) {
            double d = p->depth[i], device = FAR / (FAR - NEAR) - FAR * NEAR / (FAR - NEAR) / d;
            double values[6] = {d, d * p->slant[i], device, 1 - NEAR / d, 1 - device, NEAR / d};
            const double sky[6] = {-1, INFINITY, 1, 1, 0, 0};
            p->z[i] = (float)(i % W ? values[k] : sky[k]);
        }
        desc.convention.depth = k < 2 ? (unsigned)k : k < 4 ? AOB_DEPTH_DEVICE : AOB_DEPTH_DEVICE_REVERSED;
        desc.convention.near = k < 2 ? 0 : NEAR;
        desc.convention.far = k < 2 ? 0 : k % 2 ? INFINITY : FAR;
        struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
        struct aob_capture capture = read_back(&file, &desc);
        check_depth(&capture, p, 0x1p-22, k < 2 ? 0 : NEAR);
        aob_capture_finish(&capture);
    }
    free(p);
}

static void test_orthographic_device_depth(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    for (int i = 0; i < COUNT; i++)
        p->z[i] = (float)(i % W ? 1 - (p->depth[i] - NEAR) / (FAR - NEAR) : 0);
    struct aob_capture_desc desc = {.file = path, .ortho_height = 3};
    desc.convention = (struct aob_convention){.depth = AOB_DEPTH_DEVICE_REVERSED, .near = NEAR, .far = FAR};
    struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    struct aob_capture capture = read_back(&file, &desc);
    for (int i = 0; i < COUNT; i++)
        assert_near(capture.hits.depth[i], (i % W ? p->depth[i] : 0), (FAR - NEAR) * 0x1p-23);
    aob_capture_finish(&capture);
    desc.convention.far = INFINITY;
    expect_refusal(&file, &desc, "finite far");
    free(p);
}

static void test_derived_normals(void **state)
{
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    make_plane(p);
    set_z(p, 0);
    struct aob_capture_desc desc = plain();
    struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    struct aob_capture capture = read_back(&file, &desc);
    check_normals(&capture, p, 0.1);
    assert_int_equal(capture.derived, (W - 1) * H);
    aob_capture_finish(&capture);

    /* A step: on both sides of it the nearer neighbour is the one of the same plane. */
    for (int i = 0; i < COUNT; i++)
        if (i % W > 20)
            p->z[i] *= 1.5f;
    file = one_part(p, "Z", EXR_PIXEL_FLOAT);
    capture = read_back(&file, &desc);
    check_normals(&capture, p, 0.1);
    aob_capture_finish(&capture);
    free(p);
}

static void test_normal_spaces(void **state)
{
    /* In the world: right, up and back of a camera, which is told by eye, target and up. */
    static const struct {
        struct aob_vec3 eye, right, up, back;
        double world_up[3];
        bool left_handed, world;
    } spaces[] = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, true, false},
        {{0, -5, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, 1}, false, true},
        {{-5, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, 1}, true, true},
        {{0, 0, -5}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, true, true},
        {{5, 0, 0}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, false, true},
    };
    static const char *const names[3] = {"N.X", "N.Y", "N.Z"};
    (void)state;
    struct plane *p = AOB_NEW(struct plane);
    for (size_t k = 0; k < AOB_COUNT(spaces); k++)
        for (int turned = 0; turned < 2; turned++) {
            make_plane(p);
            set_z(p, INFINITY);
            struct aob_vec3 w = aob_vec_add(
                aob_vec_add(aob_vec_scale(spaces[k].right, p->n.x), aob_vec_scale(spaces[k].up, p->n.y)),
                aob_vec_scale(spaces[k].back, p->n.z));
            w = aob_vec_scale(w,
                              turned ? -0.95 : 0.95); /* away from the camera, and not quite of unit length */
            for (int i = 0; i < COUNT; i++) {
                p->normal[0][i] = (float)w.x;
                p->normal[1][i] = (float)w.y;
                p->normal[2][i] = (float)w.z;
            }
            struct aob_capture_desc desc = plain();
            desc.has_camera = spaces[k].world;
            desc.eye = spaces[k].eye;
            desc.convention.normals = spaces[k].world ? AOB_NORMALS_WORLD : AOB_NORMALS_VIEW;
            desc.convention.left_handed = spaces[k].left_handed;
            memcpy(desc.convention.up, spaces[k].world_up, sizeof desc.convention.up);
            struct sheet_file file = one_part(p, "Z", EXR_PIXEL_FLOAT);
            add_normals(&file.sheets[0], p, names);
            struct aob_capture capture = read_back(&file, &desc);
            check_normals(&capture, p, 1e-4);
            aob_capture_finish(&capture);
            desc.has_camera = false;
            if (spaces[k].world)
                expect_refusal(&file, &desc, "state eye and target");
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

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    snprintf(path, sizeof path, "/tmp/aobudget-capture-%ld.exr", (long)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_forms_of_files),
        cmocka_unit_test(test_depth_conventions),
        cmocka_unit_test(test_orthographic_device_depth),
        cmocka_unit_test(test_derived_normals),
        cmocka_unit_test(test_normal_spaces),
        cmocka_unit_test(test_parts_and_windows),
        cmocka_unit_test(test_several_candidates),
        cmocka_unit_test(test_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, remove_file);
}
