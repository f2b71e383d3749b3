#include "suspect.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"

void aob_suspect_say(struct aob_suspect *suspect, enum aob_night_verdict verdict, enum aob_outcome outcome,
                     const char *format, ...)
{
    va_list list;
    va_start(list, format);
    suspect->verdict = verdict;
    suspect->outcome = outcome;
    aob_line_print_list(suspect->said, sizeof suspect->said, format, list);
    va_end(list);
}

static bool is_good(const struct aob_point *point)
{
    return strcmp(point->status, "ok") == 0;
}

static const struct aob_point *last_good(const struct aob_point *points, size_t count)
{
    while (count && !is_good(&points[count - 1]))
        count--;
    return count ? &points[count - 1] : NULL;
}

/* Adds "miss_ratio 0.2 -> 0.3" of each cache figure that is another. */
static size_t add_cache_changes(const json_t *before, const json_t *now, struct aob_text *text)
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
        aob_text_add(text, ", and %zu more cache figures", count - 1);
    return count;
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
        aob_suspect_say(s, AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD, "%s", text.data + 2);
    aob_text_finish(&text);
}

/* A case that could not run the night before either is no news. */
static void judge_failure(struct aob_suspect *s, const struct aob_point *last)
{
    if (last && is_good(last))
        aob_suspect_say(s, AOB_NIGHT_BROKEN, AOB_OUTCOME_WORSE, "%s now, and it ran before: %s",
                        s->now->status, s->now->reason);
    else if (strcmp(s->now->status, "failed") == 0)
        aob_suspect_say(s, AOB_NIGHT_NONE, AOB_OUTCOME_OPEN, "failed, as before: %s", s->now->reason);
}

static bool differ(const char *a, const char *b)
{
    return *a && *b && strcmp(a, b) != 0;
}

static void judge(struct aob_suspect *s, double precision)
{
    const struct aob_line *line = s->line;
    const struct aob_point *last = line->count > 1 ? &line->points[line->count - 2] : NULL;
    s->now = &line->points[line->count - 1];
    s->before = last_good(line->points, line->count - 1);
    s->beside = s->low = s->high = s->watch.before = s->watch.shift = NAN;
    if (!is_good(s->now)) {
        judge_failure(s, last);
        return;
    }
    if (!s->before) {
        aob_suspect_say(s, AOB_NIGHT_FIRST, AOB_OUTCOME_GOOD, "its first night");
        return;
    }
    judge_counted(s);
    aob_watch_line(line->points, line->count, precision, &s->watch);
    s->moved = differ(s->before->image, s->now->image);
    if (s->watch.suspect)
        s->old = last_good(line->points, s->watch.since);
    else if (s->moved)
        s->old = s->before;
}

void aob_suspects_choose(struct aob_suspects *suspects, const struct aob_lines *lines, double precision)
{
    suspects->items = AOB_NEW_ARRAY(struct aob_suspect, lines->count + 1);
    for (size_t i = 0; i < lines->count; i++) {
        struct aob_suspect *s = &suspects->items[suspects->count++];
        s->line = &lines->items[i];
        judge(s, precision);
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

int64_t aob_suspect_since(const struct aob_suspect *suspect)
{
    return suspect->watch.suspect ? suspect->line->points[suspect->watch.since].night : suspect->now->night;
}
