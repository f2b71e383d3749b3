#include "budget_table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "reports/page/answer_text.h"

/* Whole cells; a bar that ends within half of one reaches it. */
static int cells(double ms, double budget_ms)
{
    if (!(budget_ms > 0))
        return AOB_BAR_CELLS + 1;
    return (int)fmin(AOB_BAR_CELLS + 1, floor(AOB_BAR_BUDGET * ms / budget_ms + 0.5));
}

void aob_budget_bar(char bar[AOB_BAR_CELLS + 2], double ms, double high, double budget_ms)
{
    int point = cells(ms, budget_ms), end = cells(high, budget_ms);
    for (int cell = 0, at = 0; cell < AOB_BAR_CELLS; cell++) {
        if (cell == AOB_BAR_BUDGET)
            bar[at++] = '|';
        bar[at++] = cell < point ? '#' : cell < end ? '-' : ' ';
    }
    if (end > AOB_BAR_CELLS)
        bar[AOB_BAR_CELLS] = '>';
    bar[AOB_BAR_CELLS + 1] = '\0';
}

/* What a row of the table shows, and how wide its columns are. */
enum { COLUMNS = 3 };
static const char *const heads[COLUMNS] = {"measured, ms", "in frames of none", "modelled, ms"};

struct columns {
    size_t count;
    size_t width[COLUMNS];
};

static void print_cost(const struct aob_answer *answer, const struct aob_answer_view *view, size_t at,
                       size_t column, struct aob_text *text)
{
    const struct aob_row *row = &answer->rows->list[view->list[at].of],
                         *none = aob_answer_none(answer, view, row);
    struct aob_interval costs[COLUMNS] = {aob_costs_measured(row->json),
                                          aob_costs_to_none(row->json, none ? none->json : NULL),
                                          aob_costs_modelled(row->json, answer->ask.profile)};
    aob_interval_print(&costs[column], text);
}

static const char *mark_of(const struct aob_answer_view *view, size_t at)
{
    const struct aob_choice *choice = &view->choice;
    return at == choice->accurate ? "*" : at == choice->hopeful ? "?" : " ";
}

static void print_row(const struct aob_answer *answer, const struct aob_answer_view *view, size_t at,
                      const struct columns *columns, struct aob_text *out)
{
    const struct aob_candidate *candidate = &view->list[at];
    const struct aob_row *row = &answer->rows->list[candidate->of];
    struct aob_text line = {0};
    char bar[AOB_BAR_CELLS + 2];
    aob_budget_bar(bar, candidate->ms, candidate->high, view->ms);
    aob_text_add(&line, "%s %.4f", mark_of(view, at), candidate->error);
    for (size_t i = 0; i < columns->count; i++) {
        struct aob_text cost = {0};
        print_cost(answer, view, at, i, &cost);
        aob_text_add(&line, "  %-*s", (int)columns->width[i], cost.data);
        aob_text_finish(&cost);
    }
    aob_text_add_line(out, "  %s  %s  %s%s%s", line.data, bar, row->technique, *row->label ? " " : "",
                      row->label);
    aob_text_finish(&line);
}

static void print_head(const struct aob_answer_view *view, const struct columns *columns,
                       struct aob_text *out)
{
    struct aob_text line = {0}, ms = {0};
    aob_text_add(&line, "    %-6s", "error");
    for (size_t i = 0; i < columns->count; i++)
        aob_text_add(&line, "  %-*s", (int)columns->width[i], heads[i]);
    aob_three_digits(fmax(view->ms, 0), &ms);
    aob_text_add_line(out, "%s  0%*s ms", line.data, AOB_BAR_BUDGET - 1, ms.data);
    aob_text_finish(&ms);
    aob_text_finish(&line);
}

/* A place of a view's list, for sorting. */
struct shown {
    const struct aob_candidate *candidate;
    size_t at;
};

