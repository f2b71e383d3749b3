#include "suspect.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "start.h"

void aob_finding_say(struct aob_finding *finding, enum aob_night_verdict verdict, enum aob_outcome outcome,
                     const char *format, ...)
{
    va_list list;
    va_start(list, format);
    finding->verdict = verdict;
    finding->outcome = outcome;
    aob_line_print_list(finding->said, sizeof finding->said, format, list);
    va_end(list);
}

static bool is_good(const struct aob_point *point)
{
    return strcmp(point->status, "ok") == 0;
}

static bool is_judged(const struct aob_nights *nights, const struct aob_point *point)
{
    for (size_t i = nights->count; i-- > 0;)
        if (nights->items[i].id == point->night)
            return !aob_night_is_stopped(&nights->items[i]);
    return false;
}

/* The latest point before the last one that was judged; with `good` only one that ran. A stopped night was not judged, so what
 * it met would be missed if it stood for the night before. */
static const struct aob_point *last_judged(const struct aob_line *line, const struct aob_nights *nights,
                                           bool good)
{
    for (size_t i = line->count - 1; i-- > 0;)
        if ((!good || is_good(&line->points[i])) && is_judged(nights, &line->points[i]))
            return &line->points[i];
    return NULL;
}

/* Adds "miss_ratio 0.2 before, 0.3 now" of a cache figure that is another, and how many more there are. */
static void add_cache_changes(const json_t *before, const json_t *now, struct aob_text *text)
{
    size_t count = 0;
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)(uintptr_t)now, name, value)
    {
        const json_t *old = json_object_get(before, name);
        if (strncmp(name, "cache.", 6) != 0 || !old || json_equal(old, value))
            continue;
        if (!count++)
            aob_text_add(text, "; %s %.4g before, %.4g now", name + 6, json_number_value(old),
                         json_number_value(value));
    }
    if (count > 1)
        aob_text_add(text, ", and %zu more cache figure%s", count - 1, count == 2 ? "" : "s");
}

/* These are counted and not timed, so any difference is one. */
static void judge_counted(struct aob_suspect *s)
{
    struct aob_text text = {0};
    double before = s->before->memory_bytes, now = s->now->memory_bytes;
    if (isfinite(before) && isfinite(now) && before != now)
        aob_text_add(&text, "; memory %.0f bytes before, %.0f now", before, now);
    add_cache_changes(s->before->figures, s->now->figures, &text);
    if (text.size)
        aob_finding_say(&s->counted, AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD, "%s", text.data + 2);
    aob_text_finish(&text);
}

/* A case that could not run the night before either is no news. One that is `unsupported` cannot run here at all. */
static void judge_failure(struct aob_suspect *s, const struct aob_point *last)
{
    if (last && is_good(last))
        aob_finding_say(&s->cost, AOB_NIGHT_BROKEN, AOB_OUTCOME_WORSE, "%s now, and it ran before: %s",
                        s->now->status, s->now->reason);
    else if (strcmp(s->now->status, "unsupported") != 0)
        aob_finding_say(&s->cost, AOB_NIGHT_FAILING, AOB_OUTCOME_OPEN, "%s%s: %s", s->now->status,
                        last ? ", as before" : " on its first night", s->now->reason);
}

static bool differ(const char *a, const char *b)
{
    return *a && *b && strcmp(a, b) != 0;
}

/* What could not be decided is asked again: the nights since then would else become the level that it must stand out against. */
static void ask_again(struct aob_suspect *s, double precision)
{
    const struct aob_line *line = s->line;
    size_t open = 0;
    if (s->watch.suspect || s->before->verdict != AOB_NIGHT_OPEN || !s->before->since)
        return;
    while (open + 1 < line->count && line->points[open].night < s->before->since)
        open++;
    struct aob_point *points = AOB_NEW_ARRAY(struct aob_point, open + 1);
    memcpy(points, line->points, open * sizeof *points);
    points[open] = *s->now;
    struct aob_watch watch;
    aob_watch_line(points, open + 1, precision, &watch);
    if (watch.suspect) {
        s->watch = watch;
        s->watch.since = watch.since < open ? watch.since : open;
    }
    free(points);
}

