#include "best.h"
#include <math.h>
#include <stdlib.h>
#include "base/member.h"
#include "base/memory.h"
#include "reports/page/answer_text.h"

struct aob_best_frame { /* one size on one backend */
    struct aob_interval cost;
};
struct aob_best_entry {
    char *target; /* "the truth within 0.5 scene units" */
    struct aob_candidate *list;
    size_t count, capacity;
    double ms;     /* that was judged by */
    size_t chosen; /* the most accurate that fits it */
};

/* The place of the frame that a record is of. */
static size_t find_frame(struct aob_best *best, const json_t *record)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s %gx%g", aob_member_text(record, "backend"), aob_member_number(record, "width"),
                 aob_member_number(record, "height"));
    size_t place = aob_table_put(&best->frames_by, text.data, best->frame_count);
    if (place == best->frame_count)
        AOB_PUSH(best->frames, best->frame_count, best->frame_capacity)->cost = AOB_NO_FRAME;
    aob_text_finish(&text);
    return place;
}

static struct aob_best_entry *find_entry(struct aob_best *best, const json_t *record, const json_t *error)
{
    struct aob_text text = {0};
    struct aob_target target = aob_target_of(error, record);
    char *said = aob_target_say(&target);
    aob_text_add(&text, "%s/%s %s %gx%g %s", aob_member_text(record, "scene"),
                 aob_member_text(record, "view"), aob_member_text(record, "backend"),
                 aob_member_number(record, "width"), aob_member_number(record, "height"), said);
    size_t place = aob_table_put(&best->places, text.data, best->count);
    if (place == best->count)
        *AOB_PUSH(best->entries, best->count, best->capacity) =
            (struct aob_best_entry){.target = aob_strdup(said), .ms = NAN, .chosen = AOB_NO_CANDIDATE};
    aob_text_finish(&text);
    free(said);
    return &best->entries[place];
}

/* All are judged anew when there is less time than before, because G-buffer and composite turned out dearer. */
static void settle(struct aob_best_entry *entry, double ms)
{
    struct aob_choice choice;
    if (entry->ms == ms)
        return;
    aob_choice_make(&choice, entry->list, entry->count, ms, INFINITY);
    entry->chosen = choice.accurate;
    entry->ms = ms;
}

/* The rule of a finished run, of what was best so far and the next. */
static void take(struct aob_best_entry *entry, const struct aob_candidate *next)
{
    *AOB_PUSH(entry->list, entry->count, entry->capacity) = *next;
    bool first = entry->chosen == AOB_NO_CANDIDATE;
    const struct aob_candidate pair[] = {first ? *next : entry->list[entry->chosen], *next};
    struct aob_choice choice;
    aob_choice_make(&choice, pair, 2, entry->ms, INFINITY);
    if (choice.accurate == AOB_NO_CANDIDATE || (!first && choice.accurate == 0))
        return;
    entry->chosen = entry->count - 1;
}

static void print(const struct aob_best *best, const struct aob_best_entry *entry, struct aob_text *line)
{
    aob_three_digits(fmax(entry->ms, 0), line);
    if (entry->chosen == AOB_NO_CANDIDATE) {
        aob_text_add(line, " ms: nothing fits%s, against %s", entry->ms > 0 ? " yet" : "", entry->target);
        return;
    }
    const struct aob_candidate *chosen = &entry->list[entry->chosen];
    const struct aob_interval cost = {chosen->ms, chosen->low, chosen->high};
    aob_text_add(line, " ms: error %.4f, ", chosen->error);
    aob_interval_print(&cost, line);
    aob_text_add(line, " ms: %s, against %s", best->cases[chosen->of], entry->target);
}

static void clear_lines(struct aob_best *best)
{
    for (size_t i = 0; i < AOB_BEST_SHOWN; i++)
        aob_text_finish(&best->lines[i]);
}

/* Its candidate, but for the error. */
static struct aob_candidate candidate_of(struct aob_best *best, const json_t *record, const char *what)
{
    struct aob_interval cost = aob_ask_cost(best->ask, record);
    *AOB_PUSH(best->cases, best->case_count, best->case_capacity) = aob_strdup(what);
    return (struct aob_candidate){
        .of = best->case_count - 1, .ms = cost.at, .low = cost.low, .high = cost.high};
}

void aob_best_take(struct aob_best *best, const json_t *record, const char *what)
{
    if (!best->ask || !aob_ask_has(best->ask, record))
        return;
    size_t place = find_frame(best, record);
    struct aob_interval *frame = &best->frames[place].cost;
    struct aob_candidate next = candidate_of(best, record, what);
    json_t *error;
    size_t i, lines = 0;
    clear_lines(best);
    aob_ask_take_frame(best->ask, record, frame);
    json_array_foreach(json_object_get(record, "errors"), i, error)
    {
        next.error = aob_costs_error(error);
        if (!isfinite(next.error))
            continue;
        struct aob_best_entry *entry = find_entry(best, record, error);
        settle(entry, aob_ask_ms(best->ask, frame));
        if (isfinite(next.ms) && aob_ask_may_choose(record))
            take(entry, &next);
        if (lines < AOB_BEST_SHOWN)
            print(best, entry, &best->lines[lines++]);
    }
}

void aob_best_init(struct aob_best *best, const struct aob_budget *budget)
{
    *best = (struct aob_best){0};
    if (!budget->name)
        return;
    best->ask = AOB_NEW(struct aob_ask);
    *best->ask = aob_ask_of(budget);
}

void aob_best_finish(struct aob_best *best)
{
    clear_lines(best);
    for (size_t i = 0; i < best->count; i++) {
        free(best->entries[i].target);
        free(best->entries[i].list);
    }
    for (size_t i = 0; i < best->case_count; i++)
        free(best->cases[i]);
    free(best->entries);
    free(best->frames);
    free(best->cases);
    free(best->ask);
    aob_table_finish(&best->places);
    aob_table_finish(&best->frames_by);
    *best = (struct aob_best){0};
}
