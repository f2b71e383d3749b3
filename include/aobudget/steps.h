/* aobudget/steps.h: steps that several techniques share, as inline helpers over technique.h. The text of step NAME is
 * steps/NAME.glsl: the build takes it where the module says so (aobudget_add_module(... STEPS blur upsample)). A step
 * that fails has kept its reason in the graph: build() may go on and fails at its end. */
#ifndef AOBUDGET_STEPS_H
#define AOBUDGET_STEPS_H
#include "technique.h"

/* Rows of a parameter table for the steps below: `field` is an int32_t of the values struct. */
#define AOB_PARAM_BLUR(T, field, taps)                                                                       \
    AOB_PARAM(T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 0, .max = 33, .rule = AOB_ODD, \
              .initial = taps,                                                                               \
              .doc = "Taps of each axis of the edge-aware blur, odd; more smooths more; 0 is off.")
#define AOB_PARAM_BLUR_PASSES(T, field, passes)                                                              \
    AOB_PARAM(T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_HOST, .min = 1, .max = 4, .initial = passes,    \
              .doc = "How often the blur is applied; more smooths more.")
#define AOB_PARAM_TILE_BLUR(T, field)                                                                        \
    AOB_PARAM(                                                                                               \
        T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_HOST, .min = 0, .max = 5, .initial = 5,               \
        .doc =                                                                                               \
            "Taps of each axis of the depth-aware mean over a 4x4 tile: 5, the outer ones half, or 0, off.")
#define AOB_PARAM_TILE_TOLERANCE(T, field)                                                                   \
    AOB_PARAM(T, field, .scale = AOB_LOG2, .min = 1e-6, .max = 1, .initial = 0.01,                           \
              .doc =                                                                                         \
                  "How far from the centre's tangent plane, as a share of its depth, the tile blur mixes.")
#define AOB_PARAM_DIVISOR(T, field)                                                                          \
    AOB_PARAM(                                                                                               \
        T, field, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_HOST, .min = 1, .max = 4,          \
        .rule = AOB_POWER_OF_TWO, .initial = 1,                                                              \
        .doc =                                                                                               \
            "Divides the size of the AO, upsampled at the end: 1 full, 2 half, 4 quarter; more is cheaper.")
#define AOB_PARAM_DEPTH_DIVISOR(T, field)                                                                    \
    AOB_PARAM(                                                                                               \
        T, field, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_HOST, .min = 1, .max = 4,          \
        .rule = AOB_POWER_OF_TWO, .initial = 1,                                                              \
        .doc = "Divides the size of the depth that is sampled: 1 full, 2 half, 4 quarter; more is cheaper.")
#define AOB_PARAM_HISTORY(T, field)                                                                          \
    AOB_PARAM(T, field, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT, .min = 0,          \
              .max = 4096, .initial = 0,                                                                     \
              .doc = "Frames that the mean over time counts at most, then old ones fade; more is smoother; " \
                     "0 is off.")
#define AOB_PARAM_CROSS5(T, field)                                                                           \
    AOB_PARAM(T, field, .stage = AOB_HOST, .choices = (const char *const[]){"off", "on", NULL},              \
              .doc = "A composite's cross of five pixels, weighed by surface: on smooths by a pixel.")

/* What aob_step_changes has found out for aob_step_temporal. Ids are 0 where no more than one frame counts. */
struct aob_changes {
    aob_tex surface; /* what the mean over time keeps of each pixel's surface */
    aob_tex changed; /* r, of divisor 8: 1 where nothing of the frames before counts, else 0 */
};

/* What a step is laid over. A step goes over visibility unless `output` says another; the passes and textures of the
 * bent normal have names that begin with bent_, so that both can go through one step in one graph. A bent normal's texture
 * may hold the visibility in w (technique.h, AOB_OUT_BENT_NORMAL). */
