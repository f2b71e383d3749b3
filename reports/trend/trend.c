#include "trend.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/table.h"
#include "change_table.h"
#include "chart.h"
#include "page/texts.h"
#include "parts.h"
#include "series.h"
#include "trend/texts.h"

/* A series with the places of its groups: config, class of machine within it, view within that. */
struct entry {
    const struct aob_trend_series *series;
    size_t config, machine, view;
};

static size_t place_of(struct aob_table *names, const char *first, const char *second)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s\x1f%s", first, second);
    size_t place = aob_table_put(names, name.data, names->count);
    aob_text_finish(&name);
    return place;
}

static int compare(const void *a, const void *b)
{
    const struct entry *p = a, *q = b;
    if (p->config != q->config)
        return p->config < q->config ? -1 : 1;
    if (p->machine != q->machine)
        return p->machine < q->machine ? -1 : 1;
    if (p->view != q->view)
        return p->view < q->view ? -1 : 1;
    return (p->series > q->series) - (p->series < q->series);
}

/* Groups stand in the order in which the lines first name them. */
static struct entry *sort_entries(const struct aob_trend_model *model)
{
    struct aob_table machines = {0}, views = {0};
    struct entry *entries = AOB_NEW_ARRAY(struct entry, model->count);
    for (size_t i = 0; i < model->count; i++) {
        const struct aob_line *line = model->series[i].line;
        entries[i] = (struct entry){&model->series[i], model->series[i].calendar->index,
                                    place_of(&machines, line->class_name, ""),
                                    place_of(&views, line->scene, line->view)};
    }
    qsort(entries, model->count, sizeof *entries, compare);
    aob_table_finish(&machines);
    aob_table_finish(&views);
    return entries;
}

/* From which group on an entry is another than the one before it: 0 config, 1 machine, 2 view, 3 none. */
static int differs(const struct entry *entries, size_t i)
{
    if (i == 0 || entries[i].config != entries[i - 1].config)
        return 0;
    if (entries[i].machine != entries[i - 1].machine)
        return 1;
    return entries[i].view != entries[i - 1].view ? 2 : 3;
}

static void open_groups(struct aob_text *page, const struct entry *entry, int from)
{
    const struct aob_line *line = entry->series->line;
    if (from <= 0)
        aob_trend_escaped(page, "<section class=group><h2>", line->config, "</h2>\n");
    if (from <= 1) {
        aob_text_add(page, "<section class=group id=m%zu-%zu>", entry->config, entry->machine);
        aob_trend_escaped(page, "<h3>", line->class_name, "</h3>\n");
    }
    aob_trend_escaped(page, "<section class=group><h4>", line->scene, " \u00b7 ");
    aob_trend_escaped(page, "", line->view, "</h4><div class=grid>\n");
}

static void close_groups(struct aob_text *page, int from)
{
    aob_text_add(page, "</div></section>%s%s\n", from <= 1 ? "</section>" : "",
                 from <= 0 ? "</section>" : "");
}

static void add_charts(struct aob_text *page, const struct entry *entries, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        int from = differs(entries, i);
        if (from < 3 && i)
            close_groups(page, from);
        if (from < 3)
            open_groups(page, &entries[i], from);
        aob_trend_series(page, entries[i].series);
    }
    if (count)
        close_groups(page, 0);
}

static void add_legend(struct aob_text *page)
{
    aob_text_add(page, "<p class=legend>");
    for (int64_t v = 0; v < AOB_NIGHT_VERDICTS; v++) {
        const struct aob_trend_word *word = aob_trend_word(v);
        if (!*word->mark)
            continue;
        aob_trend_chip(page, v, word->meaning);
        aob_text_add(page, " <small>%s</small> ", word->meaning);
    }
    aob_text_add(page, "</p>\n");
}

static void add_navigation(struct aob_text *page, const struct entry *entries, size_t count, size_t changes)
{
    aob_text_add(page, "<nav><a href=#changes>what changed</a>\n");
    for (size_t i = 0; i < count; i++)
        if (differs(entries, i) < 2) {
            aob_text_add(page, "<a href=#m%zu-%zu>", entries[i].config, entries[i].machine);
            aob_trend_escaped(page, "", entries[i].series->line->config, " \u00b7 ");
            aob_trend_escaped(page, "", entries[i].series->line->class_name, "</a>\n");
        }
    aob_text_add(
        page,
        "<a href=#nights>nights</a></nav></header>\n<div class=tools id=tools hidden><label>Filter <input "
        "type=search id=filter placeholder=\"words: technique, view, verdict\" autocomplete=off></label>"
        "<span class=soft role=status><span id=charts>%zu</span> charts, <span id=shown>%zu</span> "
        "changes</span></div>\n<main>\n",
        count, changes);
}

static void add_night(struct aob_text *page, const struct aob_night *night)
{
    aob_trend_escaped(page, "<tr><td>", night->date, "</td>");
    aob_trend_escaped(page, "<td>", night->name, "</td>");
    aob_text_add(page, "<td class=n>%zu</td><td class=n>%zu</td><td>%s</td></tr>\n", night->cases, night->ok,
                 night->whole ? "" : "not ended");
}

static void add_nights(struct aob_text *page, const struct aob_nights *nights)
{
    aob_text_add(
        page,
        "<section id=nights><h2>Nights</h2>\n<details><summary>%zu night%s, the latest first</summary>"
        "<div class=\"scroll plain\" tabindex=0><table><thead><tr><th>began</th><th>config</th>"
        "<th class=n>cases</th><th class=n>ok</th><th></th></tr></thead><tbody>\n",
        nights->count, nights->count == 1 ? "" : "s");
    for (size_t i = nights->count; i-- > 0;)
        add_night(page, &nights->items[i]);
    aob_text_add(page, "</tbody></table></div></details></section>\n");
}

static void make_page(const struct aob_trend_desc *desc, const struct aob_trend_model *model,
                      struct aob_text *page)
{
    struct aob_trend_changes changes = {0};
    struct entry *entries = sort_entries(model);
    aob_trend_changes_find(model, &changes);
    aob_trend_open(page, desc->title ? desc->title : "Trend");
    aob_trend_change_lead(page, model, &changes);
    add_navigation(page, entries, model->count, changes.count);
    aob_trend_change_table(page, &changes);
    for (size_t i = 0; i < model->calendar_count; i++)
        aob_trend_ticks(page, &model->calendars[i]);
    add_legend(page);
    add_charts(page, entries, model->count);
    add_nights(page, desc->nights);
    aob_text_add(
        page,
        "</main>\n<footer>The ratio is the time of a frame divided by that of the fixed pass, measured "
        "beside it; a bar is its 95 %% interval. A line is a level: what the nights have in common "
        "until they shift. It is interrupted where a night is missing.</footer>\n<script>\n%s</script>\n"
        "<script>\n%s</script>\n</body></html>\n",
        aob_text_page_script, aob_text_trend_script);
    free(entries);
    free(changes.items);
}

bool aob_trend_write(const struct aob_trend_desc *desc, struct aob_error *error)
{
    struct aob_trend_model model = {0};
    struct aob_text page = {0};
    aob_trend_model_make(desc->lines, desc->nights, &model);
    make_page(desc, &model, &page);
    char *path = aob_path_join(desc->out, "index.html");
    bool ok = aob_file_write(path, page.data, page.size, error);
    free(path);
    aob_text_finish(&page);
    aob_trend_model_finish(&model);
    return ok;
}
