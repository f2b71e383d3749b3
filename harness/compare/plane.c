#include "plane.h"
#include <math.h>
#include "base/json.h"
#include "base/memory.h"
#include "reports/page/chart_job.h"

bool aob_plane_find(const struct aob_compared *item, struct aob_place_on_plane *a,
                    struct aob_place_on_plane *b)
{
    double ratio = *item->unfit.text ? NAN : item->wide.ratio;
    *a = (struct aob_place_on_plane){item->couple->a->ratio, aob_error_true_rmse(&item->errors.a)};
    *b = (struct aob_place_on_plane){a->cost * ratio, aob_error_true_rmse(&item->errors.b)};
    return a->cost > 0 && b->cost > 0 && isfinite(a->error + b->error + b->cost);
}

struct drawing {
    json_t *lines, *points[2][2]; /* x and y of A and of B */
    struct aob_span across, up;
    size_t count;
};

static void add_case(struct drawing *d, const struct aob_compared *item,
                     const struct aob_place_on_plane place[2])
{
    struct aob_text name = {0};
    aob_row_describe(item->couple->a, &name);
    for (int side = 0; side < 2; side++) {
        json_array_append_new(d->points[side][0], json_real(place[side].cost));
        json_array_append_new(d->points[side][1], json_real(place[side].error));
        aob_span_include(&d->across, place[side].cost);
        aob_span_include(&d->up, place[side].error);
    }
    json_array_append_new(d->lines,
                          json_pack("{s:o, s:s, s:I, s:[f, f], s:[f, f]}", "name", aob_json_text(name.data),
                                    "style", "curve", "colour", (json_int_t)d->count + 2, "x", place[0].cost,
                                    place[1].cost, "y", place[0].error, place[1].error));
    d->count++;
    aob_text_finish(&name);
}

static void add_points(struct drawing *d, int side)
{
    json_array_append_new(d->lines,
                          json_pack("{s:s, s:s, s:i, s:O, s:O}", "name", side ? "B" : "A", "style", "points",
                                    "colour", side, "x", d->points[side][0], "y", d->points[side][1]));
}

static json_t *draw(struct drawing *d)
{
    for (int side = 0; side < 2; side++)
        add_points(d, side);
    return json_pack("{s:s, s:s, s:o, s:o, s:o, s:O}", "kind", "chart", "title",
                     "What moved on the plane of cost and error", "subtitle",
                     json_sprintf("%zu case%s whose image changed, from A to B; lower left is better",
                                  d->count, d->count == 1 ? "" : "s"),
                     "x", aob_chart_axis("cost (fixed passes", d->across, 5), "y",
                     aob_chart_axis("RMSE (visibility", d->up, 5), "series", d->lines);
}

static bool has_place(const struct aob_compared *item, struct aob_place_on_plane place[2])
{
    return item->image.moved && aob_plane_find(item, &place[0], &place[1]);
}

bool aob_plane_any(const struct aob_compared_table *table)
{
    struct aob_place_on_plane place[2];
    for (size_t i = 0; i < table->couples->count; i++)
        if (has_place(&table->items[i], place))
            return true;
    return false;
}

void aob_plane_add(struct aob_gallery *gallery, const struct aob_compared_table *table)
{
    struct drawing d = {.lines = json_array(), .across = AOB_SPAN_EMPTY, .up = AOB_SPAN_EMPTY};
    struct aob_place_on_plane place[2];
    for (int i = 0; i < 4; i++)
        d.points[i / 2][i % 2] = json_array();
    for (size_t i = 0; i < table->couples->count; i++)
        if (has_place(&table->items[i], place))
            add_case(&d, &table->items[i], place);
    *AOB_PUSH(gallery->figures, gallery->count, gallery->capacity) =
        (struct aob_figure){.kind = AOB_FIGURE_CHART, .file = aob_strdup(AOB_PLANE_FILE), .job = draw(&d)};
    for (int i = 0; i < 4; i++)
        json_decref(d.points[i / 2][i % 2]);
    json_decref(d.lines);
}
