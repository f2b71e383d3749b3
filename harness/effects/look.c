#include <math.h>
#include "base/clock.h"
#include "base/json.h"
#include "planner.h"

static const unsigned half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), mean = AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL),
                      visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);

/* Of visibility alone, which the flicker is of, whatever else a set has. */
static bool measure_flicker(struct aob_effect_planner *p, struct aob_error *error)
{
    struct aob_effects *e = p->effects;
    const unsigned sets[AOB_EFFECT_IMAGES] = {visible, visible | half, visible | mean, visible | half | mean};
    struct aob_effect_frames_desc desc = aob_effect_planner_frames(p, sets, AOB_EFFECT_IMAGES);
    int64_t start = aob_clock_wall_ns();
    desc.unlit = true;
    desc.spp = e->spp;
    aob_effect_planner_say(p, "measuring flicker");
    e->flicker_records = aob_effect_frames_measure(&desc, &e->flickers, error);
    e->images_s += (double)(aob_clock_wall_ns() - start) * 1e-9;
    return e->flicker_records;
}

static double flicker_of(const json_t *records, size_t at)
{
    const json_t *sequence = json_object_get(json_array_get(records, at), "sequence");
    return aob_json_to_number(json_object_get(sequence, "flicker"));
}

double aob_effect_planner_flicker(const struct aob_effect_planner *p, unsigned set)
{
    const struct aob_effects *e = p->effects;
    if (!e->answer.frames)
        return NAN;
    return set ? flicker_of(e->flicker_records, aob_effect_image_of(set)) : flicker_of(e->truth_records, 0);
}

/* How much nearer to the truth the mean is, of the set that it brings the nearest. */
static double find_gain(const struct aob_effects *e)
{
    unsigned sets[AOB_EFFECT_SETS];
    size_t count = aob_effect_sets(e->answer.open & ~mean, sets);
    double most = 0;
    for (size_t i = 0; i < count; i++) {
        const unsigned one = sets[i], many = one | mean;
        if (one)
            most = fmax(most, aob_drawn_error(&e->seen, &e->drawn[aob_effect_image_of(one)], one).rmse -
                                  aob_drawn_error(&e->seen, &e->drawn[aob_effect_image_of(many)], many).rmse);
    }
    return most;
}

/* Where nothing moves a mean can only bring the image nearer. If it brings no set nearer by what the rules have left of their share of the
 * tolerance, frames have enough samples, and it is not taken to save a set that misses the tolerance by a hair. */
static void judge_mean(struct aob_effect_answer *answer, double gain)
{
    answer->bounds.most[AOB_EFFECT_TEMPORAL] = gain;
    if (gain <= aob_effect_bounds_left(&answer->bounds, aob_effect_ask_tolerance(&answer->ask)))
        answer->open &= ~mean;
}

bool aob_effect_planner_look(struct aob_effect_planner *p, struct aob_error *error)
{
    struct aob_effect_answer *a = &p->effects->answer;
    const unsigned open = a->open & ~mean, sizes[2] = {open & ~half, open},
                   means[2] = {sizes[0] | mean, open | mean};
    const struct aob_effect_turn one = {.sets = sizes, .count = 2}, many = {1, AOB_EFFECT_HISTORY, means, 2};
    if (!open)
        return true;
    if (!aob_effect_planner_draw(p, &one, error))
        return false;
    if (!(a->open & mean))
        return true;
    if (!aob_effect_planner_draw(p, &many, error))
        return false;
    if (a->frames)
        return measure_flicker(p, error);
    judge_mean(a, find_gain(p->effects));
    return true;
}
