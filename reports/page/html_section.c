#include "html.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct aob_figure *find_figure(const struct aob_gallery *g, enum aob_figure_kind kind,
                                            size_t section, const struct aob_row *row)
{
    for (size_t i = 0; i < g->count; i++)
        if (g->figures[i].kind == kind && g->figures[i].section == section && g->figures[i].row == row)
            return &g->figures[i];
    return NULL;
}

static void add_missing(struct aob_text *page, const struct aob_figure *figure)
{
    aob_text_add(page, "<div class=missing><strong>");
    aob_html_escape(page, figure->title);
    aob_text_add(page, "</strong>: this figure was not drawn: ");
    aob_html_escape(page, figure->failure);
    aob_text_add(page, "</div>\n");
}

/* File names are made of letters, digits and dashes, so they need no escape. */
static void add_picture(struct aob_text *page, const struct aob_figure *figure, const char *link)
{
    if (figure->failure) {
        add_missing(page, figure);
        return;
    }
    aob_text_add(page, "<a href=\"%s\"><img loading=lazy src=\"%s\" alt=\"", link, figure->file);
    aob_html_escape(page, figure->title);
    aob_text_add(page, ". ");
    aob_html_escape(page, aob_member_text(figure->job, "subtitle"));
    aob_text_add(page, "\"></a>\n");
}

static void add_link(struct aob_text *page, const struct aob_figure *figure, const char *name)
{
    if (figure && !figure->failure)
        aob_text_add(page, "<a href=\"%s\">%s</a>", figure->file, name);
    else if (figure) {
        aob_text_add(page, "<span>no %s: ", name);
        aob_html_escape(page, figure->failure);
        aob_text_add(page, "</span> ");
    }
}

static void add_front(struct aob_text *page, const struct aob_figure *figure)
{
    char ms[32];
    aob_text_add(page, "<details><summary>%zu cases on the Pareto front</summary><ol class=front>\n",
                 figure->front_count);
    for (size_t i = 0; i < figure->front_count; i++) {
        const struct aob_row *row = figure->front[i];
        aob_html_ms(ms, row->cost_ms);
        aob_text_add(page, "<li>%s ms, RMSE in band %.4f: <strong>", ms, row->band_rmse);
        aob_html_escape(page, row->technique);
        aob_text_add(page, "</strong> ");
        aob_html_escape(page, row->label);
        aob_text_add(page, "</li>\n");
    }
    aob_text_add(page, "</ol></details>\n");
}

/* Each SVG is followed by its PNG. */
static void add_charts(struct aob_text *page, const struct aob_gallery *g, size_t section)
{
    aob_text_add(page, "<div class=grid>\n");
    for (size_t i = 0; i + 1 < g->count; i++) {
        const struct aob_figure *svg = &g->figures[i];
        if (svg->kind != AOB_FIGURE_CHART || svg->section != section || !strstr(svg->file, ".svg"))
            continue;
        aob_text_add(page, "<figure>");
        add_picture(page, svg, svg->file);
        aob_text_add(page, "<figcaption>");
        add_link(page, &g->figures[i + 1], "PNG");
        if (svg->front_count)
            add_front(page, svg);
        aob_text_add(page, "</figcaption></figure>\n");
    }
    aob_text_add(page, "</div>\n");
}

static void add_triptych(struct aob_text *page, const struct aob_gallery *g, const struct aob_figure *figure)
{
    const struct aob_figure *map = find_figure(g, AOB_FIGURE_MAP, figure->section, figure->row);
    const struct aob_figure *split = find_figure(g, AOB_FIGURE_SPLIT, figure->section, figure->row);
    aob_text_add(page, "<figure><div class=wide>");
    add_picture(page, figure, map && !map->failure ? map->file : figure->file);
    if (split)
        add_picture(page, split, split->file);
    aob_text_add(page, "</div><figcaption>");
    add_link(page, map, "error map, pixel by pixel");
    add_link(page, find_figure(g, AOB_FIGURE_VTI, figure->section, figure->row), "data for ParaView (.vti)");
    aob_text_add(page, "</figcaption></figure>\n");
}

static void add_pictures(struct aob_text *page, const struct aob_gallery *g, size_t section)
{
    bool any = false;
    for (size_t i = 0; i < g->count; i++) {
        const struct aob_figure *figure = &g->figures[i];
        if (figure->kind != AOB_FIGURE_TRIPTYCH || figure->section != section)
            continue;
        if (!any)
            aob_text_add(page, json_object_get(figure->job, "alone")
                                   ? "<h3>Each technique's image: there is no reference</h3>\n"
                                   : "<h3>Each technique's most accurate case</h3>\n");
        any = true;
        add_triptych(page, g, figure);
    }
    for (size_t i = 0; i < g->count; i++) {
        const struct aob_figure *figure = &g->figures[i];
        if (figure->kind != AOB_FIGURE_HEIGHT || figure->section != section)
            continue;
        aob_text_add(page, "<h3>Where the most accurate of them still errs</h3>\n<figure class=half>");
        add_picture(page, figure, figure->file);
        aob_text_add(page, "</figure>\n");
    }
    if (!any)
        aob_text_add(page, "<p class=soft>No case of this view has an image.</p>\n");
}

void aob_html_section(struct aob_text *page, const struct aob_gallery *g, size_t section)
{
    const struct aob_section *s = &g->sections[section];
    aob_text_add(page, "<section id=s%zu><h2>", section);
    aob_html_escape(page, s->scene);
    aob_text_add(page, " <small>");
    aob_html_escape(page, s->view);
    if (g->rows->run_count > 1) {
        aob_text_add(page, " \u00b7 ");
        aob_html_escape(page, g->rows->runs[s->run].name);
    }
    aob_text_add(page, "</small></h2>\n");
    add_charts(page, g, section);
    aob_html_split(page, g, section);
    add_pictures(page, g, section);
    aob_text_add(page, "</section>\n");
}
