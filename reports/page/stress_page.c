#include "stress_page.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "gallery.h"
#include "html.h"
#include "page/texts.h"

/* The document while the page is made of it. Members that are not there are empty texts and lists. */
struct stress_page {
    const json_t *properties, *rows;
    struct aob_gallery gallery; /* a figure for each image */
    struct aob_text text;
};

static const char *text_of(const json_t *object, const char *name)
{
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : "";
}

static double number_of(const json_t *object, const char *name)
{
    return aob_json_to_number(json_object_get(object, name));
}

static void add_escaped(struct stress_page *page, const char *before, const char *text, const char *after)
{
    aob_text_add(&page->text, "%s", before);
    aob_html_escape(&page->text, text);
    aob_text_add(&page->text, "%s", after);
}

/* The row's cell of a property; NULL: it was not asked. */
static const json_t *cell_of(const json_t *row, const char *property)
{
    const json_t *cells = json_object_get(row, "cells"), *cell;
    for (size_t i = 0; (cell = json_array_get(cells, i)); i++)
        if (strcmp(text_of(cell, "property"), property) == 0)
            return cell;
    return NULL;
}

/* What one subject is called: rows that differ in their backend only are one. */
static void name_subject(const json_t *row, struct aob_text *name)
{
    const char *technique = text_of(row, "technique"), *module = text_of(row, "module");
    aob_text_add(name, "%s", *technique ? technique : "instruments");
    if (*module)
        aob_text_add(name, " (%s)", module);
}

static bool same_subject(const json_t *a, const json_t *b)
{
    return strcmp(text_of(a, "technique"), text_of(b, "technique")) == 0 &&
           strcmp(text_of(a, "module"), text_of(b, "module")) == 0;
}

/* Whether the row is the first of its subject. */
static bool leads(const struct stress_page *page, size_t at)
{
    const json_t *row = json_array_get(page->rows, at);
    for (size_t i = 0; i < at; i++)
        if (same_subject(json_array_get(page->rows, i), row))
            return false;
    return true;
}

/* --- Pictures --- */

static void add_picture(struct stress_page *page, const json_t *row, const json_t *cell, const char *out)
{
    struct aob_text file = {0}, title = {0}, image = {0};
    const char *name = text_of(cell, "image"), *dot = strrchr(name, '.');
    aob_text_add(&file, "%.*s", (int)(dot ? (size_t)(dot - name) : strlen(name)), name);
    aob_gallery_plain_name(file.data);
    aob_text_add(&image, "%s/images/%s", out, text_of(cell, "image"));
    name_subject(row, &title);
    aob_text_add(&title, ": %s", text_of(cell, "property"));
    struct aob_figure *figure = AOB_PUSH(page->gallery.figures, page->gallery.count, page->gallery.capacity);
    *figure = (struct aob_figure){.kind = AOB_FIGURE_TRIPTYCH,
                                  .job = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s}", "kind", "triptych",
                                                   "title", title.data, "subtitle", text_of(cell, "reason"),
                                                   "technique_name", "What it drew", "reference_name",
                                                   "What it should be", "limit_group",
                                                   text_of(cell, "property"), "image", image.data)};
    struct aob_text path = {0};
    aob_text_add(&path, "figures/%s.png", file.data);
    figure->file = path.data;
    if (!json_is_true(json_object_get(cell, "compared")))
        json_object_set_new(figure->job, "alone", json_true());
    aob_text_finish(&file);
    aob_text_finish(&title);
    aob_text_finish(&image);
}

static void draw_pictures(struct stress_page *page, const struct aob_stress_page_desc *desc)
{
    const json_t *row, *cell;
    for (size_t r = 0; (row = json_array_get(page->rows, r)); r++)
        for (size_t i = 0; (cell = json_array_get(json_object_get(row, "cells"), i)); i++)
            if (*text_of(cell, "image"))
                add_picture(page, row, cell, desc->out);
    char *plotter = aob_gallery_plotter(desc->program);
    if (page->gallery.count)
        aob_gallery_draw(&page->gallery, plotter, desc->out);
    free(plotter);
}

/* --- Text --- */

static const char *mark_of(const char *outcome)
{
    static const char *const marks[][2] = {
        {"pass", "ok"}, {"fail", "failed"}, {"by definition", "invalid"}, {"n/a", "unsupported"}};
    for (size_t i = 0; i < AOB_COUNT(marks); i++)
        if (strcmp(outcome, marks[i][0]) == 0)
            return marks[i][1];
    return "unsupported";
}

