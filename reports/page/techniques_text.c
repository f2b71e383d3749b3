#include "techniques_text.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "markdown.h"

static void add_cell(struct aob_text *page, const char *text)
{
    aob_text_add(page, " ");
    aob_md_escape(page, *text ? text : "\u2013");
    aob_text_add(page, " |");
}

/* As in `list techniques`: shortest, six digits. */
static void add_value(struct aob_text *page, double value)
{
    if (isfinite(value))
        aob_text_add(page, "%.6g", value);
    else
        aob_text_add(page, "\u2013");
}

static bool is_length(const json_t *param)
{
    return strcmp(aob_member_text(param, "unit"), "scene_units") == 0;
}

static void add_bounds(struct aob_text *page, const json_t *param)
{
    const json_t *choices = json_object_get(param, "choices");
    double initial = aob_member_number(param, "initial");
    if (!json_is_array(choices)) {
        aob_text_add(page, " ");
        add_value(page, initial);
        aob_text_add(page, "%s | ", is_length(param) && initial > 0 ? " m" : "");
        add_value(page, aob_member_number(param, "min"));
        aob_text_add(page, " .. ");
        add_value(page, aob_member_number(param, "max"));
        aob_text_add(page, " |");
        return;
    }
    const char *first = json_string_value(json_array_get(choices, (size_t)initial));
    aob_text_add(page, " ");
    aob_md_code(page, first ? first : "?");
    aob_text_add(page, " |");
    for (size_t i = 0; i < json_array_size(choices); i++) {
        const char *choice = json_string_value(json_array_get(choices, i));
        aob_text_add(page, "%s", i ? ", " : " ");
        aob_md_code(page, choice ? choice : "?");
    }
    aob_text_add(page, " |");
}

static const char *unit_of(const json_t *param)
{
    const char *unit = aob_member_text(param, "unit");
    if (is_length(param))
        return "scene units";
    return strcmp(unit, "none") == 0 || strcmp(unit, "count") == 0 ? "" : unit;
}

static void add_params(struct aob_text *page, const json_t *technique)
{
    static const char *const head[] = {"parameter", "default", "bounds", "unit", "does", NULL};
    const json_t *params = json_object_get(technique, "params");
    if (!json_array_size(params)) {
        aob_text_add(page, "It has no parameters.\n\n");
        return;
    }
    aob_techniques_add_head(page, head);
    for (size_t i = 0; i < json_array_size(params); i++) {
        const json_t *param = json_array_get(params, i);
        aob_text_add(page, "| ");
        aob_md_code(page, aob_member_text(param, "name"));
        aob_text_add(page, " |");
        add_bounds(page, param);
        add_cell(page, unit_of(param));
        add_cell(page, aob_member_text(param, "doc"));
        aob_text_add(page, "\n");
    }
    aob_text_add(page, "\n");
}

static void add_falloff(struct aob_text *page, const json_t *falloff)
{
    bool hard = true;
    for (size_t i = 0; i < json_array_size(falloff); i++)
        hard = hard && json_number_value(json_array_get(falloff, i)) == 1;
    if (hard) {
        aob_text_add(page, "each counts alike (hard cutoff)");
        return;
    }
    aob_text_add(page, "one counts");
    for (size_t i = 0; i < json_array_size(falloff); i++) {
        aob_text_add(page, i ? ", " : " ");
        add_value(page, json_number_value(json_array_get(falloff, i)));
    }
    aob_text_add(page, " at 0, 1/4, 1/2, 3/4 and all of that distance");
}

/* The first case that has one serves, because the definition depends on parameters only. */
static void add_definition(struct aob_text *page, const struct aob_techniques *t, size_t technique)
{
    const json_t *definition = NULL;
    for (size_t s = 0; s < t->rows.section_count && !definition; s++) {
        const struct aob_row *row = aob_techniques_row(t, technique, s);
        definition = row ? json_object_get(row->json, "definition") : NULL;
    }
    aob_text_add(page, "Definition: ");
    if (!json_is_object(definition)) {
        aob_text_add(page, "it claims nothing that could be traced.\n\n");
        return;
    }
    char *radius = aob_member_show(json_object_get(definition, "radius"));
    aob_text_add(page, "directions weighted ");
    aob_text_add(page, strcmp(aob_member_text(definition, "weighting"), "uniform") == 0 ? "evenly"
                                                                                        : "by the cosine");
    aob_text_add(page, ", occluders up to ");
    aob_md_escape(page, radius);
    aob_text_add(page, strcmp(aob_member_text(definition, "distance"), "triangle") == 0
                           ? " scene units away by the nearest point of their triangle; "
                           : " scene units away; ");
    add_falloff(page, json_object_get(definition, "falloff"));
    aob_text_add(page, json_is_true(json_object_get(definition, "mapped")) ? "; the result is mapped.\n\n"
                                                                           : ".\n\n");
    free(radius);
}

static void add_sampling(struct aob_text *page, const json_t *technique)
{
    const char *param = aob_member_text(technique, "sampling");
    const char *sequence = aob_member_text(technique, "sequence");
    if (!*param)
        return;
    aob_text_add(page, "Sampling: ");
    aob_md_code(page, param);
    aob_text_add(page, strcmp(sequence, "independent") == 0
                           ? " counts its samples, independent of each other.\n\n"
                           : " counts its samples, stratified or of low discrepancy.\n\n");
}

static void add_paragraph(struct aob_text *page, const char *before, const char *text)
{
    if (!*text)
        return;
    aob_text_add(page, "%s", before);
    aob_md_escape(page, text);
    aob_text_add(page, "\n\n");
}

static const struct aob_figure *figure_of(const struct aob_techniques *t, const struct aob_row *row)
{
    for (size_t i = 0; row && i < t->gallery.count; i++)
        if (t->gallery.figures[i].row == row)
            return &t->gallery.figures[i];
    return NULL;
}

