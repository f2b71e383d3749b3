#include "html.h"
#include <math.h>
#include <stdlib.h>
#include "answer_text.h"

/* The first of the runs that has a budget; false: none has. */
static bool find_budget(const struct aob_rows *rows, struct aob_budget *budget)
{
    bool found = false;
    for (size_t i = 0; i < rows->run_count && !found; i++)
        found = aob_budget_from_json(budget, json_object_get(rows->runs[i].info, "budget"));
    return found;
}

static void add_text(struct aob_text *page, const struct aob_text *text)
{
    aob_html_escape(page, text->data ? text->data : "");
}

static void add_interval(struct aob_text *page, const struct aob_interval *interval)
{
    struct aob_text shown = {0};
    aob_interval_print(interval, &shown);
    aob_html_number_cell(page, interval->at, shown.data);
    aob_text_finish(&shown);
}

/* Two thirds of the bar are the budget. Where nothing is left, every bar goes over. */
static double share(double ms, double budget_ms)
{
    return budget_ms > 0 ? fmin(100, 200 * ms / (3 * budget_ms)) : 100;
}

static void add_bar(struct aob_text *page, const struct aob_candidate *candidate, double budget_ms)
{
    aob_text_add(page, "<span class=bar><i style=\"width:%.1f%%\"></i><b style=\"width:%.1f%%\"></b></span>",
                 share(candidate->high, budget_ms), share(candidate->ms, budget_ms));
}

static void add_where(struct aob_text *page, const struct aob_rows *rows, const struct aob_answer_view *view)
{
    const struct aob_row *first = view->first;
    if (rows->run_count > 1)
        aob_html_text_cell(page, "", rows->runs[first->run].name);
    aob_html_text_cell(page, "", first->scene);
    aob_html_text_cell(page, "", first->view);
    aob_text_add(page, "<td>%d\u00d7%d ", first->width, first->height);
    aob_html_escape(page, first->backend);
    aob_text_add(page, "</td>");
}

static void add_chip(struct aob_text *page, enum aob_fit fit)
{
    static const struct {
        const char *class_name, *text;
    } chips[AOB_FIT_COUNT] = {[AOB_FIT_OVER] = {"failed", "over"},
                              [AOB_FIT_POINT] = {"invalid", "its point only"},
                              [AOB_FIT_WHOLE] = {"ok", "fits"}};
    aob_text_add(page, "<span class=\"chip %s\">%s</span> ", chips[fit].class_name, chips[fit].text);
}

/* In one cell, so that the table is no wider than the page: the bar, the verdict, and what is left or lacks. */
static void add_share(struct aob_text *page, const struct aob_candidate *candidate, double budget_ms)
{
    struct aob_text room = {0};
    aob_answer_print_room(candidate, budget_ms, &room);
    aob_text_add(page, "<td class=budget>");
    add_bar(page, candidate, budget_ms);
    add_chip(page, aob_candidate_fit(candidate, budget_ms));
    add_text(page, &room);
    aob_text_add(page, "</td>");
    aob_text_finish(&room);
}

/* What is chosen, else what is nearest. */
static void add_row(struct aob_text *page, const struct aob_answer *answer,
                    const struct aob_answer_view *view)
{
    bool fits = view->choice.accurate != AOB_NO_CANDIDATE;
    const struct aob_candidate *candidate = &view->list[fits ? view->choice.accurate : view->choice.least];
    const struct aob_row *row = &answer->rows->list[candidate->of],
                         *none = aob_answer_none(answer, view, row);
    struct aob_interval measured = aob_costs_measured(row->json),
                        to_none = aob_costs_to_none(row->json, none ? none->json : NULL),
                        modelled = aob_costs_modelled(row->json, answer->ask.profile);
    char error[32];
    aob_html_decimal(error, candidate->error);
    aob_text_add(page, "<tr>");
    add_where(page, answer->rows, view);
    aob_html_text_cell(page, "strong", row->technique);
    aob_text_add(page, "<td class=params>");
    aob_html_label(page, row);
    aob_text_add(page, "</td>");
    aob_html_number_cell(page, candidate->error, error);
    add_share(page, candidate, view->ms);
    add_interval(page, &measured);
    add_interval(page, &to_none);
    if (answer->ask.profile)
        add_interval(page, &modelled);
    aob_text_add(page, "</tr>\n");
}

static void add_head(struct aob_text *page, const struct aob_answer *answer)
{
    aob_text_add(page,
                 "<div class=\"scroll plain\"><table><thead><tr>%s<th>scene</th><th>view</th><th>size</th>"
                 "<th>technique</th><th>case</th><th>error</th><th>of the budget</th>"
                 "<th>measured <small>(ms)</small></th><th>in frames of none</th>",
                 answer->rows->run_count > 1 ? "<th>run</th>" : "");
    if (answer->ask.profile)
        aob_text_add(page, "<th>modelled <small>(ms)</small></th>");
    aob_text_add(page, "</tr></thead><tbody>\n");
}