/* The gravest outcome of a subject's rows, which the table shows. */
static const json_t *gravest(const struct stress_page *page, size_t at, const char *property)
{
    static const char *const order[] = {"fail", "by definition", "pass", "n/a"};
    const json_t *first = json_array_get(page->rows, at), *row, *found = NULL;
    size_t rank = AOB_COUNT(order);
    for (size_t r = at; (row = json_array_get(page->rows, r)); r++) {
        const json_t *cell = same_subject(row, first) ? cell_of(row, property) : NULL;
        for (size_t k = 0; cell && k < rank; k++)
            if (strcmp(text_of(cell, "outcome"), order[k]) == 0) {
                found = cell;
                rank = k;
            }
    }
    return found;
}

static void add_mark(struct stress_page *page, size_t at, const char *property)
{
    const json_t *cell = gravest(page, at, property);
    if (!cell) {
        aob_text_add(&page->text, "<td></td>");
        return;
    }
    const char *outcome = text_of(cell, "outcome");
    aob_text_add(&page->text, "<td><a class=\"chip %s\" href=\"#%s-%zu\" title=\"", mark_of(outcome),
                 property, at);
    aob_html_escape(&page->text, text_of(cell, "reason"));
    aob_text_add(&page->text, "\">%s</a></td>", outcome);
}

static void add_matrix(struct stress_page *page)
{
    const json_t *property;
    aob_text_add(&page->text,
                 "<section id=\"table\"><h2>Technique by property</h2>\n<p>A cell shows the gravest "
                 "answer of all backends, and leads to the answers.</p>\n<div class=\"scroll\">"
                 "<table><thead><tr><th><button>property</button></th>");
    for (size_t r = 0; r < json_array_size(page->rows); r++) {
        struct aob_text name = {0};
        if (!leads(page, r))
            continue;
        name_subject(json_array_get(page->rows, r), &name);
        add_escaped(page, "<th><button>", name.data, "</button></th>");
        aob_text_finish(&name);
    }
    aob_text_add(&page->text, "</tr></thead><tbody>\n");
    for (size_t i = 0; (property = json_array_get(page->properties, i)); i++) {
        add_escaped(page, "<tr><td><a href=\"#", text_of(property, "name"), "\">");
        add_escaped(page, "", text_of(property, "name"), "</a> ");
        add_escaped(page, "<small>", text_of(property, "group"), "</small></td>");
        for (size_t r = 0; r < json_array_size(page->rows); r++)
            if (leads(page, r))
                add_mark(page, r, text_of(property, "name"));
        aob_text_add(&page->text, "</tr>\n");
    }
    aob_text_add(&page->text, "</tbody></table></div></section>\n");
}

static void add_number(struct stress_page *page, double value)
{
    if (isfinite(value))
        aob_text_add(&page->text, "<td class=\"n\">%.3g</td>", value);
    else
        aob_text_add(&page->text, "<td class=\"n\">\u2013</td>");
}

static void add_answer(struct stress_page *page, const json_t *row, const json_t *cell, size_t anchor,
                       bool first)
{
    struct aob_text name = {0};
    name_subject(row, &name);
    aob_text_add(&page->text, "<tr");
    if (first)
        aob_text_add(&page->text, " id=\"%s-%zu\"", text_of(cell, "property"), anchor);
    add_escaped(page, "><td>", name.data, "</td>");
    add_escaped(page, "<td>", text_of(row, "backend"), "</td>");
    aob_text_add(&page->text, "<td><span class=\"chip %s\">", mark_of(text_of(cell, "outcome")));
    add_escaped(page, "", text_of(cell, "outcome"), "</span></td>");
    add_number(page, number_of(cell, "worst"));
    add_number(page, number_of(cell, "bound"));
    add_escaped(page, "<td class=\"params\">", text_of(cell, "reason"), "");
    if (strcmp(text_of(cell, "reason"), text_of(cell, "where")) != 0)
        add_escaped(page, "<br><small>", text_of(cell, "where"), "</small>");
    aob_text_add(&page->text, "</td>");
    add_escaped(page, "<td class=\"params\"><code>", text_of(cell, "command"), "</code></td></tr>\n");
    aob_text_finish(&name);
}

/* Answers of one property, the backends of a subject beside each other. */
static void add_answers(struct stress_page *page, const char *property)
{
    const json_t *row;
    aob_text_add(&page->text,
                 "<div class=\"scroll plain\"><table><thead><tr><th>technique</th><th>backend</th>"
                 "<th>outcome</th><th>worst</th><th>bound</th><th>where, or why</th>"
                 "<th>shown again by</th></tr></thead><tbody>\n");
    for (size_t lead = 0; lead < json_array_size(page->rows); lead++) {
        bool first = true;
        if (!leads(page, lead))
            continue;
        for (size_t r = lead; (row = json_array_get(page->rows, r)); r++) {
            const json_t *cell =
                same_subject(row, json_array_get(page->rows, lead)) ? cell_of(row, property) : NULL;
            if (!cell)
                continue;
            add_answer(page, row, cell, lead, first);
            first = false;
        }
    }
    aob_text_add(&page->text, "</tbody></table></div>\n");
}

