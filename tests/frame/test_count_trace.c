/* What is counted against what is traced, in each pass of every technique. Of the words as glslang writes them, which keep
 * every read: as many invocations, as many operations on images as words of the trace, and the plain image to the last bit,
 * so counters change nothing. Of the optimised words: as many invocations, no fewer operations than distinct fetches and no
 * more than fetches, and the plain image but for rounding. What the driver gets is valid. */
#include "counted.h"
#include <math.h>
#include <spirv-tools/libspirv.h>
#include "shader/blocks.h"
#include "shader/counters.h"
#include "frame/past.h"
#include "traced.h"

enum { W = 64, H = 36, GUARD = 4, BUFFER_WORDS = 1 << 14 };

struct setting {
    const char *technique, *params;
};

/* What changes which passes there are, or how loops and branches go. The compiler behind the drivers is one, so they are
 * tried on one of them. */
static const struct setting settings[] = {
    {"alchemy", "blur=5 divisor=2 composite=on"},
    {"alchemy", "samples_per_band=4 bands=3 blur=0"},
    {"alchemy", "depth_encoding=packed16 normal_encoding=packed8"},
    {"ao_volumes", "divisor=1 cull=off sides=16 falloff=1"},
    {"crytek_ssao", "hemisphere=on samples=32 depth_divisor=2"},
    {"crytek_ssao", "size=screen rotation=mirror amplification=off divisor=2 blur=0"},
    {"gtao", "weighting=uniform divisor=2 depth_divisor=4 blur=5"},
    {"gtao", "normals=from_depth depth_divisor=2 divisor=2"},
    {"gtao", "history=8 blur=0"},
    {"hbao", "weighting=cosine tangents=per_direction directions=16 steps=3 blur=0"},
    {"hbao", "snapping=off depth_divisor=2 blur=5"},
    {"ray_march", "directions=4 rays=2 steps=4"},
    {"starcraft2_ssao", "radii=one blocker=table divisor=2 blur_passes=2"},
    {"volumetric_obscurance", "resolutions=two samples=12"},
    {"volumetric_obscurance", "hemisphere=on samples=16 divisor=2 blur=5"},
};

/* --- The words, as the driver gets them ----------------------------------------------------------------------------- */

static const struct aob_gpu_fns *original;
static int validated;

static void validate(const uint32_t *words, size_t count)
{
    const uint32_t opengl = 0x00010000;
    spv_context context = spvContextCreate(words[1] == opengl ? SPV_ENV_OPENGL_4_5 : SPV_ENV_VULKAN_1_3);
    spv_const_binary_t binary = {words, count};
    spv_diagnostic why = NULL;
    if (spvValidate(context, &binary, &why) != SPV_SUCCESS)
        fail_msg("%s", why ? why->error : "not valid");
    spvDiagnosticDestroy(why);
    spvContextDestroy(context);
    validated++;
}

static uint32_t *rewrite_and_validate(void *self, const uint32_t *words, size_t *count, uint32_t storage,
                                      struct aob_error *error)
{
    const struct aob_gpu_rewrite *rewrite = self;
    uint32_t *made = rewrite->words(rewrite->self, words, count, storage, error);
    if (made)
        validate(made, *count);
    return made;
}

static bool create_validated(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                             struct aob_gpu_program **program, struct aob_error *error)
{
    const struct aob_gpu_rewrite rewrite = {(void *)desc->rewrite, rewrite_and_validate};
    struct aob_gpu_program_desc validated_desc = *desc;
    validated_desc.rewrite = desc->rewrite ? &rewrite : NULL;
    return original->program_create(gpu, &validated_desc, program, error);
}

/* --- A frame whose words are counted as glslang writes them --------------------------------------------------------- */

struct raw {
    struct aob_first first;
    struct aob_frame frame;
    struct aob_gpu_buffer *buffer;
    struct aob_gpu_rewrite rewrites[AOB_MAX_PASS];
    struct aob_blocks blocks[AOB_MAX_PASS];
    struct aob_count_pass passes[AOB_MAX_PASS];
};

static uint32_t *count_as_written(void *self, const uint32_t *words, size_t *count, uint32_t storage,
                                  struct aob_error *error)
{
    struct aob_spirv spirv;
    if (!aob_spirv_init(&spirv, words, *count, error) || !aob_blocks_init(self, &spirv, error))
        fail_msg("%s", error->text);
    uint32_t *made = aob_counters_insert(&spirv, storage, count);
    aob_spirv_finish(&spirv);
    return made;
}

