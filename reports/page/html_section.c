#include "html.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char cache_heading[] = "<h3>Cache</h3>\n<p class=soft>Caches of named devices, simulated over "
                                    "what the shaders fetched. How a device "
                                    "orders its warps is not known, so each figure is a band: from one warp "
                                    "in flight to as many as a unit holds. "
                                    "Trust where a curve bends and which of two lies higher more than a "
                                    "figure itself. The knee is the radius at "
                                    "which misses reach half of their plateau.</p>\n";

/* The figures of one panel. */
struct view {
    const struct aob_figure *figures;
    size_t count;
};

/* Of the same row and output as `like`. */
static const struct aob_figure *find_figure(const struct view *view, enum aob_figure_kind kind,
                                            const struct aob_figure *like)
{
    for (size_t i = 0; i < view->count; i++)
        if (view->figures[i].kind == kind && view->figures[i].row == like->row &&
            view->figures[i].look == like->look)
            return &view->figures[i];
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
    aob_text_add(page, "<details><summary>%zu case%s on the Pareto front</summary><ol class=front>\n",
                 figure->front_count, figure->front_count == 1 ? "" : "s");
    for (size_t i = 0; i < figure->front_count; i++) {
        const struct aob_row *row = figure->front[i];
        aob_html_ms(ms, row->cost_ms);
        aob_text_add(page, "<li>%s ms, RMSE in band %.4f: <strong>", ms,
                     aob_row_score(row, figure->target)->metrics.band_rmse);
        aob_html_escape(page, row->technique);
        aob_text_add(page, "</strong> ");
        aob_html_label(page, row);
        aob_text_add(page, "</li>\n");
    }
    aob_text_add(page, "</ol></details>\n");
}

static void add_chart(struct aob_text *page, const struct aob_figure *svg, const struct aob_figure *png)
{
    aob_text_add(page, "<figure>");
    add_picture(page, svg, svg->file);
    aob_text_add(page, "<figcaption>");
    add_link(page, png, "PNG");
    if (svg->front_count)
        add_front(page, svg);
    if (svg->note) {
        aob_text_add(page, "<div>");
        aob_html_escape(page, svg->note);
        aob_text_add(page, "</div>");
    }
    aob_text_add(page, "</figcaption></figure>\n");
}

/* Each SVG is followed by its PNG. */
static void add_charts(struct aob_text *page, const struct view *view, enum aob_figure_kind kind,
                       const char *heading)
{
    bool any = false;
    for (size_t i = 0; i + 1 < view->count; i++) {
        const struct aob_figure *svg = &view->figures[i];
        if (svg->kind != kind || !strstr(svg->file, ".svg"))
            continue;
        if (!any)
            aob_text_add(page, "%s<div class=grid>\n", heading);
        any = true;
        add_chart(page, svg, svg + 1);
    }
    aob_text_add(page, any ? "</div>\n" : "");
}

static void add_case(struct aob_text *page, const struct aob_row *row)
{
    aob_html_label(page, row);
    aob_html_given(page, row);
}

static void add_triptych(struct aob_text *page, const struct view *view, const struct aob_figure *figure)
{
    const struct aob_figure *map = find_figure(view, AOB_FIGURE_MAP, figure);
    const struct aob_figure *split = find_figure(view, AOB_FIGURE_SPLIT, figure);
    aob_text_add(page, "<figure><div class=wide>");
    add_picture(page, figure, map && !map->failure ? map->file : figure->file);
    if (split)
        add_picture(page, split, split->file);
    aob_text_add(page, "</div><figcaption>");
    add_link(page, map, "error map, pixel by pixel");
    add_link(page, find_figure(view, AOB_FIGURE_VTI, figure), "data for ParaView (.vti)");
    add_case(page, figure->row);
    aob_text_add(page, "</figcaption></figure>\n");
}

static bool add_triptychs(struct aob_text *page, const struct view *view, const char *heading)
{
    bool any = false;
    for (size_t i = 0; i < view->count; i++) {
        if (view->figures[i].kind != AOB_FIGURE_TRIPTYCH)
            continue;
        if (!any)
            aob_text_add(page, "<h4>%s</h4>\n", heading);
        any = true;
        add_triptych(page, view, &view->figures[i]);
    }
    return any;
}