/* The pictures of a property's cells: drawn in the order of the rows, as draw_pictures added them. */
static void add_pictures(struct stress_page *page, const char *property)
{
    const json_t *row, *cell;
    size_t at = 0;
    aob_text_add(&page->text, "<div class=\"grid\">\n");
    for (size_t r = 0; (row = json_array_get(page->rows, r)); r++)
        for (size_t i = 0; (cell = json_array_get(json_object_get(row, "cells"), i)); i++) {
            const struct aob_figure *figure = *text_of(cell, "image") ? &page->gallery.figures[at++] : NULL;
            if (!figure || strcmp(text_of(cell, "property"), property) != 0)
                continue;
            if (figure->failure)
                add_escaped(page, "<figure><div class=\"missing\">", figure->failure, "</div>");
            else
                add_escaped(page, "<figure><img loading=\"lazy\" alt=\"\" src=\"", figure->file, "\">");
            add_escaped(page, "<figcaption>", text_of(row, "technique"), ", ");
            add_escaped(page, "", text_of(row, "backend"), ": ");
            add_escaped(page, "", text_of(cell, "reason"), "</figcaption></figure>\n");
        }
    aob_text_add(&page->text, "</div>\n");
}

static void add_property(struct stress_page *page, const json_t *property)
{
    const char *name = text_of(property, "name");
    add_escaped(page, "<section id=\"", name, "\"><h3>");
    add_escaped(page, "", name, "</h3>\n<p>");
    add_escaped(page, "", text_of(property, "sentence"), "</p>\n<p class=\"soft\">Measured: ");
    add_escaped(page, "", text_of(property, "measure"), ". Bound: ");
    aob_text_add(&page->text, "%.3g in software, %.3g on a GPU. ", number_of(property, "bound_software"),
                 number_of(property, "bound_gpu"));
    add_escaped(page, "", text_of(property, "bound_reason"), " Source: ");
    add_escaped(page, "", text_of(property, "source"), "</p>\n");
    add_answers(page, name);
    add_pictures(page, name);
    aob_text_add(&page->text, "</section>\n");
}

static void add_devices(struct stress_page *page)
{
    const json_t *row;
    json_t *seen = json_object();
    aob_text_add(&page->text, "<dl class=\"facts\">\n");
    for (size_t r = 0; (row = json_array_get(page->rows, r)); r++) {
        const char *backend = text_of(row, "backend"), *missing = text_of(row, "missing");
        if (!*backend || json_object_get(seen, backend))
            continue;
        json_object_set_new(seen, backend, json_true());
        add_escaped(page, "<dt>", backend, "</dt>");
        add_escaped(page, "<dd>", *missing ? missing : text_of(row, "device"), " ");
        add_escaped(page, "", text_of(row, "driver"), "</dd>\n");
    }
    json_decref(seen);
    aob_text_add(&page->text, "</dl>\n");
}

static void add_head(struct stress_page *page, const json_t *document)
{
    static const char *const words[] = {"pass", "fail", "by definition", "n/a"};
    const json_t *counts = json_object_get(document, "counts");
    aob_text_add(
        &page->text,
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width,initial-scale=1\"><title>aobudget: hard cases</title>\n<style>\n"
        "%s</style></head><body>\n<header><h1>Hard cases</h1>\n<p>Each property is a way in which a "
        "renderer was wrong. A cell passes, fails, is \u201cby definition\u201d where the technique\u2019s "
        "text makes it so, or is not applicable.</p>\n<p>",
        aob_text_page_style);
    for (size_t i = 0; i < AOB_COUNT(words); i++)
        aob_text_add(&page->text, "<span class=\"chip %s\">%lld %s</span> ", mark_of(words[i]),
                     (long long)json_integer_value(json_object_get(counts, words[i])), words[i]);
    aob_text_add(&page->text, "</p>\n");
    add_devices(page);
    aob_text_add(&page->text, "</header><main>\n");
}

bool aob_stress_page_write(const struct aob_stress_page_desc *desc, struct aob_error *error)
{
    struct stress_page page = {.properties = json_object_get(desc->document, "properties"),
                               .rows = json_object_get(desc->document, "rows")};
    const json_t *property;
    page.gallery.folder = "figures";
    draw_pictures(&page, desc);
    add_head(&page, desc->document);
    add_matrix(&page);
    for (size_t i = 0; (property = json_array_get(page.properties, i)); i++)
        add_property(&page, property);
    aob_text_add(&page.text,
                 "</main>\n<footer>The command of a cell asks the same question again; with --out it "
                 "keeps the picture.</footer></body></html>\n");
    char *path = aob_path_join(desc->out, "index.html");
    bool ok = aob_file_write(path, page.text.data, page.text.size, error);
    free(path);
    aob_gallery_finish(&page.gallery);
    aob_text_finish(&page.text);
    return ok;
}
