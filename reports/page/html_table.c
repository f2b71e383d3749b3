#include "html.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"

/* One table: the cases against one target. */
struct table {
    const struct aob_rows *rows;
    size_t target;
    bool outputs; /* some case gives more than visibility */
};

static void add_scene(struct aob_text *page, const struct aob_row *row)
{
    aob_html_text_cell(page, "", row->scene);
}

static void add_view(struct aob_text *page, const struct aob_row *row)
{
    aob_html_text_cell(page, "", row->view);
}

static void add_technique(struct aob_text *page, const struct aob_row *row)
{
    aob_html_text_cell(page, "strong", row->technique);
}

static void add_label(struct aob_text *page, const struct aob_row *row)
{
    aob_text_add(page, "<td class=params>");
    aob_html_label(page, row);
    aob_text_add(page, "</td>");
}

static void add_backend(struct aob_text *page, const struct aob_row *row)
{
    aob_html_text_cell(page, "", row->backend);
}

static void add_size(struct aob_text *page, const struct aob_row *row)
{
    char shown[64];
    snprintf(shown, sizeof shown, "%d\u00d7%d", row->width, row->height);
    aob_html_number_cell(page, row->width && row->height ? (double)row->width * row->height : NAN, shown);
}

/* Only the four words of the journal become class names. */
static const char *status_class(const char *status)
{
    static const char *const known[] = {"ok", "unsupported", "invalid", "failed"};
    for (size_t i = 0; i < AOB_COUNT(known); i++)
        if (strcmp(status, known[i]) == 0)
            return known[i];
    return "failed";
}

static void add_status(struct aob_text *page, const struct aob_row *row)
{
    aob_text_add(page, "<td class=status><span class=clip title=\"");
    aob_html_escape(page, row->reason);
    aob_text_add(page, "\"><span class=\"chip %s\">", status_class(row->status));
    aob_html_escape(page, *row->status ? row->status : "unknown");
    aob_text_add(page, "</span>");
    if (*row->reason) {
        aob_text_add(page, " <span class=reason>");
        aob_html_escape(page, row->reason);
        aob_text_add(page, "</span>");
    }
    aob_text_add(page, "</span></td>");
}

static void add_time(struct aob_text *page, const struct aob_row *row)
{
    char ms[32];
    aob_html_ms(ms, row->cost_ms);
    aob_html_number_cell(page, row->cost_ms, ms);
}

static void add_ratio(struct aob_text *page, const struct aob_row *row)
{
    char shown[96];
    bool bounded = isfinite(row->ci_low) && isfinite(row->ci_high);
    snprintf(shown, sizeof shown, bounded ? "%.3f <small>[%.3f, %.3f]</small>" : "%.3f", row->ratio,
             row->ci_low, row->ci_high);
    aob_html_number_cell(page, row->ratio, shown);
}

static void add_memory(struct aob_text *page, const struct aob_row *row)
{
    char shown[32];
    snprintf(shown, sizeof shown, "%.2f", row->memory_bytes / 1048576);
    aob_html_number_cell(page, row->memory_bytes, shown);
}

/* What is no metric; those come behind, the run before where there are several. */
static const struct column {
    const char *name, *unit, *meaning;
    bool number;
    void (*add)(struct aob_text *, const struct aob_row *);
} columns[] = {
    {"scene", "", "", false, add_scene},
    {"view", "", "", false, add_view},
    {"technique", "", "", false, add_technique},
    {"parameters", "", "and run options: what varies among the cases, then what is not at its default", false,
     add_label},
    {"outputs", "", "what the case gives; no pass is laid that none of them reads", false,
     aob_html_outputs_cell},
    {"backend", "", "", false, add_backend},
    {"size", "px", "", true, add_size},
    {"status", "", "with the reason if it is not ok", false, add_status},
    {"time", "ms", "of one frame: processor time, or on a real GPU the device's or wall time", true,
     add_time},
    {"ratio", "95 % interval", "time divided by that of the fixed reference pass", true, add_ratio},
    {"memory", "MiB", "textures of the technique", true, add_memory},
};

