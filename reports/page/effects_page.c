#include "effects_page.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "chart_job.h"
#include "html.h"
#include "page/texts.h"

/* The first figure is the set taken, the last the chart; between them is one for each effect that has a picture. */
struct effects_page {
    const struct aob_effects_page_desc *desc;
    const json_t *document, *chosen, *effects;
    struct aob_gallery gallery;
    struct aob_text text;
};

static void add_escaped(struct effects_page *page, const char *before, const char *text, const char *after)
{
    aob_text_add(&page->text, "%s", before);
    aob_html_escape(&page->text, text);
    aob_text_add(&page->text, "%s", after);
}

/* "visibility + half_size", or "nothing". */
static void name_set(const json_t *set, struct aob_text *name)
{
    const json_t *names = json_object_get(set, "effects"), *one;
    for (size_t i = 0; (one = json_array_get(names, i)); i++)
        aob_text_add(name, "%s%s", i ? " + " : "", json_string_value(one));
    if (!json_array_size(names))
        aob_text_add(name, "nothing");
}

/* A capture is compared with its own image, and nothing in that is off. */
static bool is_own(const struct effects_page *page)
{
    return strcmp(aob_member_text(page->document, "reference"), "own") == 0;
}

static const char *off(const struct effects_page *page)
{
    return is_own(page) ? "differs" : "off";
}

/* --- Pictures --- */

static void add_figure(struct effects_page *page, enum aob_figure_kind kind, const char *file, json_t *job)
{
    struct aob_text path = {0};
    aob_text_add(&path, "figures/%s", file);
    *AOB_PUSH(page->gallery.figures, page->gallery.count, page->gallery.capacity) =
        (struct aob_figure){.kind = kind, .file = path.data, .job = job};
}

static void add_picture(struct effects_page *page, const char *file, const char *title, const json_t *set)
{
    char *image = aob_path_join(page->desc->out, aob_member_text(set, "image"));
    struct aob_text name = {0};
    name_set(set, &name);
    json_t *job =
        json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:b, s:f}", "kind", "triptych", "title",
                  title, "subtitle", name.data, "image", image, "technique", "technique.lit", "reference",
                  "reference.lit", "error", "error.lit", "quantity", "the lit image", "reference_name",
                  is_own(page) ? "Full size" : "Reference", "limit_group", "lit", "colour", 1, "exposure",
                  aob_member_number(page->document, "exposure"));
    add_figure(page, AOB_FIGURE_OUTPUT, file, job ? job : json_object());
    aob_text_finish(&name);
    free(image);
}

static bool has_picture(const json_t *set)
{
    return *aob_member_text(set, "image");
}

static void add_pictures(struct effects_page *page)
{
    const json_t *row;
    if (has_picture(page->chosen))
        add_picture(page, "taken.png", "taken", page->chosen);
    for (size_t i = 0; (row = json_array_get(page->effects, i)); i++) {
        const json_t *other = json_object_get(row, "otherwise");
        struct aob_text file = {0}, title = {0};
        aob_text_add(&file, "%s.png", aob_member_text(row, "name"));
        aob_text_add(&title, "%s %s", json_is_true(json_object_get(row, "called")) ? "without" : "with",
                     aob_member_text(row, "name"));
        if (has_picture(other))
            add_picture(page, file.data, title.data, other);
        aob_text_finish(&file);
        aob_text_finish(&title);
    }
}

static json_t *series_of(const char *name, const char *style, int colour, json_t *x, json_t *y)
{
    return json_pack("{s:s, s:s, s:i, s:o, s:o}", "name", name, "style", style, "colour", colour, "x", x, "y",
                     y);
}

/* All sets by cost and error. */
static void add_chart(struct effects_page *page)
{
    json_t *x[2] = {json_array(), json_array()}, *y[2] = {json_array(), json_array()}, *series = json_array();
    const json_t *sets = json_object_get(page->document, "sets"), *set;
    struct aob_span across = AOB_SPAN_EMPTY, up = AOB_SPAN_EMPTY;
    for (size_t i = 0; (set = json_array_get(sets, i)); i++) {
        int taken = json_equal(json_object_get(set, "effects"), json_object_get(page->chosen, "effects"));
        json_array_append(x[taken], json_object_get(set, "ms"));
        json_array_append(y[taken], json_object_get(set, "rmse"));
        aob_span_include(&across, aob_member_number(set, "ms"));
        aob_span_include(&up, aob_member_number(set, "rmse"));
    }
    json_array_append_new(series, series_of("other sets", "points", 0, x[0], y[0]));
    json_array_append_new(series, series_of("taken", "points", 1, x[1], y[1]));
    add_figure(page, AOB_FIGURE_CHART, "sets.svg",
               json_pack("{s:s, s:s, s:o, s:o, s:o}", "kind", "chart", "title", "Sets of effects", "x",
                         aob_chart_axis("time a frame (ms", across, 20), "y",
                         aob_chart_axis("RMSE of the lit image (relative", up, 20), "series", series));
}

