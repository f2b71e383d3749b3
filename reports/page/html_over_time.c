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
    "<p class=soft>RMSE is the mean over the frames, each against the truth of its own "
    "time. Flicker is how "
    "much the error changes from frame to frame at one point of a surface (RMS), without the noise of the "
    "truths; "
    "beside it how much the truth itself changes there, and the share of the points that "
    "could be compared: those that the frame before shows too, well within one surface.</p>\n<div "
    "class=\"scroll plain\"><table><thead><tr><th>technique</th><th>case</th><th "
    "class=n>ms</th><th class=n>RMSE, all frames</th><th class=n>flicker</th><th class=n>the truth "
    "changes</th><th "
    "class=n>compared</th></tr></thead><tbody>\n";

static void add_place(struct aob_text *page, const json_t *place)
{
    for (size_t i = 0; i < 3; i++)
        aob_text_add(page, "%s%.4g", i ? ", " : "(", json_number_value(json_array_get(place, i)));
    aob_text_add(page, ")");
}

/* Two sequences of one view differ by this. */
static void add_path(struct aob_text *page, const struct aob_row *row)
{
    const json_t *motion = json_object_get(row->json, "motion"),
                 *camera = json_object_get(row->json, "camera");
    static const char *const ends[] = {"eye", "target"};
    bool still = true;
    for (size_t i = 0; i < AOB_COUNT(ends); i++)
        still = still && json_equal(json_object_get(motion, ends[i]), json_object_get(camera, ends[i]));
    if (still) {
        aob_text_add(page, "<p class=soft>The camera is still.</p>\n");
        return;
    }
    aob_text_add(page, "<p class=soft>The camera goes from ");
    add_place(page, json_object_get(motion, "eye"));
    aob_text_add(page, " to ");
    add_place(page, json_object_get(camera, "eye"));
    aob_text_add(page, ", and looks at ");
    add_place(page, json_object_get(motion, "target"));
    aob_text_add(page, " first, at ");
    add_place(page, json_object_get(camera, "target"));
    aob_text_add(page, " in the end.</p>\n");
}

void aob_html_over_time(struct aob_text *page, const struct aob_gallery *g, const struct aob_panel *panel)
{
    const struct aob_section *section = &g->rows->sections[panel->section];
    bool any = false;
    for (size_t i = 0; i < section->count; i++) {
        const struct aob_row *row = &g->rows->list[section->rows[i]];
        const json_t *sequence = aob_over_time_of(row, panel->target);
        if (!sequence)
            continue;
        if (!any) {
            aob_text_add(page, "<h4>Over time</h4>\n");
            add_path(page, row);
            aob_text_add(page, "%s", head);
        }
        any = true;
        add_row(page, row, sequence);
    }
    aob_text_add(page, any ? "</tbody></table></div>\n" : "");
}