struct aob_step {
    aob_tex tex;
    int32_t divisor;            /* of tex; of `downsample`, to be reached */
    int32_t taps;               /* of the filters; 0: the step is left out */
    int32_t passes;             /* blur, gaussian: how often; 0 means once */
    int32_t frames;             /* temporal: how many count; 0 and 1: the step is left out */
    struct aob_changes changes; /* temporal */
    enum aob_output output; /* AOB_OUT_VISIBILITY or AOB_OUT_BENT_NORMAL: what tex is, and what comes out */
};
static inline const char *aob_step_name(const struct aob_step *step, const char *bent_name)
{
    return step->output == AOB_OUT_BENT_NORMAL ? bent_name : bent_name + 5;
}
static inline enum aob_format aob_step_format(const struct aob_step *step)
{
    return step->output == AOB_OUT_BENT_NORMAL ? AOB_RGBA16F : AOB_R16F;
}

/* Visibility and bent normal in one texture, so that one pass computes them and one filter smooths them. aob_open_kind() says
 * what such a texture carries where the bent normal is wanted for itself; a technique that makes another output of it asks
 * for more. The kind is the texture's format, the `output` of its steps, and what aob_open_outputs() gives in the end. */
static inline enum aob_output aob_open_kind(const struct aob_graph *graph)
{
    return aob_wants(graph, AOB_OUT_BENT_NORMAL) ? AOB_OUT_BENT_NORMAL : AOB_OUT_VISIBILITY;
}
static inline enum aob_format aob_open_format(enum aob_output kind)
{
    return aob_step_format(&(struct aob_step){.output = kind});
}
static inline bool aob_open_outputs(struct aob_graph *graph, enum aob_output kind, aob_tex open)
{
    return (kind != AOB_OUT_BENT_NORMAL || aob_output(graph, AOB_OUT_BENT_NORMAL, open)) &&
           aob_output(graph, AOB_OUT_VISIBILITY, open);
}

/* aob_step_downsample(graph, .divisor = 2): the depth divided, for aob_pass.depth. Id 0, which is the G-buffer's own
 * depth, where the divisor is 1. */
#define aob_step_downsample(graph, ...) aob_lay_downsample(graph, &(struct aob_step){__VA_ARGS__})
static inline aob_tex aob_lay_downsample(struct aob_graph *graph, const struct aob_step *step)
{
    if (step->divisor <= 1)
        return (aob_tex){0};
    aob_tex low =
        aob_texture(graph, .name = "low_depth", .format = AOB_R32F, .divisor = (uint32_t)step->divisor);
    aob_pass(graph, .name = "downsample", .shader = "downsample", .reads = AOB_DEPTH,
             .out = {{.name = "depth", .tex = low}});
    return low;
}

/* aob_step_blur(graph, .tex = raw, .taps = 5, .divisor = 2): a separable filter, two passes each time; constant
 * parameter `blur`, the taps. aob_step_gaussian also needs the uniform parameters blur_depth and blur_normal. Both
 * return the last texture: `tex` itself where there are no taps. */
#define aob_step_blur(graph, ...)     aob_lay_blur(graph, "blur", &(struct aob_step){__VA_ARGS__})
#define aob_step_gaussian(graph, ...) aob_lay_blur(graph, "gaussian", &(struct aob_step){__VA_ARGS__})
static inline aob_tex aob_lay_blur(struct aob_graph *graph, const char *text, const struct aob_step *step)
{
    aob_tex raw = step->tex;
    int32_t passes = step->passes ? step->passes : 1;
    for (int32_t i = 0; step->taps && i < 2 * passes; i++) {
        char bent_name[] = "bent_blur_x1";
        bent_name[10] = i % 2 ? 'y' : 'x';
        bent_name[11] = (char)('1' + i / 2);
        const char *name = aob_step_name(step, bent_name);
        aob_tex next = aob_texture(graph, .name = name, .format = aob_step_format(step),
                                   .divisor = (uint32_t)step->divisor);
        aob_pass(graph, .name = name, .shader = text, .defines = {{"AXIS", i % 2}},
                 .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "raw", .tex = raw}},
                 .out = {{.name = "blurred", .tex = next}});
        raw = next;
    }
    return raw;
}

/* aob_step_tile_blur(graph, .tex = raw, .taps = 5, .divisor = 2): one pass of the mean over a tile of 4x4 pixels;
 * uniform float parameter blur_tolerance. `tex` itself where there are no taps. */
