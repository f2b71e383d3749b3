#include "html.h"
#include "base/memory.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void add_head(struct aob_text *page, const struct aob_rows *rows)
{
    static const struct {
        const char *name, *unit, *meaning;
        bool number;
    } columns[] = {
        {"scene", "", "", false},
        {"view", "", "", false},
        {"technique", "", "", false},
        {"parameters", "", "and the run options that are not the same in all cases", false},
        {"backend", "", "", false},
        {"size", "px", "", true},
        {"status", "", "with the reason if it is not ok", false},
        {"time", "ms", "of one frame: processor time, or wall time on a real GPU", true},
        {"ratio", "95 % interval", "time divided by that of the fixed reference pass", true},
        {"RMSE", "", "of visibility, 0 to 1, against the ray-traced reference", true},
        {"RMSE in band", "", "where the reference is occluded at all: visibility below 0.995", true},
        {"bias", "", "mean of technique minus reference: negative is too dark", true},
        {"p95", "", "95th percentile of the absolute error", true},
        {"definition", "RMS", "what the technique does not even try to get right", true},
        {"missing", "RMS", "what the depth buffer does not know", true},
        {"estimator", "RMS", "what the technique could still gain from the same depth buffer", true},
        {"border", "%", "share of the squared error near the edges of the view", true},
        {"FLIP", "", "mean difference that one notices between the two images: 0 none, 1 most", true},
        {"SSIM", "", "mean structural similarity: 1 if the two images are equal", true},
        {"ref. SE", "", "standard error of the reference itself", true},
        {"memory", "MiB", "textures of the technique", true},
    };
    aob_text_add(page, "<thead><tr>%s", rows->run_count > 1 ? "<th><button>run</button></th>" : "");
    for (size_t i = 0; i < AOB_COUNT(columns); i++)
        aob_text_add(page, "<th%s title=\"%s\"><button>%s%s%s%s</button></th>",
                     columns[i].number ? " class=n" : "", columns[i].meaning, columns[i].name,
                     *columns[i].unit ? " <small>" : "", columns[i].unit, *columns[i].unit ? "</small>" : "");
    aob_text_add(page, "</tr></thead>\n");
}

static void add_decimal(struct aob_text *page, double value)
{
    char shown[32];
    aob_html_decimal(shown, value);
    aob_html_number_cell(page, value, shown);
}

static void add_ratio(struct aob_text *page, const struct aob_row *row)
{
    char shown[96];
    bool bounded = isfinite(row->ci_low) && isfinite(row->ci_high);
    snprintf(shown, sizeof shown, bounded ? "%.3f <small>[%.3f, %.3f]</small>" : "%.3f", row->ratio,
             row->ci_low, row->ci_high);
    aob_html_number_cell(page, row->ratio, shown);
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
    aob_text_add(page, "<td class=status><span class=\"chip %s\">", status_class(row->status));
    aob_html_escape(page, *row->status ? row->status : "unknown");
    aob_text_add(page, "</span>");
    if (*row->reason) {
        aob_text_add(page, " <span class=reason>");
        aob_html_escape(page, row->reason);
        aob_text_add(page, "</span>");
    }
    aob_text_add(page, "</td>");
}

static void add_size(struct aob_text *page, const struct aob_row *row)
{
    char shown[64];
    snprintf(shown, sizeof shown, "%d\u00d7%d", row->width, row->height);
    aob_html_number_cell(page, row->width && row->height ? (double)row->width * row->height : NAN, shown);
}

static void add_memory(struct aob_text *page, double bytes)
{
    char shown[32];
    snprintf(shown, sizeof shown, "%.2f", bytes / 1048576);
    aob_html_number_cell(page, bytes, shown);
}

static void add_row(struct aob_text *page, const struct aob_rows *rows, const struct aob_row *row)
{
    char ms[32];
    aob_text_add(page, "<tr>");
    if (rows->run_count > 1)
        aob_html_text_cell(page, "", rows->runs[row->run].name);
    aob_html_text_cell(page, "", row->scene);
    aob_html_text_cell(page, "", row->view);
    aob_html_text_cell(page, "strong", row->technique);
    aob_html_text_cell(page, "params", row->label);
    aob_html_text_cell(page, "", row->backend);
    add_size(page, row);
    add_status(page, row);
    aob_html_ms(ms, row->cost_ms);
    aob_html_number_cell(page, row->cost_ms, ms);
    add_ratio(page, row);
    add_decimal(page, row->rmse);
    add_decimal(page, row->band_rmse);
    add_decimal(page, row->bias);
    add_decimal(page, row->p95);
    add_decimal(page, row->definition_rmse);
    add_decimal(page, row->missing_rmse);
    add_decimal(page, row->estimator_rmse);
    aob_html_share_cell(page, row->border_share);
    add_decimal(page, row->flip);
    add_decimal(page, row->ssim);
    add_decimal(page, row->reference_se);
    add_memory(page, row->memory_bytes);
    aob_text_add(page, "</tr>\n");
}

void aob_html_table(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(
        page, "<section id=cases><h2>All cases</h2>\n"
              "<p class=tools><label>Show rows with <input id=filter type=search placeholder=\"gtao vulkan\">"
              "</label> <output id=shown></output></p>\n<div class=scroll><table id=table>\n");
    add_head(page, rows);
    aob_text_add(page, "<tbody>\n");
    for (size_t i = 0; i < rows->count; i++)
        add_row(page, rows, &rows->list[i]);
    aob_text_add(page, "</tbody></table></div></section>\n");
}
