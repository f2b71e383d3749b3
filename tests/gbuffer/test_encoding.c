#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/half.h"
#include "base/memory.h"
#include "random.h"
#include "rig.h"
#include "technique/param.h"

/* What shaders read of an encoded G-buffer, against bounds that follow from the encoding's own step. */

enum { W = 160, H = 90 };

struct values {
    int32_t component;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, component, .stage = AOB_CONSTANT, .min = 0, .max = 2, .doc = "."),
};
static const struct aob_shader shaders[] = {
    {"z", "void main() { o = aob_view_z(aob_pixel); }\n"},
    {"error", "void main() { o = aob_depth_error(aob_view_z(aob_pixel)); }\n"},
    {"normal",
     "void main() { vec3 n = aob_normal(aob_pixel); o = COMPONENT == 0 ? n.x : COMPONENT == 1 ? n.y : "
     "n.z; }\n"},
    {NULL, NULL}};
static const char *chosen;

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex out = aob_texture(graph, .name = "o", .format = AOB_R32F);
    return aob_pass(graph, .name = "only", .shader = chosen,
                    .reads = strcmp(chosen, "normal") ? AOB_DEPTH : AOB_NORMAL,
                    .out = {{.name = "o", .tex = out}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, out);
}
static const struct aob_technique technique = {.abi = AOB_ABI,
                                               .size = sizeof technique,
                                               .name = "probe",
                                               .title = "t",
                                               .citation = "c",
                                               .params = params,
                                               .param_count = 1,
                                               .values_size = sizeof(struct values),
                                               .shaders = shaders,
                                               .build = build};

static void set_option(struct aob_options *options, const char *name, const char *text)
{
    double values[AOB_OPTION_COUNT];
    const struct aob_param *param = aob_param_find(aob_option_params, AOB_OPTION_COUNT, name);
    aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, 1, values);
    for (int i = 0; i < AOB_OPTION_COUNT; i++)
        if (aob_option_params[i].type == AOB_INT)
            values[i] = *(int32_t *)((char *)options + aob_option_params[i].offset);
        else
            values[i] = (double)*(float *)((char *)options + aob_option_params[i].offset);
    assert_true(aob_param_parse(param, text, &values[param - aob_option_params], NULL));
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, values, options, sizeof *options);
}

static void probe(const struct aob_rig *rig, const char *backend, const char *shader, int component,
                  const struct aob_options *options, float *pixels)
{
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    chosen = shader;
    aob_rig_probe(rig, gpu, &technique, &(struct values){component}, options, pixels);
    aob_gpu_close(gpu);
}

/* A low view of `spheres`, which holds sky; all depths lie within 0.25 and 50. */
static void rig_of(struct aob_rig *rig, double ortho)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = aob_scene_view(aob_scene_find("spheres"), "front")->camera;
    camera.eye.y = 0.4;
    camera.target.y = 0.6;
    camera.ortho_height = ortho;
    aob_scene_find("spheres")->build(&mesh);
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
}

/* Greatest distance from z that a half step of the encoding allows, plus single precision of decoding it. */
static double step_of(const char *encoding, bool ortho, double z, double n, double f)
{
    double u = 0x1p-24, device = strstr(encoding, "24") ? 1 / (0x1p24 - 1) : 0;
    if (!strcmp(encoding, "r32f"))
        return 0;
    if (!strcmp(encoding, "r16f"))
        return z * 0x1p-11;
    if (!strcmp(encoding, "unorm16") || !strcmp(encoding, "packed16"))
        return f * (0.5 / 65535 + 4 * u);
    if (ortho)
        return (f - n) * (0.5 * device + 8 * u) + z * 4 * u;
    if (strstr(encoding, "infinite"))
        return z * z / n * 0.5 * device + z * 4 * u;
    if (strstr(encoding, "reversed")) /* relative precision survives at the far end */
        return z * z * (f - n) / (n * f) * 0.5 * device + z * 8 * u;
    return z * z * (f - n) / (n * f) * (0.5 * device + 4 * u) +
           z * 8 * u; /* the float near 1 has steps of u */
}

