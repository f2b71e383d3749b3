/* Words that the page, the Markdown and the screen of a night share; plain text, not escaped. */
#ifndef AOB_REPORTS_TREND_NIGHT_WORDS_H
#define AOB_REPORTS_TREND_NIGHT_WORDS_H
#include "night_page.h"

/* "nightly 2026-11-30". */
void aob_night_words_title(const struct aob_night_page *page, struct aob_text *text);

/* "2 slower, 1 moved", in the order of the items' first; "nothing changed" without an item. */
void aob_night_words_verdict(const struct aob_night_page *page, struct aob_text *text);

/* "120 of 122 cases ok, 118 series watched, 3 stood out". */
void aob_night_words_counts(const struct aob_night_page *page, struct aob_text *text);

/* "+5.2 %": beside the old module where that was measured, else of the levels; "\u2013" where neither is known. */
void aob_night_words_change(const struct aob_night_item *item, char text[32]);

/* "+5.0 % [+4.1 %, +5.9 %]", measured beside the old module; nothing where it was not. */
void aob_night_words_beside(const struct aob_night_item *item, struct aob_text *text);
#endif
