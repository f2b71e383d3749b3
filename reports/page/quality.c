#include "chart_job.h"
#include "curves.h"
#include "base/memory.h"
#include "base/text.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Cases of one section, size and backend that have both a cost and a score. */
struct cloud {
    const struct aob_row **rows;
    size_t count, capacity;
};

static bool has_point(const struct aob_row *row)
{
    return aob_row_is_ok(row) && isfinite(row->cost_ms) && row->cost_ms > 0 && isfinite(row->band_rmse) &&
           row->band_rmse > 0;
}

static struct cloud collect(const struct aob_gallery *g, size_t section, int width, int height)
{
    struct cloud cloud = {0};
    const char *backend = aob_gallery_backend(g, section);
    for (size_t i = 0; i < g->rows->count; i++) {
        const struct aob_row *row = &g->rows->list[i];
        if (has_point(row) && row->width == width && row->height == height &&
            strcmp(row->backend, backend) == 0 && aob_gallery_section(g, row) == section)
            *AOB_PUSH(cloud.rows, cloud.count, cloud.capacity) = row;
    }
    return cloud;
}

static int by_cost(const void *a, const void *b)
{
    const struct aob_row *p = *(const struct aob_row *const *)a, *q = *(const struct aob_row *const *)b;
    if (p->cost_ms != q->cost_ms)
        return (p->cost_ms > q->cost_ms) - (p->cost_ms < q->cost_ms);
    return (p->band_rmse > q->band_rmse) - (p->band_rmse < q->band_rmse);
}

/* Sorts the cloud by cost and picks what nothing cheaper beats. */
static struct cloud pareto_front(struct cloud *cloud)
{
    struct cloud front = {0};
    double best = HUGE_VAL;
    qsort(cloud->rows, cloud->count, sizeof(const struct aob_row *), by_cost);
    for (size_t i = 0; i < cloud->count; i++) {
        if (cloud->rows[i]->band_rmse >= best)
            continue;
        best = cloud->rows[i]->band_rmse;
        *AOB_PUSH(front.rows, front.count, front.capacity) = cloud->rows[i];
    }
    return front;
}

/* Points of one technique, or of all if it is NULL; JSON null if there are none. */
static json_t *series_json(const struct cloud *cloud, const char *technique, const char *name,
                           const char *style, size_t colour)
{
    json_t *x = json_array(), *y = json_array();
    for (size_t i = 0; i < cloud->count; i++) {
        if (technique && strcmp(cloud->rows[i]->technique, technique))
            continue;
        json_array_append_new(x, json_real(cloud->rows[i]->cost_ms));
        json_array_append_new(y, json_real(cloud->rows[i]->band_rmse));
    }
    if (json_array_size(x))
        return json_pack("{s:s, s:s, s:I, s:o, s:o}", "name", name, "style", style, "colour",
                         (json_int_t)colour, "x", x, "y", y);
    json_decref(x);
    json_decref(y);
    return NULL;
}

static json_t *all_series(const struct aob_gallery *g, const struct cloud *cloud, const struct cloud *front)
{
    json_t *series = json_array();
    for (size_t t = 0; t < g->technique_count; t++)
        json_array_append_new(series, series_json(cloud, g->techniques[t], g->techniques[t], "points", t));
    json_array_append_new(series, series_json(front, NULL, "Pareto front", "front", 0));
    return series;
}

static char *subtitle_of(const struct aob_section *s, const struct cloud *cloud)
{
    struct aob_text text = {0};
    const struct aob_row *row = cloud->rows[0];
    aob_text_add(&text, "%s \u00b7 %s \u00b7 %d\u00d7%d \u00b7 %s \u00b7 %zu cases; lower left is better",
                 s->scene, s->view, row->width, row->height, row->backend, cloud->count);
    return text.data;
}

static void add_chart(struct aob_gallery *g, size_t section, struct cloud *cloud)
{
    struct aob_span across = AOB_SPAN_EMPTY, up = AOB_SPAN_EMPTY;
    struct cloud front = pareto_front(cloud);
    for (size_t i = 0; i < cloud->count; i++) {
        aob_span_include(&across, cloud->rows[i]->cost_ms);
        aob_span_include(&up, cloud->rows[i]->band_rmse);
    }
    char *subtitle = subtitle_of(&g->sections[section], cloud);
    json_t *job = json_pack("{s:s, s:s, s:o, s:o, s:o}", "title", "What accuracy costs", "subtitle", subtitle,
                            "x", aob_chart_axis("time a frame (ms", across, 5), "y",
                            aob_chart_axis("RMSE where occluded (visibility", up, 5), "series",
                            all_series(g, cloud, &front));
    struct aob_figure *figure = aob_chart_add(g, section, "quality", job);
    figure->front = front.rows;
    figure->front_count = front.count;
    free(subtitle);
}

/* Is row `index` the first of its size in the section? */
static bool is_new_size(const struct aob_gallery *g, size_t section, size_t index)
{
    const struct aob_row *row = &g->rows->list[index];
    if (!has_point(row) || aob_gallery_section(g, row) != section)
        return false;
    for (size_t i = 0; i < index; i++) {
        const struct aob_row *other = &g->rows->list[i];
        if (has_point(other) && other->width == row->width && other->height == row->height &&
            aob_gallery_section(g, other) == section)
            return false;
    }
    return true;
}

void aob_curves_add_quality(struct aob_gallery *g, size_t section)
{
    for (size_t i = 0; i < g->rows->count; i++) {
        if (!is_new_size(g, section, i))
            continue;
        struct cloud cloud = collect(g, section, g->rows->list[i].width, g->rows->list[i].height);
        if (cloud.count)
            add_chart(g, section, &cloud);
        free(cloud.rows);
    }
}