static void check_depth(const struct aob_rig *rig, const char *backend, const char *encoding, bool ortho)
{
    float pixels[W * H], errors[W * H]; /* errors: what shaders take for the most */
    struct aob_options options = {.near = 0.25f, .far = 50, .fetch = strcmp(backend, "vulkan") == 0};
    double worst = 0, share = 0;
    size_t sky = 0;
    set_option(&options, "depth_encoding", encoding);
    probe(rig, backend, "z", 0, &options, pixels);
    probe(rig, backend, "error", 0, &options, errors);
    for (int i = 0; i < W * H; i++) {
        if (rig->hits.depth[i] <= 0) {
            assert_true(pixels[i] >= 5e8f);
            sky++;
            continue;
        }
        double z = (double)rig->hits.depth[i], e = fabs((double)pixels[i] - z);
        double step = step_of(encoding, ortho, z, 0.25, 50);
        if (e > step * 1.0001)
            fail_msg("%s on %s: depth %.9g is read as %.9g, off by more than %.3g", encoding, backend, z,
                     (double)pixels[i], step);
        worst = fmax(worst, e);
        share =
            fmax(share, (e - z * 0x1p-21) / (double)errors[i]); /* below 0 where the error is taken for 0 */
    }
    assert_true(sky > 100);
    assert_true(share <= 1 && (strstr(encoding, "16") == NULL || share > 0.5));
    /* an encoding that is not applied at all would pass the bound above */
    assert_true(strstr(encoding, "32") ? worst < 1e-3 : worst > 1e-7);
    printf("%s %s%s: greatest error of depth %.2e, %.2f of what shaders allow for\n", backend, encoding,
           ortho ? ", orthographic" : "", worst, share);
}

static void test_depth_within_its_step(void **state)
{
    (void)state;
    static const char *const encodings[] = {"r32f",
                                            "r16f",
                                            "unorm16",
                                            "packed16",
                                            "device24",
                                            "device32",
                                            "device24_reversed",
                                            "device32_reversed",
                                            "device24_infinite",
                                            "device32_infinite"};
    struct aob_rig rig;
    for (int ortho = 0; ortho < 2; ortho++) {
        rig_of(&rig, ortho ? 3 : 0);
        for (size_t e = 0; e < AOB_COUNT(encodings) - (ortho ? 2 : 0); e++) {
            check_depth(&rig, "vulkan", encodings[e], ortho);
            check_depth(&rig, "gl-egl", encodings[e], ortho);
        }
        aob_rig_finish(&rig);
    }
}

/* Radians. By the sine as well as the cosine, which says nothing of small angles. */
static double angle_between(const float *a, const float *b)
{
    struct aob_vec3 v = aob_vec((double)a[0], (double)a[1], (double)a[2]),
                    w = aob_vec((double)b[0], (double)b[1], (double)b[2]);
    return atan2(aob_vec_length(aob_vec_cross(v, w)), aob_vec_dot(v, w));
}

/* The normals that a shader reads, three floats a pixel; the caller frees. */
static float *read_normals(const struct aob_rig *rig, const char *backend, const struct aob_options *options)
{
    float component[W * H], *normals = AOB_NEW_ARRAY(float, 3 * W * H);
    for (int c = 0; c < 3; c++) {
        probe(rig, backend, "normal", c, options, component);
        for (int i = 0; i < W * H; i++)
            normals[3 * i + c] = component[i];
    }
    return normals;
}

/* Greatest angle in degrees between the normal that a shader reads of a surface and the true one. */
static double normal_error(const struct aob_rig *rig, const struct aob_options *options, const float *truth)
{
    float *normals = read_normals(rig, "gl-egl", options);
    double worst = 0;
    for (int i = 0; i < W * H; i++)
        if (rig->hits.depth[i] > 0)
            worst = fmax(worst, angle_between(&normals[3 * i], &truth[4 * i]));
    free(normals);
    return worst * 180 / M_PI;
}

/* What an encoding does to a direction: components of a vector, of the point of the octahedron, or of a point of a disc are
 * each off by up to half a step. Half floats below 1 have steps of 2^-11, and the point 1 itself is one. */
