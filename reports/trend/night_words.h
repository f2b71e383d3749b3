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

/* "+5.2 %": of a confirmed change what was measured beside the old module, else how far the levels differ; "\u2013" where
 * that is not known. */
void aob_night_words_change(const struct aob_night_item *item, char text[32]);

/* "+5.0 % [+4.1 %, +5.9 %]", measured beside the old module; nothing where it was not. */
void aob_night_words_beside(const struct aob_night_item *item, struct aob_text *text);

/* "error in band 0.0312 \u2192 0.0340, 1.00 \u2192 1.25 MiB": what of it differs from the point before. */
void aob_night_words_rest(const struct aob_night_item *item, struct aob_text *text);
#endif
