#include "gallery_plan.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "curves.h"
#include "over_time.h"

/* Orders the scores of one technique by an output, or with NULL by visibility: the smaller the better, NAN does not take part.
 * A score is NULL where there is no target. The image holds an output's truth against the case's own target only. A score of
 * visibility without a band comes after those that have one. */
static double rank_of(const struct aob_score *score, const struct aob_output_look *look)
{
    if (look)
        return score && score->own ? aob_metric_get(&score->metrics, aob_metric_find(look->metric)) : NAN;
    if (!score)
        return 0;
    if (isfinite(score->metrics.band_rmse))
        return score->metrics.band_rmse;
    return isfinite(score->metrics.rmse) ? 1e3 + score->metrics.rmse : 1e6;
}

/* Has the run what a picture of the row against the panel's target shows: the image, and the truth in it or beside it?
 * Without a target, what a technique has no score of at all is shown alone. */
static bool is_pictured(const struct aob_panel *panel, const struct aob_row *row)
{
    const struct aob_score *score = aob_row_score(row, panel->target);
    if (!aob_row_is_ok(row) || !*row->image)
        return false;
    return panel->target == AOB_NO_TARGET ? !row->score_count : score && (score->own || *score->truth);
}

/* Each technique's best row of the panel, or NULL; free() the list. */
static const struct aob_row **best_rows(const struct aob_rows *rows, const struct aob_panel *panel,
                                        const struct aob_output_look *look)
{
    const struct aob_section *section = &rows->sections[panel->section];
    const struct aob_row **best = AOB_NEW_ARRAY(const struct aob_row *, rows->technique_count);
    bool *scored = AOB_NEW_ARRAY(bool, rows->technique_count);
    for (size_t i = 0; i < section->count; i++) {
        const struct aob_row *row = &rows->list[section->rows[i]], **place = &best[row->technique_place];
        scored[row->technique_place] |= row->score_count > 0;
        if (strcmp(row->backend, section->backend) != 0 || !is_pictured(panel, row))
            continue;
        double own = rank_of(aob_row_score(row, panel->target), look);
        if (!isnan(own) && (!*place || own < rank_of(aob_row_score(*place, panel->target), look)))
            *place = row;
    }
    for (size_t k = 0; k < rows->technique_count; k++)
        if (panel->target == AOB_NO_TARGET && scored[k])
            best[k] = NULL;
    free(scored);
    return best;
}

/* The figures of the output that the picture is of. */
static char *facts_of(const struct aob_rows *rows, const struct aob_row *row, const struct aob_score *score,
                      enum aob_output output, const char *label)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s \u00b7 %s", row->scene, row->view);
    if (row->width && row->height)
        aob_text_add(&text, " \u00b7 %d\u00d7%d", row->width, row->height);
    if (*label)
        aob_text_add(&text, " \u00b7 %s", label);
    if (score) {
        char *target = aob_target_say(&rows->targets[score->target]);
        aob_text_add(&text, " \u00b7 against %s", target);
        free(target);
        aob_metrics_print_brief(&score->metrics, 1u << output, " \u00b7 ", &text);
    }
    return text.data;
}

static json_t *headings_of(const struct aob_score *score)
{
    const struct aob_metrics *m = &score->metrics;
    return json_pack("[o, o, o]", json_sprintf("Definition: RMS %.4f", m->definition_rmse),
                     json_sprintf("Missing information: RMS %.4f", m->missing_rmse),
                     json_sprintf("Estimator: RMS %.4f", m->estimator_rmse));
}

static void set_path(json_t *job, const char *name, const char *folder, const char *file)
{
    struct aob_text path = {0};
    aob_text_add(&path, "%s/%s", folder, file);
    json_object_set_new(job, name, json_string(path.data));
    aob_text_finish(&path);
}

/* What the figure compares with, and the colours it shares. */
static void set_truth(json_t *job, const struct aob_rows *rows, const struct aob_panel *panel,
                      enum aob_figure_kind kind, const struct aob_figure *figure)
{
    const struct aob_score *score = figure->score;
    if (!score) {
        json_object_set_new(job, "alone", json_true());
        return;
    }
    /* One scale to compare techniques by; the landscape has its own, or the best one would be flat. */
    json_object_set_new(job, "limit_group",
                        json_sprintf("%s %zu %zu", kind == AOB_FIGURE_HEIGHT ? "height" : "section",
                                     panel->section, score->target));
    json_object_set_new(job, "reference_name",
                        json_string(rows->targets[score->target].screen ? "Reference: screen-space bound"
                                                                        : "Reference: ray-traced"));
    if (!score->own)
        set_path(job, "reference_image", rows->runs[figure->row->run].folder, score->truth);
    if (kind == AOB_FIGURE_SPLIT)
        json_object_set_new(job, "parts", headings_of(score));
}

