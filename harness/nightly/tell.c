#include "tell.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "reports/trend/night_page.h"
#include "reports/trend/trend.h"

/* The verdicts that are told, worst first. Cases that fail every night come last; first cases are only counted. */
static const enum aob_night_verdict ranks[] = {AOB_NIGHT_BROKEN, AOB_NIGHT_SLOWER,  AOB_NIGHT_MOVED,
                                               AOB_NIGHT_OPEN,   AOB_NIGHT_MACHINE, AOB_NIGHT_CHANGED,
                                               AOB_NIGHT_FASTER, AOB_NIGHT_OUTLIER, AOB_NIGHT_FAILING};

static struct aob_night_item item_of(const struct aob_suspect *s)
{
    return (struct aob_night_item){.line = s->line,
                                   .now = s->now,
                                   .before = s->before,
                                   .verdict = s->told.verdict,
                                   .said = s->told.said,
                                   .before_ratio = s->watch.before,
                                   .after_ratio = s->watch.before * s->watch.shift,
                                   .beside = s->beside,
                                   .low = s->low,
                                   .high = s->high,
                                   .map = s->map};
}

/* Of each verdict what is worse comes before what is not. `items` has room for all. */
static size_t gather(const struct aob_suspects *suspects, struct aob_night_item *items)
{
    size_t count = 0;
    for (size_t r = 0; r < AOB_COUNT(ranks); r++)
        for (int worse = 1; worse >= 0; worse--)
            for (size_t i = 0; i < suspects->count; i++) {
                const struct aob_suspect *s = &suspects->items[i];
                if (s->told.verdict == ranks[r] && (s->told.outcome == AOB_OUTCOME_WORSE) == worse)
                    items[count++] = item_of(s);
            }
    return count;
}

static size_t count_verdict(const struct aob_suspects *suspects, enum aob_night_verdict verdict)
{
    size_t count = 0;
    for (size_t i = 0; i < suspects->count; i++)
        count += suspects->items[i].told.verdict == verdict;
    return count;
}

static size_t count_outcome(const struct aob_suspects *suspects, enum aob_outcome outcome)
{
    size_t count = 0;
    for (size_t i = 0; i < suspects->count; i++)
        count += suspects->items[i].told.outcome == outcome;
    return count;
}

static size_t count_good(const struct aob_suspects *suspects)
{
    size_t count = 0;
    for (size_t i = 0; i < suspects->count; i++)
        count += strcmp(suspects->items[i].now->status, "ok") == 0;
    return count;
}

static size_t count_suspects(const struct aob_suspects *suspects)
{
    size_t count = 0;
    for (size_t i = 0; i < suspects->count; i++)
        count += aob_suspect_stands_out(&suspects->items[i]);
    return count;
}

/* Adds what the night did not compare: first cases, such as the run lacks, and such as the night before had. */
static void add_lacks(const struct aob_night_told *told, struct aob_text *text, const char *before)
{
    size_t first = count_verdict(told->suspects, AOB_NIGHT_FIRST);
    if (first)
        aob_text_add(text, "%s%zu for the first time", text->size ? before : "", first);
    if (told->missing)
        aob_text_add(text, "%s%zu of %zu cases not measured", text->size ? before : "", told->missing,
                     told->asked);
    if (told->gone)
        aob_text_add(text, "%s%zu of the night before not in this one", text->size ? before : "", told->gone);
}

json_t *aob_night_summary(const struct aob_night_told *told)
{
    struct aob_text line = {0};
    json_t *counts = json_object();
    for (size_t r = 0; r < AOB_COUNT(ranks); r++) {
        const char *name = aob_night_verdict_names[ranks[r]];
        size_t count = count_verdict(told->suspects, ranks[r]);
        json_object_set_new(counts, name, json_integer((json_int_t)count));
        if (count)
            aob_text_add(&line, "%s%zu %s", line.size ? ", " : "", count, name);
    }
    if (!line.size)
        aob_text_add(&line, told->suspects->watched ? "nothing changed" : "nothing to compare with");
    add_lacks(told, &line, "; ");
    json_t *summary = json_pack("{s:s, s:i, s:i, s:i, s:i, s:i, s:o}", "line", line.data, "worse",
                                (int)count_outcome(told->suspects, AOB_OUTCOME_WORSE), "open",
                                (int)count_outcome(told->suspects, AOB_OUTCOME_OPEN), "first",
                                (int)count_verdict(told->suspects, AOB_NIGHT_FIRST), "missing",
                                (int)told->missing, "gone", (int)told->gone, "verdicts", counts);
    aob_text_finish(&line);
    return summary;
}

enum aob_exit aob_night_code(const struct aob_night_told *told)
{
    if (count_outcome(told->suspects, AOB_OUTCOME_WORSE))
        return AOB_EXIT_BAD;
    return told->missing || count_outcome(told->suspects, AOB_OUTCOME_OPEN) ? AOB_EXIT_PART : AOB_EXIT_OK;
}