static void add_name(struct aob_text *page, const char *name, const char *unit, const char *meaning,
                     bool number)
{
    aob_text_add(page, "<th%s title=\"%s\"><button>%s%s%s%s</button></th>", number ? " class=n" : "", meaning,
                 name, *unit ? " <small>" : "", unit, *unit ? "</small>" : "");
}

static const struct aob_score *score_of(const struct table *table, const struct aob_row *row)
{
    return aob_row_score(row, table->target);
}

/* What has a score has a row in the table of its target; what has none, in all. */
static bool is_in(const struct table *table, const struct aob_row *row)
{
    return !row->score_count || score_of(table, row);
}

/* Columns of nothing but dashes are left out: `shown` has a place for each metric of the table. */
static void find_shown(const struct table *table, bool *shown)
{
    for (size_t i = 0; i < table->rows->count; i++) {
        const struct aob_score *score = score_of(table, &table->rows->list[i]);
        for (size_t k = 0; score && aob_metric_table[k].name; k++)
            shown[k] = shown[k] || isfinite(aob_metric_get(&score->metrics, &aob_metric_table[k]));
    }
}

static bool is_shown(const struct table *table, const struct column *column)
{
    return column->add != aob_html_outputs_cell || table->outputs;
}

static void add_head(struct aob_text *page, const struct table *table, const bool *shown)
{
    aob_text_add(page, "<thead><tr>");
    if (table->rows->run_count > 1)
        add_name(page, "run", "", "", false);
    for (size_t i = 0; i < AOB_COUNT(columns); i++)
        if (is_shown(table, &columns[i]))
            add_name(page, columns[i].name, columns[i].unit, columns[i].meaning, columns[i].number);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        if (shown[m - aob_metric_table])
            add_name(page, m->title, m->unit ? m->unit : "", m->doc, true);
    aob_text_add(page, "</tr></thead>\n");
}

static void add_row(struct aob_text *page, const struct table *table, const bool *shown,
                    const struct aob_row *row)
{
    const struct aob_score *score = score_of(table, row);
    aob_text_add(page, "<tr>");
    if (table->rows->run_count > 1)
        aob_html_text_cell(page, "", table->rows->runs[row->run].name);
    for (size_t i = 0; i < AOB_COUNT(columns); i++)
        if (is_shown(table, &columns[i]))
            columns[i].add(page, row);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        if (shown[m - aob_metric_table])
            aob_html_metric_cell(page, m, score ? aob_metric_get(&score->metrics, m) : NAN);
    aob_text_add(page, "</tr>\n");
}

static void add_table(struct aob_text *page, const struct aob_rows *rows, size_t target)
{
    struct table made = {.rows = rows, .target = target};
    bool shown[64] = {false};
    _Static_assert(sizeof(struct aob_metrics) / sizeof(double) <= sizeof shown, "a place for each metric");
    find_shown(&made, shown);
    for (size_t i = 0; i < rows->count; i++)
        made.outputs = made.outputs || (is_in(&made, &rows->list[i]) && aob_html_gives_more(&rows->list[i]));
    aob_text_add(page, "<div class=scroll><table class=cases>\n");
    add_head(page, &made, shown);
    aob_text_add(page, "<tbody>\n");
    for (size_t i = 0; i < rows->count; i++)
        if (is_in(&made, &rows->list[i]))
            add_row(page, &made, shown, &rows->list[i]);
    aob_text_add(page, "</tbody></table></div>\n");
}

void aob_html_table(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(
        page, "<section id=cases><h2>All cases</h2>\n"
              "<p class=tools><label>Show rows with <input id=filter type=search placeholder=\"gtao vulkan\">"
              "</label> <output id=shown></output> <a href=\"cases.csv\">all of it as cases.csv</a></p>\n");
    for (size_t i = 0; i < rows->target_count; i++) {
        aob_html_target_open(page, rows, i, "");
        add_table(page, rows, i);
        aob_text_add(page, "</div>\n");
    }
    if (!rows->target_count)
        add_table(page, rows, AOB_NO_TARGET);
    aob_text_add(page, "</section>\n");
}
