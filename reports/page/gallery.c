#include "gallery.h"
#include "curves.h"
#include "base/memory.h"
#include "base/text.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t aob_gallery_section(const struct aob_gallery *g, const struct aob_row *row)
{
    size_t i = 0;
    while (i < g->section_count &&
           (g->sections[i].run != row->run || strcmp(g->sections[i].scene, row->scene) ||
            strcmp(g->sections[i].view, row->view)))
        i++;
    return i;
}

size_t aob_gallery_technique(const struct aob_gallery *g, const char *name)
{
    size_t i = 0;
    while (i < g->technique_count && strcmp(g->techniques[i], name))
        i++;
    return i;
}

const char *aob_gallery_backend(const struct aob_gallery *g, size_t section)
{
    for (size_t i = 0; i < g->rows->count; i++)
        if (aob_row_is_ok(&g->rows->list[i]) && aob_gallery_section(g, &g->rows->list[i]) == section)
            return g->rows->list[i].backend;
    return "";
}

static void list_sections(struct aob_gallery *g)
{
    for (size_t i = 0; i < g->rows->count; i++) {
        const struct aob_row *row = &g->rows->list[i];
        if (aob_gallery_section(g, row) == g->section_count)
            *AOB_PUSH(g->sections, g->section_count, g->section_capacity) =
                (struct aob_section){row->run, row->scene, row->view};
        if (aob_gallery_technique(g, row->technique) == g->technique_count)
            *AOB_PUSH(g->techniques, g->technique_count, g->technique_capacity) = row->technique;
    }
}

/* Letters, digits and dashes; the rest of a hostile name becomes dashes. */
static void plain_name(char *name)
{
    for (char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_')
            *c = '-';
}

static char *file_name(const struct aob_gallery *g, size_t section, const char *name, const char *end)
{
    struct aob_text text = {0};
    const struct aob_section *s = &g->sections[section];
    aob_text_add(&text, "%.40s-%.40s-%.60s", s->scene, s->view, name);
    plain_name(text.data);
    struct aob_text file = {0};
    aob_text_add(&file, "%s/%04zu-%s%s", g->folder, g->count, text.data, end);
    aob_text_finish(&text);
    return file.data;
}

struct aob_figure *aob_gallery_add(struct aob_gallery *g, enum aob_figure_kind kind, size_t section,
                                   const char *name, const char *end, json_t *job)
{
    static const char *const kinds[] = {"triptych", "map", "split", "height", "vti", "chart"};
    char *file = file_name(g, section, name, end);
    struct aob_figure *figure = AOB_PUSH(g->figures, g->count, g->capacity);
    if (!job) /* a path that is no UTF-8; the figure will say that it has no image */
        job = json_object();
    json_object_set_new(job, "kind", json_string(kinds[kind]));
    *figure = (struct aob_figure){.kind = kind, .section = section, .file = file, .job = job};
    figure->title = aob_member_text(job, "title");
    return figure;
}

/* The smaller the better; without a score a row comes last. */
static double score(const struct aob_row *row)
{
    if (isfinite(row->band_rmse))
        return row->band_rmse;
    return isfinite(row->rmse) ? 1e3 + row->rmse : 1e6;
}

static const struct aob_row *best_row(const struct aob_gallery *g, size_t section, const char *technique)
{
    const char *backend = aob_gallery_backend(g, section);
    const struct aob_row *best = NULL;
    for (size_t i = 0; i < g->rows->count; i++) {
        const struct aob_row *row = &g->rows->list[i];
        if (!aob_row_is_ok(row) || !*row->image || strcmp(row->technique, technique) ||
            strcmp(row->backend, backend) || aob_gallery_section(g, row) != section)
            continue;
        if (!best || score(row) < score(best))
            best = row;
    }
    return best;
}

static void add_fact(struct aob_text *text, const char *name, double value)
{
    if (isfinite(value))
        aob_text_add(text, " \u00b7 %s %s%.4f", name, value < 0 ? "\u2212" : "", fabs(value));
}

static char *facts_of(const struct aob_row *row, const char *label)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s \u00b7 %s", row->scene, row->view);
    if (row->width && row->height)
        aob_text_add(&text, " \u00b7 %d\u00d7%d", row->width, row->height);
    if (*label)
        aob_text_add(&text, " \u00b7 %s", label);
    add_fact(&text, "RMSE", row->rmse);
    add_fact(&text, "RMSE in band", row->band_rmse);
    add_fact(&text, "bias", row->bias);
    add_fact(&text, "p95 |e|", row->p95);
    return text.data;
}

/* A capture's case, or one of a run without a reference. */
static bool has_score(const struct aob_row *row)
{
    return json_is_object(json_object_get(row->json, "error"));
}

static json_t *headings_of(const struct aob_row *row)
{
    static const char *const names[] = {"Definition", "Missing information", "Estimator"};
    const double values[] = {row->definition_rmse, row->missing_rmse, row->estimator_rmse};
    json_t *headings = json_array();
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        json_array_append_new(headings, json_sprintf("%s: RMS %.4f", names[i], values[i]));
    return headings;
}

