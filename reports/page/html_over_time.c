/* What the cases of a sequence do over time. */
#include "html.h"
#include <stdio.h>
#include "base/memory.h"
#include "over_time.h"

static void add_number(struct aob_text *page, double value)
{
    char decimal[32];
    aob_html_decimal(decimal, value);
    aob_html_number_cell(page, value, decimal);
}

static void add_row(struct aob_text *page, const struct aob_row *row, const json_t *sequence)
{
    char text[32];
    double compared = aob_member_number(sequence, "compared");
    aob_text_add(page, "<tr>");
    aob_html_text_cell(page, "strong", row->technique);
    aob_text_add(page, "<td class=params>");
    aob_html_label(page, row);
    aob_text_add(page, "</td>");
    aob_html_ms(text, row->cost_ms);
    aob_html_number_cell(page, row->cost_ms, text);
    add_number(page, aob_member_number(sequence, "error_mean"));
    add_number(page, aob_member_number(sequence, "flicker"));
    add_number(page, aob_member_number(sequence, "truth_change"));
    snprintf(text, sizeof text, "%.1f\u00a0%%", 100 * compared);
    aob_html_number_cell(page, compared, text);
    aob_text_add(page, "</tr>\n");
}

static const char head[] =
    "<h4>Over time</h4>\n<p class=soft>RMSE is the mean over the frames, each against the truth of its own "
    "time. Flicker is how "
    "much the error changes from frame to frame at one point of a surface (RMS), without the noise of the "
    "truths; "
    "beside it how much the truth itself changes there, and the share of the points that "
    "could be compared: those that the frame before shows too, well within one surface.</p>\n<div "
    "class=\"scroll plain\"><table><thead><tr><th>technique</th><th>case</th><th "
    "class=n>ms</th><th class=n>RMSE, all frames</th><th class=n>flicker</th><th class=n>the truth "
    "changes</th><th "
    "class=n>compared</th></tr></thead><tbody>\n";

void aob_html_over_time(struct aob_text *page, const struct aob_gallery *g, const struct aob_panel *panel)
{
    const struct aob_section *section = &g->rows->sections[panel->section];
    bool any = false;
    for (size_t i = 0; i < section->count; i++) {
        const struct aob_row *row = &g->rows->list[section->rows[i]];
        const json_t *sequence = aob_over_time_of(row, panel->target);
        if (!sequence)
            continue;
        if (!any)
            aob_text_add(page, "%s", head);
        any = true;
        add_row(page, row, sequence);
    }
    aob_text_add(page, any ? "</tbody></table></div>\n" : "");
}
