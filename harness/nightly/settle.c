#include "settle.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "base/file.h"
#include "base/memory.h"
#include "compare/compare.h"
#include "compare/quotient.h"
#include "group.h"

struct settling {
    struct aob_suspects *suspects;
    const struct aob_nightly_desc *desc;
    const struct aob_night_start *start;
    struct aob_old_files files;
    struct aob_nights nights;
    struct aob_groups groups;
};

static bool is_same_build(const struct aob_suspect *s)
{
    return *s->old->build && strcmp(s->old->build, s->now->build) == 0;
}

static const struct aob_night *night_of(const struct settling *g, int64_t id)
{
    for (size_t i = 0; i < g->nights.count; i++)
        if (g->nights.items[i].id == id)
            return &g->nights.items[i];
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

/* Of the two images only what was stored: the errors. */
static void judge_by_errors(struct aob_suspect *s, const char *why)
{
    const struct aob_point *a = s->before, *b = s->now;
    const struct aob_error_pair pair = {
        {a->rmse, a->reference_se, a->band_pixels}, {b->rmse, b->reference_se, b->band_pixels}, NAN};
    enum aob_error_change change = aob_error_change(&pair);
    char errors[200];
    aob_error_change_print(&pair, errors, sizeof errors);
    aob_suspect_say(s, AOB_NIGHT_MOVED,
                    change == AOB_ERROR_MORE      ? AOB_OUTCOME_WORSE
                    : change == AOB_ERROR_UNKNOWN ? AOB_OUTCOME_OPEN
                                                  : AOB_OUTCOME_GOOD,
                    "the image changed; %s; %s", errors, why);
}

static bool is_folder(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* By the image that the earlier night's run still has. */
static void compare_stored(struct settling *g, struct aob_suspect *s, const char *why)
{
    const struct aob_night *night = night_of(g, s->before->night);
    judge_by_errors(s, why);
    if (night && is_folder(night->folder))
        aob_group_add(aob_groups_find(&g->groups, g->start->folder, NULL, night->folder), s);
}

static void leave_open(struct settling *g, struct aob_suspect *s, const char *why)
{
    char shift[100];
    if (s->watch.suspect) {
        describe_shift(g, s, shift);
        aob_suspect_say(s, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN, "%s, and not measured again: %s", shift, why);
    } else
        compare_stored(g, s, why);
}

static void blame_machine(struct settling *g, struct aob_suspect *s)
{
    char shift[100];
    if (!s->watch.suspect) {
        compare_stored(g, s, "the technique's build is the same: the program or the driver changed it");
        return;
    }
    describe_shift(g, s, shift);
    aob_suspect_say(
        s, AOB_NIGHT_MACHINE, AOB_OUTCOME_GOOD,
        "%s, and the technique's build is the same: the machine, the driver or the program is the cause",
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
        aob_group_add(aob_groups_find(&g->groups, g->start->folder, s->now->module, old), s);
    else
        leave_open(g, s, why.text);
    free(old);
}

static void measure_groups(struct settling *g)
{
    for (size_t i = 0; i < g->groups.count; i++) { /* leave_open may add groups behind this one */
        struct aob_error why = {{0}};
        const char *module = g->groups.list[i]->module;
        size_t count = g->groups.list[i]->count;
        if (module && !g->desc->quiet)
            aob_note("nightly: measuring %zu case%s of %s again, beside the old build", count,
                     count == 1 ? "" : "s", module);
        if (aob_group_measure(g->groups.list[i], g->desc, g->start->run, &why) || !module)
            continue;
        for (size_t k = 0; k < count; k++)
            leave_open(g, g->groups.list[i]->items[k], why.text);
    }
}

/* Of each interval of the night: of the differences that are told a share of AOB_NIGHTLY_DISCOVERY is false on average. */
static double night_level(const struct settling *g)
{
    double *p = AOB_NEW_ARRAY(double, g->suspects->count + 1);
    size_t count = 0;
    for (size_t i = 0; i < g->groups.count; i++) {
        const struct aob_group *group = g->groups.list[i];
        for (size_t k = 0; group->module && k < group->count; k++) {
            const struct aob_compared *item = aob_group_item(group, group->items[k]);
            if (item && !*item->unfit.text)
                p[count++] = aob_ratio_p(&item->cost.cost, item->cost.processes);
        }
    }
    double level = aob_watch_level(p, count, AOB_NIGHTLY_DISCOVERY);
    free(p);
    return level;
}

/* Both builds cost the same beside each other. Whether the machine has changed or only that night's measurement was off is seen
 * from what the new build costs now. */
static void judge_same(const struct settling *g, struct aob_suspect *s, const struct aob_compared *item)
{
    double again = item->couple->b->ratio / s->watch.before;
    char shift[100];
    describe_shift(g, s, shift);
    bool gone = fabs(log(again)) <= log1p(s->watch.least);
    aob_suspect_say(
        s, gone ? AOB_NIGHT_OUTLIER : AOB_NIGHT_MACHINE, AOB_OUTCOME_GOOD,
        gone ? "%s, and not when it was measured again; %s"
             : "%s, and the old build beside it is too, so the machine or the driver is the cause; %s",
        shift, item->judgement.reason);
}

/* Only its image was asked after, so a cost that is not decided leaves nothing open. */
static enum aob_outcome outcome_of(const struct aob_suspect *s, const struct aob_judgement *j)
{
    enum aob_outcome outcome = aob_judgement_outcome(j, false);
    bool open = outcome == AOB_OUTCOME_OPEN && !s->watch.suspect && j->error != AOB_ERROR_UNKNOWN;
    return open ? AOB_OUTCOME_GOOD : outcome;
}

/* By the two images alone. */
static void judge_images(struct aob_suspect *s, const struct aob_compared *item)
{
    if (item->judgement.verdict != AOB_VERDICT_MOVED || item->judgement.error == AOB_ERROR_UNKNOWN)
        return;
    char errors[200];
    aob_error_change_print(&item->errors, errors, sizeof errors);
    aob_suspect_say(s, AOB_NIGHT_MOVED,
                    item->judgement.error == AOB_ERROR_MORE ? AOB_OUTCOME_WORSE : AOB_OUTCOME_GOOD,
                    "the image changed; %s", errors);
}

static void judge_beside(const struct settling *g, struct aob_suspect *s, const struct aob_compared *item)
{
    const struct aob_judgement *j = &item->judgement;
    char shift[100];
    if (s->moved && !s->watch.suspect && j->verdict != AOB_VERDICT_MOVED) {
        judge_by_errors(s, "the old build gives the same one now, so the program or the driver changed it");
        return;
    }
    if (!isfinite(s->now->ratio)) {
        judge_by_errors(s, "nothing is timed");
        judge_images(s, item);
        return;
    }
    s->beside = item->cost.cost.ratio;
    s->low = item->cost.cost.low;
    s->high = item->cost.cost.high;
    describe_shift(g, s, shift);
    if (j->verdict == AOB_VERDICT_MOVED)
        aob_suspect_say(s, AOB_NIGHT_MOVED, outcome_of(s, j), "%s", j->reason);
    else if (j->verdict == AOB_VERDICT_SLOWER || j->verdict == AOB_VERDICT_FASTER)
        aob_suspect_say(s, j->verdict == AOB_VERDICT_SLOWER ? AOB_NIGHT_SLOWER : AOB_NIGHT_FASTER,
                        aob_judgement_outcome(j, false), "%s; beside the old build %s", shift, j->reason);
    else if (j->verdict == AOB_VERDICT_SAME)
        judge_same(g, s, item);
    else
        aob_suspect_say(s, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN, "%s; beside the old build %s", shift, j->reason);
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

static bool judge_group(const struct settling *g, struct aob_group *group, double level,
                        struct aob_error *error)
{
    if (!group->ready)
        return true;
    if (!aob_contest_judge(&group->contest, group->module ? level : 0, error))
        return false;
    aob_compared_draw(&group->contest.table, g->desc->dispatch.program);
    for (size_t k = 0; k < group->count; k++) {
        struct aob_suspect *s = group->items[k];
        const struct aob_compared *item = aob_group_item(group, s);
        if (!item && group->module)
            aob_suspect_say(s, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN,
                            "it stood out, and could not be measured beside the old build: %s has the causes",
                            group->folder);
        if (!item)
            continue;
        keep_map(group, s, item);
        if (group->module)
            judge_beside(g, s, item);
        else
            judge_images(s, item);
    }
    return true;
}

bool aob_suspects_settle(struct aob_suspects *suspects, struct aob_history *history,
                         const struct aob_nightly_desc *desc, const struct aob_night_start *start,
                         struct aob_error *error)
{
    char *old = aob_path_join(start->folder, "old");
    struct settling g = {
        .suspects = suspects, .desc = desc, .start = start, .files = {history, desc->old, old}};
    bool ok = aob_nights_read(history, start->name, &g.nights, error);
    for (size_t i = 0; ok && i < suspects->count; i++)
        if (aob_suspect_stands_out(&suspects->items[i]))
            choose_group(&g, &suspects->items[i]);
    if (ok)
        measure_groups(&g);
    double level = night_level(&g);
    for (size_t i = 0; ok && i < g.groups.count; i++)
        ok = judge_group(&g, g.groups.list[i], level, error);
    aob_groups_finish(&g.groups);
    aob_nights_finish(&g.nights);
    free(old);
    return ok;
}
