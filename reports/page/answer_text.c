#include "answer_text.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

void aob_three_digits(double value, struct aob_text *text)
{
    aob_text_add(text, fabs(value) >= 999.5 ? "%.0f" : "%.3g", value);
}

static void add_range(double low, double high, struct aob_text *text)
{
    aob_text_add(text, " (");
    aob_three_digits(low, text);
    aob_text_add(text, " .. ");
    aob_three_digits(high, text);
    aob_text_add(text, ")");
}

void aob_interval_print(const struct aob_interval *interval, struct aob_text *text)
{
    if (!isfinite(interval->at)) {
        aob_text_add(text, "-");
        return;
    }
    aob_three_digits(interval->at, text);
    if (isfinite(interval->high))
        add_range(interval->low, interval->high, text);
    else
        aob_text_add(text, " (no interval)");
}

struct aob_interval aob_answer_room(const struct aob_candidate *candidate, double ms)
{
    return (struct aob_interval){ms - candidate->ms, ms - candidate->high, ms - candidate->low};
}

/* Behind "1.1 ms over" or "0.69 ms to spare": the interval, or that it reaches to the other side. */
static void add_ends(const struct aob_interval *room, struct aob_text *text)
{
    bool over = room->at < 0;
    double least = over ? -room->high : room->low, most = over ? -room->low : room->high;
    if (!isfinite(room->low))
        aob_text_add(text, ", but no interval is known");
    else if (least >= 0)
        add_range(fabs(least), most, text); /* never -0 */
    else {
        aob_text_add(text, ", but perhaps ");
        aob_three_digits(-least, text);
        aob_text_add(text, over ? " ms to spare" : " ms over");
    }
}

void aob_answer_print_room(const struct aob_candidate *candidate, double ms, struct aob_text *text)
{
    struct aob_interval room = aob_answer_room(candidate, ms);
    aob_three_digits(fabs(room.at), text);
    aob_text_add(text, room.at < 0 ? " ms over" : " ms to spare");
    add_ends(&room, text);
}

struct aob_answer_pass aob_answer_dearest_pass(const struct aob_row *row, const char *profile)
{
    const json_t *time = json_object_get(row->json, "time"), *pass;
    const json_t *whole = profile ? aob_costs_model(row->json, profile) : time;
    const char *member = profile ? "ms" : aob_costs_member(time);
    struct aob_answer_pass best = {"", NAN, ""};
    size_t i;
    json_array_foreach(json_object_get(whole, "passes"), i, pass)
    {
        double ms = aob_member_number(pass, member);
        if (isfinite(ms) && !(ms <= best.ms))
            best =
                (struct aob_answer_pass){aob_member_text(pass, "name"), ms, aob_member_text(pass, "limit")};
    }
    return best;
}

void aob_answer_print_budget(const struct aob_answer *answer, const struct aob_row *row,
                             struct aob_text *text)
{
    aob_three_digits(answer->ask.ms, text);
    aob_text_add(text, " ms");
    if (answer->ask.profile)
        aob_text_add(text, ", modelled on %s", answer->ask.profile);
    else
        aob_text_add(text, " of %s, measured here", aob_costs_clock(json_object_get(row->json, "time")));
}

static void print_others(const struct aob_interval *frame, struct aob_text *text)
{
    aob_text_add(text, "G-buffer and composite ");
    if (!isfinite(frame->at)) {
        aob_text_add(text, "are not known");
        return;
    }
    aob_text_add(text, "take ");
    aob_interval_print(frame, text);
    aob_text_add(text, " ms");
}

void aob_answer_print_frame(const struct aob_ask *ask, const struct aob_budget *budget,
                            const struct aob_interval *frame, struct aob_text *text)
{
    aob_text_add(text, "Of a frame of ");
    aob_three_digits(budget->frame_ms, text);
    aob_text_add(text, " ms ");
    if (budget->rest_ms > 0) {
        aob_text_add(text, "the rest takes ");
        aob_three_digits(budget->rest_ms, text);
        aob_text_add(text, " ms, and ");
    }
    print_others(frame, text);
    if (!(budget->rest_ms > 0))
        aob_text_add(text, ", and what the rest takes is not said");
    aob_text_add(text, ": ambient occlusion has ");
    aob_three_digits(ask->ms, text);
    aob_text_add(text, " ms.");
}

static void print_target(const struct aob_answer *answer, const struct aob_row *row, size_t target,
                         struct aob_text *text)
{
    char *against = aob_target_say(&answer->rows->targets[target]);
    aob_text_add(text, "%s %dx%d against %s", row->backend, row->width, row->height, against);
    free(against);
}

void aob_answer_print_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                           struct aob_text *text)
{
    aob_text_add(text, "%s/%s ", view->first->scene, view->first->view);
    print_target(answer, view->first, view->target, text);
}