enum kind { VECTOR, OCTAHEDRON, DISC_OF_SINE, DISC_OF_HALF_SINE };
struct encoding_row {
    const char *name;
    enum kind kind;
    double half_step;
};
static const struct encoding_row encoding_rows[] = {
    {"rgba32f", VECTOR, 0},
    {"rgba16f", VECTOR, 0x1p-12},
    {"rgba8", VECTOR, 1 / 255.0},
    {"rgb10", VECTOR, 1 / 1023.0},
    {"oct_rg16f", OCTAHEDRON, 0x1p-12},
    {"oct_rg8", OCTAHEDRON, 1 / 255.0},
    {"packed8", DISC_OF_SINE, 1 / 255.0},
    {"sphere_rg16f", DISC_OF_HALF_SINE, 0x1p-12},
};

/* The greatest angle between the points of the unit sphere over two points of its disc, one at the distance r from the
 * middle and the other at most d from it: of all of those, the two differ most in height at the distances r - d and r + d. */
static double lifted_angle(double r, double d)
{
    double z = sqrt(fmax(0, 1 - r * r)), low = fmax(0, r - d), high = fmin(1, r + d);
    double rise = fmax(sqrt(1 - low * low) - z, z - sqrt(1 - high * high));
    return 2 * asin(hypot(d, rise) / 2);
}

/* The greatest angle that this can make, radians.
 * A vector of length 1 that moves by d turns by at most asin d, and d is at most the half step times the root of 3.
 * Along a face of the octahedron z follows from x and y, so that a point moves by at most h sqrt(1 + 1 + 4); its length is at
 * least the root of 1/3.
 * Four units of single precision are for the arithmetic of the shader. */
static double greatest_angle(const struct encoding_row *row, const float *n)
{
    double h = row->half_step, u = 0x1p-24;
    switch (row->kind) {
    case VECTOR:
        return asin(h * sqrt(3)) + 4 * u;
    case OCTAHEDRON:
        return h * sqrt(18) + 4 * u;
    case DISC_OF_SINE:
        return lifted_angle(hypot((double)n[0], (double)n[1]), h * sqrt(2) + 4 * u);
    default: /* angles are halved on the disc */
        return 2 * lifted_angle(sqrt(fmax(0, 1 - (double)n[2]) / 2), h * sqrt(2) + 4 * u);
    }
}

/* Directions all over the sphere, the six axes and both sides of the octahedron's edges among them. */
static void scatter_normals(float *normals)
{
    uint32_t state = 7;
    for (int i = 0; i < W * H; i++) {
        struct aob_vec3 v = aob_vec(random_normal(&state), random_normal(&state), random_normal(&state));
        if (i < 6)
            v = aob_vec(i / 2 == 0, i / 2 == 1, i / 2 == 2);
        if (i < 6)
            v = aob_vec_scale(v, i % 2 ? -1 : 1);
        else if (i < W)
            v.z = i % 2 ? 1e-4 : -1e-4;
        v = aob_vec_normalize(v);
        const float n[4] = {(float)v.x, (float)v.y, (float)v.z, 0};
        memcpy(&normals[4 * i], n, sizeof n);
    }
}

static void check_encoding(const struct aob_rig *rig, const char *backend, const struct encoding_row *row)
{
    struct aob_options options = {.fetch = strcmp(backend, "vulkan") == 0};
    double worst = 0, share = 0, length = 0;
    set_option(&options, "normal_encoding", row->name);
    float *normals = read_normals(rig, backend, &options);
    for (int i = 0; i < W * H; i++) {
        const float *n = &rig->gbuffer.normal[4 * i], *r = &normals[3 * i];
        double size = aob_vec_length(aob_vec((double)r[0], (double)r[1], (double)r[2]));
        length = fmax(length, fabs(size - 1));
        if (row->kind == DISC_OF_SINE && n[2] < 0)
            continue; /* these are lost */
        double angle = angle_between(r, n), most = greatest_angle(row, n);
        if (angle > most)
            fail_msg("%s on %s: (%.9g, %.9g, %.9g) is read %.3g radians away, at most %.3g", row->name,
                     backend, (double)n[0], (double)n[1], (double)n[2], angle, most);
        worst = fmax(worst, angle);
        share = fmax(share, angle / most);
    }
    printf("%s: normals as %s: greatest angle %.4f degrees, %.3f of what it may be; length within %.1e\n",
           backend, row->name, worst * 180 / M_PI, share, length);
    assert_true(length < 1e-6);
    /* an encoding that is not applied at all would pass the bounds above */
    assert_true(row->half_step == 0 || share > 0.5);
    free(normals);
}

