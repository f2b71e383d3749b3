#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

/* The weights of each shared step and of hbao's own blur: one bright pixel in a dark image, and what each pixel about it
 * becomes, written out. The surface is a wall that faces the camera, part of which may be turned or set back. */

enum { N = 48, CENTRE = 24, TAPS = 9, EDGE = 24 /* columns from here on are the changed part */ };

struct values {
    float blur_depth, blur_normal, blur_tolerance;
    int32_t blur;
};
static const struct values initial = {0.5f, 0.5f, 0.01f, TAPS};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, blur_depth, .max = 9, .initial = 0.5, .doc = "As in the step."),
    AOB_PARAM(struct values, blur_normal, .min = -1, .max = 1, .initial = 0.5, .doc = "As in the step."),
    AOB_PARAM(struct values, blur_tolerance, .max = 1, .initial = 0.01, .doc = "As in the step."),
    AOB_PARAM(struct values, blur, .stage = AOB_CONSTANT, .max = 33, .initial = TAPS, .doc = "Taps."),
};

/* What the next build() lays. */
static struct step {
    const char *input, *output; /* names in the text */
    int axis, divisor, x, y;    /* x, y: the bright pixel, of the image divided */
} step;

static const char impulse_text[] = "void main() { raw = aob_pixel == ivec2(X, Y) ? 1.0 : 0.0; }\n";

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex raw = aob_texture(graph, .name = "raw", .format = AOB_R32F, .divisor = (uint32_t)step.divisor);
    aob_tex out = aob_texture(graph, .name = "out", .format = AOB_R32F);
    aob_pass(graph, .name = "impulse", .shader = "impulse", .defines = {{"X", step.x}, {"Y", step.y}},
             .reads = AOB_DEPTH, .out = {{.name = "raw", .tex = raw}});
    return aob_pass(graph, .name = "step", .shader = "step", .defines = {{"AXIS", step.axis}},
                    .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = step.input, .tex = raw}},
                    .out = {{.name = step.output, .tex = out}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, out);
}

static void draw(const struct aob_rig *rig, struct aob_gpu *gpu, const char *text, struct step laid,
                 float *pixels)
{
    const struct aob_shader shaders[] = {{"impulse", impulse_text}, {"step", text}, {NULL, NULL}};
    const struct aob_technique technique = {.abi = AOB_ABI,
                                            .size = sizeof technique,
                                            .name = "impulse",
                                            .title = "",
                                            .citation = "",
                                            .params = params,
                                            .param_count = AOB_COUNT(params),
                                            .values_size = sizeof(struct values),
                                            .shaders = shaders,
                                            .build = build};
    step = laid;
    aob_rig_probe(rig, gpu, &technique, &initial, &(struct aob_options){0}, pixels);
}

/* The wall is 3 away and 3 * 2 tan(30 degrees) / 48 = .0722 a pixel. */
static void wall(struct aob_rig *rig, float back, float cosine)
{
    aob_rig_plane(rig, &(struct aob_rig_plane){.width = N, .height = N});
    for (int i = 0; i < N * N; i++) {
        if (i % N < EDGE)
            continue;
        rig->gbuffer.depth[i] += back;
        rig->gbuffer.normal[4 * i] = sqrtf(1 - cosine * cosine);
        rig->gbuffer.normal[4 * i + 2] = cosine;
    }
}

static double gauss(int k)
{
    double sigma = TAPS / 4.0;
    return abs(k) <= TAPS / 2 ? exp(-k * k / (2 * sigma * sigma)) : 0;
}

static double gauss_sum(void)
{
    double sum = 0;
    for (int k = -TAPS / 2; k <= TAPS / 2; k++)
        sum += gauss(k);
    return sum;
}

