/* The lit composite on devices: an open surface shows what a path tracer sees, and each output that is wanted takes the place of
 * what stands in for it. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "reference/incident_shot.h"
#include "reference/lit.h"
#include "reference/specular.h"
#include "rig.h"

enum { W = 48, H = 27, PIXELS = W * H };

static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

/* A floor in one material, seen from eye level to below. */
static void open_floor(struct aob_rig *rig, struct aob_material material)
{
    const struct aob_camera camera = {.eye = {0.3, 1.2, 2}, .target = {0, 0, 0.4}, .fov_deg = 70};
    struct aob_mesh mesh = {0};
    aob_mesh_paint(&mesh, material);
    aob_mesh_add_quad(&mesh, aob_vec(-40, 0, -40), aob_vec(0, 0, 80), aob_vec(80, 0, 0));
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
    rig->light = *slanted_light();
}

static void trace(const struct aob_rig *rig, double radius, int spp, struct aob_incident *lit)
{
    const struct aob_incident_desc desc = {.radius = radius, .bounces = 8, .light = &rig->light, .spp = spp};
    struct aob_error error = {{0}};
    bool ok = aob_tracer_lit(rig->tracer, &rig->camera, &rig->hits, &desc, lit, &error);
    assert_string_equal(error.text, "");
    assert_true(ok);
}

static void draw_lit(const struct aob_rig *rig, struct aob_gpu *gpu, float (*lit)[3])
{
    aob_rig_run_outputs(rig, gpu, "none", "", AOB_FETCH_SAMPLED,
                        (float *[AOB_OUTPUT_COUNT]){[AOB_OUT_LIT] = lit[0]});
}

/* The error of the sum over the image, and of a single pixel, in what the truth's standard errors leave. */
static void check_open(const struct aob_rig *rig, struct aob_gpu *gpu, const struct aob_incident *truth)
{
    float lit[PIXELS][3];
    draw_lit(rig, gpu, lit);
    for (int c = 0; c < 3; c++) {
        double sum = 0, all = 0, se = 0, worst = 0;
        int pixels = 0;
        for (int i = 0; i < PIXELS; i++) {
            if (rig->hits.primitive[i] == AOB_NO_PRIMITIVE) {
                assert_true(lit[i][c] == 0);
                continue;
            }
            double off = (double)lit[i][c] - (double)truth->rgb[i][c];
            sum += off;
            all += (double)truth->rgb[i][c];
            se += (double)truth->se[i][c] * (double)truth->se[i][c];
            worst = fmax(worst, fabs(off));
            pixels++;
        }
        print_message("           channel %d: mean %.4f, off by %+.5f of it, a pixel by %.4f; se %.5f\n", c,
                      all / pixels, sum / all, worst, sqrt(se / pixels));
        assert_true(pixels > PIXELS / 2);
        assert_true(fabs(sum / all) <= 0.004 + 3 * sqrt(se) / all);
        assert_true(worst <= 0.02 * all / pixels + 6 * sqrt(se / pixels));
    }
}

/* What 8 bits hold: of base colours the root. */
#define ROOT(bits) ((bits) * (bits) / 65025.0f)
#define BYTE(bits) ((bits) / 255.0f)

/* Roughness, metal and base colour matter, each in its own way; so does the light's direction. */
static void test_open(void **state)
{
    static const struct aob_material materials[] = {
        {{ROOT(228), ROOT(180), ROOT(80)}, 1, 0},
        {{ROOT(30), ROOT(20), ROOT(36)}, BYTE(77), 0},
        {{ROOT(242), ROOT(198), ROOT(114)}, BYTE(128), 1},
        {{ROOT(242), ROOT(198), ROOT(114)}, BYTE(38), 1},
        {{ROOT(161), ROOT(161), ROOT(242)}, BYTE(179), BYTE(128)},
    };
    (void)state;
    for (size_t m = 0; m < AOB_COUNT(materials); m++) {
        struct aob_rig rig;
        struct aob_incident truth;
        open_floor(&rig, materials[m]);
        trace(&rig, 1, 1024, &truth);
        for (size_t b = 0; b < (m ? 1 : AOB_COUNT(backends)); b++) {
            struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
            check_open(&rig, gpu, &truth);
            aob_gpu_close(gpu);
        }
        aob_incident_finish(&truth);
        aob_rig_finish(&rig);
    }
}

struct images {
    float ao[PIXELS], bent[PIXELS][3], bounced[PIXELS][3], lobe[PIXELS], light[PIXELS][3], lit[PIXELS][3];
};

