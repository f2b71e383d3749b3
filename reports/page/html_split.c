#include "html.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>

/* The value and, small, its part of the squared error; a perfect image has no parts. */
static void add_part(struct aob_text *page, double value, double square, double whole)
{
    char decimal[32], shown[96];
    double percent = 100 * square / (whole * whole);
    aob_html_decimal(decimal, value);
    if (isfinite(percent))
        snprintf(shown, sizeof shown, "%s <small>%s%.0f\u00a0%%</small>", decimal,
                 percent <= -0.5 ? "\u2212" : "", fabs(percent));
    else
        snprintf(shown, sizeof shown, "%s", decimal);
    aob_html_number_cell(page, value, shown);
}

/* Why the score has no parts. */
static const char *reason_of(const struct aob_score *score)
{
    return json_object_get(score->json, "estimator_rmse") ? "not split: it has no definition to trace"
                                                          : "not split: an older record";
}

static void add_parts(struct aob_text *page, const struct aob_score *score, bool captured)
{
    const struct aob_metrics *m = &score->metrics;
    double d = m->definition_rmse, e = m->estimator_rmse, missing = m->missing_rmse;
    double products = 2 * (m->definition_missing + m->definition_estimator + m->missing_estimator);
    add_part(page, d, d * d, m->rmse);
    if (captured)
        aob_html_text_cell(page, "n", "not known of a capture");
    else
        add_part(page, missing, missing * missing, m->rmse);
    add_part(page, e, e * e, m->rmse);
    add_part(page, products, products, m->rmse);
}

static void add_row(struct aob_text *page, const struct aob_rows *rows, const struct aob_figure *figure)
{
    const struct aob_score *score = figure->score;
    aob_text_add(page, "<tr>");
    aob_html_text_cell(page, "strong", figure->row->technique);
    aob_html_metric_cell(page, aob_metric_find("rmse"), score->metrics.rmse);
    if (aob_score_is_split(score))
        add_parts(page, score, rows->targets[score->target].screen);
    else
        aob_text_add(page, "<td class=soft colspan=4>%s</td>", reason_of(score));
    aob_html_metric_cell(page, aob_metric_find("border_share"), score->metrics.border_share);
    aob_text_add(page, "</tr>\n");
}

/* A head of the table: the metric's title, its sentence when one points at it. */
static void add_column(struct aob_text *page, const char *metric)
{
    const struct aob_metric *m = aob_metric_find(metric);
    aob_text_add(page, "<th class=n title=\"%s\">%s</th>", m->doc, m->title);
}

static void add_columns(struct aob_text *page)
{
    static const char *const parts[] = {"rmse", "definition_rmse", "missing_rmse", "estimator_rmse"};
    aob_text_add(page, "<thead><tr><th>technique</th>");
    for (size_t i = 0; i < AOB_COUNT(parts); i++)
        add_column(page, parts[i]);
    aob_text_add(page, "<th class=n>2\u00a0\u00d7\u00a0covariances</th>");
    add_column(page, "border_share");
    aob_text_add(page, "</tr></thead>\n");
}

void aob_html_split(struct aob_text *page, const struct aob_gallery *g, const struct aob_panel *panel)
{
    const struct aob_figure *figures = &g->figures[panel->first];
    bool any = false;
    for (size_t i = 0; i < panel->count; i++)
        any = any || figures[i].kind == AOB_FIGURE_SPLIT;
    if (!any)
        return;
    aob_text_add(
        page, "<h4>Where the error comes from</h4>\n<p class=soft>RMS of each part and its share of the "
              "squared error, for each technique\u2019s most accurate case, pictured below. The shares "
              "add up to 100 %%; "
              "a negative one means that parts cancel each other.</p>\n<div class=\"scroll plain\"><table>");
    add_columns(page);
    aob_text_add(page, "<tbody>\n");
    for (size_t i = 0; i < panel->count; i++)
        if (figures[i].kind == AOB_FIGURE_TRIPTYCH && figures[i].score)
            add_row(page, g->rows, &figures[i]);
    aob_text_add(page, "</tbody></table></div>\n");
}