static void test_separable_weights(void **state)
{
    static const char *const texts[][2] = {
        {"gtao", "blur"}, {"hbao", "blur"}, {"starcraft2_ssao", "gaussian"}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float pixels[N * N];
    (void)state;
    wall(&rig, 0, 1);
    for (size_t t = 0; t < AOB_COUNT(texts); t++)
        for (int axis = 0; axis < 2; axis++) {
            draw(&rig, gpu, aob_rig_text(texts[t][0], texts[t][1]),
                 (struct step){"raw", "blurred", axis, 1, CENTRE, CENTRE}, pixels);
            for (int i = 0; i < N * N; i++) {
                int along = (axis ? i / N : i % N) - CENTRE, aside = (axis ? i % N : i / N) - CENTRE;
                assert_near(pixels[i], aside ? 0 : gauss(along) / gauss_sum(), 1e-6);
            }
        }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The bright pixel is column `away` of the changed part, seen from the last column of the rest: its weight there is
 * `factor` of a Gaussian's, and the others of that part weigh as much less. */
static void check_factor(const struct aob_rig *rig, struct aob_gpu *gpu, const char *owner, const char *name,
                         int away, double factor)
{
    float pixels[N * N];
    double weights = 0;
    draw(rig, gpu, aob_rig_text(owner, name), (struct step){"raw", "blurred", 0, 1, EDGE + away - 1, CENTRE},
         pixels);
    for (int k = -TAPS / 2; k <= TAPS / 2; k++)
        weights += gauss(k) * (k > 0 ? factor : 1);
    assert_near(pixels[CENTRE * N + EDGE - 1], gauss(away) * factor / weights, 1e-5);
}

/* A surface that is turned by an angle counts by the eighth power of its cosine; beyond the tolerance of the normals of
 * gaussian it counts nothing, within it all. */
static void test_weights_over_a_crease(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    (void)state;
    wall(&rig, 0, 0.9f);
    check_factor(&rig, gpu, "gtao", "blur", 1, pow(0.9, 8));
    check_factor(&rig, gpu, "gtao", "blur", 3, pow(0.9, 8));
    check_factor(&rig, gpu, "starcraft2_ssao", "gaussian", 1, 1);
    aob_rig_finish(&rig);
    wall(&rig, 0, 0.49f);
    check_factor(&rig, gpu, "starcraft2_ssao", "gaussian", 1, 0);
    aob_rig_finish(&rig);
    wall(&rig, 0, 0.51f);
    check_factor(&rig, gpu, "starcraft2_ssao", "gaussian", 1, 1);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Set back by a depth: hbao's is a Gaussian in it, gaussian's a limit; tile_blur's a limit as a share of the depth, .01
 * of 3; that of the others .05 of the distance between the points and 1e-4 of the depth: of the next pixel, .0722
 * aside, so .0039. */
static void test_weights_over_a_step(void **state)
{
    static const struct {
        const char *owner, *name;
        double back, factor;
    } rows[] = {
        {"hbao", "blur", 0.5, 0.60653066},         {"hbao", "blur", 1, 0.13533528},
        {"hbao", "blur", -0.5, 0.60653066},        {"starcraft2_ssao", "gaussian", 0.499, 1},
        {"starcraft2_ssao", "gaussian", 0.501, 0}, {"starcraft2_ssao", "gaussian", -0.501, 0},
    };
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float pixels[N * N];
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        wall(&rig, (float)rows[i].back, 1);
        check_factor(&rig, gpu, rows[i].owner, rows[i].name, 1, rows[i].factor);
        aob_rig_finish(&rig);
    }
    for (int k = 0; k < 4; k++) {
        float back = (const float[]){0.0037f, 0.0041f, 0.0299f, 0.0301f}[k];
        bool tile = k >= 2;
        wall(&rig, back, 1);
        draw(&rig, gpu, tile ? aob_rig_text("crytek_ssao", "tile_blur") : aob_rig_text("gtao", "blur"),
             (struct step){"raw", "blurred", 0, 1, EDGE, CENTRE}, pixels);
        assert_int_equal(pixels[CENTRE * N + EDGE - 1] > 0, k % 2 == 0);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

static void test_tile_and_cross_weights(void **state)
{
    static const double tile[5] = {0.125, 0.25, 0.25, 0.25, 0.125};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float box[N * N], cross[N * N];
    (void)state;
    wall(&rig, 0, 1);
    draw(&rig, gpu, aob_rig_text("crytek_ssao", "tile_blur"),
         (struct step){"raw", "blurred", 0, 1, CENTRE, CENTRE}, box);
    draw(&rig, gpu, aob_rig_text("alchemy", "cross5"), (struct step){"raw", "crossed", 0, 1, CENTRE, CENTRE},
         cross);
    for (int i = 0; i < N * N; i++) {
        int x = i % N - CENTRE, y = i / N - CENTRE;
        bool inside = abs(x) <= 2 && abs(y) <= 2;
        assert_near(box[i], inside ? tile[x + 2] * tile[y + 2] : 0, 1e-6);
        assert_near(cross[i], abs(x) + abs(y) <= 1 ? 0.2 : 0, 1e-6);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A pixel of the divided image stands at the first pixel of its block; between them weights are bilinear. */
static void test_upsampling_weights(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float pixels[N * N];
    (void)state;
    wall(&rig, 0, 1);
    for (int divisor = 2; divisor <= 4; divisor *= 2) {
        draw(&rig, gpu, aob_rig_text("gtao", "upsample"),
             (struct step){"low", "full", 0, divisor, CENTRE / divisor, CENTRE / divisor}, pixels);
        for (int i = 0; i < N * N; i++) {
            double x = abs(i % N - CENTRE) / (double)divisor, y = abs(i / N - CENTRE) / (double)divisor;
            assert_near(pixels[i], fmax(0, 1 - x) * fmax(0, 1 - y), 1e-6);
        }
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_separable_weights), cmocka_unit_test(test_weights_over_a_crease),
        cmocka_unit_test(test_weights_over_a_step), cmocka_unit_test(test_tile_and_cross_weights),
        cmocka_unit_test(test_upsampling_weights)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