static void draw(struct effects_page *page)
{
    add_pictures(page);
    add_chart(page);
    char *plotter = aob_gallery_plotter(page->desc->program);
    aob_gallery_draw(&page->gallery, plotter, page->desc->out);
    free(plotter);
}

/* --- Text --- */

static void add_image(struct effects_page *page, const struct aob_figure *figure, const char *caption)
{
    if (figure->failure)
        add_escaped(page, "<figure><div class=\"missing\">", figure->failure, "</div>");
    else
        add_escaped(page, "<figure><img loading=\"lazy\" alt=\"\" src=\"", figure->file, "\">");
    add_escaped(page, "<figcaption>", caption, "</figcaption></figure>\n");
}

static bool is_sequence(const struct effects_page *page)
{
    return aob_member_number(page->document, "frames") > 0;
}

static void add_cell(struct effects_page *page, const json_t *set, const char *member, double scale)
{
    double value = set ? scale * aob_member_number(set, member) : NAN;
    char shown[32] = "\u2013";
    if (isfinite(value))
        snprintf(shown, sizeof shown, "%.3g", value);
    aob_html_number_cell(&page->text, value, shown);
}

static void add_cells(struct effects_page *page, const json_t *set)
{
    add_cell(page, set, "rmse", 100);
    if (is_sequence(page))
        add_cell(page, set, "flicker", 100);
    add_cell(page, set, "flip", 1);
    add_cell(page, set, "ms", 1);
}

/* The heads of those cells. */
static void add_cell_heads(struct effects_page *page, const char *before)
{
    aob_text_add(&page->text, "<th>%s%s by, %%</th>%s<th>FLIP</th><th>ms</th></tr></thead><tbody>\n", before,
                 off(page), is_sequence(page) ? "<th>flicker, %</th>" : "");
}

static void add_effects(struct effects_page *page)
{
    const json_t *row;
    aob_text_add(&page->text, "<section id=\"effects\"><h2>What the view calls for</h2>\n<div class=\"scroll "
                              "plain\"><table><thead><tr><th>effect</th><th>why</th>");
    add_cell_heads(page, "otherwise ");
    for (size_t i = 0; (row = json_array_get(page->effects, i)); i++) {
        bool called = json_is_true(json_object_get(row, "called"));
        aob_text_add(&page->text, "<tr><td><span class=\"chip %s\">", called ? "ok" : "unsupported");
        add_escaped(page, "", aob_member_text(row, "name"), "</span></td>");
        add_escaped(page, "<td class=\"params\">", aob_member_text(row, "sentence"), "</td>");
        add_cells(page, json_is_object(json_object_get(row, "otherwise")) ? json_object_get(row, "otherwise")
                                                                          : NULL);
        aob_text_add(&page->text, "</tr>\n");
    }
    aob_text_add(&page->text, "</tbody></table></div></section>\n");
}

/* In the order in which they were added. */
static void add_gallery(struct effects_page *page)
{
    const json_t *row;
    size_t at = 0;
    aob_text_add(
        &page->text,
        "<section id=\"pictures\"><h2>What each effect adds to the lit image</h2>\n<p>Each picture is "
        "the lit image of a set, %s, and the difference, at one exposure.</p>\n<div "
        "class=\"grid\">\n",
        is_own(page) ? "the one of full size with all that may be called for" : "the reference");
    if (has_picture(page->chosen))
        add_image(page, &page->gallery.figures[at++], "the set that is taken");
    for (size_t i = 0; (row = json_array_get(page->effects, i)); i++)
        if (has_picture(json_object_get(row, "otherwise")))
            add_image(page, &page->gallery.figures[at++], aob_member_text(row, "sentence"));
    aob_text_add(
        &page->text,
        "</div></section>\n<section id=\"sets\"><h2>All sets by cost and error</h2>\n<div class=\"grid\">");
    add_image(page, &page->gallery.figures[at], "every set that was looked at");
    aob_text_add(&page->text, "</div>\n");
}