static void add_sentences(struct aob_text *page, const struct aob_answer *answer,
                          const struct aob_answer_whole *whole)
{
    struct aob_sentences sentences = {0};
    struct aob_text head = {0};
    aob_answer_print_whole(answer, whole, &head);
    aob_answer_say_whole(answer, whole, &sentences);
    aob_text_add(page, "<p>Over ");
    add_text(page, &head);
    aob_text_add(page, ".");
    for (size_t i = 0; i < sentences.count; i++) {
        aob_text_add(page, " ");
        aob_html_escape(page, sentences.items[i]);
    }
    aob_text_add(page, "</p>\n");
    aob_text_finish(&head);
    aob_sentences_finish(&sentences);
}

/* A view whose every case lacks the cost that is judged has no row. */
static void add_unknown(struct aob_text *page, const struct aob_answer *answer,
                        const struct aob_answer_view *view)
{
    struct aob_text head = {0};
    aob_answer_print_view(answer, view, &head);
    aob_text_add(&head, ": of %zu case%s the cost that is judged is not known", view->unknown,
                 view->unknown == 1 ? "" : "s");
    aob_text_add(page, "<p class=soft>");
    add_text(page, &head);
    aob_text_add(page, ".</p>\n");
    aob_text_finish(&head);
}

static void add_target(struct aob_text *page, const struct aob_answer *answer, size_t target)
{
    size_t count = 0;
    for (size_t i = 0; i < answer->view_count; i++)
        count += answer->views[i].target == target && answer->views[i].count;
    aob_html_target_open(page, answer->rows, target, "");
    if (count)
        add_head(page, answer);
    for (size_t i = 0; i < answer->view_count; i++)
        if (answer->views[i].target == target && answer->views[i].count)
            add_row(page, answer, &answer->views[i]);
    aob_text_add(page, count ? "</tbody></table></div>\n"
                             : "<p class=soft>No case has both an error and the cost that is judged.</p>\n");
    for (size_t i = 0; i < answer->view_count; i++)
        if (answer->views[i].target == target && !answer->views[i].count)
            add_unknown(page, answer, &answer->views[i]);
    for (size_t i = 0; i < answer->whole_count; i++)
        if (answer->wholes[i].target == target && answer->wholes[i].views > 1)
            add_sentences(page, answer, &answer->wholes[i]);
    aob_text_add(page, "</div>\n");
}

static void add_frames(struct aob_text *page, const struct aob_answer *answer)
{
    for (size_t i = 0; i < answer->frame_count; i++) {
        struct aob_text said = {0};
        aob_answer_print_frame(answer, &answer->frames[i], &said);
        aob_text_add(page, " ");
        add_text(page, &said);
        aob_text_finish(&said);
    }
}

/* What has no row: scenes and views of which no case answers, and cases that are not there. */
static void add_lost(struct aob_text *page, const struct aob_answer *answer)
{
    struct aob_text lost = {0};
    for (size_t i = 0; i < answer->place_count; i++) {
        struct aob_text place = {0};
        if (answer->places[i].questions)
            continue;
        aob_answer_print_place(answer, &answer->places[i], &place);
        aob_text_add(page, "<p class=soft>");
        add_text(page, &place);
        aob_text_add(page, ".</p>\n");
        aob_text_finish(&place);
    }
    aob_answer_print_lost(&answer->cases, &lost);
    if (lost.size)
        aob_text_add(page, "<p class=soft>Not all cases are there: %s.</p>\n", lost.data);
    aob_text_finish(&lost);
}

static void add_opening(struct aob_text *page, const struct aob_answer *answer)
{
    const struct aob_budget *budget = answer->ask.budget;
    aob_text_add(page, "<section id=budget><h2>Budget <small>");
    aob_html_escape(page, budget->title);
    aob_text_add(page, "</small></h2>\n<p class=soft>Source: ");
    aob_html_escape(page, budget->source);
    aob_text_add(page, ".");
    add_frames(page, answer);
    aob_text_add(page, " A case fits if the upper end of its cost does, ");
    if (budget->device) {
        aob_text_add(page, "as it is modelled on ");
        aob_html_escape(page, budget->device);
    } else
        aob_text_add(page, "as it was measured here");
    aob_text_add(
        page,
        ". For each scene and view the most accurate case that fits is shown, or the nearest where "
        "none does. In a bar the line is the budget, and the pale part reaches to the upper end.</p>\n");
}

void aob_html_budget(struct aob_text *page, const struct aob_rows *rows)
{
    struct aob_budget budget;
    struct aob_answer answer;
    if (!find_budget(rows, &budget))
        return;
    struct aob_ask ask = aob_ask_of(&budget);
    aob_answer_make(&answer, rows, &ask);
    add_opening(page, &answer);
    add_lost(page, &answer);
    for (size_t t = 0; t < rows->target_count; t++)
        add_target(page, &answer, t);
    aob_text_add(page, "</section>\n");
    aob_answer_finish(&answer);
    aob_budget_finish(&budget);
}