/* What an image's figure shows: of an output, or with NULL of visibility. */
struct wish {
    enum aob_figure_kind kind;
    const struct aob_output_look *look;
    const struct aob_row *row;
};

static const char *end_of(const struct wish *wish)
{
    static const char *const ends[] = {".png", "-map.png", "-split.png", "-height.png", ".vti"};
    if (!wish->look)
        return ends[wish->kind];
    return wish->kind == AOB_FIGURE_OUTPUT ? wish->look->end : wish->look->map_end;
}

static void add_title(struct aob_text *title, const struct wish *wish)
{
    static const char *const ends[] = {"", ": AO error", ": where the error comes from",
                                       ": AO error as height", ""};
    aob_text_add(title, "%s", wish->row->technique);
    if (!wish->look)
        aob_text_add(title, "%s", ends[wish->kind]);
    else
        aob_text_add(title, ": %s",
                     wish->kind == AOB_FIGURE_OUTPUT ? wish->look->title : wish->look->map_title);
}

/* 0: it is the plotter's choice. The lit image is shown as its FLIP was taken. */
static double exposure_of(const struct aob_output_look *look, const struct aob_score *score)
{
    const struct aob_metric *metric = look->exposed ? aob_metric_find(look->exposed) : NULL;
    return metric && score ? aob_metric_get(&score->metrics, metric) : look->exposure;
}

/* An output's channels and colours; its figures share a scale of their own. */
static void set_look(json_t *job, const struct aob_panel *panel, const struct aob_output_look *look,
                     const struct aob_score *score)
{
    json_object_set_new(job, "error", json_string(look->error));
    json_object_set_new(job, "limit_group",
                        json_sprintf("output %d %zu %zu", look->output, panel->section, panel->target));
    if (look->amount)
        json_object_set_new(job, "amount", json_string(look->amount));
    if (look->quantity)
        json_object_set_new(job, "quantity", json_string(look->quantity));
    if (!look->technique)
        return;
    json_object_set_new(job, "technique", json_string(look->technique));
    json_object_set_new(job, "reference", json_string(look->reference));
    json_object_set_new(job, "reference_name", json_string(look->truth));
    if (look->colour)
        json_object_set_new(job, "colour", json_true());
    if (exposure_of(look, score) > 0)
        json_object_set_new(job, "exposure", json_real(exposure_of(look, score)));
}

static struct aob_figure *add_image(struct aob_gallery *g, const struct aob_panel *panel,
                                    const struct wish *wish, const char *label)
{
    const struct aob_row *row = wish->row;
    const struct aob_score *score = aob_row_score(row, panel->target);
    char *facts = facts_of(g->rows, row, score, wish->look ? wish->look->output : AOB_OUT_VISIBILITY, label);
    struct aob_text title = {0}, heading = {0};
    add_title(&title, wish);
    aob_text_add(&heading, "Technique: %s", row->technique);
    json_t *job =
        json_pack("{s:s, s:s, s:s}", "title", title.data, "subtitle", facts, "technique_name", heading.data);
    struct aob_figure *figure = aob_gallery_add(g, panel, wish->kind, row->technique, end_of(wish), job);
    figure->row = row;
    figure->score = score;
    figure->look = wish->look;
    set_path(figure->job, "image", g->rows->runs[row->run].folder, row->image);
    set_truth(figure->job, g->rows, panel, wish->kind, figure);
    if (wish->look)
        set_look(figure->job, panel, wish->look, score);
    aob_text_finish(&title);
    aob_text_finish(&heading);
    free(facts);
    return figure;
}

static void add_output(struct aob_gallery *g, const struct aob_panel *panel,
                       const struct aob_output_look *look)
{
    const struct aob_row **best = best_rows(g->rows, panel, look);
    for (size_t k = 0; k < g->rows->technique_count; k++) {
        const struct aob_row *row = best[k];
        if (row && look->technique)
            add_image(g, panel, &(struct wish){AOB_FIGURE_OUTPUT, look, row}, row->label);
        if (row)
            add_image(g, panel, &(struct wish){AOB_FIGURE_OUTPUT_MAP, look, row}, row->label);
    }
    free(best);
}

