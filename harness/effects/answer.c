#include "answer.h"
#include <math.h>
#include "capture_words.h"

static const double tie = 0.02, tie_error = 0.001;

double aob_effect_ask_tolerance(const struct aob_effect_ask *ask)
{
    if (!isnan(ask->tolerance))
        return ask->tolerance;
    return isfinite(ask->budget_ms) ? tie_error : AOB_EFFECT_TOLERANCE;
}

/* The least that a set may be measured by: of all sets, or with a budget alone of those that fit. */
struct least {
    double rmse, flicker;
};
static struct least find_least(const struct aob_effect_answer *answer)
{
    bool of_fitting = isnan(answer->ask.tolerance) && isfinite(answer->ask.budget_ms);
    struct least least = {INFINITY, INFINITY};
    for (size_t i = 0; i < answer->count; i++) {
        const struct aob_effect_candidate *c = &answer->candidates[i];
        if (!c->fits && of_fitting)
            continue;
        least.rmse = fmin(least.rmse, c->error.rmse);
        least.flicker = fmin(least.flicker, c->flicker);
    }
    return least;
}

static void judge(struct aob_effect_answer *answer)
{
    answer->least = 0;
    for (size_t i = 0; i < answer->count; i++) {
        struct aob_effect_candidate *c = &answer->candidates[i];
        c->fits = c->ms <= answer->ask.budget_ms;
        if (c->error.rmse < answer->candidates[answer->least].error.rmse)
            answer->least = (int)i;
    }
    const struct least least = find_least(answer);
    answer->most = aob_effect_ask_tolerance(&answer->ask);
    for (size_t i = 0; i < answer->count; i++) {
        struct aob_effect_candidate *c = &answer->candidates[i];
        c->loss = fmax(c->error.rmse - least.rmse, c->flicker - least.flicker); /* NAN counts for nothing */
        c->within = c->loss <= answer->most;
    }
}

/* Where nothing within the tolerance fits the budget, what cannot be told from the least loss that fits is as good. */
static void fall_back(struct aob_effect_answer *answer)
{
    double least = INFINITY;
    for (size_t i = 0; i < answer->count; i++) {
        const struct aob_effect_candidate *c = &answer->candidates[i];
        if (c->fits && c->within)
            return;
        if (c->fits)
            least = fmin(least, c->loss);
    }
    answer->most = least + tie_error;
}

static bool may_be_taken(const struct aob_effect_answer *answer, const struct aob_effect_candidate *c)
{
    return c->fits && c->loss <= answer->most;
}

/* Costs are measured to about the tie: of sets that it does not tell apart the nearer one is taken. */
static int nearest_of_ties(const struct aob_effect_answer *answer, int cheapest)
{
    const struct aob_effect_candidate *all = answer->candidates;
    int best = cheapest;
    for (int i = 0; i < (int)answer->count; i++)
        if (may_be_taken(answer, &all[i]) && all[i].ms <= (1 + tie) * all[cheapest].ms &&
            all[i].loss < all[best].loss)
            best = i;
    return best;
}

void aob_effect_answer_choose(struct aob_effect_answer *answer)
{
    const struct aob_effect_candidate *all = answer->candidates;
    int cheapest = -1;
    judge(answer);
    fall_back(answer);
    for (int i = 0; i < (int)answer->count; i++)
        if (may_be_taken(answer, &all[i]) && (cheapest < 0 || all[i].ms < all[cheapest].ms))
            cheapest = i;
    answer->chosen = cheapest < 0 ? -1 : nearest_of_ties(answer, cheapest);
}

const struct aob_effect_candidate *aob_effect_answer_find(const struct aob_effect_answer *answer,
                                                          unsigned set)
{
    for (size_t i = 0; i < answer->count; i++)
        if (answer->candidates[i].set == set)
            return &answer->candidates[i];
    return NULL;
}

bool aob_effect_answer_ties(const struct aob_effect_answer *answer,
                            const struct aob_effect_candidate *candidate)
{
    const struct aob_effect_candidate *chosen =
        answer->chosen < 0 ? NULL : &answer->candidates[answer->chosen];
    return chosen && candidate != chosen && may_be_taken(answer, candidate) &&
           candidate->ms <= (1 + tie) * chosen->ms;
}

unsigned aob_effect_turned(unsigned set, enum aob_effect_id id)
{
    const unsigned bent = AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL),
                   light = AOB_EFFECT_BIT(AOB_EFFECT_DIRECTIONAL);
    unsigned turned = set ^ AOB_EFFECT_BIT(id);
    if (id == AOB_EFFECT_VISIBILITY)
        return aob_effect_has(set, id) ? 0 : turned;
    if (turned)
        turned |= AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY);
    if ((turned & bent) && (turned & light))
        turned &= ~(id == AOB_EFFECT_BENT_NORMAL ? light : bent);
    return turned;
}