static void run_raw(struct raw *raw, struct aob_gpu *gpu, int pass)
{
    static uint32_t words[BUFFER_WORDS];
    struct aob_error error = {""};
    const struct aob_blocks *blocks = &raw->blocks[pass];
    memset(words, 0, sizeof words);
    if (!aob_gpu_buffer_write(gpu, raw->buffer, 0, sizeof words, words, &error) ||
        !aob_gpu_run(gpu, &(struct aob_gpu_run_desc){&raw->frame.passes[pass], 1, 1}, NULL, NULL, &error) ||
        !aob_gpu_buffer_read(gpu, raw->buffer, 0, sizeof words, words, &error))
        fail_msg("%s", error.text);
    raw->passes[pass].invocations = words[AOB_COUNTERS_INVOCATIONS];
    assert_int_equal(words[AOB_COUNTERS_BLOCKS + blocks->first], words[AOB_COUNTERS_INVOCATIONS]);
    for (size_t i = 0; i < blocks->count; i++)
        raw->passes[pass].whole.image += words[AOB_COUNTERS_BLOCKS + i] * blocks->each[i].image;
}

static void raw_init(struct raw *raw, struct counted *counted, const struct counted_desc *desc)
{
    struct aob_error error = {""};
    *raw = (struct raw){.buffer = aob_gpu_buffer_create(counted->gpu, 4 * BUFFER_WORDS, &error)};
    for (int i = 0; i < AOB_MAX_PASS; i++)
        raw->rewrites[i] = (struct aob_gpu_rewrite){&raw->blocks[i], count_as_written};
    struct aob_frame_desc frame = {.technique = desc->technique,
                                   .values = desc->values,
                                   .fetch = (enum aob_fetch)desc->options->fetch,
                                   .rewrites = raw->rewrites,
                                   .storage = raw->buffer};
    if (!raw->buffer || !aob_first_init(&raw->first, &counted->screen, &frame, &error))
        fail_msg("%s", error.text);
    frame.past = aob_first_past(&raw->first);
    if (!aob_frame_init_desc(&raw->frame, &counted->screen, &frame, &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < raw->frame.graph.pass_count; i++)
        if (raw->frame.passes[i])
            run_raw(raw, counted->gpu, i);
}

static void raw_finish(struct raw *raw)
{
    struct aob_gpu *gpu = raw->frame.screen->gpu;
    aob_frame_finish(&raw->frame);
    aob_first_finish(&raw->first);
    aob_gpu_buffer_destroy(gpu, raw->buffer);
    for (int i = 0; i < AOB_MAX_PASS; i++)
        aob_blocks_finish(&raw->blocks[i]);
}

/* --- Words of a trace ----------------------------------------------------------------------------------------------- */

struct fetches {
    size_t all, distinct; /* distinct within each invocation, added up */
};

/* `seen`: by a word's place, the invocation that had it last, from 1 on. */
static void add_invocation(const uint32_t *words, size_t slots, size_t number, uint32_t *seen,
                           struct fetches *sum)
{
    for (size_t i = 0; i < slots; i++) {
        if (words[i] == AOB_TRACE_NONE)
            continue;
        size_t place = 2 * (size_t)(words[i] & ~AOB_TRACE_BILINEAR) + (words[i] >= AOB_TRACE_BILINEAR);
        sum->all++;
        sum->distinct += seen[place] != number;
        seen[place] = (uint32_t)number;
    }
}

static struct fetches fetches_of(const struct taken_pass *pass)
{
    struct fetches sum = {0, 0};
    size_t texels = 1;
    for (int i = 0; i < pass->pass.plane_count; i++)
        texels += (size_t)pass->pass.planes[i].width * (size_t)pass->pass.planes[i].height;
    uint32_t *seen = AOB_NEW_ARRAY(uint32_t, 2 * texels);
    for (size_t i = 0; i < pass->count; i++)
        add_invocation(pass->words + i * pass->slots, pass->slots, i + 1, seen, &sum);
    free(seen);
    return sum;
}

static bool same_pass(const struct taken_pass *traced, const struct raw *raw, const struct aob_count *count)
{
    const struct fetches fetches = fetches_of(traced);
    const struct aob_count_pass *written = &raw->passes[traced->pass.index];
    const struct aob_count_pass *optimised = &count->passes[traced->pass.index];
    bool same = written->invocations == traced->count && optimised->invocations == traced->count &&
                written->whole.image == (double)fetches.all &&
                optimised->whole.image <= (double)fetches.all &&
                optimised->whole.image >= (double)fetches.distinct;
    if (!same)
        printf("pass %s: %zu invocations, %zu fetches, %zu distinct; as written %llu, %.0f; optimised %llu, "
               "%.0f\n",
               traced->pass.name, traced->count, fetches.all, fetches.distinct,
               (unsigned long long)written->invocations, written->whole.image,
               (unsigned long long)optimised->invocations, optimised->whole.image);
    return same;
}

/* --- Images --------------------------------------------------------------------------------------------------------- */

static float *image_of(struct aob_frame *frame)
{
    struct aob_error error = {""};
    float *pixels = AOB_NEW_ARRAY(float, W *H);
    if (!aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, pixels, &error))
        fail_msg("%s", error.text);
    return pixels;
}