static void draw_all(const struct aob_rig *rig, struct aob_gpu *gpu, unsigned wanted, struct images *images)
{
    float *const all[AOB_OUTPUT_COUNT] = {images->ao,   images->bent[0],  images->bounced[0],
                                          images->lobe, images->light[0], images->lit[0]};
    float *some[AOB_OUTPUT_COUNT] = {NULL};
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        some[which] = wanted >> which & 1 ? all[which] : NULL;
    aob_rig_run_outputs(rig, gpu, "gtao", "radius=0.5", AOB_FETCH_SAMPLED, some);
}

/* As the pass reads it: 8 bits of the root, 8 bits. */
static void material_at(const struct aob_rig *rig, int i, double base[3], double *metal)
{
    for (int c = 0; c < 3; c++) {
        double root = rint(255 * sqrt((double)rig->gbuffer.albedo[3 * i + c])) / 255;
        base[c] = root * root;
    }
    *metal = rint(255 * (double)rig->gbuffer.shine[2 * i + 1]) / 255;
}

static struct aob_vec3 normal_at(const struct aob_rig *rig, int i)
{
    const float *n = rig->gbuffer.normal + 4 * i;
    return aob_vec((double)n[0], (double)n[1], (double)n[2]);
}

/* What an open surface mirrors of the light, and of a light that is 1 from everywhere. */
struct mirror {
    float light[PIXELS][3], even[PIXELS][3];
};

/* What the composite has to make of the other images. */
static void compose(const struct aob_rig *rig, const struct images *images, unsigned wanted,
                    const struct mirror *mirror, int i, double rgb[3])
{
    struct aob_frame_axes axes = aob_camera_axes(&rig->camera);
    struct aob_light view;
    double base[3], metal, open[3];
    bool bounces = wanted >> AOB_OUT_VISIBILITY_RGB & 1, light = wanted >> AOB_OUT_IRRADIANCE & 1;
    struct aob_vec3 axis = normal_at(rig, i);
    aob_light_turn(&rig->light, &axes, &view);
    if (wanted >> AOB_OUT_BENT_NORMAL & 1)
        axis = aob_vec_normalize(
            aob_vec((double)images->bent[i][0], (double)images->bent[i][1], (double)images->bent[i][2]));
    aob_light_irradiance(&view, axis, open);
    material_at(rig, i, base, &metal);
    for (int c = 0; c < 3; c++) {
        double v = (double)images->ao[i], bounced = bounces ? (double)images->bounced[i][c] : v;
        double plain = light ? (double)images->light[i][c] : v * open[c], whole = plain * bounced / v;
        double closed = fmax(whole - plain, 0) / fmax(1 - v, 1 / 256.0);
        double share = wanted >> AOB_OUT_SPECULAR & 1 ? (double)images->lobe[i] : v;
        rgb[c] = base[c] * (1 - metal) * whole + share * (double)mirror->light[i][c] +
                 (1 - share) * closed * (double)mirror->even[i][c];
    }
}