#define aob_step_tile_blur(graph, ...) aob_lay_tile_blur(graph, &(struct aob_step){__VA_ARGS__})
static inline aob_tex aob_lay_tile_blur(struct aob_graph *graph, const struct aob_step *step)
{
    if (step->taps == 0)
        return step->tex;
    const char *name = aob_step_name(step, "bent_tile_blur");
    aob_tex next =
        aob_texture(graph, .name = name, .format = aob_step_format(step), .divisor = (uint32_t)step->divisor);
    aob_pass(graph, .name = name, .shader = "tile_blur", .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "raw", .tex = step->tex}}, .out = {{.name = "blurred", .tex = next}});
    return next;
}

/* aob_step_upsample(graph, .tex = low, .divisor = 2): edge-aware upsampling to full size. `tex` itself where the
 * divisor is 1. */
#define aob_step_upsample(graph, ...) aob_lay_upsample(graph, &(struct aob_step){__VA_ARGS__})
static inline aob_tex aob_lay_upsample(struct aob_graph *graph, const struct aob_step *step)
{
    if (step->divisor <= 1)
        return step->tex;
    aob_tex full =
        aob_texture(graph, .name = aob_step_name(step, "bent_full"), .format = aob_step_format(step));
    aob_pass(graph, .name = aob_step_name(step, "bent_upsample"), .shader = "upsample",
             .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "low", .tex = step->tex}},
             .out = {{.name = "full", .tex = full}});
    return full;
}

/* struct aob_changes changes = aob_step_changes(graph, .frames = 16, .taps = 5, .divisor = 2): where something has changed since the frame
 * before, within the uniform parameter `radius`, beyond which nothing darkens, and as much farther as a filter of so many taps (and
 * passes) of a divided image and its upsampling carry that. It is laid before a pass whose noise is another in each frame (by
 * aob_frame), for that to read `changed` and to keep one noise there: where no mean is taken, noise that changes flickers. Texts
 * changes, change_groups, changed and change_spread.
 *
 * aob_step_temporal(graph, .tex = full, .frames = 16, .changes = changes): the mean over time of an image of full size, in 32 bits.
 * Text temporal; constant parameter `history`, the frames. `tex` itself where no more than one frame counts. */
