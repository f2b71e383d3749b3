#include "best.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/member.h"
#include "base/memory.h"
#include "reports/page/answer_text.h"

struct aob_best_entry {
    char *target;                /* "the truth within 0.5 scene units" */
    struct aob_candidate chosen; /* the most accurate that fits; `what` NULL: none does yet */
    char *what;
};

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
        AOB_PUSH(best->entries, best->count, best->capacity)->target = aob_strdup(said);
    aob_text_finish(&text);
    free(said);
    return &best->entries[place];
}

/* The rule of a finished run, of what was best so far and the next. */
static void take(struct aob_best_entry *entry, const struct aob_candidate *next, const struct aob_ask *ask,
                 const char *what)
{
    const struct aob_candidate pair[] = {entry->what ? entry->chosen : *next, *next};
    struct aob_choice choice;
    aob_choice_make(&choice, pair, 2, ask->ms, ask->error);
    if (choice.accurate == AOB_NO_CANDIDATE || (entry->what && choice.accurate == 0))
        return;
    free(entry->what);
    entry->what = aob_strdup(what);
    entry->chosen = *next;
}

static void print(const struct aob_best *best, const struct aob_best_entry *entry, struct aob_text *line)
{
    const struct aob_interval cost = {entry->chosen.ms, entry->chosen.low, entry->chosen.high};
    aob_three_digits(best->ask->ms, line);
    if (entry->what) {
        aob_text_add(line, " ms: error %.4f, ", entry->chosen.error);
        aob_interval_print(&cost, line);
        aob_text_add(line, " ms: %s, against %s", entry->what, entry->target);
    } else
        aob_text_add(line, " ms: nothing fits yet, against %s", entry->target);
}

static void clear_lines(struct aob_best *best)
{
    for (size_t i = 0; i < AOB_BEST_SHOWN; i++)
        aob_text_finish(&best->lines[i]);
}

void aob_best_take(struct aob_best *best, const json_t *record, const char *what)
{
    if (!best->ask || !aob_ask_has(best->ask, record))
        return;
    struct aob_interval cost = aob_ask_cost(best->ask, record);
    bool counts = isfinite(cost.at) && aob_ask_may_choose(record);
    json_t *error;
    size_t i, lines = 0;
    clear_lines(best);
    json_array_foreach(json_object_get(record, "errors"), i, error)
    {
        struct aob_candidate next = {
            .ms = cost.at, .low = cost.low, .high = cost.high, .error = aob_costs_error(error)};
        if (!isfinite(next.error))
            continue;
        struct aob_best_entry *entry = find_entry(best, record, error);
        if (counts)
            take(entry, &next, best->ask, what);
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
        free(best->entries[i].what);
    }
    free(best->entries);
    free(best->ask);
    aob_table_finish(&best->places);
    *best = (struct aob_best){0};
}
