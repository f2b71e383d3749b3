#include "settle.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "compare/compare.h"
#include "compare/quotient.h"
#include "group.h"

struct settling {
    struct aob_suspects *suspects;
    const struct aob_nightly_desc *desc;
    const struct aob_night_start *start;
    const struct aob_nights *nights;
    struct aob_old_files files;
    struct aob_groups groups;
};

static bool is_same_build(const struct aob_suspect *s)
{
    return *s->old->build && strcmp(s->old->build, s->now->build) == 0;
}

static const struct aob_night *night_of(const struct settling *g, int64_t id)
{
    for (size_t i = 0; i < g->nights->count; i++)
        if (g->nights->items[i].id == id)
            return &g->nights->items[i];
    return NULL;
}

static const char *date_of(const struct settling *g, int64_t id)
{
    const struct aob_night *night = night_of(g, id);
    return night ? night->date : "";
}

/* "5.1 % dearer since 2026-11-30": of its level, not of the times beside each other. */
static void describe_shift(const struct settling *g, const struct aob_suspect *s, char text[100])
{
    double percent = 100 * (s->watch.shift - 1);
    aob_line_print(text, 100, "%.1f %% %s since %.10s", fabs(percent), percent > 0 ? "dearer" : "cheaper",
                   date_of(g, aob_suspect_since(s)));
}

static enum aob_outcome outcome_of(enum aob_error_change change)
{
    return change == AOB_ERROR_MORE      ? AOB_OUTCOME_WORSE
           : change == AOB_ERROR_UNKNOWN ? AOB_OUTCOME_OPEN
                                         : AOB_OUTCOME_GOOD;
}

static void say_image(struct aob_suspect *s, const struct aob_error_pair *errors)
{
    char text[200];
    aob_error_change_print(errors, text, sizeof text);
    aob_finding_say(&s->image, AOB_NIGHT_MOVED, outcome_of(aob_error_change(errors)),
                    "the image changed; %s%s%s", text, *s->cause ? "; " : "", s->cause);
}

/* Of the two images only what the history has: the errors. */
static void judge_by_errors(struct aob_suspect *s, const char *cause)
{
    const struct aob_point *a = s->before, *b = s->now;
    const struct aob_error_pair errors = {
        {a->rmse, a->reference_se, a->band_pixels}, {b->rmse, b->reference_se, b->band_pixels}, NAN};
    aob_line_print(s->cause, sizeof s->cause, "%s", cause);
    say_image(s, &errors);
}

/* By the image that the earlier night's run still has. */
static void compare_stored(struct settling *g, struct aob_suspect *s, const char *cause)
{
    const struct aob_night *night = night_of(g, s->before->night);
    judge_by_errors(s, cause);
    if (night && aob_folder_exists(night->folder))
        aob_group_add(aob_groups_stored(&g->groups, g->start->folder, s->now, s->before, night->folder), s);
}

static void leave_open(struct settling *g, struct aob_suspect *s, const char *why)
{
    char shift[100];
    if (s->moved)
        compare_stored(g, s, s->watch.suspect ? "" : why);
    if (!s->watch.suspect)
        return;
    describe_shift(g, s, shift);
    aob_finding_say(&s->cost, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN, "%s, and not measured again: %s", shift, why);
}

static void blame_machine(struct settling *g, struct aob_suspect *s)
{
    char shift[100];
    if (s->moved)
        compare_stored(g, s, "the technique's build is the same, so the program changed it");
    if (!s->watch.suspect)
        return;
    describe_shift(g, s, shift);
    aob_finding_say(&s->cost, AOB_NIGHT_MACHINE, AOB_OUTCOME_GOOD,
                    "%s, and the technique's build is the same: the machine or the program is the cause",
                    shift);
}

static void choose_group(struct settling *g, struct aob_suspect *s)
{
    struct aob_error why = {{0}};
    if (is_same_build(s)) {
        blame_machine(g, s);
        return;
    }
    char *old = aob_old_files_find(&g->files, s->old, s->now, &why);
    if (old)
        aob_group_add(aob_groups_beside(&g->groups, g->start->folder, s->now, old), s);
    else
        leave_open(g, s, why.text);
    free(old);
}

static void measure_group(struct settling *g, struct aob_group *group)
{
    struct aob_error why = {{0}};
    if (group->beside && !g->desc->quiet)
        aob_note("nightly: measuring %zu case%s of %s again, beside the old build", group->count,
                 group->count == 1 ? "" : "s", group->module);
    if (aob_group_measure(group, g->desc, g->start->run, &why) || !group->beside)
        return;
    for (size_t k = 0; k < group->count; k++)
        leave_open(g, group->items[k], why.text);
}

/* Stored images are compared last, since those come to them whose module could not be measured. */
static void measure_groups(struct settling *g)
{
    for (size_t i = 0; i < g->groups.count; i++)
        if (g->groups.list[i]->beside)
            measure_group(g, g->groups.list[i]);
    for (size_t i = 0; i < g->groups.count; i++)
        if (!g->groups.list[i]->tried)
            measure_group(g, g->groups.list[i]);
}

/* Whether its times are enough for a verdict, which aob_judge gives. */
static bool is_tested(const struct aob_compared *item)
{
    return item && !*item->unfit.text && item->cost.rounds >= AOB_COMPARE_ROUNDS &&
           item->cost.processes >= AOB_COMPARE_PROCESSES;
}