/* What an open surface mirrors: the image of `none` less what is diffuse in it. */
static void find_mirror(const struct aob_rig *rig, struct aob_gpu *gpu, float (*mirror)[3])
{
    struct aob_frame_axes axes = aob_camera_axes(&rig->camera);
    struct aob_light view;
    aob_light_turn(&rig->light, &axes, &view);
    draw_lit(rig, gpu, mirror);
    for (int i = 0; i < PIXELS; i++) {
        double base[3], metal, open[3];
        if (rig->hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        material_at(rig, i, base, &metal);
        aob_light_irradiance(&view, normal_at(rig, i), open);
        for (int c = 0; c < 3; c++)
            mirror[i][c] -= (float)(base[c] * (1 - metal) * open[c]);
    }
}

static void check_sum(const struct aob_rig *rig, struct aob_gpu *gpu, unsigned wanted,
                      const struct mirror *mirror)
{
    struct images *images = AOB_NEW(struct images);
    double worst = 0;
    draw_all(rig, gpu, wanted | 1u << AOB_OUT_VISIBILITY | 1u << AOB_OUT_LIT, images);
    for (int i = 0; i < PIXELS; i++) {
        double rgb[3];
        if (rig->hits.primitive[i] == AOB_NO_PRIMITIVE || images->ao[i] < 0.01f)
            continue;
        compose(rig, images, wanted, mirror, i, rgb);
        for (int c = 0; c < 3; c++)
            worst = fmax(worst, fabs(rgb[c] - (double)images->lit[i][c]));
    }
    print_message("           wanted %2u: off by %.5f at most\n", wanted, worst);
    assert_true(worst < 0.004); /* half floats of values below 2, and of the share of the mirror */
    free(images);
}

/* All sixteen sets of outputs, in a room with coloured walls, a window's light and metal. */
static void test_sets(void **state)
{
    struct aob_rig rig;
    struct mirror *mirror = AOB_NEW(struct mirror);
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    (void)state;
    aob_rig_scene(&rig, "gallery", NULL, W, H, 0);
    rig.light = aob_light_uniform;
    find_mirror(&rig, gpu, mirror->even);
    rig.light = *slanted_light();
    find_mirror(&rig, gpu, mirror->light);
    for (unsigned set = 0; set < 16; set++)
        check_sum(&rig, gpu, set << AOB_OUT_BENT_NORMAL, mirror);
    aob_gpu_close(gpu);
    aob_rig_finish(&rig);
    free(mirror);
}

static void trace_outputs(const struct aob_rig *rig, double radius, struct images *images)
{
    struct aob_incident_desc desc = {.radius = radius, .spp = 512};
    const struct aob_specular_desc lobe = {.radius = radius, .roughness = -1, .spp = 512};
    struct aob_incident plain, bounced, light;
    struct aob_specular specular;
    assert_true(aob_tracer_incident(rig->tracer, &rig->camera, &rig->hits, &desc, &plain, NULL));
    desc.bounces = 8;
    assert_true(aob_tracer_incident(rig->tracer, &rig->camera, &rig->hits, &desc, &bounced, NULL));
    desc.bounces = 0;
    desc.light = &rig->light;
    assert_true(aob_tracer_incident(rig->tracer, &rig->camera, &rig->hits, &desc, &light, NULL));
    assert_true(aob_tracer_specular(rig->tracer, &rig->camera, &rig->hits, &lobe, &specular, NULL));
    memcpy(images->bounced, bounced.rgb, sizeof images->bounced);
    memcpy(images->light, light.rgb, sizeof images->light);
    memcpy(images->lobe, specular.so, sizeof images->lobe);
    for (int i = 0; i < PIXELS; i++)
        images->ao[i] = fmaxf(plain.rgb[i][0], 1e-3f);
    aob_incident_finish(&plain);
    aob_incident_finish(&bounced);
    aob_incident_finish(&light);
    aob_specular_finish(&specular);
}

/* Relative RMSE in band of what the composite makes of the true outputs that are wanted. */
static double given_error(const struct aob_rig *rig, const struct images *images, unsigned wanted,
                          const struct mirror *mirror, const struct aob_incident *truth)
{
    double square = 0, all = 0;
    for (int i = 0; i < PIXELS; i++) {
        double rgb[3];
        if (rig->hits.primitive[i] == AOB_NO_PRIMITIVE || images->ao[i] >= 0.995f)
            continue;
        compose(rig, images, wanted, mirror, i, rgb);
        for (int c = 0; c < 3; c++) {
            double t = (double)truth->rgb[i][c];
            square += (rgb[c] - t) * (rgb[c] - t);
            all += t * t;
        }
    }
    return sqrt(square / all);
}

/* Given the true outputs the composite is within a tenth of the truth, in half of what visibility alone leaves, and no effect
 * is there in vain beside the others. */
static void test_given(void **state)
{
    enum {
        BOUNCES = 1 << AOB_OUT_VISIBILITY_RGB,
        LOBE = 1 << AOB_OUT_SPECULAR,
        LIGHT = 1 << AOB_OUT_IRRADIANCE
    };
    struct aob_rig rig;
    struct aob_incident truth;
    struct mirror *mirror = AOB_NEW(struct mirror);
    struct images *images = AOB_NEW(struct images);
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    aob_rig_scene(&rig, "gallery", "ball", W, H, 0);
    rig.light = aob_light_uniform;
    find_mirror(&rig, gpu, mirror->even);
    rig.light = *slanted_light();
    find_mirror(&rig, gpu, mirror->light);
    trace(&rig, 0.5, 512, &truth);
    trace_outputs(&rig, 0.5, images);
    double none = given_error(&rig, images, 0, mirror, &truth),
           all = given_error(&rig, images, BOUNCES | LOBE | LIGHT, mirror, &truth);
    double lacks[] = {given_error(&rig, images, LOBE | LIGHT, mirror, &truth),
                      given_error(&rig, images, BOUNCES | LIGHT, mirror, &truth),
                      given_error(&rig, images, BOUNCES | LOBE, mirror, &truth)};
    print_message("           off by %.4f, of visibility alone %.4f; without bounces %.4f, specular %.4f, "
                  "irradiance %.4f\n",
                  all, none, lacks[0], lacks[1], lacks[2]);
    assert_true(all < 0.1 && all < 0.5 * none);
    for (size_t i = 0; i < AOB_COUNT(lacks); i++)
        assert_true(all < lacks[i]);
    aob_incident_finish(&truth);
    aob_gpu_close(gpu);
    aob_rig_finish(&rig);
    free(mirror);
    free(images);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_open),
        cmocka_unit_test(test_sets),
        cmocka_unit_test(test_given),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