/* The map alone, or the pictures with the map behind them. */
static void add_output_figure(struct aob_text *page, const struct view *view, const struct aob_figure *map)
{
    const struct aob_figure *pictures = find_figure(view, AOB_FIGURE_OUTPUT, map);
    aob_text_add(page, pictures ? "<figure><div class=wide>" : "<figure class=half>");
    if (pictures)
        add_picture(page, pictures, map->failure ? pictures->file : map->file);
    else
        add_picture(page, map, map->file);
    aob_text_add(page, pictures ? "</div><figcaption>" : "<figcaption>");
    if (pictures)
        add_link(page, map, "error map, pixel by pixel");
    add_case(page, map->row);
    aob_text_add(page, "</figcaption></figure>\n");
}

static void add_output(struct aob_text *page, const struct view *view, const struct aob_output_look *look)
{
    bool any = false;
    for (size_t i = 0; i < view->count; i++) {
        const struct aob_figure *figure = &view->figures[i];
        if (figure->kind != AOB_FIGURE_OUTPUT_MAP || figure->look != look)
            continue;
        if (!any)
            aob_text_add(page, "<h4>%s</h4>\n", look->heading);
        if (!any && look->sentence)
            aob_text_add(page, "<p class=soft>%s</p>\n", look->sentence);
        any = true;
        add_output_figure(page, view, figure);
    }
}

static void add_landscape(struct aob_text *page, const struct view *view)
{
    for (size_t i = 0; i < view->count; i++) {
        if (view->figures[i].kind != AOB_FIGURE_HEIGHT)
            continue;
        aob_text_add(page, "<h4>Where the most accurate of them still errs</h4>\n<figure class=half>");
        add_picture(page, &view->figures[i], view->figures[i].file);
        aob_text_add(page, "</figure>\n");
    }
}

static void add_panel(struct aob_text *page, const struct aob_gallery *g, const struct aob_panel *panel)
{
    struct view view = {&g->figures[panel->first], panel->count};
    if (panel->target == AOB_NO_TARGET) {
        add_triptychs(page, &view, "Each technique\u2019s image: there is no reference");
        add_charts(page, &view, AOB_FIGURE_CHART, "<h3>What time follows from</h3>\n");
        add_charts(page, &view, AOB_FIGURE_CACHE, cache_heading);
        return;
    }
    aob_html_target_open(page, g->rows, panel->target, "");
    add_charts(page, &view, AOB_FIGURE_CHART, "");
    aob_html_over_time(page, g, panel);
    add_charts(page, &view, AOB_FIGURE_OVER_TIME, "");
    aob_html_split(page, g, panel);
    if (!panel->cases)
        aob_text_add(page, "<p class=soft>No case of this view is compared with it.</p>\n");
    else if (!add_triptychs(page, &view, "Each technique\u2019s most accurate case"))
        aob_text_add(page, "<p class=soft>The run keeps no image of these cases, or not this truth.</p>\n");
    add_landscape(page, &view);
    for (size_t i = 0; i < AOB_OUTPUT_LOOKS; i++)
        add_output(page, &view, &aob_output_looks[i]);
    aob_text_add(page, "</div>\n");
}

void aob_html_section(struct aob_text *page, const struct aob_gallery *g, size_t section)
{
    const struct aob_section *s = &g->rows->sections[section];
    size_t panels = g->rows->target_count + 1;
    aob_text_add(page, "<section id=s%zu><h2>", section);
    aob_html_escape(page, s->scene);
    aob_text_add(page, " <small>");
    aob_html_escape(page, s->view);
    if (g->rows->run_count > 1) {
        aob_text_add(page, " \u00b7 ");
        aob_html_escape(page, g->rows->runs[s->run].name);
    }
    aob_text_add(page, "</small></h2>\n");
    for (size_t i = 0; i < panels; i++)
        add_panel(page, g, &g->panels[section * panels + i]);
    aob_text_add(page, "</section>\n");
}