static void add_sets(struct effects_page *page)
{
    const json_t *sets = json_object_get(page->document, "sets"), *set;
    aob_text_add(&page->text, "<div class=\"scroll plain\"><table><thead><tr><th>set</th>");
    add_cell_heads(page, "");
    for (size_t i = 0; (set = json_array_get(sets, i)); i++) {
        struct aob_text name = {0};
        name_set(set, &name);
        add_escaped(page, "<tr><td>", name.data, "</td>");
        add_cells(page, set);
        aob_text_add(&page->text, "</tr>\n");
        aob_text_finish(&name);
    }
    aob_text_add(&page->text, "</tbody></table></div></section>\n");
}

static void add_fact(struct effects_page *page, const char *name, const char *value)
{
    add_escaped(page, "<dt>", name, "</dt>");
    add_escaped(page, "<dd>", value, "</dd>\n");
}

static void add_facts(struct effects_page *page)
{
    const json_t *d = page->document, *fingerprint = json_object_get(d, "fingerprint");
    struct aob_text size = {0}, truth = {0};
    aob_text_add(&size, "%.0f x %.0f, ", aob_member_number(d, "width"), aob_member_number(d, "height"));
    if (is_sequence(page))
        aob_text_add(&size, "the last of %.0f frames, ", aob_member_number(d, "frames"));
    aob_text_add(&size, "radius %.4g, light %s", aob_member_number(d, "radius"), aob_member_text(d, "light"));
    aob_text_add(&truth, "the lit image %s; %.0f pixels a side became one for the pictures and FLIP",
                 aob_member_text(d, "against"), aob_member_number(d, "flip_shrink"));
    aob_text_add(&page->text, "<dl class=\"facts\">\n");
    add_fact(page, "view", size.data);
    add_fact(page, "compared", truth.data);
    add_fact(page, "device", aob_member_text(fingerprint, "device"));
    add_fact(page, "times", *aob_member_text(d, "profile") ? aob_member_text(d, "profile") : "measured");
    aob_text_add(&page->text, "</dl>\n");
    aob_text_finish(&size);
    aob_text_finish(&truth);
}

static void add_head(struct effects_page *page)
{
    struct aob_text name = {0};
    name_set(page->chosen, &name);
    aob_text_add(
        &page->text,
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width,initial-scale=1\"><title>aobudget: effects</title>\n<style>\n%s</style>"
        "</head><body>\n<header><h1>Effects that ",
        aob_text_page_style);
    add_escaped(page, "", aob_member_text(page->document, "scene"), " ");
    add_escaped(page, "", aob_member_text(page->document, "view"), " calls for</h1>\n");
    if (json_is_object(page->chosen)) {
        add_escaped(page, "<p>Taken: ", name.data, "");
        aob_text_add(&page->text, ": %.3g ms a frame, %s by %.3g %% of the light",
                     aob_member_number(page->chosen, "ms"), off(page),
                     100 * aob_member_number(page->chosen, "rmse"));
        if (is_sequence(page))
            aob_text_add(&page->text, ", with a flicker of %.2g %%",
                         100 * aob_member_number(page->chosen, "flicker"));
        aob_text_add(&page->text, ".</p>\n");
    } else
        aob_text_add(&page->text, "<p>Nothing fits the budget.</p>\n");
    add_facts(page);
    aob_text_add(&page->text, "</header><main>\n");
    aob_text_finish(&name);
}

bool aob_effects_page_write(const struct aob_effects_page_desc *desc, struct aob_error *error)
{
    struct effects_page page = {.desc = desc,
                                .document = desc->document,
                                .chosen = json_object_get(desc->document, "chosen"),
                                .effects = json_object_get(desc->document, "effects")};
    page.gallery.folder = "figures";
    draw(&page);
    add_head(&page);
    add_effects(&page);
    add_gallery(&page);
    add_sets(&page);
    aob_text_add(&page.text, "</main></body></html>\n");
    char *path = aob_path_join(desc->out, "index.html");
    bool ok = aob_file_write(path, page.text.data, page.text.size, error);
    free(path);
    aob_text_finish(&page.text);
    aob_gallery_finish(&page.gallery);
    return ok;
}