#define aob_step_changes(graph, ...)  aob_lay_history(graph, &(struct aob_step){__VA_ARGS__})
#define aob_step_temporal(graph, ...) aob_lay_temporal(graph, &(struct aob_step){__VA_ARGS__})
static inline aob_tex aob_lay_changes(struct aob_graph *graph, aob_tex surface)
{
    enum { LOW, HIGH, CHANGE_LOW, CHANGE_HIGH, GROUP_LOW, GROUP_HIGH, COUNT };
    static const char *const names[COUNT] = {"tile_low",    "tile_high", "change_low",
                                             "change_high", "group_low", "group_high"};
    aob_tex box[COUNT], changed = aob_texture(graph, .name = "changed", .format = AOB_R8, .divisor = 8);
    for (int i = 0; i < COUNT; i++)
        box[i] =
            aob_texture(graph, .name = names[i], .format = AOB_RGBA32F, .divisor = i < GROUP_LOW ? 8 : 64);
    aob_pass(graph, .name = "changes", .shader = "changes", .reads = AOB_DEPTH | AOB_VELOCITY,
             .border = AOB_CLAMP, .in = {{.name = "surface_before", .tex = aob_previous(graph, surface)}},
             .out = {{.name = "tile_low", .tex = box[LOW]},
                     {.name = "tile_high", .tex = box[HIGH]},
                     {.name = "change_low", .tex = box[CHANGE_LOW]},
                     {.name = "change_high", .tex = box[CHANGE_HIGH]}});
    aob_pass(
        graph, .name = "change_groups", .shader = "change_groups",
        .in = {{.name = "tile_low", .tex = box[CHANGE_LOW]}, {.name = "tile_high", .tex = box[CHANGE_HIGH]}},
        .out = {{.name = "change_low", .tex = box[GROUP_LOW]},
                {.name = "change_high", .tex = box[GROUP_HIGH]}});
    aob_pass(graph, .name = "changed", .shader = "changed",
             .in = {{.name = "tile_low", .tex = box[LOW]},
                    {.name = "tile_high", .tex = box[HIGH]},
                    {.name = "change_low", .tex = box[CHANGE_LOW]},
                    {.name = "change_high", .tex = box[CHANGE_HIGH]},
                    {.name = "group_low", .tex = box[GROUP_LOW]},
                    {.name = "group_high", .tex = box[GROUP_HIGH]}},
             .out = {{.name = "changed", .tex = changed}});
    return changed;
}
static inline aob_tex aob_lay_change_spread(struct aob_graph *graph, aob_tex near, int32_t tiles)
{
    if (tiles == 0)
        return near;
    aob_tex changed = aob_texture(graph, .name = "change_spread", .format = AOB_R8, .divisor = 8);
    aob_pass(graph, .name = "change_spread", .shader = "change_spread", .defines = {{"SPREAD", tiles}},
             .in = {{.name = "near", .tex = near}}, .out = {{.name = "changed", .tex = changed}});
    return changed;
}
static inline struct aob_changes aob_lay_history(struct aob_graph *graph, const struct aob_step *step)
{
    struct aob_changes changes = {{0}, {0}};
    if (step->frames <= 1)
        return changes;
    int32_t divisor = step->divisor > 1 ? step->divisor : 1, passes = step->passes ? step->passes : 1;
    int32_t reach = divisor * (passes * (step->taps / 2)) + (divisor > 1 ? divisor : 0); /* pixels */
    changes.surface = aob_texture(graph, .name = "open_surface", .format = AOB_RGBA32F);
    changes.changed = aob_lay_change_spread(graph, aob_lay_changes(graph, changes.surface), (reach + 4) / 8);
    return changes;
}
static inline aob_tex aob_lay_temporal(struct aob_graph *graph, const struct aob_step *step)
{
    if (step->frames <= 1)
        return step->tex;
    aob_tex open = aob_texture(graph, .name = "open_mean",
                               .format = step->output == AOB_OUT_BENT_NORMAL ? AOB_RGBA32F : AOB_R32F);
    aob_pass(graph, .name = "temporal", .shader = "temporal", .reads = AOB_DEPTH | AOB_NORMAL | AOB_VELOCITY,
             .in = {{.name = "now", .tex = step->tex},
                    {.name = "open_before", .tex = aob_previous(graph, open)},
                    {.name = "surface_before", .tex = aob_previous(graph, step->changes.surface)},
                    {.name = "changed", .tex = step->changes.changed}},
             .out = {{.name = "open", .tex = open}, {.name = "surface", .tex = step->changes.surface}});
    return open;
}

/* aob_step_bounces(graph, .tex = open): visibility after bounces between surfaces of the pixel's own albedo, for each
 * channel, by the polynomial of Jimenez et al. 2016; `open` is a visibility of full size, or a bent normal with one in w.
 * One pass and the output itself; nothing where it is not wanted. */
#define aob_step_bounces(graph, ...) aob_lay_bounces(graph, &(struct aob_step){__VA_ARGS__})
static inline bool aob_lay_bounces(struct aob_graph *graph, const struct aob_step *step)
{
    if (!aob_wants(graph, AOB_OUT_VISIBILITY_RGB))
        return true;
    aob_tex bounced = aob_texture(graph, .name = "bounces", .format = AOB_RGBA16F);
    return aob_pass(graph, .name = "bounces", .shader = "bounces", .reads = AOB_DEPTH | AOB_MATERIAL,
                    .in = {{.name = "open", .tex = step->tex}},
                    .out = {{.name = "bounced", .tex = bounced}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY_RGB, bounced);
}

/* aob_step_cross5(graph, .tex = raw, .taps = 5): the composite's cross of five pixels, over an image of full size.
 * `tex` itself where there are no taps. */
#define aob_step_cross5(graph, ...) aob_lay_cross5(graph, &(struct aob_step){__VA_ARGS__})
static inline aob_tex aob_lay_cross5(struct aob_graph *graph, const struct aob_step *step)
{
    if (step->taps == 0)
        return step->tex;
    const char *name = aob_step_name(step, "bent_composite");
    aob_tex crossed = aob_texture(graph, .name = name, .format = aob_step_format(step));
    aob_pass(graph, .name = name, .shader = "cross5", .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "raw", .tex = step->tex}}, .out = {{.name = "crossed", .tex = crossed}});
    return crossed;
}
#endif
