#include "cost.h"
#include <math.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"

static const char composite[] = "lit_composite";

/* What of a set the composite reads: that is the same at both sizes, and of one frame or a mean of many. */
static unsigned read_of(unsigned set)
{
    return set & ~(AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE) | AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL));
}

static void add_new(unsigned set, unsigned sets[AOB_EFFECT_FRAMES], size_t *count)
{
    for (size_t i = 0; i < *count; i++)
        if (sets[i] == set)
            return;
    sets[(*count)++] = set;
}

size_t aob_effect_frames_choose(unsigned open, unsigned sets[AOB_EFFECT_FRAMES])
{
    const unsigned visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY),
                   half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE),
                   bounces = open & AOB_EFFECT_BIT(AOB_EFFECT_MULTI_BOUNCE);
    size_t count = 0;
    add_new(0, sets, &count);
    if (!open)
        return count;
    add_new(visible | bounces | half, sets, &count);
    add_new(open, sets, &count);
    return count;
}

static double part_ms(const json_t *part, const json_t *time)
{
    return aob_json_to_number(json_object_get(part, "ratio_to_ref")) *
           aob_json_to_number(json_object_get(time, "ref_ms"));
}

static const json_t *modelled_of(const json_t *record, const char *profile)
{
    return json_object_get(json_object_get(json_object_get(record, "cache"), profile), "modelled");
}

double aob_effect_frame_ms(const json_t *record, const char *profile)
{
    const json_t *time = json_object_get(record, "time");
    if (profile)
        return aob_json_to_number(
            json_object_get(json_object_get(modelled_of(record, profile), "frame"), "ms"));
    return part_ms(time, time);
}

static double pass_ms(const json_t *record, const char *profile, const json_t *pass)
{
    return profile ? aob_json_to_number(json_object_get(pass, "ms"))
                   : part_ms(pass, json_object_get(record, "time"));
}

static const json_t *passes_of(const json_t *record, const char *profile)
{
    return json_object_get(profile ? modelled_of(record, profile) : json_object_get(record, "time"),
                           "passes");
}

/* NAN where the frame has no pass of the name. */
static double find_pass(const struct aob_effect_costs *costs, const struct aob_effect_frame *frame,
                        const char *name)
{
    const json_t *pass;
    size_t at;
    json_array_foreach(passes_of(frame->record, costs->profile), at, pass)
    {
        const char *own = json_string_value(json_object_get(pass, "name"));
        if (own && strcmp(own, name) == 0)
            return pass_ms(frame->record, costs->profile, pass);
    }
    return NAN;
}

/* What the frame's passes of an effect take; NAN where it has none of them. */
static double effect_ms(const struct aob_effect_costs *costs, const struct aob_effect_frame *frame,
                        const struct aob_effect_row *row)
{
    double sum = NAN;
    for (const char *const *pass = row->passes; *pass; pass++) {
        double ms = find_pass(costs, frame, *pass);
        if (isfinite(ms))
            sum = isfinite(sum) ? sum + ms : ms;
    }
    return sum;
}

/* The passes that make visibility, with what the rest of the frame takes besides its passes. */
static double base_ms(const struct aob_effect_costs *costs, const struct aob_effect_frame *frame)
{
    double rest = aob_effect_frame_ms(frame->record, costs->profile),
           own = costs->unlit ? 0 : find_pass(costs, frame, composite);
    for (int id = 0; id < AOB_EFFECT_COUNT; id++) {
        double passes = effect_ms(costs, frame, &aob_effect_rows[id]);
        rest -= isfinite(passes) ? passes : 0;
    }
    return rest - own;
}

/* NAN where no frame has just these passes. */
static double find_base_ms(const struct aob_effect_costs *costs, bool bends, bool half)
{
    for (size_t i = 0; i < costs->count; i++) {
        const struct aob_effect_frame *frame = &costs->frames[i];
        if (frame->set && aob_effect_set_bends(frame->set) == bends &&
            aob_effect_has(frame->set, AOB_EFFECT_HALF_SIZE) == half)
            return base_ms(costs, frame);
    }
    return NAN;
}