static void add_visibility(struct aob_gallery *g, const struct aob_panel *panel, enum aob_figure_kind kind,
                           const struct aob_row *row)
{
    add_image(g, panel, &(struct wish){.kind = kind, .row = row}, row->label);
}

static void add_images(struct aob_gallery *g, const struct aob_panel *panel)
{
    const struct aob_row **best = best_rows(g->rows, panel, NULL), *top = NULL;
    for (size_t k = 0; k < g->rows->technique_count; k++) {
        const struct aob_row *row = best[k];
        if (!row)
            continue;
        const struct aob_score *score = aob_row_score(row, panel->target);
        add_visibility(g, panel, AOB_FIGURE_TRIPTYCH, row);
        if (score)
            add_visibility(g, panel, AOB_FIGURE_MAP, row);
        if (score && aob_score_is_split(score))
            add_visibility(g, panel, AOB_FIGURE_SPLIT, row);
        add_visibility(g, panel, AOB_FIGURE_VTI, row);
        if (score && (!top || rank_of(score, NULL) < rank_of(aob_row_score(top, panel->target), NULL)))
            top = row;
    }
    if (top)
        add_visibility(g, panel, AOB_FIGURE_HEIGHT, top);
    for (size_t i = 0; i < AOB_OUTPUT_LOOKS; i++)
        add_output(g, panel, &aob_output_looks[i]);
    free(best);
}

static size_t count_cases(const struct aob_rows *rows, size_t section, size_t target)
{
    size_t count = 0;
    for (size_t i = 0; i < rows->sections[section].count; i++)
        count += aob_row_score(&rows->list[rows->sections[section].rows[i]], target) != NULL;
    return count;
}

static void add_panel(struct aob_gallery *g, size_t section, size_t target)
{
    struct aob_panel panel = {.section = section, .target = target, .first = g->count};
    if (target == AOB_NO_TARGET) {
        aob_curves_add_timing(g, &panel);
        aob_curves_add_cache(g, &panel);
    } else
        panel.cases = count_cases(g->rows, section, target);
    if (panel.cases) {
        aob_curves_add_quality(g, &panel);
        aob_over_time_add(g, &panel);
    }
    if (panel.cases || target == AOB_NO_TARGET)
        add_images(g, &panel);
    panel.count = g->count - panel.first;
    *AOB_PUSH(g->panels, g->panel_count, g->panel_capacity) = panel;
}

void aob_gallery_plan(struct aob_gallery *g, const struct aob_rows *rows)
{
    *g = (struct aob_gallery){.rows = rows, .folder = "figures"};
    for (size_t s = 0; s < rows->section_count; s++) {
        for (size_t t = 0; t < rows->target_count; t++)
            add_panel(g, s, t);
        add_panel(g, s, AOB_NO_TARGET);
    }
}

/* Names without a number stay when a technique joins, so a folder under version control changes little. */
static char *lasting_name(const struct aob_gallery *g, const struct aob_row *row, json_t *taken)
{
    struct aob_text name = {0}, file = {0};
    aob_text_add(&name, "%.60s-%.40s-%.40s", row->technique, row->scene, row->view);
    aob_gallery_plain_name(name.data);
    aob_text_add(&file, "%s/%s.png", g->folder, name.data);
    if (json_object_get(taken, name.data)) {
        aob_text_finish(&file);
        aob_text_add(&file, "%s/%s-%zu.png", g->folder, name.data, g->count);
    }
    json_object_set_new(taken, name.data, json_true());
    aob_text_finish(&name);
    return file.data;
}

void aob_gallery_plan_triptychs(struct aob_gallery *g, const struct aob_rows *rows,
                                const struct aob_row *const *which, size_t count, const char *folder)
{
    json_t *taken = json_object();
    *g = (struct aob_gallery){.rows = rows, .folder = folder};
    for (size_t i = 0; i < count; i++) {
        if (!which[i])
            continue;
        const struct aob_score *own = aob_row_own_score(which[i]);
        struct aob_panel panel = {.section = which[i]->section, .target = own ? own->target : AOB_NO_TARGET};
        char *file = lasting_name(g, which[i], taken);
        struct aob_figure *figure =
            add_image(g, &panel, &(struct wish){.kind = AOB_FIGURE_TRIPTYCH, .row = which[i]}, "");
        free(figure->file);
        figure->file = file;
    }
    json_decref(taken);
}