/* Of each interval of the night: of the differences that are told a share of AOB_NIGHTLY_DISCOVERY is false on average. */
static double night_level(const struct settling *g)
{
    double *p = AOB_NEW_ARRAY(double, g->suspects->count + 1);
    size_t count = 0;
    for (size_t i = 0; i < g->groups.count; i++) {
        const struct aob_group *group = g->groups.list[i];
        for (size_t k = 0; group->beside && k < group->count; k++) {
            const struct aob_compared *item = aob_group_item(group, group->items[k]);
            if (is_tested(item))
                p[count++] = aob_ratio_p(&item->cost.cost, item->cost.processes);
        }
    }
    double level = aob_watch_level(p, count, AOB_NIGHTLY_DISCOVERY);
    free(p);
    return level;
}

/* Both builds cost the same beside each other. Whether the machine has changed or only that night's measurement was off is seen
 * from what the new build costs now. */
static void judge_same(struct aob_suspect *s, const struct aob_compared *item, const char *shift)
{
    double again = item->couple->b->ratio / s->watch.before;
    bool gone = fabs(log(again)) <= log1p(s->watch.least);
    aob_finding_say(
        &s->cost, gone ? AOB_NIGHT_OUTLIER : AOB_NIGHT_MACHINE, AOB_OUTCOME_GOOD,
        gone ? "%s, and not when it was measured again; %s"
             : "%s, and the old build beside it is too, so the machine or the program is the cause; %s",
        shift, item->judgement.reason);
}

/* A cost that nobody suspected is told where it turns out to be dearer, and leaves nothing open. */
static void judge_cost(const struct settling *g, struct aob_suspect *s, const struct aob_compared *item)
{
    const struct aob_judgement *j = &item->judgement;
    enum aob_night_verdict verdict = j->cost == AOB_VERDICT_SLOWER ? AOB_NIGHT_SLOWER : AOB_NIGHT_FASTER;
    enum aob_outcome outcome = j->cost == AOB_VERDICT_SLOWER ? AOB_OUTCOME_WORSE : AOB_OUTCOME_GOOD;
    bool differs = j->cost == AOB_VERDICT_SLOWER || j->cost == AOB_VERDICT_FASTER;
    char shift[100];
    s->beside = item->cost.cost.ratio;
    s->low = item->cost.cost.low;
    s->high = item->cost.cost.high;
    if (!s->watch.suspect) {
        if (differs)
            aob_finding_say(&s->cost, verdict, outcome, "its cost beside the old build is %.1f %% %s",
                            100 * fabs(s->beside - 1), s->beside > 1 ? "dearer" : "cheaper");
        return;
    }
    describe_shift(g, s, shift);
    if (differs)
        aob_finding_say(&s->cost, verdict, outcome, "%s, %.1f %% %s beside the old build", shift,
                        100 * fabs(s->beside - 1), s->beside > 1 ? "dearer" : "cheaper");
    else if (j->cost == AOB_VERDICT_SAME)
        judge_same(s, item, shift);
    else
        aob_finding_say(&s->cost, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN,
                        "%s, not decided beside the old build: %s", shift,
                        *item->unfit.text ? item->unfit.text : j->reason);
}

/* `item` is measured beside the old build, or of the stored images of both nights. */
static void judge_image(struct aob_suspect *s, const struct aob_compared *item, bool beside)
{
    bool drawn = aob_row_is_ok(item->couple->a) && aob_row_is_ok(item->couple->b);
    if (item->image.moved)
        say_image(s, &item->errors);
    else if (s->moved && beside)
        judge_by_errors(s, drawn ? "the old build gives the same one now, so the program changed it"
                                 : "it could not be drawn beside the old build");
}

static void keep_map(const struct aob_group *group, struct aob_suspect *s, const struct aob_compared *item)
{
    if (!item->map)
        return;
    struct aob_text path = {0};
    aob_text_add(&path, "%s/%s", group->name, item->map);
    free(s->map);
    s->map = path.data;
}

static void miss_item(const struct aob_group *group, struct aob_suspect *s)
{
    if (s->moved)
        judge_by_errors(s, "it could not be drawn beside the old build");
    if (s->watch.suspect)
        aob_finding_say(
            &s->cost, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN,
            "its cost stood out, and could not be measured beside the old build: %s has the causes",
            group->folder);
}

/* A night that times nothing has no cost to tell of. */
static void judge_item(const struct settling *g, const struct aob_group *group, struct aob_suspect *s)
{
    const struct aob_compared *item = aob_group_item(group, s);
    if (!item && group->beside)
        miss_item(group, s);
    if (!item)
        return;
    keep_map(group, s, item);
    judge_image(s, item, group->beside);
    if (group->beside && isfinite(s->now->ratio))
        judge_cost(g, s, item);
}

static bool judge_group(const struct settling *g, struct aob_group *group, double level,
                        struct aob_error *error)
{
    if (!group->ready)
        return true;
    if (!aob_contest_judge(&group->contest, group->beside ? level : 0, error))
        return false;
    aob_compared_draw(&group->contest.table, g->desc->dispatch.program);
    for (size_t k = 0; k < group->count; k++)
        judge_item(g, group, group->items[k]);
    return true;
}

bool aob_suspects_settle(struct aob_suspects *suspects, struct aob_history *history,
                         const struct aob_nights *nights, const struct aob_nightly_desc *desc,
                         const struct aob_night_start *start, struct aob_error *error)
{
    char *old = aob_path_join(start->folder, "old");
    struct settling g = {suspects, desc, start, nights, {history, desc->old, old}, {0}};
    for (size_t i = 0; i < suspects->count; i++)
        if (aob_suspect_stands_out(&suspects->items[i]))
            choose_group(&g, &suspects->items[i]);
    measure_groups(&g);
    double level = night_level(&g);
    bool ok = true;
    for (size_t i = 0; ok && i < g.groups.count; i++)
        ok = judge_group(&g, g.groups.list[i], level, error);
    for (size_t i = 0; i < suspects->count; i++)
        aob_suspect_join(&suspects->items[i]);
    aob_groups_finish(&g.groups);
    free(old);
    return ok;
}