/* A build from well within the level before: the night in which a level began is known to a few nights only, and the build of
 * the last night before it may be the one that is to blame. */
static const struct aob_point *build_before(const struct aob_suspect *s)
{
    const struct aob_point *points = s->line->points, *old = s->before;
    size_t passed = 0;
    for (size_t i = s->watch.since; i-- > s->watch.level && passed <= AOB_WATCH_NIGHTS;)
        if (is_good(&points[i])) {
            old = &points[i];
            passed++;
        }
    return old;
}

static void judge(struct aob_suspect *s, const struct aob_nights *nights, double precision)
{
    const struct aob_line *line = s->line;
    s->now = &line->points[line->count - 1];
    s->before = last_judged(line, nights, true);
    s->beside = s->low = s->high = s->watch.before = s->watch.shift = NAN;
    if (!is_good(s->now)) {
        judge_failure(s, last_judged(line, nights, false));
        return;
    }
    if (!s->before) {
        aob_finding_say(&s->cost, AOB_NIGHT_FIRST, AOB_OUTCOME_GOOD, "its first night");
        return;
    }
    judge_counted(s);
    aob_watch_line(line->points, line->count, precision, &s->watch);
    ask_again(s, precision);
    s->moved = differ(s->before->image, s->now->image);
    if (s->watch.suspect)
        s->old = build_before(s);
    else if (s->moved)
        s->old = s->before;
}

void aob_suspects_choose(struct aob_suspects *suspects, const struct aob_lines *lines,
                         const struct aob_nights *nights, double precision)
{
    suspects->items = AOB_NEW_ARRAY(struct aob_suspect, lines->count + 1);
    for (size_t i = 0; i < lines->count; i++) {
        struct aob_suspect *s = &suspects->items[suspects->count++];
        s->line = &lines->items[i];
        judge(s, nights, precision);
        suspects->watched += s->before != NULL;
    }
}

void aob_suspects_finish(struct aob_suspects *suspects)
{
    for (size_t i = 0; i < suspects->count; i++)
        free(suspects->items[i].map);
    free(suspects->items);
    *suspects = (struct aob_suspects){0};
}

bool aob_suspect_stands_out(const struct aob_suspect *suspect)
{
    return suspect->old;
}

int64_t aob_suspect_since(const struct aob_suspect *s)
{
    return s->watch.suspect ? s->line->points[s->watch.since].night : 0;
}

static bool is_decided(const struct aob_finding *cost)
{
    return cost->verdict == AOB_NIGHT_SLOWER || cost->verdict == AOB_NIGHT_FASTER ||
           cost->verdict == AOB_NIGHT_MACHINE;
}

int64_t aob_suspect_restart(const struct aob_suspect *s)
{
    if (is_decided(&s->cost))
        return s->watch.suspect ? aob_suspect_since(s) : s->now->night;
    return s->told.verdict == AOB_NIGHT_OPEN ? aob_suspect_since(s) : 0;
}

static int severity(const struct aob_finding *finding)
{
    static const int ranks[] = {[AOB_OUTCOME_GOOD] = 1, [AOB_OUTCOME_OPEN] = 2, [AOB_OUTCOME_WORSE] = 3};
    return *finding->said ? ranks[finding->outcome] : 0;
}

void aob_suspect_join(struct aob_suspect *s)
{
    const struct aob_finding *const all[] = {&s->image, &s->cost, &s->counted}, *worst = &s->cost;
    struct aob_text said = {0};
    for (size_t i = AOB_COUNT(all); i-- > 0;)
        worst = severity(all[i]) >= severity(worst) ? all[i] : worst;
    for (size_t i = 0; i < AOB_COUNT(all); i++)
        if (*all[i]->said)
            aob_text_add(&said, "%s%s", said.size ? "; " : "", all[i]->said);
    if (said.size)
        aob_finding_say(&s->told, worst->verdict, worst->outcome, "%s", said.data);
    aob_text_finish(&said);
}
