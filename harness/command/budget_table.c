#include "budget_table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "reports/page/answer_text.h"

/* Whole cells; a bar that ends within half of one reaches it. */
static int cells(double ms, double budget_ms)
{
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

static void print_column(const struct aob_interval *interval, struct aob_text *line)
{
    struct aob_text text = {0};
    aob_interval_print(interval, &text);
    aob_text_add(line, "  %-22s", text.data);
    aob_text_finish(&text);
}

static const char *mark_of(const struct aob_answer_view *view, size_t at)
{
    const struct aob_choice *choice = &view->choice;
    return at == choice->accurate ? "*" : at == choice->hopeful ? "?" : " ";
}

static void print_row(const struct aob_answer *answer, const struct aob_answer_view *view, size_t at,
                      struct aob_text *out)
{
    const struct aob_candidate *candidate = &view->list[at];
    const struct aob_row *row = &answer->rows->list[candidate->of],
                         *none = aob_answer_none(answer, view, row);
    struct aob_interval measured = aob_costs_measured(row->json),
                        to_none = aob_costs_to_none(row->json, none ? none->json : NULL);
    struct aob_text line = {0};
    char bar[AOB_BAR_CELLS + 2];
    aob_budget_bar(bar, candidate->ms, candidate->high, answer->ask.ms);
    aob_text_add(&line, "%s %.4f", mark_of(view, at), candidate->error);
    print_column(&measured, &line);
    print_column(&to_none, &line);
    if (answer->ask.profile) {
        struct aob_interval modelled = aob_costs_modelled(row->json, answer->ask.profile);
        print_column(&modelled, &line);
    }
    aob_text_add_line(out, "  %s  %s  %s%s%s", line.data, bar, row->technique, *row->label ? " " : "",
                      row->label);
    aob_text_finish(&line);
}

static void print_head(const struct aob_answer *answer, struct aob_text *out)
{
    struct aob_text line = {0};
    aob_text_add(&line, "    %-6s  %-22s  %-22s", "error", "measured, ms", "in frames of none");
    if (answer->ask.profile)
        aob_text_add(&line, "  %-22s", "modelled, ms");
    struct aob_text ms = {0};
    aob_three_digits(answer->ask.ms, &ms);
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

static void print_sentences(const struct aob_sentences *sentences, struct aob_text *out)
{
    for (size_t i = 0; i < sentences->count; i++)
        aob_text_add_line(out, "  %s", sentences->items[i]);
}

static void print_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                       struct aob_text *out)
{
    struct aob_sentences sentences = {0};
    struct aob_text head = {0};
    size_t count, fitting = 0;
    for (size_t i = 0; i < view->count; i++)
        fitting += aob_candidate_fit(&view->list[i], answer->ask.ms) == AOB_FIT_WHOLE;
    aob_answer_print_view(answer, view, &head);
    aob_text_add(&head, ": %zu of %zu cases fit ", fitting, view->count);
    aob_answer_print_budget(answer, view->first, &head);
    if (view->unknown)
        aob_text_add(&head, "; of %zu more the cost is not known", view->unknown);
    aob_text_add_line(out, "%s", head.data);
    struct shown *shown = gather(view, &count);
    if (count)
        print_head(answer, out);
    for (size_t i = 0; i < count; i++)
        print_row(answer, view, shown[i].at, out);
    aob_answer_say_view(answer, view, &sentences);
    print_sentences(&sentences, out);
    aob_sentences_finish(&sentences);
    aob_text_finish(&head);
    free(shown);
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

void aob_budget_table_print(const struct aob_answer *answer, struct aob_text *out)
{
    for (size_t i = 0; i < answer->view_count; i++)
        print_view(answer, &answer->views[i], out);
    for (size_t i = 0; i < answer->whole_count; i++)
        print_whole(answer, &answer->wholes[i], out);
}
