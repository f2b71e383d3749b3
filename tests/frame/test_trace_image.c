/* A traced frame draws what a plain one draws, in every bit of every target of every pass: when its reads were counted,
 * and after a capture in strips. */
#include "traced.h"
#include "technique/registry.h"

enum { W = 96, H = 54 };

struct setting {
    const char *technique, *params;
};

/* What changes which passes there are, or how their loops are laid out: unrolled loops are where compilers differ. */
static const struct setting settings[] = {
    {"alchemy", "blur=33 divisor=2 composite=on"},
    {"alchemy", "samples=64 blur=3"},
    {"alchemy", "samples_per_band=4 bands=3 blur=0"},
    {"ao_volumes", "divisor=1"},
    {"ao_volumes", "falloff=1 cull=off divisor=2"},
    {"ao_volumes", "sides=16"},
    {"crytek_ssao", "hemisphere=on samples=32 depth_divisor=2"},
    {"crytek_ssao", "size=screen rotation=mirror amplification=off divisor=2 blur=0"},
    {"gtao", "slices=9 steps=3 falloff=0.5"},
    {"gtao", "weighting=uniform divisor=2 depth_divisor=4 blur=5"},
    {"gtao", "slices=1 steps=12 depth_divisor=2"},
    {"gtao", "history=8"},
    {"hbao", "divisor=2 directions=4 steps=4 snapping=per_direction"},
    {"hbao", "weighting=cosine tangents=per_direction directions=16 steps=3 blur=0"},
    {"hbao", "snapping=off depth_divisor=2 blur=33"},
    {"ray_march", "directions=4 rays=2 steps=4"},
    {"starcraft2_ssao", "radii=one blocker=table divisor=2 blur_passes=2"},
    {"starcraft2_ssao", "samples=32 depth_divisor=4 blur=9"},
    {"volumetric_obscurance", "resolutions=two samples=12"},
    {"volumetric_obscurance", "hemisphere=on samples=16 divisor=2 blur=5"},
};

/* Encodings differ in what a read of the G-buffer costs, and so in how loops are laid out. */
static const struct setting encodings[] = {
    {"alchemy", "depth_encoding=packed16 normal_encoding=packed8"},
    {"alchemy", "normals=from_depth"},
    {"gtao", "depth_encoding=device24 normal_encoding=oct_rg16f"},
    {"gtao", "normals=from_depth depth_divisor=2 divisor=2"},
    {"hbao", "depth_encoding=r16f normal_encoding=rgba8"},
};

struct rigs {
    struct aob_rig perspective, parallel;
};

static void init_parallel(struct aob_rig *rig)
{
    struct aob_mesh mesh = {0};
    const struct aob_camera camera = {.eye = {0, 2, 4}, .target = {0, 0.8, 0}, .ortho_height = 3};
    aob_scene_find("cornell")->build(&mesh);
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
}

static bool same_image(struct traced *traced, const char *when)
{
    size_t differ;
    struct aob_error error = {""};
    if (!aob_trace_compare(&traced->trace, &traced->plain, &differ, &error))
        fail_msg("%s", error.text);
    if (differ)
        printf("%s: %zu texels differ %s\n", traced->gpu->info.backend, differ, when);
    return differ == 0;
}

static bool check(struct aob_gpu *gpu, const struct aob_rig *rig, const struct aob_technique *technique,
                  const char *params)
{
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    struct aob_options options;
    unsigned char values[4 * AOB_MAX_PARAM];
    aob_rig_params(technique, params, values, &options);
    traced_init(traced, rig, gpu, &(struct traced_desc){technique, values, &options, .device_bytes = 400000});
    bool same = same_image(traced, "when counted");
    take(traced, taken);
    same = same_image(traced, "after a capture") && same;
    if (!same)
        printf("  in %s %s\n", technique->name, params);
    taken_finish(taken);
    traced_finish(traced);
    free(traced);
    free(taken);
    return same;
}

static bool check_all(struct aob_gpu *gpu, const struct aob_rig *rig, const char *params)
{
    bool same = true;
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        same = check(gpu, rig, *t, params) && same;
    return same;
}

static bool check_settings(struct aob_gpu *gpu, const struct aob_rig *rig, const struct setting *list,
                           size_t count)
{
    bool same = true;
    for (size_t i = 0; i < count; i++)
        for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
            if (strcmp((*t)->name, list[i].technique) == 0)
                same = check(gpu, rig, *t, list[i].params) && same;
    return same;
}

/* The compiler behind the three drivers is one, so the many settings are tried on one of them. */
static bool check_vulkan(const struct rigs *rigs)
{
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    bool same = check_all(gpu, &rigs->perspective, "fetch=sampled");
    same = check_all(gpu, &rigs->perspective, "fetch=storage") && same;
    same = check_all(gpu, &rigs->parallel, "fetch=sampled") && same;
    same = check_settings(gpu, &rigs->perspective, settings, AOB_COUNT(settings)) && same;
    same = check_settings(gpu, &rigs->parallel, encodings, AOB_COUNT(encodings)) && same;
    aob_gpu_close(gpu);
    return same;
}

static bool check_gl(const struct rigs *rigs, const char *backend)
{
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    bool same = check_all(gpu, &rigs->perspective, "fetch=sampled");
    same = check_all(gpu, &rigs->parallel, "fetch=storage") && same;
    aob_gpu_close(gpu);
    return same;
}

static void test_images_are_equal(void **state)
{
    (void)state;
    struct rigs rigs;
    aob_rig_scene(&rigs.perspective, "cornell", "blocks", W, H, 4);
    init_parallel(&rigs.parallel);
    bool same = check_vulkan(&rigs);
    same = check_gl(&rigs, "gl-egl") && same;
    same = check_gl(&rigs, "gl-osmesa") && same;
    aob_rig_finish(&rigs.perspective);
    aob_rig_finish(&rigs.parallel);
    assert_true(same);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_images_are_equal)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
