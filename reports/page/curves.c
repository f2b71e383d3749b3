#include "curves.h"
#include "chart_job.h"
#include "places.h"
#include "base/memory.h"
#include "base/text.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CURVE_LIMIT = 8 };

/* Cases that differ in nothing but the axis. */
struct group {
    const char *technique;
    size_t place; /* of the technique in the rows' list */
    json_t *rest; /* what they share */
    struct aob_curve_point *samples;
    size_t count, capacity;
    size_t turn; /* its place among the technique's groups */
};
struct groups {
    struct group *list;
    size_t count, capacity;
};

static double parameter(const struct aob_row *row, const char *name)
{
    return aob_member_number(json_object_get(row->json, "params"), name);
}

static double radius_of(const struct aob_row *row)
{
    return parameter(row, "radius");
}

static double samples_of(const struct aob_row *row)
{
    double samples = parameter(row, "samples"), slices = parameter(row, "slices"),
           directions = parameter(row, "directions"), rays = parameter(row, "rays"),
           steps = parameter(row, "steps");
    if (isfinite(samples))
        return samples;
    if (isfinite(slices))
        return 2 * slices * steps;
    return directions * steps * (isfinite(rays) ? rays : 1);
}

static double megapixels_of(const struct aob_row *row)
{
    return row->width && row->height ? row->width * 1e-6 * row->height : NAN;
}

const struct aob_curve_axis aob_curve_axes[] = {
    {"radius", "radius (scene units", "radius", radius_of, (const char *const[]){"radius", NULL}},
    {"samples", "depth samples a pixel (count", "sample count", samples_of,
     (const char *const[]){"samples", "slices", "directions", "rays", "steps", NULL}},
    {"megapixels", "resolution (megapixels", "resolution", megapixels_of,
     (const char *const[]){"size", NULL}},
    {NULL},
};

/* Everything of the row that may make it another curve. */
static json_t *rest_of(const struct aob_row *row, const struct aob_curve_axis *axis)
{
    json_t *rest = json_object(), *params = json_object_get(row->json, "params");
    char size[32];
    snprintf(size, sizeof size, "%d\u00d7%d", row->width, row->height);
    if (json_is_object(params))
        json_object_update(rest, params);
    if (json_is_object(json_object_get(row->json, "options")))
        json_object_update(rest, json_object_get(row->json, "options"));
    json_object_set_new(rest, "size", json_string(size));
    json_object_set_new(rest, "backend", json_string(row->backend));
    for (const char *const *word = axis->words; *word; word++)
        json_object_del(rest, *word);
    return rest;
}

static struct group *group_of(struct groups *groups, json_t *places, const struct aob_row *row,
                              const struct aob_curve_axis *axis)
{
    json_t *rest = rest_of(row, axis);
    size_t place = aob_place(places, json_pack("[s, O]", row->technique, rest));
    if (place < groups->count) {
        json_decref(rest);
        return &groups->list[place];
    }
    struct group *g = AOB_PUSH(groups->list, groups->count, groups->capacity);
    *g = (struct group){.technique = row->technique, .place = row->technique_place, .rest = rest};
    return g;
}

static void free_groups(struct groups *groups)
{
    for (size_t i = 0; i < groups->count; i++) {
        json_decref(groups->list[i].rest);
        free(groups->list[i].samples);
    }
    free(groups->list);
}