static double half_upsample_ms(const struct aob_effect_costs *costs, bool bends)
{
    for (size_t i = 0; i < costs->count; i++) {
        const struct aob_effect_frame *frame = &costs->frames[i];
        double ms = find_pass(costs, frame, bends ? "bent_upsample" : "upsample");
        if (frame->set && isfinite(ms))
            return ms;
    }
    return NAN;
}

/* Full size where a frame of that was timed: bent normals are dearer than visibility by the same factor at both sizes. Else by the pixels: four
 * times what half size takes, which is sampled up no more. */
static double visibility_ms(const struct aob_effect_costs *costs, unsigned set)
{
    bool half = aob_effect_has(set, AOB_EFFECT_HALF_SIZE), bends = aob_effect_set_bends(set);
    double own = find_base_ms(costs, bends, half), other = find_base_ms(costs, !bends, half);
    if (isfinite(own))
        return own;
    if (isfinite(other))
        return other * find_base_ms(costs, bends, !half) / find_base_ms(costs, !bends, !half);
    return 4 * (find_base_ms(costs, bends, !half) - half_upsample_ms(costs, bends));
}

/* The mean over the frames that have passes of the effect. */
static double mean_effect_ms(const struct aob_effect_costs *costs, const struct aob_effect_row *row)
{
    double sum = 0, count = 0;
    for (size_t i = 0; i < costs->count; i++) {
        double ms = effect_ms(costs, &costs->frames[i], row);
        sum += isfinite(ms) ? ms : 0;
        count += isfinite(ms);
    }
    return count ? sum / count : NAN;
}

/* The composite's own time with the outputs that it reads: the same at both sizes, and whoever gives visibility. NAN where no frame has
 * just these. */
static double composite_with(const struct aob_effect_costs *costs, unsigned effects)
{
    double sum = 0, count = 0;
    for (size_t i = 0; i < costs->count; i++) {
        unsigned set = read_of(costs->frames[i].set) | AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);
        double ms = find_pass(costs, &costs->frames[i], composite);
        if (set == effects && isfinite(ms)) {
            sum += ms;
            count++;
        }
    }
    return count ? sum / count : NAN;
}

static int count_bits(unsigned bits)
{
    return bits ? (int)(bits & 1) + count_bits(bits >> 1) : 0;
}

/* Where no frame has just these outputs, what lies between the plain one and that of most of them is shared evenly by the effects. */
static double composite_ms(const struct aob_effect_costs *costs, unsigned set)
{
    if (costs->unlit)
        return 0;
    unsigned visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY), wanted = read_of(set), most = 0;
    double exact = composite_with(costs, wanted), plain = composite_with(costs, visible);
    for (size_t i = 0; i < costs->count; i++)
        if (count_bits(read_of(costs->frames[i].set)) > count_bits(most))
            most = read_of(costs->frames[i].set);
    if (isfinite(exact) || most == visible)
        return isfinite(exact) ? exact : plain;
    unsigned known = 0, mosts = most & ~AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL);
    double sum = 0, all = composite_with(costs, most) - plain;
    for (int id = AOB_EFFECT_MULTI_BOUNCE; id <= AOB_EFFECT_SPECULAR; id++) {
        double alone = composite_with(costs, visible | AOB_EFFECT_BIT(id)) - plain;
        if (!isfinite(alone))
            continue;
        known |= AOB_EFFECT_BIT(id);
        all -= aob_effect_has(mosts, (enum aob_effect_id)id) ? alone : 0;
        sum += aob_effect_has(wanted, (enum aob_effect_id)id) ? alone : 0;
    }
    int rest = count_bits(mosts & ~known & ~visible);
    return plain + sum + (rest ? all / rest * count_bits(wanted & ~known & ~visible) : 0);
}

double aob_effect_cost(const struct aob_effect_costs *costs, unsigned set)
{
    for (size_t i = 0; i < costs->count; i++)
        if (costs->frames[i].set == set)
            return aob_effect_frame_ms(costs->frames[i].record, costs->profile);
    double sum = visibility_ms(costs, set) + composite_ms(costs, set);
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        if (aob_effect_has(set, (enum aob_effect_id)id) && *aob_effect_rows[id].passes)
            sum += mean_effect_ms(costs, &aob_effect_rows[id]);
    return sum;
}
