/* Of a technique that keeps a history the frame that is traced and counted has one before it: what it reads then, by hand, and what the
 * first frame would have read in its place. */
#include "counted.h"
#include <math.h>
#include "frame/past.h"
#include "traced.h"

enum { W = 70, H = 67, PIXELS = W * H };

/* `gtao` with a mean over time of a view that a camera came to with a step aside, or that it stands before. */
struct stage {
    struct aob_gpu *gpu;
    struct aob_rig before, now;
    struct aob_screen screen;
    struct aob_options options;
    const struct aob_technique *technique;
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_frame plain; /* its frames 0 and 1 have been drawn */
    struct aob_past past;   /* what frame 0 left */
};

static struct aob_screen_pose pose_of(const struct aob_rig *rig)
{
    return (struct aob_screen_pose){&rig->gbuffer, &rig->light, aob_camera_then(&rig->camera)};
}

static void draw_frames(struct stage *stage)
{
    struct aob_error error = {""};
    const struct aob_frame_desc desc = {
        .technique = stage->technique, .values = stage->values, .readable = true};
    const struct aob_screen_pose pose = pose_of(&stage->now);
    bool ok = aob_screen_init(&stage->screen, stage->gpu, &stage->before.gbuffer, &stage->options, &error) &&
              aob_frame_init_desc(&stage->plain, &stage->screen, &desc, &error) &&
              aob_frame_run(&stage->plain, 1, NULL, &error);
    aob_past_take(&stage->plain, &stage->past);
    if (!ok || !aob_screen_show(&stage->screen, &pose, &error) ||
        !aob_frame_set(&stage->plain, 1, stage->values, &error) ||
        !aob_frame_run(&stage->plain, 1, NULL, &error))
        fail_msg("%s", error.text);
}