static double largest_difference(const float *a, const float *b)
{
    double most = 0;
    for (size_t i = 0; i < W * H; i++)
        most = fmax(most, fabs((double)a[i] - (double)b[i]));
    return most;
}

/* Each pass may round a pixel's target to the next number of 16 bits, which lie 2^-11 apart below 1. */
static bool near_image(struct traced *traced, struct raw *raw, struct counted *counted)
{
    float *plain = image_of(&traced->plain), *written = image_of(&raw->frame),
          *optimised = image_of(&counted->count.frame);
    double exact = largest_difference(plain, written), near = largest_difference(plain, optimised);
    bool good = exact == 0 && near <= ldexp(traced->plain.graph.pass_count, -11);
    if (!good)
        printf("images differ by %g as written, by %g optimised\n", exact, near);
    free(plain);
    free(written);
    free(optimised);
    return good;
}

/* -------------------------------------------------------------------------------------------------------------------- */

static bool check(struct aob_gpu *gpu, const struct aob_rig *rig, const char *name, const char *params)
{
    struct traced *traced = AOB_NEW(struct traced);
    struct counted *counted = AOB_NEW(struct counted);
    struct raw *raw = AOB_NEW(struct raw);
    struct taken *taken = AOB_NEW(struct taken);
    const struct aob_technique *found = counted_find(name);
    struct aob_options options;
    unsigned char values[4 * AOB_MAX_PARAM];
    aob_rig_params(found, params, values, &options);
    const struct counted_desc desc = {.technique = found, .values = values, .options = &options};
    traced_init(traced, rig, gpu,
                &(struct traced_desc){.technique = found, .values = values, .options = &options});
    counted_init(counted, rig, gpu, &desc);
    raw_init(raw, counted, &desc);
    take(traced, taken);
    bool same = near_image(traced, raw, counted);
    for (size_t i = 0; i < taken->pass_count; i++)
        same = same_pass(&taken->passes[i], raw, &counted->count) && same;
    if (!same)
        printf("  in %s %s on %s\n", name, params, gpu->info.backend);
    taken_finish(taken);
    raw_finish(raw);
    counted_finish(counted);
    traced_finish(traced);
    free(taken);
    free(raw);
    free(counted);
    free(traced);
    return same;
}

static bool check_backend(const struct aob_rig *rig, const char *backend, const char *params,
                          size_t setting_count)
{
    bool same = true;
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    struct aob_gpu_fns fns = *gpu->fns;
    original = gpu->fns;
    fns.program_create = create_validated;
    gpu->fns = &fns;
    validated = 0;
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        same = check(gpu, rig, (*t)->name, params) && same;
    for (size_t i = 0; i < setting_count; i++)
        same = check(gpu, rig, settings[i].technique, settings[i].params) && same;
    gpu->fns = original;
    aob_gpu_close(gpu);
    assert_true(validated > 0);
    return same;
}

static void test_counts_agree_with_traces(void **state)
{
    (void)state;
    struct aob_rig rig;
    aob_rig_scene(&rig, "cornell", "blocks", W, H, GUARD);
    bool same = check_backend(&rig, "vulkan", "fetch=sampled", AOB_COUNT(settings));
    same = check_backend(&rig, "gl-egl", "fetch=storage", 0) && same;
    aob_rig_finish(&rig);
    assert_true(same);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_counts_agree_with_traces)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
