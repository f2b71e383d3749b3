#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"
#include "technique/param.h"
#include "technique/registry.h"

enum { W = 640, H = 360 };

struct difference {
    size_t equal, beyond; /* pixels: of the same bits, more than 1/255 apart */
    double mean;
};

/* Of the many pairs of technique and encoding, which differ in how a texel is read and not in where: */
enum { SMALL_W = 320, SMALL_H = 180 };

static struct difference compare(const float *a, const float *b, size_t count)
{
    struct difference d = {0};
    for (size_t i = 0; i < count; i++) {
        double e = fabs((double)a[i] - b[i]);
        d.equal += memcmp(&a[i], &b[i], sizeof(float)) == 0;
        d.beyond += !(e <= 1.0 / 255);
        d.mean += e / (double)count;
    }
    return d;
}

static void check_close(const char *what, const char *technique, const float *a, const float *b, size_t count)
{
    struct difference d = compare(a, b, count);
    printf("%s %s: %zu of %zu pixels equal, %zu beyond 1/255, mean difference %.2e\n", technique, what,
           d.equal, count, d.beyond, d.mean);
    assert_true(d.beyond <= count / 10000);
    assert_true(d.mean <= 1e-5);
}

/* Two scenes of one size: spheres/close, and cornell for what draws volumes, as the spheres' 46,000 would take minutes. */
struct rigs {
    struct aob_rig spheres, cornell;
};

static void rigs_init(struct rigs *rigs, int width, int height)
{
    aob_rig_scene(&rigs->spheres, "spheres", "close", width, height, 0);
    aob_rig_scene(&rigs->cornell, "cornell", "blocks", width, height, 0);
}

static void rigs_finish(struct rigs *rigs)
{
    aob_rig_finish(&rigs->spheres);
    aob_rig_finish(&rigs->cornell);
}

static const struct aob_rig *rig_for(const struct rigs *rigs, const struct aob_technique *technique)
{
    return strcmp(technique->name, "ao_volumes") == 0 ? &rigs->cornell : &rigs->spheres;
}

/* Every built-in technique, on one device after the other; Vulkan under its validation layer. */
static void test_backends_agree(void **state)
{
    (void)state;
    enum { VULKAN, EGL, OSMESA, STORAGE, COUNT };
    static const char *const backends[COUNT] = {"vulkan", "gl-egl", "gl-osmesa", "vulkan"};
    float *ao[COUNT];
    struct rigs rigs;
    rigs_init(&rigs, W, H);
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++) {
        for (int b = 0; b < COUNT; b++) {
            struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
            ao[b] = AOB_NEW_ARRAY(float, W *H);
            aob_rig_run(rig_for(&rigs, *t), gpu, (*t)->name, "",
                        b == STORAGE ? AOB_FETCH_STORAGE : AOB_FETCH_SAMPLED, ao[b]);
            aob_gpu_close(gpu);
        }
        check_close("vulkan against gl-egl", (*t)->name, ao[VULKAN], ao[EGL], W * H);
        check_close("storage against sampled", (*t)->name, ao[STORAGE], ao[VULKAN], W * H);
        assert_int_equal(compare(ao[EGL], ao[OSMESA], W * H).equal, W * H);
        for (int b = 0; b < COUNT; b++)
            free(ao[b]);
    }
    rigs_finish(&rigs);
}

/* Every encoding of depth, normals and kind of normals occurs; each technique runs under all of them. */
static const char *const encodings[] = {
    "depth_encoding=r16f normal_encoding=oct_rg16f",
    "depth_encoding=unorm16 normal_encoding=rgba8",
    "depth_encoding=packed16 normal_encoding=packed8",
    "depth_encoding=device24 normals=shading",
    "depth_encoding=device24_reversed normal_encoding=oct_rg16f normals=shading",
    "depth_encoding=device24_infinite normals=from_depth",
    "depth_encoding=device32 normal_encoding=packed8",
    "depth_encoding=device32_reversed normals=from_depth",
    "depth_encoding=device32_infinite normal_encoding=rgba8 normals=shading",
    "normal_encoding=rgba16f",
    "normal_encoding=oct_rg8 normals=shading",
    "normal_encoding=rgb10",
    "normal_encoding=sphere_rg16f normals=shading",
};