static struct stage *stage_create(const char *params, double step)
{
    struct stage *stage = AOB_NEW(struct stage);
    struct aob_camera camera = {.eye = {0.2 - step, 1.6, 4.4}, .target = {-step, 0.7, 0}, .fov_deg = 50};
    struct aob_mesh mesh = {0};
    stage->gpu = aob_rig_gpu("vulkan");
    aob_scene_find("spheres")->build(&mesh);
    aob_rig_init(&stage->before, &mesh, &camera, W, H, 0);
    camera.moves = step != 0;
    camera.previous_eye = camera.eye;
    camera.previous_target = camera.target;
    camera.eye.x += step;
    camera.target.x += step;
    aob_rig_init(&stage->now, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
    stage->technique = counted_find("gtao");
    aob_rig_params(stage->technique, params, stage->values, &stage->options);
    draw_frames(stage);
    return stage;
}

static void stage_destroy(struct stage *stage)
{
    aob_frame_finish(&stage->plain);
    aob_screen_finish(&stage->screen);
    aob_rig_finish(&stage->before);
    aob_rig_finish(&stage->now);
    aob_gpu_close(stage->gpu);
    free(stage);
}

/* The frame 0 of the same view: what it would read of before is there, and counts for nothing. */
static struct aob_past no_past(const struct stage *stage)
{
    struct aob_past past = stage->past;
    past.number = -1;
    return past;
}

/* --- Traces --------------------------------------------------------------------------------------------------------- */

static void trace(struct stage *stage, const struct aob_past *past, struct traced *traced,
                  struct taken *taken)
{
    struct aob_error error = {""};
    const struct aob_trace_desc desc = {
        .screen = &stage->screen, .technique = stage->technique, .values = stage->values, .past = past};
    traced->gpu = stage->gpu;
    if (!aob_trace_init(&traced->trace, &desc, &error))
        fail_msg("%s", error.text);
    take(traced, taken);
}

/* Words of a pass that name texels of the texture of that name. */
static double reads_of(const struct taken *taken, const char *pass_name, const char *texture)
{
    double count = 0;
    for (size_t p = 0; p < taken->pass_count; p++) {
        const struct taken_pass *pass = &taken->passes[p];
        for (int i = 0; strcmp(pass->pass.name, pass_name) == 0 && i < pass->pass.plane_count; i++) {
            const struct aob_trace_plane *plane = &pass->pass.planes[i];
            uint32_t end = plane->first + (uint32_t)plane->width * (uint32_t)plane->height;
            for (size_t w = 0; strcmp(taken->frame.textures[plane->texture].name, texture) == 0 &&
                               w < pass->count * pass->slots;
                 w++)
                count += pass->words[w] != AOB_TRACE_NONE && pass->words[w] >= plane->first &&
                         pass->words[w] < end;
        }
    }
    return count;
}

/* Pixels that show a surface, and those of them whose tile has not changed by what the traced frame wrote. */
struct kinds {
    double surface, kept;
};

static struct kinds kinds_of(const struct stage *stage, const struct aob_trace *trace)
{
    enum { TILES_X = (W + 7) / 8, TILES = TILES_X * ((H + 7) / 8) };
    const struct aob_pass_graph *graph = &trace->frame.graph;
    unsigned char changed[TILES];
    struct aob_error error = {""};
    struct kinds kinds = {0, 0};
    int index = 0;
    while (strcmp(graph->textures[index].name, "changed") != 0)
        index++;
    if (!aob_gpu_texture_read(stage->gpu, trace->frame.textures[index], 0, changed, &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < PIXELS; i++) {
        bool surface = stage->now.gbuffer.depth[i] < 0.5f * AOB_GBUFFER_SKY;
        kinds.surface += surface;
        kinds.kept += surface && !changed[i / W / 8 * TILES_X + i % W / 8];
    }
    return kinds;
}

/* Of the frame before, `temporal` reads of a surface where nothing has changed what `taps` pixels held, surface and mean. */
static void check_reads(const struct stage *stage, const struct aob_trace *trace, const struct taken *taken,
                        int taps)
{
    const struct kinds kinds = kinds_of(stage, trace);
    double means = reads_of(taken, "temporal", "open_mean before");
    printf("%.0f surfaces of %d, %.0f where nothing has changed, %.0f reads of a mean\n", kinds.surface,
           PIXELS, kinds.kept, means);
    assert_true(kinds.surface > 0.3 * PIXELS);
    assert_true(means == taps * kinds.kept);
    assert_true(reads_of(taken, "temporal", "open_surface before") == taps * kinds.kept);
    assert_true(reads_of(taken, "temporal", "changed") == kinds.surface);
    assert_true(reads_of(taken, "temporal", "visibility") == PIXELS);
    assert_true(reads_of(taken, "temporal", "velocity") == PIXELS);
}

static void check_trace(double step, int taps, double kept)
{
    struct stage *stage = stage_create("history=8 blur=0", step);
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    struct aob_error error = {""};
    size_t differ;
    trace(stage, &stage->past, traced, taken);
    check_reads(stage, &traced->trace, taken, taps);
    const struct kinds kinds = kinds_of(stage, &traced->trace);
    assert_true(kinds.kept >= kept * kinds.surface);
    if (!aob_trace_compare(&traced->trace, &stage->plain, &differ, &error))
        fail_msg("%s", error.text);
    assert_int_equal(differ, 0);
    taken_finish(taken);
    aob_trace_finish(&traced->trace);
    free(taken);
    free(traced);
    stage_destroy(stage);
}

/* A still camera sees every surface again at the centre of its pixel: one tap of each texture. */
static void test_a_still_camera_reads_one_pixel(void **state)
{
    (void)state;
    check_trace(0, 1, 1);
}

/* One that moves sees them between pixels: 4 x 4. The frame before is the real one, from where the camera was. */
static void test_a_moving_camera_reads_sixteen(void **state)
{
    (void)state;
    check_trace(0.03, 16, 0.5);
}

/* Where nothing is handed over the trace draws its own frame 0, which of a still view is the same. */
static void test_a_trace_makes_its_own_past(void **state)
{
    (void)state;
    struct stage *stage = stage_create("history=8 blur=0", 0);
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *given = AOB_NEW(struct taken), *own = AOB_NEW(struct taken), *again = AOB_NEW(struct taken);
    trace(stage, &stage->past, traced, given);
    aob_trace_finish(&traced->trace);
    trace(stage, NULL, traced, own);
    assert_same_words(given, own);
    take(traced, again); /* however often it is captured it is frame 1 */
    assert_same_words(given, again);
    aob_trace_finish(&traced->trace);
    taken_finish(given);
    taken_finish(own);
    taken_finish(again);
    free(given);
    free(own);
    free(again);
    free(traced);
    stage_destroy(stage);
}

/* The first frame finds nothing: everything in it is new, so that nothing of before is read. */
static void test_a_first_frame_reads_nothing(void **state)
{
    (void)state;
    struct stage *stage = stage_create("history=8 blur=0", 0);
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    const struct aob_past none = no_past(stage);
    trace(stage, &none, traced, taken);
    check_reads(stage, &traced->trace, taken, 0);
    assert_true(kinds_of(stage, &traced->trace).kept == 0);
    aob_trace_finish(&traced->trace);
    taken_finish(taken);
    free(taken);
    free(traced);
    stage_destroy(stage);
}

/* A technique without a history is traced as if it were given none. */
static void test_no_history_no_past(void **state)
{
    (void)state;
    struct stage *stage = stage_create("blur=0", 0);
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *given = AOB_NEW(struct taken), *none = AOB_NEW(struct taken);
    trace(stage, &stage->past, traced, given);
    assert_int_equal(traced->trace.frame.number, 0);
    aob_trace_finish(&traced->trace);
    trace(stage, NULL, traced, none);
    assert_same_words(given, none);
    aob_trace_finish(&traced->trace);
    taken_finish(given);
    taken_finish(none);
    free(given);
    free(none);
    free(traced);
    stage_destroy(stage);
}

/* --- Counts --------------------------------------------------------------------------------------------------------- */

static struct aob_count *count_of(struct stage *stage, const struct aob_past *past)
{
    struct aob_count *count = AOB_NEW(struct aob_count);
    struct aob_error error = {""};
    const struct aob_count_desc desc = {
        .screen = &stage->screen, .technique = stage->technique, .values = stage->values, .past = past};
    if (!aob_count_init(count, &desc, &error) || !aob_count_run(count, &error))
        fail_msg("%s", error.text);
    return count;
}

static void destroy(struct aob_count *count)
{
    aob_count_finish(count);
    free(count);
}

/* What frame 1 computes over what frame 0 does, in a pass. */
static double ratio_of(const struct aob_count *second, const struct aob_count *first, const char *pass)
{
    int index = 0;
    while (strcmp(first->frame.graph.passes[index].name, pass) != 0)
        index++;
    const struct aob_operations *a = &second->passes[index].whole, *b = &first->passes[index].whole;
    printf("%s: frame 1 over frame 0: arithmetic %.3f, reads %.3f\n", pass, a->alu / b->alu,
           a->image / b->image);
    assert_true(a->image >= b->image);
    return a->alu / b->alu;
}

static void test_a_history_is_work(void **state)
{
    (void)state;
    double temporal[2];
    for (int moves = 0; moves < 2; moves++) {
        struct stage *stage = stage_create("history=8 blur=0", moves ? 0.03 : 0);
        const struct aob_past none = no_past(stage);
        struct aob_count *first = count_of(stage, &none), *second = count_of(stage, &stage->past);
        temporal[moves] = ratio_of(second, first, "temporal");
        assert_true(ratio_of(second, first, "changes") > 1.1);
        assert_true(ratio_of(second, first, "horizon") >= 1);
        if (!moves) { /* its own past is the same view's */
            struct aob_count *own = count_of(stage, NULL);
            assert_memory_equal(own->passes, second->passes, sizeof own->passes);
            destroy(own);
        }
        destroy(first);
        destroy(second);
        stage_destroy(stage);
    }
    assert_true(temporal[0] > 1.1 && temporal[1] > temporal[0]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_still_camera_reads_one_pixel),
                                       cmocka_unit_test(test_a_moving_camera_reads_sixteen),
                                       cmocka_unit_test(test_a_trace_makes_its_own_past),
                                       cmocka_unit_test(test_a_first_frame_reads_nothing),
                                       cmocka_unit_test(test_no_history_no_past),
                                       cmocka_unit_test(test_a_history_is_work)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