enum aob_effect_why aob_effect_answer_why(const struct aob_effect_answer *answer, enum aob_effect_id id)
{
    if (answer->chosen < 0)
        return AOB_WHY_BUDGET;
    if (aob_effect_has(answer->lacks, id) || (id == AOB_EFFECT_TEMPORAL && answer->no_sequence))
        return AOB_WHY_NO_DATA;
    unsigned turned = aob_effect_turned(answer->candidates[answer->chosen].set, id);
    return aob_effect_has(answer->open, id) && aob_effect_answer_find(answer, turned) ? AOB_WHY_MEASURED
                                                                                      : AOB_WHY_RULE;
}

static void explain_no_data(const struct aob_effect_answer *answer, enum aob_effect_id id,
                            struct aob_text *text)
{
    if (id == AOB_EFFECT_TEMPORAL)
        aob_text_add(text, "not known: %s", answer->no_sequence);
    else
        aob_effect_explain_lack(id, text);
}

/* What a rule says, with its bound. */
static void explain_rule(const struct aob_effect_answer *answer, enum aob_effect_id id, struct aob_text *text)
{
    static const char *const sentences[AOB_EFFECT_COUNT] = {
        [AOB_EFFECT_MULTI_BOUNCE] =
            "between surfaces as dark and as open as these, bounces change the image by",
        [AOB_EFFECT_BENT_NORMAL] =
            "the light is so even that looking it up along another direction changes the image by",
        [AOB_EFFECT_DIRECTIONAL] =
            "the light is so even that what is closed by direction changes the image by",
        [AOB_EFFECT_SPECULAR] =
            "what these surfaces mirror is so little, or so wide, that its occlusion changes the image by",
        [AOB_EFFECT_TEMPORAL] =
            "nothing moves, and a frame has so many samples that a mean of many brings the image nearer by",
    };
    const struct aob_effect_candidate *none = aob_effect_answer_find(answer, 0);
    double tolerance = 100 * aob_effect_ask_tolerance(&answer->ask);
    if (sentences[id] && isfinite(answer->bounds.most[id]) &&
        aob_effect_has(answer->open, AOB_EFFECT_VISIBILITY))
        aob_text_add(text, "no: %s %.2g %% at most, of a tolerance of %.3g %%", sentences[id],
                     100 * answer->bounds.most[id], tolerance);
    else if (id == AOB_EFFECT_VISIBILITY)
        aob_text_add(text, "no: without any occlusion the image is off by %.2g %%, of a tolerance of %.3g %%",
                     100 * none->error.rmse, tolerance);
    else
        aob_text_add(
            text, "no: it goes with visibility, and without any occlusion the image is within the tolerance");
}

/* What the other set is like; flicker where it is another one. */
static void explain_measured(const struct aob_effect_answer *answer, const struct aob_effect_candidate *other,
                             enum aob_effect_id id, struct aob_text *text)
{
    const struct aob_effect_candidate *chosen = &answer->candidates[answer->chosen];
    const char *is = answer->no_truth ? "differs by" : "is off by";
    bool in = aob_effect_has(chosen->set, id);
    double own = 100 * chosen->error.rmse, turned = 100 * other->error.rmse, more = other->ms - chosen->ms;
    aob_text_add(text, "%s: %s the image %s %.3g %% in place of %.3g %%, ", in ? "yes" : "no",
                 in ? "without it" : "with it", is, turned, own);
    if (fabs(other->flicker - chosen->flicker) > 0)
        aob_text_add(text, "flickers by %.2g %% in place of %.2g %%, ", 100 * other->flicker,
                     100 * chosen->flicker);
    aob_text_add(text, "and a frame takes %.3g ms %s", fabs(more), more > 0 ? "more" : "less");
}

void aob_effect_answer_explain(const struct aob_effect_answer *answer, enum aob_effect_id id,
                               struct aob_text *text)
{
    enum aob_effect_why why = aob_effect_answer_why(answer, id);
    if (why == AOB_WHY_BUDGET)
        aob_text_add(text, "no: no set fits the budget");
    else if (why == AOB_WHY_RULE)
        explain_rule(answer, id, text);
    else if (why == AOB_WHY_NO_DATA)
        explain_no_data(answer, id, text);
    else {
        const struct aob_effect_candidate *chosen = &answer->candidates[answer->chosen];
        explain_measured(answer, aob_effect_answer_find(answer, aob_effect_turned(chosen->set, id)), id,
                         text);
    }
}