void aob_answer_print_whole(const struct aob_answer *answer, const struct aob_answer_whole *whole,
                            struct aob_text *text)
{
    aob_text_add(text, "all %zu scenes and views, ", whole->views);
    print_target(answer, whole->first, whole->target, text);
    aob_text_add(text, ": %zu setting%s in all of them", whole->count, whole->count == 1 ? " is" : "s are");
}

static void print_case(const struct aob_row *row, struct aob_text *text)
{
    aob_text_add(text, "%s%s%s", row->technique, *row->label ? " " : "", row->label);
}

/* Takes over the text. */
static void push(struct aob_sentences *sentences, struct aob_text *text)
{
    *AOB_PUSH(sentences->items, sentences->count, sentences->capacity) = text->data;
    *text = (struct aob_text){0};
}

void aob_sentences_finish(struct aob_sentences *sentences)
{
    for (size_t i = 0; i < sentences->count; i++)
        free(sentences->items[i]);
    free(sentences->items);
    *sentences = (struct aob_sentences){0};
}

/* "The most accurate case that fits is gtao slices=1: error 0.0123, 1.31 ms (0.9 .. 1.8), 0.69 ms to spare." */
static void say_case(const struct aob_answer *answer, const char *what, const struct aob_candidate *candidate,
                     struct aob_sentences *sentences)
{
    struct aob_text text = {0};
    struct aob_interval cost = {candidate->ms, candidate->low, candidate->high};
    aob_text_add(&text, "%s is ", what);
    print_case(&answer->rows->list[candidate->of], &text);
    aob_text_add(&text, ": error %.4f, ", candidate->error);
    aob_interval_print(&cost, &text);
    aob_text_add(&text, " ms, ");
    aob_answer_print_room(candidate, answer->ask.ms, &text);
    aob_text_add(&text, ".");
    push(sentences, &text);
}

static void say_pass(const struct aob_answer *answer, const struct aob_candidate *candidate,
                     struct aob_sentences *sentences)
{
    struct aob_answer_pass pass =
        aob_answer_dearest_pass(&answer->rows->list[candidate->of], answer->ask.profile);
    struct aob_text text = {0};
    if (!*pass.name)
        return;
    aob_text_add(&text, "Its pass '%s' takes most, ", pass.name);
    aob_three_digits(pass.ms, &text);
    aob_text_add(&text, " ms");
    if (*pass.limit)
        aob_text_add(&text, ", and is limited by %s.", pass.limit);
    else
        aob_text_add(&text, "; a measured time names no resource.");
    push(sentences, &text);
}

/* How the sentences call a case, or a setting in its worst view. */
struct words {
    const char *accurate, *hopeful, *cheap, *least;
};

static void say_choice(const struct aob_answer *answer, const struct aob_candidate *list,
                       const struct aob_choice *choice, const struct words *words,
                       struct aob_sentences *sentences)
{
    if (choice->accurate != AOB_NO_CANDIDATE)
        say_case(answer, words->accurate, &list[choice->accurate], sentences);
    if (choice->hopeful != AOB_NO_CANDIDATE)
        say_case(answer, words->hopeful, &list[choice->hopeful], sentences);
    if (isfinite(answer->ask.error) && choice->cheap != AOB_NO_CANDIDATE)
        say_case(answer, words->cheap, &list[choice->cheap], sentences);
    if (choice->accurate == AOB_NO_CANDIDATE && choice->least != AOB_NO_CANDIDATE) {
        say_case(answer, words->least, &list[choice->least], sentences);
        say_pass(answer, &list[choice->least], sentences);
    }
}

static void say_text(const char *sentence, struct aob_sentences *sentences)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s", sentence);
    push(sentences, &text);
}

static void say_error(const struct aob_answer *answer, const struct aob_choice *choice,
                      struct aob_sentences *sentences)
{
    struct aob_text text = {0};
    if (isinf(answer->ask.error) || choice->cheap != AOB_NO_CANDIDATE)
        return;
    aob_text_add(&text, "Nothing has an error of %g or less.", answer->ask.error);
    push(sentences, &text);
}

void aob_answer_say_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                         struct aob_sentences *sentences)
{
    static const struct words words = {
        "The most accurate case that fits",
        "More accurate, with a point that fits and an upper end that does not,",
        "The cheapest case within the error", "Nothing fits with its upper end: what is nearest"};
    if (!view->count)
        say_text("No case has both this error and this cost.", sentences);
    say_choice(answer, view->list, &view->choice, &words, sentences);
    if (view->count)
        say_error(answer, &view->choice, sentences);
}

void aob_answer_say_whole(const struct aob_answer *answer, const struct aob_answer_whole *whole,
                          struct aob_sentences *sentences)
{
    static const struct words words = {
        "The most accurate setting whose worst view fits",
        "More accurate in its worst view, with a point that fits and an upper end that does not,",
        "The cheapest setting within the error",
        "No setting fits everywhere with its upper end: what is nearest"};
    if (!whole->count)
        say_text("No setting was measured in all of these views.", sentences);
    say_choice(answer, whole->list, &whole->choice, &words, sentences);
    if (whole->count)
        say_error(answer, &whole->choice, sentences);
}
