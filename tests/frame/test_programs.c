/* Frames that share programs draw what frames with their own do, in all sizes and with all values of uniforms. */
#include "frame/programs.h"
#include "check.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "rig.h"
#include "technique/param.h"
#include "technique/registry.h"

enum { W = 40, H = 24 };

static const struct aob_technique *gtao(void)
{
    const struct aob_technique *const *t = aob_builtin_techniques;
    while (strcmp((*t)->name, "gtao") != 0)
        t++;
    return *t;
}

/* One frame; `programs` NULL: it compiles its own. */
static void draw(struct aob_gpu *gpu, const struct aob_rig *rig, const char *params,
                 struct aob_programs *programs, float *pixels)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_screen screen;
    struct aob_error error = {{0}};
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    aob_rig_params(gtao(), params, values, &options);
    const struct aob_frame_desc desc = {.technique = gtao(), .values = values, .programs = programs};
    if (!aob_screen_init(&screen, gpu, &rig->gbuffer, &options, &error) ||
        !aob_frame_init_desc(frame, &screen, &desc, &error) || !aob_frame_run(frame, 1, NULL, &error) ||
        !aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, pixels, &error))
        fail_msg("%s", error.text);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    free(frame);
}

static void compare(struct aob_gpu *gpu, const struct aob_rig *rig, const char *params,
                    struct aob_programs *programs)
{
    static float own[4 * W * H], shared[4 * W * H];
    size_t bytes = (size_t)rig->width * (size_t)rig->height * sizeof *own;
    draw(gpu, rig, params, NULL, own);
    draw(gpu, rig, params, programs, shared);
    if (memcmp(own, shared, bytes) != 0)
        fail_msg("%s, %s at %dx%d: the images differ", gpu->info.backend, params, rig->width, rig->height);
}

static void shared_programs_draw_the_same(void **state)
{
    static const char *const backends[] = {"vulkan", "gl-egl"};
    (void)state;
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        struct aob_rig small, large;
        struct aob_programs programs;
        aob_rig_scene(&small, "corner", "far", W, H, 0);
        aob_rig_scene(&large, "cornell", "front", 2 * W + 1, 2 * H - 1, 0);
        aob_programs_init(&programs, gpu);
        compare(gpu, &small, "radius=0.5 blur=0", &programs);
        assert_int_equal(programs.count, 1); /* the horizon pass */
        compare(gpu, &large, "radius=2 blur=0 falloff=0.5", &programs);
        assert_int_equal(programs.count, 1); /* sizes, views and uniforms are no other text */
        compare(gpu, &small, "radius=0.5 blur=0 slices=2", &programs);
        assert_int_equal(programs.count, 2);
        compare(gpu, &small, "radius=0.5 blur=5", &programs);
        assert_int_equal(programs.count,
                         5); /* two of the blur, and the horizon again, whose text has all constants */
        aob_programs_finish(&programs);
        aob_rig_finish(&small);
        aob_rig_finish(&large);
        aob_gpu_close(gpu);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shared_programs_draw_the_same)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