/* Through a sampler on one backend and as a storage image on the other. */
static void test_normals_within_their_step(void **state)
{
    (void)state;
    struct aob_rig rig;
    rig_of(&rig, 0);
    scatter_normals(rig.gbuffer.normal);
    for (size_t r = 0; r < AOB_COUNT(encoding_rows); r++) {
        check_encoding(&rig, "gl-egl", &encoding_rows[r]);
        check_encoding(&rig, "vulkan", &encoding_rows[r]);
    }
    aob_rig_finish(&rig);
}

static void test_shading_and_derived_normals(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_options shading = {.normals = AOB_NORMALS_SHADING},
                       derived = {.normals = AOB_NORMALS_FROM_DEPTH};
    rig_of(&rig, 0);
    assert_true(normal_error(&rig, &shading, rig.gbuffer.shading) < 0.03);
    aob_rig_finish(&rig);
    /* Flat walls give their exact normal but for the rounding of single precision, at the image's edge too. */
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    double worst = normal_error(&rig, &derived, rig.gbuffer.normal);
    printf("normals from depth on flat walls: greatest angle %.4f degrees\n", worst);
    assert_true(worst < 46); /* in the crease itself a pixel's neighbours lie on the other wall */
    float *normals = read_normals(&rig, "gl-egl", &derived);
    size_t wrong = 0;
    for (int i = 0; i < W * H; i++)
        wrong += angle_between(&normals[3 * i], &rig.gbuffer.normal[4 * i]) > 0.1 * M_PI / 180;
    free(normals);
    printf("normals from depth: %zu of %d pixels beyond 0.1 degrees\n", wrong, W * H);
    assert_true(wrong <= W); /* a row at the crease */
    aob_rig_finish(&rig);
}

static void test_both_packed_share_a_texture(void **state)
{
    (void)state;
    float alone[W * H], together[W * H];
    struct aob_rig rig;
    struct aob_options options = {.depth_encoding = AOB_DEPTH_PACKED16, .far = 50};
    rig_of(&rig, 0);
    probe(&rig, "vulkan", "z", 0, &options, alone);
    options.normal_encoding = AOB_NORMAL_PACKED8;
    probe(&rig, "vulkan", "z", 0, &options, together);
    assert_memory_equal(alone, together, sizeof alone);
    aob_rig_finish(&rig);
}

static void test_refusals(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_encoding encoding;
    struct aob_error error = {{0}};
    rig_of(&rig, 3);
    struct aob_options options = {.depth_encoding = AOB_DEPTH_DEVICE32_INFINITE};
    assert_false(aob_encoding_init(&encoding, &options, &rig.gbuffer, &error));
    assert_contains(error.text, "perspective");
    options = (struct aob_options){.depth_encoding = AOB_DEPTH_DEVICE24, .near = 3, .far = 2};
    assert_false(aob_encoding_init(&encoding, &options, &rig.gbuffer, &error));
    assert_contains(error.text, "near 3 is not below far 2");
    options = (struct aob_options){.depth_encoding = AOB_DEPTH_DEVICE24};
    assert_true(aob_encoding_init(&encoding, &options, &rig.gbuffer, &error));
    assert_true(encoding.near > 0 && encoding.near < encoding.far);
    aob_rig_finish(&rig);
}

static void test_half_floats(void **state)
{
    (void)state;
    assert_int_equal(aob_half_from_float(1), 0x3c00);
    assert_int_equal(aob_half_from_float(0.7f), 0x399a); /* the nearer neighbour: truncation gives 0x3999 */
    assert_int_equal(aob_half_from_float(AOB_HALF_MAX), 0x7bff);
    assert_int_equal(aob_half_from_float(INFINITY), 0x7c00);
    assert_true(aob_half_to_float(0x0001) == 0x1p-24f);
    for (unsigned bits = 0; bits < 0x7c00; bits++)
        assert_int_equal(aob_half_from_float(aob_half_to_float((uint16_t)bits)), bits);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_depth_within_its_step),
                                       cmocka_unit_test(test_normals_within_their_step),
                                       cmocka_unit_test(test_shading_and_derived_normals),
                                       cmocka_unit_test(test_both_packed_share_a_texture),
                                       cmocka_unit_test(test_refusals),
                                       cmocka_unit_test(test_half_floats)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
