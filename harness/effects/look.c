#include <math.h>
#include "base/clock.h"
#include "base/json.h"
#include "mean_gain.h"
#include "planner.h"

static const unsigned half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), mean = AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL),
                      visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);

/* The mean of so many frames tells the noise of one. */
enum { FEW = 2 };

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
    return set ? flicker_of(e->flicker_records, aob_effect_image_of(set)) : flicker_of(e->truth_records, 0);
}

/* Two frames tell the noise; where that may matter, the mean is drawn of as many as it counts. */
static bool look_at_mean(struct aob_effect_planner *p, struct aob_error *error)
{
    struct aob_effect_answer *a = &p->effects->answer;
    const unsigned sets[2] = {a->open & ~half, a->open};
    const struct aob_effect_turn turn = {.turn = 1, AOB_EFFECT_HISTORY, sets, 2};
    a->bounds.most[AOB_EFFECT_TEMPORAL] = aob_effect_mean_gain(&p->effects->seen, p->effects->drawn, a->open);
    if (a->bounds.most[AOB_EFFECT_TEMPORAL] <=
        aob_effect_bounds_left(&a->bounds, aob_effect_ask_tolerance(&a->ask))) {
        a->open &= ~mean;
        return true;
    }
    return aob_effect_planner_draw(p, &turn, error);
}

bool aob_effect_planner_look(struct aob_effect_planner *p, struct aob_error *error)
{
    const struct aob_effect_answer *a = &p->effects->answer;
    const unsigned open = a->open, plain = open & ~(half | mean),
                   sets[AOB_EFFECT_IMAGES] = {plain, plain | half, plain | mean, plain | half | mean};
    const bool means = open & mean;
    const struct aob_effect_turn turn = {
        .still_frames = means ? FEW : 0, .sets = sets, .count = means ? 4 : 2};
    if (!open)
        return true;
    if (!aob_effect_planner_draw(p, &turn, error) || (a->frames && !measure_flicker(p, error)))
        return false;
    return !means || a->frames || look_at_mean(p, error);
}