static void test_backends_agree_on_encodings(void **state)
{
    (void)state;
    struct aob_gpu *vulkan = aob_rig_gpu("vulkan"), *egl = aob_rig_gpu("gl-egl");
    float *a = AOB_NEW_ARRAY(float, SMALL_W *SMALL_H), *b = AOB_NEW_ARRAY(float, SMALL_W *SMALL_H);
    struct rigs rigs;
    rigs_init(&rigs, SMALL_W, SMALL_H);
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        for (size_t e = 0; e < AOB_COUNT(encodings); e++) {
            aob_rig_run(rig_for(&rigs, *t), vulkan, (*t)->name, encodings[e], AOB_FETCH_SAMPLED, a);
            aob_rig_run(rig_for(&rigs, *t), egl, (*t)->name, encodings[e], AOB_FETCH_SAMPLED, b);
            check_close(encodings[e], (*t)->name, a, b, SMALL_W * SMALL_H);
        }
    free(a);
    free(b);
    rigs_finish(&rigs);
    aob_gpu_close(vulkan);
    aob_gpu_close(egl);
}

/* Odd sizes: divided targets do not come out even. At most 3 pixels may differ by more than 1/255. */
static void test_backends_agree_at_odd_sizes(void **state)
{
    (void)state;
    enum { ODD_W = 333, ODD_H = 187 };
    struct aob_gpu *vulkan = aob_rig_gpu("vulkan"), *egl = aob_rig_gpu("gl-egl");
    float *a = AOB_NEW_ARRAY(float, ODD_W *ODD_H), *b = AOB_NEW_ARRAY(float, ODD_W *ODD_H);
    struct rigs rigs;
    rigs_init(&rigs, ODD_W, ODD_H);
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        for (int divisor = 1; divisor <= 4; divisor *= 2) {
            char params[40];
            snprintf(params, sizeof params, "divisor=%d", divisor);
            if (divisor > 1 && !aob_param_find((*t)->params, (*t)->param_count, "divisor"))
                continue;
            aob_rig_run(rig_for(&rigs, *t), vulkan, (*t)->name, divisor > 1 ? params : "", AOB_FETCH_SAMPLED,
                        a);
            aob_rig_run(rig_for(&rigs, *t), egl, (*t)->name, divisor > 1 ? params : "", AOB_FETCH_SAMPLED, b);
            struct difference d = compare(a, b, ODD_W * ODD_H);
            printf("%s %s at %dx%d: %zu pixels beyond 1/255\n", (*t)->name, params, ODD_W, ODD_H, d.beyond);
            assert_true(d.beyond <= 3);
        }
    free(a);
    free(b);
    rigs_finish(&rigs);
    aob_gpu_close(vulkan);
    aob_gpu_close(egl);
}

/* Bent normals, component by component, from each backend and each kind of read. */
static void test_backends_agree_on_bent_normals(void **state)
{
    (void)state;
    enum { COUNT = 4, TINY_W = 160, TINY_H = 90, FLOATS = 3 * TINY_W * TINY_H };
    static const char *const techniques[] = {"gtao", "hbao", "ray_march"}, *const backends[COUNT] = {
                                                                               "gl-egl", "gl-osmesa",
                                                                               "vulkan", "vulkan"};
    float *ao = AOB_NEW_ARRAY(float, TINY_W *TINY_H), *bent[COUNT];
    struct rigs rigs;
    rigs_init(&rigs, TINY_W, TINY_H);
    for (size_t t = 0; t < AOB_COUNT(techniques); t++) {
        for (int b = 0; b < COUNT; b++) {
            struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
            bent[b] = AOB_NEW_ARRAY(float, FLOATS);
            aob_rig_run_open(&rigs.spheres, gpu, techniques[t], "",
                             b == 3 ? AOB_FETCH_STORAGE : AOB_FETCH_SAMPLED, ao, (float(*)[3])bent[b]);
            aob_gpu_close(gpu);
        }
        check_close("bent normals, vulkan against gl-egl", techniques[t], bent[2], bent[0], FLOATS);
        check_close("bent normals, storage against sampled", techniques[t], bent[3], bent[2], FLOATS);
        assert_int_equal(compare(bent[0], bent[1], FLOATS).equal, FLOATS);
        for (int b = 0; b < COUNT; b++)
            free(bent[b]);
    }
    rigs_finish(&rigs);
    free(ao);
}

