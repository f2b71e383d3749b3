#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "fuzz_frame.h"
#include "technique/param.h"

enum { TRIES = 16 };

static size_t choice_count(const struct aob_param *param)
{
    size_t count = 0;
    while (param->choices[count])
        count++;
    return count;
}

/* Between the bounds, as the table says that values are best spaced. A range that begins at 0 has no logarithm there. */
static double spread(struct aob_chance *chance, const struct aob_param *param, double low, double high)
{
    double least = low > 0 ? low : high * 1e-9;
    return param->scale == AOB_LOG2 && high > least ? aob_chance_log(chance, least, high)
                                                    : aob_chance_between(chance, low, high);
}

static double whole(const struct aob_param *param, double value)
{
    double rounded = param->type == AOB_INT ? floor(value + 0.5) : value;
    return fmin(fmax(rounded, param->min), param->max);
}

/* A whole number of each frame's own: a bound now and then. */
static double free_number(struct aob_chance *chance, const struct aob_param *param, double scale)
{
    switch (aob_chance_below(chance, 10)) {
    case 0:
        return param->min;
    case 1:
        return param->max;
    case 2:
        return param->initial;
    default:
        break;
    }
    /* A length of 1e-6 or 1e6 reaches no neighbour, or all of them, so half of the lengths are of the scene's size. */
    if (param->unit == AOB_UNIT_LENGTH && aob_chance_once_in(chance, 2))
        return whole(param, scale * aob_chance_log(chance, 1e-3, 10));
    return whole(param, spread(chance, param, param->min, param->max));
}

/* Constants bound loops: what is far over the default would draw for seconds and say nothing new. */
static double fixed_number(struct aob_chance *chance, const struct aob_param *param)
{
    bool counts = param->type == AOB_INT && param->unit != AOB_UNIT_LENGTH;
    double most = counts ? fmin(param->max, 2 * fabs(param->initial) + 8) : param->max;
    switch (aob_chance_below(chance, 6)) {
    case 0:
        return param->min;
    case 1:
        return most;
    case 2:
    case 3:
        return param->initial;
    default:
        return whole(param, spread(chance, param, param->min, most));
    }
}

static double draw(struct aob_chance *chance, const struct aob_param *param, double scale)
{
    if (param->choices)
        return (double)aob_chance_below(chance, choice_count(param));
    for (int i = 0; i < TRIES; i++) {
        double value =
            param->stage == AOB_UNIFORM ? free_number(chance, param, scale) : fixed_number(chance, param);
        if (aob_param_obeys(param, value))
            return value;
    }
    return param->initial;
}

static bool is_refused(const struct aob_fuzz_frame *frame)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    const char *why = NULL;
    aob_fuzz_frame_pack(frame, values, &options);
    return frame->technique->check && !frame->technique->check(values, &why);
}

static void draw_some(struct aob_fuzz_frame *frame, struct aob_chance *chance, double scale, bool uniforms)
{
    const struct aob_technique *technique = frame->technique;
    double before[AOB_MAX_PARAM];
    memcpy(before, frame->params, sizeof before);
    for (int t = 0; t < TRIES; t++) {
        for (uint32_t i = 0; i < technique->param_count; i++)
            if ((technique->params[i].stage == AOB_UNIFORM) == uniforms)
                frame->params[i] = draw(chance, &technique->params[i], scale);
        if (!is_refused(frame))
            return;
    }
    memcpy(frame->params, before, sizeof before);
}

static const struct aob_param *option_of(const char *name)
{
    return aob_param_find(aob_option_params, AOB_OPTION_COUNT, name);
}

static void set_option(struct aob_fuzz_frame *frame, const char *name, size_t value)
{
    frame->options[option_of(name) - aob_option_params] = (double)value;
}

static size_t draw_choice(struct aob_chance *chance, const char *name)
{
    return aob_chance_below(chance, choice_count(option_of(name)));
}

/* Half of the frames have the default encodings, where no loss of the encoding hides what a technique does. */
static void draw_options(struct aob_fuzz_frame *frame, struct aob_chance *chance)
{
    size_t depth = aob_chance_once_in(chance, 2) ? 0 : draw_choice(chance, "depth_encoding");
    bool infinite = depth == AOB_DEPTH_DEVICE24_INFINITE || depth == AOB_DEPTH_DEVICE32_INFINITE;
    if (infinite && !frame->gbuffer.projection.perspective)
        depth = AOB_DEPTH_DEVICE32;
    set_option(frame, "depth_encoding", depth);
    set_option(frame, "normal_encoding",
               aob_chance_once_in(chance, 2) ? 0 : draw_choice(chance, "normal_encoding"));
    set_option(frame, "normals", draw_choice(chance, "normals"));
    set_option(frame, "fetch", aob_chance_once_in(chance, 4) ? AOB_FETCH_STORAGE : AOB_FETCH_SAMPLED);
    for (size_t i = AOB_OPTION_FIRST_SWITCH; i < AOB_OPTION_COUNT; i++)
        frame->options[i] = aob_chance_once_in(chance, 2);
}

void aob_fuzz_values_fixed(struct aob_fuzz_frame *frame, struct aob_chance *chance)
{
    const struct aob_technique *technique = frame->technique;
    aob_param_defaults(technique->params, technique->param_count, 1, frame->params);
    aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, 1, frame->options);
    draw_some(frame, chance, 1, false);
    draw_options(frame, chance);
}

void aob_fuzz_values_free(struct aob_fuzz_frame *frame, struct aob_chance *chance, double scale)
{
    draw_some(frame, chance, scale, true);
}
