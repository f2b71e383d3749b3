#include "html.h"
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

/* Why the record's error has no parts. */
static const char *reason_of(const struct aob_row *row)
{
    const json_t *score = json_object_get(row->json, "error");
    if (!json_is_object(score))
        return "no error was measured";
    return json_object_get(score, "estimator_rmse") ? "not split: it has no definition to trace"
                                                    : "not split: an older record";
}

static void add_parts(struct aob_text *page, const struct aob_row *row)
{
    double d = row->definition_rmse, m = row->missing_rmse, e = row->estimator_rmse;
    add_part(page, d, d * d, row->rmse);
    if (aob_row_is_captured(row))
        aob_html_text_cell(page, "n", "not known of a capture");
    else
        add_part(page, m, m * m, row->rmse);
    add_part(page, e, e * e, row->rmse);
    add_part(page, 2 * row->covariance, 2 * row->covariance, row->rmse);
}

static void add_row(struct aob_text *page, const struct aob_row *row)
{
    char shown[32];
    aob_text_add(page, "<tr>");
    aob_html_text_cell(page, "strong", row->technique);
    aob_html_decimal(shown, row->rmse);
    aob_html_number_cell(page, row->rmse, shown);
    if (aob_row_is_split(row))
        add_parts(page, row);
    else
        aob_text_add(page, "<td class=soft colspan=4>%s</td>", reason_of(row));
    aob_html_share_cell(page, row->border_share);
    aob_text_add(page, "</tr>\n");
}

void aob_html_split(struct aob_text *page, const struct aob_gallery *g, size_t section)
{
    bool any = false;
    for (size_t i = 0; i < g->count; i++)
        any = any || (g->figures[i].kind == AOB_FIGURE_SPLIT && g->figures[i].section == section);
    if (!any)
        return;
    aob_text_add(page,
                 "<h3>Where the error comes from</h3>\n<p class=soft>RMS of each part and its share of the "
                 "squared error, for each technique\u2019s most accurate case, pictured below. The shares "
                 "add up to 100 %%; "
                 "a negative one means that parts cancel each other.</p>\n<div class=\"scroll plain\"><table>"
                 "<thead><tr><th>technique</th><th class=n>RMSE</th>"
                 "<th class=n>definition</th><th class=n>missing</th><th class=n>estimator</th>"
                 "<th class=n>2\u00a0\u00d7\u00a0covariances</th><th class=n>border "
                 "<small>%%</small></th></tr></thead>\n<tbody>\n");
    for (size_t i = 0; i < g->count; i++)
        if (g->figures[i].kind == AOB_FIGURE_TRIPTYCH && g->figures[i].section == section)
            add_row(page, g->figures[i].row);
    aob_text_add(page, "</tbody></table></div>\n");
}