static int by_x(const void *a, const void *b)
{
    const struct aob_curve_point *p = a, *q = b;
    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

static bool is_curve(struct group *g)
{
    qsort(g->samples, g->count, sizeof *g->samples, by_x);
    return g->count > 1 && g->samples[0].x < g->samples[g->count - 1].x;
}

/* The cases of the section that have a place on the axis and a figure, in groups. */
static struct groups group_rows(const struct aob_rows *rows, size_t section,
                                const struct aob_curves_desc *desc)
{
    struct groups all = {0};
    json_t *places = json_object();
    for (size_t i = 0; i < rows->sections[section].count; i++) {
        const struct aob_row *row = &rows->list[rows->sections[section].rows[i]];
        struct aob_curve_point point = {.x = desc->axis->value(row), .low = NAN, .high = NAN};
        if (!aob_row_is_ok(row) || !isfinite(point.x) || !desc->measure(row, desc->user, &point))
            continue;
        struct group *g = group_of(&all, places, row, desc->axis);
        *AOB_PUSH(g->samples, g->count, g->capacity) = point;
    }
    json_decref(places);
    return all;
}

/* The section's curves over the axis; groups with a single x are dropped. */
static struct groups collect(const struct aob_rows *rows, size_t section, const struct aob_curves_desc *desc)
{
    struct groups all = group_rows(rows, section, desc), curves = {0};
    for (size_t i = 0; i < all.count; i++) {
        struct group *g = &all.list[i];
        if (!is_curve(g))
            continue;
        *AOB_PUSH(curves.list, curves.count, curves.capacity) = *g;
        *g = (struct group){0};
    }
    free_groups(&all);
    return curves;
}

/* Each technique's first curve before any second one; within a technique as in the journal, so the first
 * backend comes first. */
static int by_turn(const void *a, const void *b)
{
    const struct group *p = a, *q = b;
    return (p->turn > q->turn) - (p->turn < q->turn);
}

static void order_groups(struct groups *groups, size_t technique_count)
{
    size_t *turns = AOB_NEW_ARRAY(size_t, technique_count);
    for (size_t i = 0; i < groups->count; i++)
        groups->list[i].turn = turns[groups->list[i].place]++;
    /* qsort may swap equals, so there are none while it runs. */
    for (size_t i = 0; i < groups->count; i++)
        groups->list[i].turn = groups->list[i].turn * groups->count + i;
    qsort(groups->list, groups->count, sizeof *groups->list, by_turn);
    for (size_t i = 0; i < groups->count; i++)
        groups->list[i].turn /= groups->count;
    free(turns);
}

static bool tells_apart(const struct groups *groups, const struct group *g, const char *name,
                        const json_t *value)
{
    for (size_t i = 0; i < groups->count; i++) {
        const json_t *other = json_object_get(groups->list[i].rest, name);
        if (groups->list[i].place == g->place && (!other || !json_equal(other, value)))
            return true;
    }
    return false;
}

/* Backend and size go into the subtitle where all curves shown share them. */
static bool is_shared(const struct groups *groups, size_t shown, const char *name)
{
    for (size_t i = 1; i < shown; i++)
        if (!json_equal(json_object_get(groups->list[i].rest, name),
                        json_object_get(groups->list[0].rest, name)))
            return false;
    return true;
}

static bool is_place(const char *name)
{
    return strcmp(name, "backend") == 0 || strcmp(name, "size") == 0;
}

/* The technique, and what sets this curve apart from the technique's others, drawn or not. */
static char *curve_name(const struct groups *groups, size_t shown, const struct group *g)
{
    struct aob_text text = {0};
    const char *name;
    json_t *value;
    aob_text_add(&text, "%s", g->technique);
    json_object_foreach(g->rest, name, value)
    {
        if (!tells_apart(groups, g, name, value) || (is_place(name) && is_shared(groups, shown, name)))
            continue;
        char *text_of_value = aob_member_show(value);
        aob_text_add(&text, " %s%s%s", is_place(name) ? "" : name, is_place(name) ? "" : "=", text_of_value);
        free(text_of_value);
    }
    return text.data;
}

static json_t *known(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *curve_json(const struct aob_rows *rows, const struct groups *groups, size_t shown,
                          const struct group *g)
{
    json_t *x = json_array(), *y = json_array(), *low = json_array(), *high = json_array();
    for (size_t i = 0; i < g->count; i++) {
        json_array_append_new(x, json_real(g->samples[i].x));
        json_array_append_new(y, json_real(g->samples[i].y));
        json_array_append_new(low, known(g->samples[i].low));
        json_array_append_new(high, known(g->samples[i].high));
    }
    char *name = curve_name(groups, shown, g);
    size_t colour = g->place + g->turn * rows->technique_count;
    json_t *curve = json_pack("{s:s, s:s, s:I, s:o, s:o, s:o, s:o}", "name", name, "style", "curve", "colour",
                              (json_int_t)colour, "x", x, "y", y, "low", low, "high", high);
    free(name);
    return curve;
}

static char *subtitle_of(const struct groups *groups, size_t shown, const struct aob_section *section,
                         const char *bars_are)
{
    static const char *const places[] = {"size", "backend"};
    struct aob_text text = {0};
    bool bars = false;
    aob_text_add(&text, "%s \u00b7 %s", section->scene, section->view);
    for (size_t i = 0; i < AOB_COUNT(places); i++) {
        const char *place = aob_member_text(groups->list[0].rest, places[i]);
        if (*place && is_shared(groups, shown, places[i]))
            aob_text_add(&text, " \u00b7 %s", place);
    }
    for (size_t i = 0; i < shown; i++)
        for (size_t k = 0; k < groups->list[i].count; k++)
            bars = bars || isfinite(groups->list[i].samples[k].low);
    if (bars)
        aob_text_add(&text, " \u00b7 bars: %s", bars_are);
    if (shown < groups->count)
        aob_text_add(&text, " \u00b7 %zu of %zu curves", shown, groups->count);
    return text.data;
}

/* What is said below the chart, of each curve; NULL where nothing is. free() it. */
static char *notes_of(const struct groups *groups, size_t shown, const struct aob_curves_desc *desc)
{
    struct aob_text notes = {0};
    for (size_t i = 0; desc->note && i < shown; i++) {
        struct aob_text note = {0};
        char *name = curve_name(groups, shown, &groups->list[i]);
        desc->note(groups->list[i].samples, groups->list[i].count, &note);
        if (note.data)
            aob_text_add(&notes, "%s%s: %s", notes.data ? "; " : "", name, note.data);
        aob_text_finish(&note);
        free(name);
    }
    return notes.data;
}

static void add_chart(struct aob_gallery *gallery, const struct aob_panel *panel,
                      const struct aob_curves_desc *desc, const struct groups *groups)
{
    size_t shown = groups->count < CURVE_LIMIT ? groups->count : CURVE_LIMIT;
    struct aob_span across = AOB_SPAN_EMPTY, up = AOB_SPAN_EMPTY;
    json_t *series = json_array();
    for (size_t i = 0; i < shown; i++) {
        json_array_append_new(series, curve_json(gallery->rows, groups, shown, &groups->list[i]));
        for (size_t k = 0; k < groups->list[i].count; k++) {
            aob_span_include(&across, groups->list[i].samples[k].x);
            aob_span_include(&up, groups->list[i].samples[k].y);
        }
    }
    char *subtitle = subtitle_of(groups, shown, &gallery->rows->sections[panel->section], desc->bars);
    struct aob_text title = {0};
    aob_text_add(&title, "%s over %s", desc->title, desc->axis->title);
    json_t *job = json_pack("{s:s, s:s, s:o, s:o, s:o}", "title", title.data, "subtitle", subtitle, "x",
                            aob_chart_axis(desc->axis->label, across, 4), "y",
                            aob_chart_axis(desc->label, up, 5), "series", series);
    struct aob_figure *figure = aob_chart_add(gallery, panel, desc->kind, desc->name, job);
    figure->note = notes_of(groups, shown, desc);
    aob_text_finish(&title);
    free(subtitle);
}

void aob_curves_add(struct aob_gallery *gallery, const struct aob_panel *panel,
                    const struct aob_curves_desc *desc)
{
    struct groups groups = collect(gallery->rows, panel->section, desc);
    if (groups.count) {
        order_groups(&groups, gallery->rows->technique_count);
        add_chart(gallery, panel, desc, &groups);
    }
    free_groups(&groups);
}
