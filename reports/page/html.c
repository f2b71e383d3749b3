#include "html.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "label.h"

static const char *entity(char c)
{
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

void aob_html_escape(struct aob_text *page, const char *text)
{
    size_t plain = strcspn(text, "&<>\"'");
    aob_text_add_bytes(page, text, plain);
    for (text += plain; *text; text += plain) {
        aob_text_add(page, "%s", entity(*text++));
        plain = strcspn(text, "&<>\"'");
        aob_text_add_bytes(page, text, plain);
    }
}

void aob_html_decimal(char text[32], double value)
{
    snprintf(text, 32, "%s%.4f", value < 0 ? "\u2212" : "", fabs(value));
}

void aob_html_ms(char text[32], double value)
{
    int decimals = value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3;
    snprintf(text, 32, "%.*f", decimals, value);
}

void aob_html_number_cell(struct aob_text *page, double value, const char *shown)
{
    if (isfinite(value))
        aob_text_add(page, "<td class=n data-v=\"%.9g\">%s</td>", value, shown);
    else
        aob_text_add(page, "<td class=n>\u2013</td>");
}

void aob_html_metric_cell(struct aob_text *page, const struct aob_metric *metric, double value)
{
    char shown[32];
    if (metric->whole)
        snprintf(shown, sizeof shown, "%.0f", value);
    else
        aob_html_decimal(shown, value);
    aob_html_number_cell(page, value, shown);
}

void aob_html_text_cell(struct aob_text *page, const char *class_name, const char *text)
{
    aob_text_add(page, *class_name ? "<td class=%s>" : "<td%s>", class_name);
    aob_html_escape(page, text);
    aob_text_add(page, "</td>");
}

void aob_html_label(struct aob_text *page, const struct aob_row *row)
{
    char *full = aob_label_full(row);
    aob_text_add(page, "<span class=clip title=\"");
    aob_html_escape(page, full);
    aob_text_add(page, *row->label || !*full ? "\">" : "\">all at their defaults");
    aob_html_escape(page, row->label);
    aob_text_add(page, "</span>");
    free(full);
}