static void add_missing(struct aob_text *page, const struct aob_row *row, const struct aob_figure *figure)
{
    if (!row)
        aob_text_add(page, "no case with every parameter at its default");
    else if (!aob_row_is_ok(row)) {
        aob_md_escape(page, row->status);
        aob_text_add(page, ", ");
        aob_md_escape(page, row->reason);
    } else if (figure) {
        aob_text_add(page, "the picture was not drawn: ");
        aob_md_escape(page, figure->failure);
    } else
        aob_text_add(page, "the run kept no image");
    aob_text_add(page, "\n\n");
}

static void add_pictures(struct aob_text *page, const struct aob_techniques *t, size_t technique)
{
    const char *name = aob_member_text(json_array_get(t->list, technique), "name");
    for (size_t s = 0; s < t->rows.section_count; s++) {
        const struct aob_row *row = aob_techniques_row(t, technique, s);
        const struct aob_figure *figure = figure_of(t, row);
        if (aob_techniques_is_oracle(t, s))
            continue;
        if (!figure || figure->failure) {
            aob_techniques_add_place(page, t, s);
            aob_text_add(page, ": ");
            add_missing(page, row, figure);
            continue;
        }
        aob_text_add(page, "![");
        aob_md_escape(page, name);
        aob_text_add(page, " on ");
        aob_md_escape(page, row->scene);
        aob_text_add(page, ", ");
        aob_md_escape(page, row->view);
        aob_text_add(page, ": AO, truth and error](");
        aob_md_link(page, figure->file);
        aob_text_add(page, ")\n\n");
    }
}

static void add_ratio(struct aob_text *page, const struct aob_row *row)
{
    if (!isfinite(row->ratio))
        aob_text_add(page, " \u2013 |");
    else if (isfinite(row->ci_low) && isfinite(row->ci_high))
        aob_text_add(page, " %.3f [%.3f, %.3f] |", row->ratio, row->ci_low, row->ci_high);
    else
        aob_text_add(page, " %.3f |", row->ratio);
}

/* The metrics that the table of costs has, of all in store/metric.h. */
static const char *const shown[] = {"rmse", "band_rmse", "bias", "definition_rmse"};

static void add_cost_head(struct aob_text *page)
{
    const char *head[4 + AOB_COUNT(shown)] = {"scene", "cost, x fixed pass", "memory, KiB"};
    for (size_t i = 0; i < AOB_COUNT(shown); i++)
        head[3 + i] = aob_metric_find(shown[i])->title;
    aob_techniques_add_head(page, head);
}

static void add_costs(struct aob_text *page, const struct aob_techniques *t, size_t technique)
{
    add_cost_head(page);
    for (size_t s = 0; s < t->rows.section_count; s++) {
        const struct aob_row *row = aob_techniques_row(t, technique, s);
        if (aob_techniques_is_oracle(t, s) || !row || !aob_row_is_ok(row))
            continue;
        const struct aob_score *own = aob_row_own_score(row);
        aob_text_add(page, "| ");
        aob_techniques_add_place(page, t, s);
        aob_text_add(page, " |");
        add_ratio(page, row);
        aob_md_number(page, row->memory_bytes / 1024, 0);
        for (size_t i = 0; i < AOB_COUNT(shown); i++)
            aob_md_number(page, own ? aob_metric_get(&own->metrics, aob_metric_find(shown[i])) : NAN, 4);
        aob_text_add(page, "\n");
    }
    aob_text_add(page, "\n");
}

static void add_oracle_rows(struct aob_text *page, const struct aob_techniques *t, size_t technique)
{
    static const char *const head[] = {"oracle",         "scene",        "pixels", "RMSE",
                                       "pixels in band", "RMSE in band", "bias",   NULL};
    bool any = false;
    for (size_t s = 0; s < t->rows.section_count; s++) {
        const struct aob_row *row = aob_techniques_row(t, technique, s);
        const json_t *oracle = aob_techniques_oracle(row);
        if (!oracle)
            continue;
        if (!any)
            aob_techniques_add_head(page, head);
        any = true;
        aob_text_add(page, "|");
        add_cell(page, aob_member_text(oracle, "name"));
        aob_text_add(page, " ");
        aob_techniques_add_place(page, t, s);
        aob_text_add(page, " |");
        aob_md_number(page, aob_member_number(oracle, "pixels"), 0);
        aob_md_number(page, aob_member_number(oracle, "rmse"), 4);
        aob_md_number(page, aob_member_number(oracle, "band_pixels"), 0);
        aob_md_number(page, aob_member_number(oracle, "band_rmse"), 4);
        aob_md_number(page, aob_member_number(oracle, "bias"), 4);
        aob_text_add(page, "\n");
    }
    if (any)
        aob_text_add(page, "\n");
}

void aob_techniques_add_technique(struct aob_text *page, const struct aob_techniques *t, size_t technique)
{
    const json_t *info = json_array_get(t->list, technique);
    aob_text_add(page, "## ");
    aob_md_code(page, aob_member_text(info, "name"));
    aob_text_add(page, ": ");
    aob_md_escape(page, aob_member_text(info, "title"));
    aob_text_add(page, "\n\n");
    add_paragraph(page, "Text: ", aob_member_text(info, "citation"));
    add_paragraph(page, "", aob_member_text(info, "summary"));
    add_paragraph(
        page, "Where it departs from its text, or the text leaves it open: ", aob_member_text(info, "notes"));
    add_definition(page, t, technique);
    add_sampling(page, info);
    add_params(page, info);
    add_pictures(page, t, technique);
    add_costs(page, t, technique);
    add_oracle_rows(page, t, technique);
}