static int by_cost(const void *a, const void *b)
{
    const struct shown *p = a, *q = b;
    if (p->candidate->ms != q->candidate->ms)
        return p->candidate->ms < q->candidate->ms ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

/* The Pareto set and what is chosen, each once, by rising cost. free() it. */
static struct shown *gather(const struct aob_answer_view *view, size_t *count)
{
    const struct aob_choice *choice = &view->choice;
    const size_t chosen[] = {choice->accurate, choice->hopeful, choice->cheap, choice->least};
    struct shown *shown = AOB_NEW_ARRAY(struct shown, view->front_count + AOB_COUNT(chosen));
    *count = 0;
    for (size_t i = 0; i < view->front_count + AOB_COUNT(chosen); i++) {
        size_t at = i < view->front_count ? view->front[i] : chosen[i - view->front_count];
        bool known = at == AOB_NO_CANDIDATE;
        for (size_t k = 0; k < *count && !known; k++)
            known = shown[k].at == at;
        if (!known)
            shown[(*count)++] = (struct shown){&view->list[at], at};
    }
    qsort(shown, *count, sizeof *shown, by_cost);
    return shown;
}

static struct columns measure_columns(const struct aob_answer *answer, const struct aob_answer_view *view,
                                      const struct shown *shown, size_t count)
{
    struct columns columns = {.count = answer->ask.profile ? COLUMNS : COLUMNS - 1};
    for (size_t i = 0; i < columns.count; i++) {
        columns.width[i] = strlen(heads[i]);
        for (size_t k = 0; k < count; k++) {
            struct aob_text cost = {0};
            print_cost(answer, view, shown[k].at, i, &cost);
            columns.width[i] = cost.size > columns.width[i] ? cost.size : columns.width[i];
            aob_text_finish(&cost);
        }
    }
    return columns;
}

/* The Pareto set and what is chosen. */
static void print_cases(const struct aob_answer *answer, const struct aob_answer_view *view,
                        struct aob_text *out)
{
    size_t count;
    struct shown *shown = gather(view, &count);
    struct columns columns = measure_columns(answer, view, shown, count);
    if (count)
        print_head(view, &columns, out);
    for (size_t i = 0; i < count; i++)
        print_row(answer, view, shown[i].at, &columns, out);
    free(shown);
}

static void print_sentences(const struct aob_sentences *sentences, struct aob_text *out)
{
    for (size_t i = 0; i < sentences->count; i++)
        aob_text_add_line(out, "  %s", sentences->items[i]);
}

static void print_view_head(const struct aob_answer *answer, const struct aob_answer_view *view,
                            struct aob_text *out)
{
    struct aob_text head = {0}, lost = {0};
    size_t fitting = 0;
    for (size_t i = 0; i < view->count; i++)
        fitting += aob_candidate_fit(&view->list[i], view->ms) == AOB_FIT_WHOLE;
    aob_answer_print_view(answer, view, &head);
    aob_text_add(&head, ": %zu of %zu cases fit ", fitting, view->count);
    aob_answer_print_budget(answer, view, &head);
    if (view->unknown)
        aob_text_add(&head, "; of %zu more the cost is not known", view->unknown);
    aob_answer_print_lost(&answer->places[view->place].cases, &lost);
    if (lost.size)
        aob_text_add(&head, "; not there: %s", lost.data);
    aob_text_add_line(out, "%s", head.data);
    aob_text_finish(&head);
    aob_text_finish(&lost);
}

static void print_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                       struct aob_text *out)
{
    struct aob_sentences sentences = {0};
    print_view_head(answer, view, out);
    print_cases(answer, view, out);
    aob_answer_say_view(answer, view, &sentences);
    print_sentences(&sentences, out);
    aob_sentences_finish(&sentences);
}

static void print_whole(const struct aob_answer *answer, const struct aob_answer_whole *whole,
                        struct aob_text *out)
{
    struct aob_sentences sentences = {0};
    struct aob_text head = {0};
    if (whole->views < 2)
        return;
    aob_answer_print_whole(answer, whole, &head);
    aob_text_add_line(out, "%s", head.data);
    aob_answer_say_whole(answer, whole, &sentences);
    print_sentences(&sentences, out);
    aob_sentences_finish(&sentences);
    aob_text_finish(&head);
}

/* Scenes and views of which no case answers, and in one line all that is not there. */
static void print_lost(const struct aob_answer *answer, struct aob_text *out)
{
    const struct aob_answer_cases *c = &answer->cases;
    const struct aob_run *run = &answer->rows->runs[0];
    size_t lost = c->failed + c->invalid + c->unsupported + c->missing;
    struct aob_text text = {0};
    for (size_t i = 0; i < answer->place_count; i++) {
        struct aob_text place = {0};
        if (answer->places[i].questions)
            continue;
        aob_answer_print_place(answer, &answer->places[i], &place);
        aob_text_add_line(out, "%s", place.data);
        aob_text_finish(&place);
    }
    aob_answer_print_lost(c, &text);
    if (run->asked < run->planned)
        aob_text_add_line(out, "a part of the run is judged: %zu of %zu cases were asked for", run->asked,
                          run->planned);
    if (lost)
        aob_text_add_line(out, "%zu of %zu cases are not there: %s", lost, lost + c->ok, text.data);
    else if (!aob_answer_is_whole(answer))
        aob_text_add_line(out, "run.json does not say how many cases were planned: some may not be there");
    aob_text_finish(&text);
}

void aob_budget_table_print(const struct aob_answer *answer, struct aob_text *out)
{
    for (size_t i = 0; i < answer->view_count; i++)
        print_view(answer, &answer->views[i], out);
    for (size_t i = 0; i < answer->whole_count; i++)
        print_whole(answer, &answer->wholes[i], out);
    print_lost(answer, out);
}
