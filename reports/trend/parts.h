/* What the pages of this room share: their frame, and how they write verdicts, days and per cents. */
#ifndef AOB_REPORTS_TREND_PARTS_H
#define AOB_REPORTS_TREND_PARTS_H
#include <stdint.h>
#include "base/text.h"
#include "history/line.h"

/* How a verdict is shown to people. */
struct aob_trend_word {
    const char *word; /* "slower" */
    const char *mark; /* name of its class and, behind "m-", of its mark in charts; "": it has none there */
    const char *meaning; /* a sentence for the legend */
};

/* Of any number that a history may hold: one that is no verdict is AOB_NIGHT_NONE. */
const struct aob_trend_word *aob_trend_word(int64_t verdict);

/* From the doctype to the heading, with the marks that charts and chips use by name; the header stays open. */
void aob_trend_open(struct aob_text *page, const char *title);

/* The word of a verdict as a chip in its colour, with its mark; `said` is what one sees when one points at it. */
void aob_trend_chip(struct aob_text *page, int64_t verdict, const char *said);

/* Between two texts of HTML a text that is escaped; NULL is "". */
void aob_trend_escaped(struct aob_text *page, const char *before, const char *text, const char *after);

/* "2026-11-30" of "2026-11-30T02:00:00Z"; what is shorter stays. */
void aob_trend_day(char day[11], const char *date);

/* "+5.2 %" of 1.052, with a true minus; "\u2013" of what is not above 0 and finite. */
void aob_trend_percent(char text[32], double ratio);
#endif
