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

static void add_chart(struct aob_gallery *g, const struct aob_panel *panel, json_t *series,
                      struct aob_span up)
{
    const struct aob_section *section = &g->rows->sections[panel->section];
    struct aob_text title = {0}, subtitle = {0};
    char *against = aob_target_say(&g->rows->targets[panel->target]);
    aob_text_add(&title, "Error of each frame, against %s", against);
    aob_text_add(&subtitle, "%s \u00b7 %s", section->scene, section->view);
    json_t *job = json_pack("{s:s, s:s, s:{s:s, s:b}, s:o, s:o}", "title", title.data, "subtitle",
                            subtitle.data, "x", "label", "frame", "log", 0, "y",
                            aob_chart_axis("RMSE (visibility", up, 5), "series", series);
    aob_chart_add(g, panel, AOB_FIGURE_OVER_TIME, "over-time", job);
    free(against);
    aob_text_finish(&title);
    aob_text_finish(&subtitle);
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
    if (json_array_size(series))
        add_chart(g, panel, series, up);
    else
        json_decref(series);
}
