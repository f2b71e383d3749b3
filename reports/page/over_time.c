#include "over_time.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "chart_job.h"

enum { CURVE_LIMIT = 8 };

const json_t *aob_over_time_of(const struct aob_row *row, size_t target)
{
    const struct aob_score *own = aob_row_own_score(row);
    const json_t *sequence = json_object_get(row->json, "sequence");
    return own && own->target == target && aob_row_is_ok(row) &&
                   json_array_size(json_object_get(sequence, "error"))
               ? sequence
               : NULL;
}

static json_t *curve_json(const struct aob_row *row, const json_t *sequence, size_t colour,
                          struct aob_span *up)
{
    const json_t *errors = json_object_get(sequence, "error");
    json_t *x = json_array(), *y = json_array();
    struct aob_text name = {0};
    for (size_t i = 0; i < json_array_size(errors); i++) {
        const json_t *error = json_array_get(errors, i);
        if (!json_is_number(error))
            continue;
        json_array_append_new(x, json_integer((json_int_t)i));
        json_array_append_new(y, json_real(json_number_value(error)));
        aob_span_include(up, json_number_value(error));
    }
    aob_text_add(&name, *row->label ? "%s %s" : "%s", row->technique, row->label);
    json_t *curve = json_pack("{s:s, s:s, s:I, s:o, s:o}", "name", name.data, "style", "curve", "colour",
                              (json_int_t)colour, "x", x, "y", y);
    aob_text_finish(&name);
    return curve;
}

/* What is drawn, before the target and the view are known. */
struct chart {
    const char *file, *title;
    json_t *x, *y, *series; /* axes and what lies between them; taken over */
};

/* A chart without series is none. */
static void add_chart(struct aob_gallery *g, const struct aob_panel *panel, const struct chart *chart)
{
    const struct aob_section *section = &g->rows->sections[panel->section];
    struct aob_text title = {0}, subtitle = {0};
    char *against = aob_target_say(&g->rows->targets[panel->target]);
    aob_text_add(&title, "%s, against %s", chart->title, against);
    aob_text_add(&subtitle, "%s \u00b7 %s", section->scene, section->view);
    json_t *job = json_pack("{s:s, s:s, s:o, s:o, s:o}", "title", title.data, "subtitle", subtitle.data, "x",
                            chart->x, "y", chart->y, "series", chart->series);
    if (json_array_size(chart->series))
        aob_chart_add(g, panel, AOB_FIGURE_OVER_TIME, chart->file, job);
    else
        json_decref(job);
    free(against);
    aob_text_finish(&title);
    aob_text_finish(&subtitle);
}

/* The cases of one technique that have a cost and a flicker. */
static json_t *points_json(const struct aob_rows *rows, const struct aob_panel *panel, size_t technique,
                           struct aob_span *across, struct aob_span *up)
{
    const struct aob_section *section = &rows->sections[panel->section];
    json_t *x = json_array(), *y = json_array();
    for (size_t i = 0; i < section->count; i++) {
        const struct aob_row *row = &rows->list[section->rows[i]];
        double flicker = aob_member_number(aob_over_time_of(row, panel->target), "flicker");
        if (row->technique_place != technique || !isfinite(flicker) || !(row->cost_ms > 0))
            continue;
        json_array_append_new(x, json_real(row->cost_ms));
        json_array_append_new(y, json_real(flicker));
        aob_span_include(across, row->cost_ms);
        aob_span_include(up, flicker);
    }
    return json_pack("{s:s, s:s, s:I, s:o, s:o}", "name", rows->techniques[technique], "style", "points",
                     "colour", (json_int_t)technique, "x", x, "y", y);
}

static void add_flicker(struct aob_gallery *g, const struct aob_panel *panel)
{
    json_t *series = json_array();
    struct aob_span across = AOB_SPAN_EMPTY, up = AOB_SPAN_EMPTY;
    for (size_t t = 0; t < g->rows->technique_count; t++) {
        json_t *points = points_json(g->rows, panel, t, &across, &up);
        if (json_array_size(json_object_get(points, "x")))
            json_array_append(series, points);
        json_decref(points);
    }
    add_chart(g, panel,
              &(struct chart){"flicker", "What less flicker costs",
                              aob_chart_axis("time a frame (ms", across, 5),
                              aob_chart_axis("flicker (visibility", up, 5), series});
}

void aob_over_time_add(struct aob_gallery *g, const struct aob_panel *panel)
{
    const struct aob_section *section = &g->rows->sections[panel->section];
    json_t *series = json_array();
    struct aob_span up = AOB_SPAN_EMPTY;
    for (size_t i = 0; i < section->count && json_array_size(series) < CURVE_LIMIT; i++) {
        const struct aob_row *row = &g->rows->list[section->rows[i]];
        const json_t *sequence = aob_over_time_of(row, panel->target);
        if (sequence)
            json_array_append_new(series, curve_json(row, sequence, json_array_size(series), &up));
    }
    add_chart(g, panel,
              &(struct chart){"over-time", "Error of each frame",
                              json_pack("{s:s, s:b}", "label", "frame", "log", 0),
                              aob_chart_axis("RMSE (visibility", up, 5), series});
    add_flicker(g, panel);
}