/* gtao's outputs beside those, in a coloured and a polished room under a directional light: two backends, and both kinds of read. */
static void test_backends_agree_on_light(void **state)
{
    (void)state;
    enum { COUNT = 4, TINY_W = 160, TINY_H = 90, PIXELS = TINY_W * TINY_H };
    static const char *const scenes[] = {"coloured_walls", "gallery"}, *const backends[COUNT] = {
                                                                           "gl-egl", "gl-osmesa", "vulkan",
                                                                           "vulkan"};
    for (size_t s = 0; s < AOB_COUNT(scenes); s++) {
        struct aob_light_projection projection;
        float *images[COUNT][AOB_OUTPUT_COUNT];
        struct aob_rig rig;
        aob_rig_scene(&rig, scenes[s], NULL, TINY_W, TINY_H, 0);
        aob_light_make(aob_light_find("sky"), &projection);
        rig.light = projection.light;
        for (int b = 0; b < COUNT; b++) {
            struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
            for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
                images[b][which] = AOB_NEW_ARRAY(float, 3 * PIXELS);
            aob_rig_run_outputs(&rig, gpu, "gtao", "", b == 3 ? AOB_FETCH_STORAGE : AOB_FETCH_SAMPLED,
                                images[b]);
            aob_gpu_close(gpu);
        }
        for (int which = AOB_OUT_VISIBILITY_RGB; which < AOB_OUTPUT_COUNT; which++) {
            size_t floats = which == AOB_OUT_SPECULAR ? PIXELS : 3 * PIXELS;
            const char *name = aob_output_name((enum aob_output)which);
            check_close(name, "gtao, vulkan against gl-egl", images[2][which], images[0][which], floats);
            check_close(name, "gtao, storage against sampled", images[3][which], images[2][which], floats);
            assert_int_equal(compare(images[0][which], images[1][which], floats).equal, floats);
        }
        for (int b = 0; b < COUNT; b++)
            for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
                free(images[b][which]);
        aob_rig_finish(&rig);
    }
}

/* The same frame twice on one device, and again after another technique ran there. */
static void test_frames_repeat(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float *first = AOB_NEW_ARRAY(float, W *H), *again = AOB_NEW_ARRAY(float, W *H);
    aob_rig_scene(&rig, "cornell", NULL, W, H, 0);
    aob_rig_run(&rig, gpu, "gtao", "", AOB_FETCH_SAMPLED, first);
    aob_rig_run(&rig, gpu, "alchemy", "seed=7", AOB_FETCH_SAMPLED, again);
    assert_true(compare(first, again, W * H).equal < W * H * 9 / 10); /* open pixels are 1 in both */
    aob_rig_run(&rig, gpu, "gtao", "", AOB_FETCH_SAMPLED, again);
    assert_int_equal(compare(first, again, W * H).equal, W * H);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(first);
    free(again);
}

/* The inner image of a guarded frame is the bare frame where nothing near the border matters: `none`, and the
 * view's own depth. */
static void test_guard_band_is_cropped(void **state)
{
    (void)state;
    struct aob_rig bare, guarded;
    aob_rig_scene(&bare, "spheres", "front", W, H, 0);
    aob_rig_scene(&guarded, "spheres", "front", W, H, 40);
    assert_int_equal(guarded.hits.width, W + 80);
    size_t other = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            size_t i = (size_t)(y * W + x), j = (size_t)((y + 40) * (W + 80) + x + 40);
            other += bare.hits.primitive[i] != guarded.hits.primitive[j];
            if (bare.hits.primitive[i] == guarded.hits.primitive[j])
                assert_near(bare.hits.depth[i], guarded.hits.depth[j], 1e-5 * bare.hits.depth[i]);
        }
    assert_true(other <= 4); /* rays through an edge may fall on either side */
    aob_rig_finish(&bare);
    aob_rig_finish(&guarded);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_backends_agree),
                                       cmocka_unit_test(test_backends_agree_on_encodings),
                                       cmocka_unit_test(test_backends_agree_at_odd_sizes),
                                       cmocka_unit_test(test_backends_agree_on_bent_normals),
                                       cmocka_unit_test(test_backends_agree_on_light),
                                       cmocka_unit_test(test_frames_repeat),
                                       cmocka_unit_test(test_guard_band_is_cropped)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
