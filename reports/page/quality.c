#include "chart_job.h"
#include "curves.h"
#include "places.h"
#include "base/memory.h"
#include "base/text.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A case in the chart: what it costs and how far it is from the target. */
struct point {
    const struct aob_row *row;
    double error;
};

/* Cases of one panel and size, on the section's backend, that have both. */
struct cloud {
    struct point *points;
    size_t count, capacity;
    size_t perfect; /* cases without any error, which have no place where the axis is logarithmic */
    int width, height;
};

static bool take_point(const struct aob_row *row, size_t target, struct point *point)
{
    const struct aob_score *score = aob_row_score(row, target);
    *point = (struct point){row, score ? score->metrics.band_rmse : NAN};
    return aob_row_is_ok(row) && isfinite(row->cost_ms) && row->cost_ms > 0 && isfinite(point->error) &&
           point->error >= 0;
}

static int by_cost(const void *a, const void *b)
{
    const struct point *p = a, *q = b;
    if (p->row->cost_ms != q->row->cost_ms)
        return (p->row->cost_ms > q->row->cost_ms) - (p->row->cost_ms < q->row->cost_ms);
    return (p->error > q->error) - (p->error < q->error);
}

/* Sorts the cloud by cost and picks what nothing cheaper beats. */
static struct cloud pareto_front(struct cloud *cloud)
{
    struct cloud front = {0};
    double best = HUGE_VAL;
    qsort(cloud->points, cloud->count, sizeof *cloud->points, by_cost);
    for (size_t i = 0; i < cloud->count; i++) {
        if (cloud->points[i].error >= best)
            continue;
        best = cloud->points[i].error;
        *AOB_PUSH(front.points, front.count, front.capacity) = cloud->points[i];
    }
    return front;
}

/* Points of one technique, or of all if it is NULL; NULL if there are none. */
static json_t *series_json(const struct cloud *cloud, const char *technique, const char *name,
                           const char *style, size_t colour)
{
    json_t *x = json_array(), *y = json_array();
    for (size_t i = 0; i < cloud->count; i++) {
        if (technique && strcmp(cloud->points[i].row->technique, technique))
            continue;
        json_array_append_new(x, json_real(cloud->points[i].row->cost_ms));
        json_array_append_new(y, json_real(cloud->points[i].error));
    }
    if (json_array_size(x))
        return json_pack("{s:s, s:s, s:I, s:o, s:o}", "name", name, "style", style, "colour",
                         (json_int_t)colour, "x", x, "y", y);
    json_decref(x);
    json_decref(y);
    return NULL;
}

static json_t *all_series(const struct aob_rows *rows, const struct cloud *cloud, const struct cloud *front)
{
    json_t *series = json_array();
    for (size_t t = 0; t < rows->technique_count; t++)
        json_array_append_new(series,
                              series_json(cloud, rows->techniques[t], rows->techniques[t], "points", t));
    json_array_append_new(series, series_json(front, NULL, "Pareto front", "front", 0));
    return series;
}

static char *subtitle_of(const struct aob_section *s, const struct cloud *cloud)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s \u00b7 %s \u00b7 %d\u00d7%d \u00b7 %s \u00b7 %zu cases; lower left is better",
                 s->scene, s->view, cloud->width, cloud->height, s->backend, cloud->count);
    if (cloud->perfect)
        aob_text_add(&text, "; %zu more left out: error 0, which a log scale cannot show", cloud->perfect);
    return text.data;
}

static char *title_of(const struct aob_rows *rows, size_t target)
{
    struct aob_text text = {0};
    char *against = aob_target_say(&rows->targets[target]);
    aob_text_add(&text, "What accuracy costs, against %s", against);
    free(against);
    return text.data;
}

/* The figure's list of the front takes over nothing of the clouds. */
static void set_front(struct aob_figure *figure, const struct cloud *front)
{
    figure->front = AOB_NEW_ARRAY(const struct aob_row *, front->count);
    figure->front_count = front->count;
    for (size_t i = 0; i < front->count; i++)
        figure->front[i] = front->points[i].row;
}

static void add_chart(struct aob_gallery *g, const struct aob_panel *panel, struct cloud *cloud)
{
    struct aob_span across = AOB_SPAN_EMPTY, up = AOB_SPAN_EMPTY;
    struct cloud front = pareto_front(cloud);
    for (size_t i = 0; i < cloud->count; i++) {
        aob_span_include(&across, cloud->points[i].row->cost_ms);
        aob_span_include(&up, cloud->points[i].error);
    }
    char *subtitle = subtitle_of(&g->rows->sections[panel->section], cloud);
    char *title = title_of(g->rows, panel->target);
    json_t *job = json_pack("{s:s, s:s, s:o, s:o, s:o}", "title", title, "subtitle", subtitle, "x",
                            aob_chart_axis("time a frame (ms", across, 5), "y",
                            aob_chart_axis("RMSE where occluded (visibility", up, 5), "series",
                            all_series(g->rows, cloud, &front));
    set_front(aob_chart_add(g, panel, AOB_FIGURE_CHART, "quality", job), &front);
    free(front.points);
    free(title);
    free(subtitle);
}

void aob_curves_add_quality(struct aob_gallery *g, const struct aob_panel *panel)
{
    const struct aob_section *section = &g->rows->sections[panel->section];
    struct cloud *clouds = NULL;
    size_t count = 0, capacity = 0;
    json_t *sizes = json_object();
    for (size_t i = 0; i < section->count; i++) {
        const struct aob_row *row = &g->rows->list[section->rows[i]];
        struct point point;
        if (strcmp(row->backend, section->backend) != 0 || !take_point(row, panel->target, &point))
            continue;
        size_t size = aob_place(sizes, json_pack("[i, i]", row->width, row->height));
        if (size == count)
            *AOB_PUSH(clouds, count, capacity) = (struct cloud){.width = row->width, .height = row->height};
        struct cloud *cloud = &clouds[size];
        if (point.error == 0)
            cloud->perfect++;
        else
            *AOB_PUSH(cloud->points, cloud->count, cloud->capacity) = point;
    }
    for (size_t i = 0; i < count; i++) {
        if (clouds[i].count)
            add_chart(g, panel, &clouds[i]);
        free(clouds[i].points);
    }
    json_decref(sizes);
    free(clouds);
}
