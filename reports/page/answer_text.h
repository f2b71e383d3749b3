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

/* "2 ms, modelled on ps4"; "2 ms of processor time, measured here", by the clock of the row. */
void aob_answer_print_budget(const struct aob_answer *answer, const struct aob_row *row,
                             struct aob_text *text);

/* "Of a frame of 16.7 ms the rest takes 13 ms, and G-buffer and composite take 1.2 (1.1 .. 1.3) ms: ambient occlusion has 2 ms." What
 * is not known is said to be so. */
void aob_answer_print_frame(const struct aob_ask *ask, const struct aob_budget *budget,
                            const struct aob_interval *frame, struct aob_text *text);

/* "corner/front vulkan 480x270 against the truth within 0.5 scene units". */
void aob_answer_print_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                           struct aob_text *text);

/* "all 7 scenes and views, vulkan 480x270 against the truth within 0.5 scene units: 12 settings are in all of them". */
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
