#include "change_table.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"
#include "parts.h"
#include "reports/page/html.h"

static void add_ratio(struct aob_text *page, double ratio)
{
    char shown[32];
    snprintf(shown, sizeof shown, "%.3f", ratio);
    aob_html_number_cell(page, ratio, shown);
}

static void add_row(struct aob_text *page, const struct aob_trend_change *change)
{
    const struct aob_trend_series *series = change->series;
    double ratio = change->after / change->before;
    char day[11], percent[32];
    aob_trend_day(day, aob_trend_dot_date(series, change->since));
    aob_trend_percent(percent, ratio);
    aob_trend_escaped(page, "<tr><td>", day, "</td>");
    aob_html_number_cell(page, ratio, percent);
    const char *said = change->told == SIZE_MAX ? NULL : series->dots[change->told].point->said;
    aob_text_add(page, "<td>");
    aob_trend_chip(page, (int64_t)change->verdict, said);
    aob_text_add(page, "</td><td class=wrap><a href=#l%" PRId64 ">", series->line->id);
    aob_trend_escaped(page, "", series->line->text, "</a></td>");
    add_ratio(page, change->before);
    add_ratio(page, change->after);
    aob_text_add(page, "<td class=wrap>");
    aob_trend_escaped(page, "", series->line->config, " \u00b7 ");
    aob_trend_escaped(page, "", series->line->class_name, "</td></tr>\n");
}

void aob_trend_change_table(struct aob_text *page, const struct aob_trend_changes *changes)
{
    aob_text_add(page, "<section id=changes><h2>What changed <small>the latest first</small></h2>\n");
    if (!changes->count) {
        aob_text_add(page,
                     "<p>Nothing: each series is at one level, and no night was told of.</p></section>\n");
        return;
    }
    aob_text_add(page, "<p class=soft>Before and after are levels of the "
                       "ratio to the fixed pass.</p>\n<div class=scroll tabindex=0 role=region "
                       "aria-label=changes><table class=cases><thead><tr>"
                       "<th><button>since</button></th><th class=n><button>change</button></th>"
                       "<th><button>verdict</button></th><th><button>series</button></th>"
                       "<th class=n><button>before</button></th><th class=n><button>after</button></th>"
                       "<th><button>config, machine</button></th></tr></thead><tbody>\n");
    for (size_t i = 0; i < changes->count; i++)
        add_row(page, &changes->items[i]);
    aob_text_add(page, "</tbody></table></div></section>\n");
}

static size_t count_series(const struct aob_trend_model *model, const struct aob_trend_calendar *calendar)
{
    size_t count = 0;
    for (size_t i = 0; i < model->count; i++)
        count += model->series[i].calendar == calendar;
    return count;
}

/* How many dots of the calendar's latest night have each verdict. */
static void count_told(const struct aob_trend_model *model, const struct aob_trend_calendar *calendar,
                       size_t told[AOB_NIGHT_VERDICTS])
{
    for (size_t i = 0; i < model->count; i++) {
        const struct aob_trend_series *series = &model->series[i];
        if (series->calendar != calendar || !series->count)
            continue;
        const struct aob_trend_dot *last = &series->dots[series->count - 1];
        if (last->night + 1 == calendar->count && *aob_trend_word(last->point->verdict)->mark)
            told[last->point->verdict]++;
    }
}

static void add_calendar(struct aob_text *page, const struct aob_trend_model *model,
                         const struct aob_trend_changes *changes, const struct aob_trend_calendar *calendar)
{
    size_t told[AOB_NIGHT_VERDICTS] = {0}, all = 0, count = 0;
    char day[11];
    aob_trend_day(day, calendar->nights[calendar->count - 1]->date);
    for (size_t i = 0; i < changes->count; i++)
        count += changes->items[i].series->calendar == calendar;
    aob_trend_escaped(page, "<p class=lead><b>", calendar->name, "</b>, ");
    aob_trend_escaped(page, "latest night ", day, ": ");
    count_told(model, calendar, told);
    for (size_t v = 0; v < AOB_NIGHT_VERDICTS; v++) {
        if (told[v])
            aob_text_add(page, "%s<b>%zu %s</b>", all ? ", " : "", told[v], aob_trend_word((int64_t)v)->word);
        all += told[v];
    }
    size_t series = count_series(model, calendar);
    aob_text_add(page, "%s. In all %zu change%s in %zu series over %zu night%s.</p>\n",
                 all ? "" : "nothing was told of", count, count == 1 ? "" : "s", series, calendar->count,
                 calendar->count == 1 ? "" : "s");
}

void aob_trend_change_lead(struct aob_text *page, const struct aob_trend_model *model,
                           const struct aob_trend_changes *changes)
{
    bool any = false;
    for (size_t i = 0; i < model->calendar_count; i++)
        if (model->calendars[i].count) {
            add_calendar(page, model, changes, &model->calendars[i]);
            any = true;
        }
    if (!any)
        aob_text_add(page, "<p class=lead>The history holds no night yet.</p>\n");
}
