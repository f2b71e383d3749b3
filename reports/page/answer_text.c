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

void aob_answer_print_budget(const struct aob_answer *answer, const struct aob_answer_view *view,
                             struct aob_text *text)
{
    const struct aob_row *judged = view->count ? &answer->rows->list[view->list[0].of] : view->first;
    aob_three_digits(fmax(view->ms, 0), text);
    aob_text_add(text, " ms");
    if (answer->ask.profile)
        aob_text_add(text, ", modelled on %s", answer->ask.profile);
    else
        aob_text_add(text, " of %s, measured here", aob_costs_clock(json_object_get(judged->json, "time")));
}

static void print_where(const struct aob_answer *answer, const struct aob_row *row, struct aob_text *text)
{
    if (answer->rows->run_count > 1)
        aob_text_add(text, "%s: ", answer->rows->runs[row->run].name);
}

/* As the file has them: rounding could make the rest the whole frame. */
static void print_others(const struct aob_budget *budget, const struct aob_interval *cost,
                         struct aob_text *text)
{
    if (budget->rest_ms > 0)
        aob_text_add(text, "the rest takes %g ms, ", budget->rest_ms);
    else
        aob_text_add(text, "what the rest takes is not said, ");
    aob_text_add(text, "G-buffer and composite ");
    if (!isfinite(cost->at)) {
        aob_text_add(text, "are not known");
        return;
    }
    aob_text_add(text, "take ");
    aob_interval_print(cost, text);
    aob_text_add(text, " ms");
}

void aob_answer_print_frame(const struct aob_answer *answer, const struct aob_answer_frame *frame,
                            struct aob_text *text)
{
    const struct aob_row *first = frame->first;
    print_where(answer, first, text);
    aob_text_add(text, "The frame has %g ms", answer->ask.budget->frame_ms);
    if (answer->frame_count > 1)
        aob_text_add(text, " on %s %dx%d", first->backend, first->width, first->height);
    aob_text_add(text, ": ");
    print_others(answer->ask.budget, &frame->cost, text);
    aob_text_add(text, frame->ms > 0 ? ", and ambient occlusion has "
                                     : ", and nothing is left for ambient occlusion: the frame is ");
    aob_three_digits(fabs(frame->ms), text);
    aob_text_add(text, frame->ms > 0 ? " ms." : " ms over.");
}

void aob_answer_print_lost(const struct aob_answer_cases *cases, struct aob_text *text)
{
    const struct {
        size_t count;
        const char *word;
    } parts[] = {{cases->failed, "failed"},
                 {cases->invalid, "invalid"},
                 {cases->unsupported, "unsupported"},
                 {cases->missing, "missing"}};
    const char *comma = "";
    for (size_t i = 0; i < AOB_COUNT(parts); i++) {
        if (!parts[i].count)
            continue;
        aob_text_add(text, "%s%zu %s", comma, parts[i].count, parts[i].word);
        comma = ", ";
    }
}

static void print_bad(const struct aob_answer_cases *c, struct aob_text *text)
{
    const size_t bad = c->failed + c->invalid + c->unsupported;
    aob_text_add(text, bad == 1 ? "its %zu case is not good: " : "none of its %zu cases is good: ", bad);
    aob_answer_print_lost(c, text);
}

void aob_answer_print_place(const struct aob_answer *answer, const struct aob_answer_place *place,
                            struct aob_text *text)
{
    const struct aob_row *row = place->first;
    struct aob_text lost = {0};
    print_where(answer, row, text);
    aob_text_add(text, "%s/%s %s %dx%d: ", row->scene, row->view, row->backend, row->width, row->height);
    if (!place->cases.ok) {
        print_bad(&place->cases, text);
        return;
    }
    aob_text_add(text, place->candidates
                           ? "no good case that may be chosen has an error against a target that is asked for"
                           : "no case that may be chosen is good");
    aob_answer_print_lost(&place->cases, &lost);
    if (lost.size)
        aob_text_add(text, "; not there: %s", lost.data);
    aob_text_finish(&lost);
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
    print_where(answer, view->first, text);
    aob_text_add(text, "%s/%s ", view->first->scene, view->first->view);
    print_target(answer, view->first, view->target, text);
}

void aob_answer_print_whole(const struct aob_answer *answer, const struct aob_answer_whole *whole,
                            struct aob_text *text)
{
    size_t places = answer->frames[whole->frame].places;
    print_where(answer, whole->first, text);
    if (whole->views == places)
        aob_text_add(text, "all %zu scenes and views, ", places);
    else
        aob_text_add(text, "%zu of %zu scenes and views, ", whole->views, places);
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
                     double ms, struct aob_sentences *sentences)
{
    struct aob_text text = {0};
    struct aob_interval cost = {candidate->ms, candidate->low, candidate->high};
    aob_text_add(&text, "%s is ", what);
    print_case(&answer->rows->list[candidate->of], &text);
    aob_text_add(&text, ": error %.4f, ", candidate->error);
    aob_interval_print(&cost, &text);
    aob_text_add(&text, " ms, ");
    aob_answer_print_room(candidate, ms, &text);
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

/* What the sentences are of: a view or a whole. */
struct said {
    const struct aob_candidate *list;
    const struct aob_choice *choice;
    double ms;
};

static void say_choice(const struct aob_answer *answer, const struct said *said, const struct words *words,
                       struct aob_sentences *sentences)
{
    const struct aob_candidate *list = said->list;
    const struct aob_choice *choice = said->choice;
    if (choice->accurate != AOB_NO_CANDIDATE)
        say_case(answer, words->accurate, &list[choice->accurate], said->ms, sentences);
    if (choice->hopeful != AOB_NO_CANDIDATE)
        say_case(answer, words->hopeful, &list[choice->hopeful], said->ms, sentences);
    if (isfinite(answer->ask.error) && choice->cheap != AOB_NO_CANDIDATE)
        say_case(answer, words->cheap, &list[choice->cheap], said->ms, sentences);
    if (choice->accurate == AOB_NO_CANDIDATE && choice->least != AOB_NO_CANDIDATE) {
        say_case(answer, words->least, &list[choice->least], said->ms, sentences);
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
    say_choice(answer, &(struct said){view->list, &view->choice, view->ms}, &words, sentences);
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
    say_choice(answer, &(struct said){whole->list, &whole->choice, whole->ms}, &words, sentences);
    if (whole->count)
        say_error(answer, &whole->choice, sentences);
}
