#include "parts.h"
#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "page/texts.h"
#include "reports/page/html.h"
#include "trend/texts.h"

static const struct aob_trend_word words[] = {
    [AOB_NIGHT_NONE] = {"not judged", "", "the levels show it, no night was told"},
    [AOB_NIGHT_FIRST] = {"first", "", "the first night of the series"},
    [AOB_NIGHT_SLOWER] = {"slower", "slower", "confirmed beside the old module"},
    [AOB_NIGHT_FASTER] = {"faster", "faster", "confirmed beside the old module"},
    [AOB_NIGHT_MOVED] = {"moved", "moved", "another image than the night before"},
    [AOB_NIGHT_OUTLIER] = {"outlier", "outlier", "stood out, and did not when it was measured again"},
    [AOB_NIGHT_MACHINE] = {"machine", "machine", "stands out, but the module does not"},
    [AOB_NIGHT_OPEN] = {"open", "open", "stood out, and could not be decided"},
    [AOB_NIGHT_BROKEN] = {"broken", "broken", "ran the night before, and does not any more"},
    [AOB_NIGHT_CHANGED] = {"changed", "changed",
                           "as fast and the same image, with other memory or cache figures"},
    [AOB_NIGHT_FAILING] = {"failing", "open", "failed, and did not run the night before either"},
};
_Static_assert(AOB_COUNT(words) == AOB_NIGHT_VERDICTS, "each verdict has a word");

const struct aob_trend_word *aob_trend_word(int64_t verdict)
{
    return &words[verdict >= 0 && verdict < AOB_NIGHT_VERDICTS ? verdict : AOB_NIGHT_NONE];
}

void aob_trend_escaped(struct aob_text *page, const char *before, const char *text, const char *after)
{
    aob_text_add(page, "%s", before);
    aob_html_escape(page, text ? text : "");
    aob_text_add(page, "%s", after);
}

/* Each verdict has a shape of its own besides its colour. */
static void add_marks(struct aob_text *page)
{
    aob_text_add(page, "<svg width=0 height=0 class=marks aria-hidden=true><defs>"
                       "<path id=m-slower d=\"M0-6 6 5H-6z\"/><path id=m-faster d=\"M0 6 6-5H-6z\"/>"
                       "<path id=m-moved d=\"M0-6 6 0 0 6-6 0z\"/><path id=m-machine d=\"M-5-5H5V5H-5z\"/>"
                       "<path id=m-broken d=\"M-6-3-3-6 0-3 3-6 6-3 3 0 6 3 3 6 0 3-3 6-6 3-3 0z\"/>"
                       "<path id=m-changed d=\"M-1.5-6h3v4.5H6v3H1.5V6h-3V1.5H-6v-3h4.5z\"/><circle "
                       "id=m-open r=5 /><circle id=m-outlier r=3.5 /></defs></svg>\n");
}

void aob_trend_open(struct aob_text *page, const char *title)
{
    aob_trend_escaped(page,
                      "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
                      "content=\"width=device-width,initial-scale=1\">\n<meta name=color-scheme "
                      "content=\"light dark\">\n<title>",
                      title, " \u2013 aobudget</title>\n<style>\n");
    aob_text_add(page, "%s%s</style></head>\n<body>\n", aob_text_page_style, aob_text_trend_style);
    add_marks(page);
    aob_trend_escaped(page, "<header><h1>", title, "</h1>\n");
}

void aob_trend_chip(struct aob_text *page, int64_t verdict, const char *said)
{
    const struct aob_trend_word *word = aob_trend_word(verdict);
    aob_text_add(page, "<span class=\"chip v\"");
    if (said && *said)
        aob_trend_escaped(page, " title=\"", said, "\"");
    aob_text_add(page, ">");
    if (*word->mark)
        aob_text_add(page,
                     "<svg class=\"m %s\" viewBox=\"-7 -7 14 14\" aria-hidden=true><use href=#m-%s /></svg>",
                     word->mark, word->mark);
    aob_text_add(page, "%s</span>", word->word);
}

void aob_trend_day(char day[11], const char *date)
{
    snprintf(day, 11, "%s", date ? date : "");
}

void aob_trend_percent(char text[32], double ratio)
{
    double percent = 100 * (ratio - 1);
    bool less = round(10 * percent) < 0; /* what rounds to 0 is +0.0 */
    if (!(ratio > 0) || !isfinite(ratio))
        snprintf(text, 32, "\u2013");
    else
        snprintf(text, 32, "%s%.*f %%", less ? "\u2212" : "+", fabs(percent) < 99.95 ? 1 : 0, fabs(percent));
}
