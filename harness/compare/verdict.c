#include "verdict.h"
#include <math.h>
#include <stdio.h>
#include "base/text.h"

const char *const aob_verdict_names[] = {"FASTER", "SLOWER", "SAME", "AMBIGUOUS", "INVALID", "MOVED"};

double aob_noise_floor(const struct aob_ratio *control)
{
    return control->bounded ? fmax(control->high - 1, 1 / control->low - 1) : INFINITY;
}

const struct aob_ratio *aob_wider_control(const struct aob_ratio *a, const struct aob_ratio *b)
{
    return aob_noise_floor(b) > aob_noise_floor(a) ? b : a;
}

/* Beyond 1 +- delta, which way the ratio may lie. */
static bool is_beyond(double ratio, double delta)
{
    return ratio > 1 + delta || ratio < 1 / (1 + delta);
}

static bool lies_beside_one(const struct aob_ratio *r)
{
    return r->low > 1 || r->high < 1;
}

/* The fixed pass is the same on both sides, so a difference that would be a verdict shows that the block lies. The middle
 * of its interval stands for it, as a record has only the ends. */
static bool control_differs(const struct aob_comparison *c)
{
    return lies_beside_one(&c->control) && is_beyond(sqrt(c->control.low * c->control.high), c->resolution);
}

static bool fail(struct aob_judgement *j, const char *reason)
{
    aob_line_print(j->reason, sizeof j->reason, "%s", reason);
    return false;
}

static bool is_valid(const struct aob_comparison *c, struct aob_judgement *j)
{
    char line[200];
    if (c->invalid)
        return fail(j, c->invalid);
    if (c->processes < AOB_COMPARE_PROCESSES) {
        snprintf(line, sizeof line, "it was timed in %zu processes, and a verdict needs %d", c->processes,
                 AOB_COMPARE_PROCESSES);
        return fail(j, line);
    }
    if (c->rounds < AOB_COMPARE_ROUNDS) {
        snprintf(line, sizeof line, "it has %zu rounds, and a verdict needs %d: measure for longer",
                 c->rounds, AOB_COMPARE_ROUNDS);
        return fail(j, line);
    }
    if (!c->cost.bounded || !c->control.bounded)
        return fail(j, "there is no interval of its cost or of the control");
    if (!control_differs(c))
        return true;
    snprintf(line, sizeof line, "the control differs from itself: [%.4f, %.4f] lies beside 1", c->control.low,
             c->control.high);
    return fail(j, line);
}

/* A noise floor hides a difference; it is no reason to call two costs the same. */
static enum aob_verdict judge_cost(const struct aob_ratio *r, double delta, double resolution)
{
    if (r->low > 1 && r->ratio > 1 + delta)
        return AOB_VERDICT_SLOWER;
    if (r->high < 1 && r->ratio < 1 / (1 + delta))
        return AOB_VERDICT_FASTER;
    if (r->low > 1 / (1 + resolution) && r->high < 1 + resolution)
        return AOB_VERDICT_SAME;
    return AOB_VERDICT_AMBIGUOUS;
}

/* To the wider side, on logarithms. */
static double half_width(const struct aob_ratio *r)
{
    return fmax(log(r->high / r->ratio), log(r->ratio / r->low));
}

/* Widths shrink with the root of the rounds, and faster while processes are few; as many again are the least that is
 * foretold. Where it is as narrow already, the difference is about as large as what is asked for, and rounds are not what
 * it lacks. */
static double rounds_needed(const struct aob_comparison *c, double delta)
{
    double wanted = 0.5 * log1p(delta), width = half_width(&c->cost);
    if (width <= wanted)
        return NAN;
    double factor = (c->lasting > 0 ? c->lasting : width) / wanted;
    return ceil((double)c->rounds * fmax(c->lasting > 0 ? 2 : 1, factor * factor));
}

static void explain_cost(const struct aob_comparison *c, struct aob_judgement *j)
{
    const char *floor = j->delta > c->resolution ? ", which is the noise floor" : "";
    double percent = 100 * j->delta;
    if (j->cost == AOB_VERDICT_SAME)
        snprintf(j->reason, sizeof j->reason, "the whole interval lies within %.3g %%", 100 * c->resolution);
    else if (j->cost != AOB_VERDICT_AMBIGUOUS)
        snprintf(j->reason, sizeof j->reason, "the interval lies %s 1, and the ratio is beyond %.3g %%%s",
                 j->cost == AOB_VERDICT_SLOWER ? "above" : "below", percent, floor);
    else if (isnan(j->rounds_needed) && *floor)
        snprintf(
            j->reason, sizeof j->reason,
            "the difference lies within the noise floor of %.3g %%, and not within the %.3g %% asked for",
            percent, 100 * c->resolution);
    else if (isnan(j->rounds_needed))
        snprintf(j->reason, sizeof j->reason,
                 "the difference is about as large as the %.3g %% that it is judged by: ask for another "
                 "--precision",
                 percent);
    else
        snprintf(j->reason, sizeof j->reason,
                 "the interval is too wide for %.3g %%%s: about %.0f rounds would decide", percent, floor,
                 j->rounds_needed);
}

/* "the image changed; RMSE 0.0412 -> 0.0455 (worse); its cost is FASTER: ..." */
static void explain_move(const struct aob_comparison *c, struct aob_judgement *j)
{
    char cost[sizeof j->reason], error[200];
    aob_line_print(cost, sizeof cost, "%s", j->reason);
    aob_error_change_print(&c->errors, error, sizeof error);
    aob_line_print(j->reason, sizeof j->reason, "the image changed; %s; its cost is %s: %s", error,
                   aob_verdict_names[j->cost], cost);
}

struct aob_judgement aob_judge(const struct aob_comparison *c)
{
    struct aob_judgement j = {.cost = AOB_VERDICT_INVALID, .error = AOB_ERROR_EQUAL, .rounds_needed = NAN};
    j.delta = c->control.bounded ? fmax(c->resolution, aob_noise_floor(&c->control)) : c->resolution;
    if (is_valid(c, &j)) {
        j.cost = judge_cost(&c->cost, j.delta, c->resolution);
        if (j.cost == AOB_VERDICT_AMBIGUOUS)
            j.rounds_needed = rounds_needed(c, j.delta);
        explain_cost(c, &j);
    }
    if (c->elsewhere && (j.cost == AOB_VERDICT_SLOWER || j.cost == AOB_VERDICT_FASTER))
        aob_line_print(j.reason, sizeof j.reason, "%s", c->elsewhere);
    j.verdict = c->moved ? AOB_VERDICT_MOVED : j.cost;
    if (c->moved) {
        j.error = aob_error_change(&c->errors);
        explain_move(c, &j);
    }
    return j;
}

enum aob_outcome aob_judgement_outcome(const struct aob_judgement *j, bool elsewhere)
{
    if ((j->cost == AOB_VERDICT_SLOWER && !elsewhere) || j->error == AOB_ERROR_MORE)
        return AOB_OUTCOME_WORSE;
    bool open = j->cost == AOB_VERDICT_AMBIGUOUS || j->cost == AOB_VERDICT_INVALID ||
                j->error == AOB_ERROR_UNKNOWN || (j->cost == AOB_VERDICT_SLOWER && elsewhere);
    return open ? AOB_OUTCOME_OPEN : AOB_OUTCOME_GOOD;
}
