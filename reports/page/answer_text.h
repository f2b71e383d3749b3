/* Sentences of an answer, for the terminal and for the page. Numbers have three digits, and milliseconds that are too few
 * for them as many as say something. */
#ifndef AOB_REPORTS_PAGE_ANSWER_TEXT_H
#define AOB_REPORTS_PAGE_ANSWER_TEXT_H
#include "answer.h"
#include "base/text.h"

/* "0.0123", "1.31", "1234": three digits, or all before the point. */
void aob_three_digits(double value, struct aob_text *text);

/* "1.31 (0.9 .. 1.8)"; "1.31 (no interval)"; "-" if it is not known. */
void aob_interval_print(const struct aob_interval *interval, struct aob_text *text);

/* What is left of `ms`: the point, its least and its most; below 0 it is an overrun. */
struct aob_interval aob_answer_room(const struct aob_candidate *candidate, double ms);

/* "0.69 ms to spare (0.2 .. 1.1)", "0.69 ms to spare, but perhaps 0.2 ms over", "1.1 ms over (0.4 .. 2)". */
void aob_answer_print_room(const struct aob_candidate *candidate, double ms, struct aob_text *text);

/* The pass of a row that takes most of what is judged; `limit` is the resource that bounds it ("": a measured time names
 * none). */
struct aob_answer_pass {
    const char *name; /* "": not known */
    double ms;
    const char *limit;
};
struct aob_answer_pass aob_answer_dearest_pass(const struct aob_row *row, const char *profile);

/* "2 ms, modelled on ps4"; "2 ms of processor time, measured here", by the clock of the first candidate. */
void aob_answer_print_budget(const struct aob_answer *answer, const struct aob_answer_view *view,
                             struct aob_text *text);

/* "The frame has 16.67 ms: the rest takes 13 ms, G-buffer and composite take 1.2 (1.1 .. 1.3) ms, and ambient occlusion has
 * 2 ms." What is not known is said to be so, where nothing is left how much is over, and of which run, backend and size that is
 * where there are several. The answer's ask must have a budget. */
void aob_answer_print_frame(const struct aob_answer *answer, const struct aob_answer_frame *frame,
                            struct aob_text *text);

/* "2 failed, 1 unsupported"; nothing where all are good. */
void aob_answer_print_lost(const struct aob_answer_cases *cases, struct aob_text *text);

/* "spheres/front vulkan 480x270: none of its 2 cases is good: 2 failed", of a place without a question; "no case that may be
 * chosen is good; not there: 2 failed" where only a `none` or `deferred` is. */
void aob_answer_print_place(const struct aob_answer *answer, const struct aob_answer_place *place,
                            struct aob_text *text);

/* "corner/front vulkan 480x270 against the truth within 0.5 scene units"; where there are several runs, the run before it. */
void aob_answer_print_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                           struct aob_text *text);

/* "all 7 scenes and views, vulkan 480x270 against the truth within 0.5 scene units: 12 settings are in all of them"; "2 of 7
 * scenes and views" where the others have no case to be chosen against that target. */
void aob_answer_print_whole(const struct aob_answer *answer, const struct aob_answer_whole *whole,
                            struct aob_text *text);

/* Sentences, each with its end: what to take, or by how much nothing fits and where that lies. */
struct aob_sentences {
    char **items;
    size_t count, capacity;
};
void aob_answer_say_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                         struct aob_sentences *sentences);
void aob_answer_say_whole(const struct aob_answer *answer, const struct aob_answer_whole *whole,
                          struct aob_sentences *sentences);
void aob_sentences_finish(struct aob_sentences *sentences);
#endif