static struct aob_figure *add_image_figure(struct aob_gallery *g, enum aob_figure_kind kind, size_t section,
                                           const struct aob_row *row, const char *label)
{
    static const char *const ends[] = {".png", "-map.png", "-split.png", "-height.png", ".vti"};
    static const char *const titles[] = {"%s", "%s: AO error", "%s: where the error comes from",
                                         "%s: AO error as height", "%s"};
    char *facts = facts_of(row, label), group[32];
    struct aob_text path = {0}, title = {0}, heading = {0};
    aob_text_add(&title, titles[kind], row->technique);
    aob_text_add(&heading, "Technique: %s", row->technique);
    aob_text_add(&path, "%s/%s", g->rows->runs[row->run].folder, row->image);
    /* One scale to compare techniques by; the landscape has its own, or the best one would be flat. */
    snprintf(group, sizeof group, "%s %zu", kind == AOB_FIGURE_HEIGHT ? "height" : "section", section);
    json_t *job =
        json_pack("{s:s, s:s, s:s, s:s, s:s, s:s}", "title", title.data, "subtitle", facts, "image",
                  path.data, "limit_group", group, "technique_name", heading.data, "reference_name",
                  aob_row_is_captured(row) ? "Reference: screen-space bound" : "Reference: ray-traced");
    if (job && !has_score(row)) {
        json_object_set_new(job, "alone", json_true());
        json_object_del(job, "limit_group");
    }
    if (job && kind == AOB_FIGURE_SPLIT)
        json_object_set_new(job, "parts", headings_of(row));
    struct aob_figure *figure = aob_gallery_add(g, kind, section, row->technique, ends[kind], job);
    figure->row = row;
    aob_text_finish(&path);
    aob_text_finish(&title);
    aob_text_finish(&heading);
    free(facts);
    return figure;
}

static void add_section(struct aob_gallery *g, size_t section)
{
    const struct aob_row *top = NULL;
    for (size_t t = 0; t < g->technique_count; t++) {
        const struct aob_row *row = best_row(g, section, g->techniques[t]);
        if (!row)
            continue;
        add_image_figure(g, AOB_FIGURE_TRIPTYCH, section, row, row->label);
        if (has_score(row))
            add_image_figure(g, AOB_FIGURE_MAP, section, row, row->label);
        if (aob_row_is_split(row))
            add_image_figure(g, AOB_FIGURE_SPLIT, section, row, row->label);
        add_image_figure(g, AOB_FIGURE_VTI, section, row, row->label);
        if (has_score(row) && (!top || score(row) < score(top)))
            top = row;
    }
    if (top)
        add_image_figure(g, AOB_FIGURE_HEIGHT, section, top, top->label);
    aob_curves_add_quality(g, section);
    aob_curves_add_timing(g, section);
}

void aob_gallery_plan(struct aob_gallery *g, const struct aob_rows *rows)
{
    *g = (struct aob_gallery){.rows = rows, .folder = "figures"};
    list_sections(g);
    for (size_t i = 0; i < g->section_count; i++)
        add_section(g, i);
}

static bool is_taken(const struct aob_gallery *g, const char *file)
{
    for (size_t i = 0; i < g->count; i++)
        if (strcmp(g->figures[i].file, file) == 0)
            return true;
    return false;
}

/* Names without a number stay when a technique joins, so a folder under version control changes little. */
static char *lasting_name(const struct aob_gallery *g, const struct aob_row *row)
{
    struct aob_text name = {0}, file = {0};
    aob_text_add(&name, "%.60s-%.40s-%.40s", row->technique, row->scene, row->view);
    plain_name(name.data);
    aob_text_add(&file, "%s/%s.png", g->folder, name.data);
    if (is_taken(g, file.data)) {
        aob_text_finish(&file);
        aob_text_add(&file, "%s/%s-%zu.png", g->folder, name.data, g->count);
    }
    aob_text_finish(&name);
    return file.data;
}

void aob_gallery_plan_triptychs(struct aob_gallery *g, const struct aob_rows *rows,
                                const struct aob_row *const *which, size_t count, const char *folder)
{
    *g = (struct aob_gallery){.rows = rows, .folder = folder};
    list_sections(g);
    for (size_t i = 0; i < count; i++) {
        if (!which[i])
            continue;
        char *file = lasting_name(g, which[i]);
        struct aob_figure *figure =
            add_image_figure(g, AOB_FIGURE_TRIPTYCH, aob_gallery_section(g, which[i]), which[i], "");
        free(figure->file);
        figure->file = file;
    }
}

void aob_gallery_finish(struct aob_gallery *g)
{
    for (size_t i = 0; i < g->count; i++) {
        free(g->figures[i].file);
        free(g->figures[i].failure);
        free(g->figures[i].front);
        json_decref(g->figures[i].job);
    }
    free(g->figures);
    free(g->sections);
    free(g->techniques);
    *g = (struct aob_gallery){0};
}
