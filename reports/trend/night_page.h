/* What one night says: as a page, as a summary for a pull request, and as one screen. The structs are borrowed, their zero is
 * the default, and a text that is NULL is "". The page escapes whatever comes from a history; the screen shows control
 * characters as escapes. The same structs give the same bytes. */
#ifndef AOB_REPORTS_TREND_NIGHT_PAGE_H
#define AOB_REPORTS_TREND_NIGHT_PAGE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/text.h"
#include "history/line.h"

/* What the night says of one line. */
struct aob_night_item {
    const struct aob_line *line;    /* never NULL */
    const struct aob_point *now;    /* the night's; NULL: the line has none in it */
    const struct aob_point *before; /* the one that it is judged against; NULL: there is none */
    enum aob_night_verdict verdict;
    const char *said;                 /* the verdict as one sentence */
    double before_ratio, after_ratio; /* levels in fixed passes, before and now; 0 or NAN: not known */
    /* Cost of the new module over that of the old one, timed beside each other this night, and its 95 % interval: 1.05 is
     * 5 % dearer. 0 or NAN: not measured again. */
    double beside, low, high;
    const char *map; /* picture of the image's change: MAP.png below the page's folder; "": none */
};

struct aob_night_page {
    const char *title;    /* the heading, such as the config's name; NULL: "Night" */
    const char *date;     /* of the night, "2026-11-30T02:00:00Z" */
    const char *old_note; /* one sentence on what could not be measured beside the old modules, and why */
    size_t cases, ok;     /* of the night */
    size_t watched;       /* lines with enough nights before it to be judged */
    size_t suspects;      /* lines that stood out, and were to be measured again */
    const struct aob_night_item *items; /* what is worth telling, worst first; their order stays */
    size_t count;
    const char *trend, *run_page; /* trend page and page of the run, relative to this page; "": no link */
};

/* Writes index.html into the folder, which is there. False after a line if it cannot. */
bool aob_night_page_write(const struct aob_night_page *page, const char *folder, struct aob_error *error);

/* Adds GitHub's Markdown of at most AOB_NIGHT_MARKDOWN lines: a line with the verdict, a table of what changed, a line of
 * links. Rows that have no room are counted in a line of their own. */
void aob_night_page_markdown(const struct aob_night_page *page, struct aob_text *text);
#define AOB_NIGHT_MARKDOWN 60

/* Adds at most AOB_NIGHT_ROWS lines of at most AOB_NIGHT_COLUMNS characters. Lines that have no room are counted in the last
 * one, and a text that is cut ends in "...". */
void aob_night_page_screen(const struct aob_night_page *page, struct aob_text *text);
#define AOB_NIGHT_ROWS    24
#define AOB_NIGHT_COLUMNS 100
#endif
