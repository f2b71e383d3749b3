#include <math.h>
#include "capture_words.h"
#include "planner.h"

/* Which effects depend on a channel that the file lacks. */
static unsigned lacks_of(unsigned materials)
{
    unsigned lacks = 0;
    if (!(materials & AOB_MATERIAL_BIT(AOB_MATERIAL_ALBEDO)))
        lacks |= AOB_EFFECT_BIT(AOB_EFFECT_MULTI_BOUNCE);
    if (!(materials & AOB_MATERIAL_BIT(AOB_MATERIAL_ROUGHNESS)))
        lacks |= AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR);
    return lacks;
}

/* The capture's own image of full size with this set is all there is to compare with. */
static void stand_in(struct aob_effects *e, unsigned set)
{
    for (size_t i = 0; i < e->seen.count; i++) {
        struct aob_seen_surface *s = &e->seen.surfaces[i];
        double rgb[3];
        aob_drawn_light(&e->seen, &e->drawn[0], set, i, rgb);
        s->visible = e->drawn[0].surfaces[i].visible;
        for (int c = 0; c < 3; c++) {
            s->truth[c] = (float)rgb[c];
            s->se[c] = 0;
        }
    }
    aob_seen_find_mean(&e->seen);
}

/* All of a set of effects that one frame of full size may hold. */
static unsigned whole_of(unsigned effects)
{
    unsigned whole = effects & ~AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE);
    return aob_effect_has(whole, AOB_EFFECT_DIRECTIONAL) ? whole & ~AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL)
                                                         : whole;
}

/* What the data allow: a capture is one frame. */
static unsigned known_of(const struct aob_effect_answer *answer)
{
    return AOB_EFFECT_ALL & ~(answer->lacks | AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL));
}

/* Rules take out what a right effect changes too little of the image with all that the data allow; the rest of it stays the reference. */
static void apply_rules(struct aob_effects *e)
{
    struct aob_effect_answer *a = &e->answer;
    const unsigned known = known_of(a);
    stand_in(e, whole_of(known));
    aob_effect_bounds_find(&e->seen, &a->bounds);
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        if (aob_effect_has(a->lacks, (enum aob_effect_id)id))
            a->bounds.most[id] = INFINITY;
    a->open = known & aob_effect_bounds_open(&a->bounds, aob_effect_ask_tolerance(&a->ask));
    a->reference = whole_of(a->open);
    stand_in(e, a->reference);
}

bool aob_effect_planner_capture(struct aob_effect_planner *p, unsigned materials, struct aob_error *error)
{
    struct aob_effect_answer *a = &p->effects->answer;
    a->no_truth = true;
    a->no_sequence = "a capture is one frame";
    a->materials = materials;
    a->lacks = lacks_of(materials);
    a->unlit = a->lacks;
    const unsigned known = known_of(a), sizes[2] = {known & ~AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), known};
    const struct aob_effect_turn turn = {.sets = sizes, .count = 2};
    if (!aob_effect_planner_draw(p, &turn, error))
        return false;
    apply_rules(p->effects);
    return p->effects->seen.mean_light > 0 ||
           aob_fail(error, "the view is black: its lit image has no error to speak of");
}