static json_t *item_to_json(const struct aob_night_item *item, enum aob_outcome outcome)
{
    static const char *const outcomes[] = {"good", "worse", "open"};
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:s}", "series", item->line->series,
                     "case", item->line->text, "verdict", aob_night_verdict_names[item->verdict], "outcome",
                     outcomes[outcome], "said", item->said, "before", aob_json_number(item->before_ratio),
                     "after", aob_json_number(item->after_ratio), "beside", aob_json_number(item->beside),
                     "low", aob_json_number(item->low), "high", aob_json_number(item->high), "map",
                     item->map ? item->map : "");
}

static bool write_document(const struct aob_night_told *told, struct aob_error *error)
{
    if (!told->desc->json)
        return true;
    json_t *document = aob_night_summary(told), *cases = json_array();
    for (size_t i = 0; i < told->suspects->count; i++) {
        const struct aob_suspect *s = &told->suspects->items[i];
        struct aob_night_item item = item_of(s);
        if (*s->told.said)
            json_array_append_new(cases, item_to_json(&item, s->told.outcome));
    }
    json_object_set_new(document, "night", json_integer(told->start->id));
    json_object_set_new(document, "date", json_string(told->start->date));
    json_object_set_new(document, "folder", aob_json_text(told->start->folder));
    json_object_set_new(document, "watched", json_integer((json_int_t)told->suspects->watched));
    json_object_set_new(document, "suspects", json_integer((json_int_t)count_suspects(told->suspects)));
    json_object_set_new(document, "cases", cases);
    bool ok = aob_json_write(document, told->desc->json, error);
    json_decref(document);
    return ok;
}

bool aob_night_trend(const struct aob_night_told *told, struct aob_error *error)
{
    struct aob_nights nights = {0};
    struct aob_lines lines = {0};
    char *folder = aob_path_join(told->start->out, "trend");
    const struct aob_lines_ask ask = {.config = told->start->name};
    bool ok = aob_folder_create(folder, error) &&
              aob_nights_read(told->history, told->start->name, &nights, error) &&
              aob_lines_read(told->history, &ask, &lines, error) &&
              aob_trend_write(&(struct aob_trend_desc){&lines, &nights, folder, told->start->name}, error);
    aob_lines_finish(&lines);
    aob_nights_finish(&nights);
    free(folder);
    return ok;
}

/* The summary goes to another place than the night's folder, where links from there lead nowhere. */
static bool write_markdown(const struct aob_night_told *told, const struct aob_night_page *page,
                           struct aob_error *error)
{
    struct aob_night_page unlinked = *page;
    struct aob_text markdown = {0};
    if (!told->desc->markdown)
        return true;
    unlinked.trend = unlinked.run_page = NULL;
    aob_night_page_markdown(&unlinked, &markdown);
    bool ok = aob_file_write(told->desc->markdown, markdown.data, markdown.size, error);
    aob_text_finish(&markdown);
    return ok;
}

/* What was not compared, and what could not be decided: its first cause stands for all, as each case has its own. */
static char *note_of(const struct aob_night_told *told, const struct aob_night_item *items, size_t count)
{
    struct aob_text text = {0};
    size_t open = 0;
    const char *first = "";
    add_lacks(told, &text, "; ");
    for (size_t i = 0; i < count; i++)
        if (items[i].verdict == AOB_NIGHT_OPEN && !open++)
            first = items[i].said;
    if (open)
        aob_text_add(&text, "%s%zu could not be decided: %s", text.size ? "; " : "", open, first);
    return text.data;
}

bool aob_night_tell(const struct aob_night_told *told, struct aob_text *out, struct aob_error *error)
{
    const struct aob_night_start *start = told->start;
    struct aob_night_item *items = AOB_NEW_ARRAY(struct aob_night_item, told->suspects->count + 1);
    size_t count = gather(told->suspects, items);
    char *report = aob_path_join(start->run, "report/index.html"), *absolute = aob_path_absolute(report);
    char *note = note_of(told, items, count);
    const struct aob_night_page page = {.title = start->name,
                                        .date = start->date,
                                        .old_note = note,
                                        .cases = told->suspects->count,
                                        .ok = count_good(told->suspects),
                                        .watched = told->suspects->watched,
                                        .suspects = count_suspects(told->suspects),
                                        .items = items,
                                        .count = count,
                                        .trend = "../trend/index.html",
                                        .run_page = !aob_file_exists(report) ? NULL
                                                    : start->measured        ? absolute
                                                                             : "report/index.html"};
    bool ok = aob_night_page_write(&page, start->folder, error) && write_markdown(told, &page, error) &&
              write_document(told, error);
    aob_night_page_screen(&page, out);
    if (ok && !told->desc->quiet)
        aob_note("nightly: page: %s/index.html", start->folder);
    free(note);
    free(report);
    free(absolute);
    free(items);
    return ok;
}
