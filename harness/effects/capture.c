#include <math.h>
#include "planner.h"

/* What visibility of full size makes of the view is all there is to compare with. */
static void stand_in(struct aob_effects *e)
{
    const unsigned visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);
    for (size_t i = 0; i < e->seen.count; i++) {
        struct aob_seen_surface *s = &e->seen.surfaces[i];
        double rgb[3];
        aob_drawn_light(&e->seen, &e->drawn[0], visible, i, rgb);
        s->visible = e->drawn[0].surfaces[i].visible;
        for (int c = 0; c < 3; c++) {
            s->truth[c] = (float)rgb[c];
            s->se[c] = 0;
        }
    }
    aob_seen_find_mean(&e->seen);
}

bool aob_effect_planner_capture(struct aob_effect_planner *p, struct aob_error *error)
{
    const unsigned visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY),
                   half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), sizes[2] = {visible, visible | half},
                   timed[3] = {0, visible, visible | half};
    struct aob_effect_answer *a = &p->effects->answer;
    const struct aob_effect_turn turn = {.sets = sizes, .count = 2};
    a->no_truth = true;
    a->no_sequence = "a capture is one frame";
    a->open = visible | half;
    if (!aob_effect_planner_draw(p, &turn, error))
        return false;
    stand_in(p->effects);
    aob_effect_bounds_find(&p->effects->seen, &a->bounds);
    a->bounds.most[AOB_EFFECT_MULTI_BOUNCE] = a->bounds.most[AOB_EFFECT_SPECULAR] =
        INFINITY; /* by no material */
    return aob_effect_planner_time(p, 0, timed, 3, error) && aob_effect_planner_judge(p, error);
}
