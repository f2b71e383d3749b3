#include "figure.h"
#include "base/memory.h"
#include "base/text.h"
#include "figure_colour.h"
#include "figure_image.h"
#include "figure_parts.h"
#include "viz.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One of the image's channels; where it is absent, a line that names it. */
static const float *channel(const json_t *figure, const float *pixels, const char *role,
                            const char *otherwise, struct aob_error *error)
{
    if (!pixels)
        aob_fail(error, "%s: has no channel %s", aob_figure_text(figure, "image", "?"),
                 aob_figure_text(figure, role, otherwise));
    return pixels;
}

static bool take_map(const json_t *figure, const struct aob_figure_image *from, struct aob_viz_map *map,
                     struct aob_error *error)
{
    bool alone = json_is_true(json_object_get(figure, "alone"));
    *map = (struct aob_viz_map){
        .title = aob_figure_text(figure, "title", ""),
        .subtitle = aob_figure_text(figure, "subtitle", ""),
        .width = from->image->width,
        .height = from->image->height,
        .error = alone ? NULL : channel(figure, from->error, "error", "error.AO", error),
        .limit = json_number_value(json_object_get(figure, "limit")),
        .amount = aob_figure_text(figure, "amount", NULL),
        .quantity = aob_figure_text(figure, "quantity", NULL),
    };
    return alone || map->error;
}

typedef int map_drawer(const struct aob_viz_map *, const char *, char *);

static bool draw_with(map_drawer *drawer, const json_t *figure, struct aob_figure_cache *cache,
                      const char *out, struct aob_error *error)
{
    struct aob_figure_image from;
    struct aob_viz_map map;
    char why[AOB_VIZ_ERROR_SIZE] = "";
    if (!aob_figure_image_load(&from, cache, figure, error) || !take_map(figure, &from, &map, error))
        return false;
    return drawer(&map, out, why) == 0 || aob_fail(error, "%s", why);
}

static bool draw_map(const json_t *figure, struct aob_figure_cache *cache, const char *out,
                     struct aob_error *error)
{
    return draw_with(aob_viz_map_png, figure, cache, out, error);
}

static bool draw_height(const json_t *figure, struct aob_figure_cache *cache, const char *out,
                        struct aob_error *error)
{
    return draw_with(aob_viz_height_png, figure, cache, out, error);
}

static bool take_greys(struct aob_viz_triptych *t, const struct aob_figure_image *from, const json_t *figure,
                       struct aob_error *error)
{
    bool alone = json_is_true(json_object_get(figure, "alone"));
    const float *technique = channel(figure, from->technique, "technique", "technique.AO", error);
    const float *reference =
        technique && !alone ? channel(figure, from->reference, "reference", "reference.AO", error) : NULL;
    t->technique.channels[0] = technique;
    t->reference.channels[0] = reference;
    return technique && (alone || reference);
}

/* The heading of a picture in colour says its exposure. */
static void add_heading(struct aob_text *text, const json_t *figure, const char *member,
                        const char *otherwise, const struct aob_viz_triptych *t)
{
    aob_text_add(text, "%s", aob_figure_text(figure, member, otherwise));
    if (t->technique.channels[1])
        aob_text_add(text, ", exposure %g", t->exposure);
}

static bool draw_triptych(const json_t *figure, struct aob_figure_cache *cache, const char *out,
                          struct aob_error *error)
{
    bool colour = json_is_true(json_object_get(figure, "colour"));
    struct aob_figure_image from;
    struct aob_viz_triptych t = {0};
    struct aob_text technique = {0}, reference = {0};
    char why[AOB_VIZ_ERROR_SIZE] = "";
    if (!aob_figure_image_load(&from, cache, figure, error) || !take_map(figure, &from, &t.map, error) ||
        !(colour ? aob_figure_take_colours : take_greys)(&t, &from, figure, error))
        return false;
    add_heading(&technique, figure, "technique_name", "Technique", &t);
    add_heading(&reference, figure, "reference_name", "Reference", &t);
    t.technique_name = technique.data;
    t.reference_name = reference.data;
    bool ok = aob_viz_triptych_png(&t, out, why) == 0 || aob_fail(error, "%s", why);
    aob_text_finish(&technique);
    aob_text_finish(&reference);
    return ok;
}

static bool draw_split(const json_t *figure, struct aob_figure_cache *cache, const char *out,
                       struct aob_error *error)
{
    struct aob_figure_image from;
    const json_t *headings = json_object_get(figure, "parts");
    struct aob_viz_split split = {0};
    struct aob_parts parts;
    char why[AOB_VIZ_ERROR_SIZE] = "";
    if (!aob_figure_image_load(&from, cache, figure, error) || !take_map(figure, &from, &split.map, error))
        return false;
    if (!aob_parts_init(&parts, &from, error))
        return aob_fail_in(error, "%s", aob_figure_text(figure, "image", "?"));
    for (size_t i = 0; i < AOB_PARTS; i++) {
        split.parts[i] = parts.maps[i];
        split.names[i] = json_string_value(json_array_get(headings, i));
    }
    int rc = aob_viz_split_png(&split, out, why);
    aob_parts_finish(&parts);
    return rc == 0 || aob_fail(error, "%s", why);
}

static bool write_fields(const struct aob_figure_image *from, const struct aob_viz_field *fields,
                         size_t count, const char *out, struct aob_error *error)
{
    char why[AOB_VIZ_ERROR_SIZE] = "";
    return aob_viz_vti(from->image->width, from->image->height, fields, count, out, why) == 0 ||
           aob_fail(error, "%s", why);
}

/* One channel, by its own name. */
static bool write_amount(const json_t *figure, const struct aob_figure_image *from, const char *out,
                         struct aob_error *error)
{
    const struct aob_viz_field field = {aob_figure_text(figure, "error", "error.AO"),
                                        channel(figure, from->error, "error", "error.AO", error)};
    return field.pixels && write_fields(from, &field, 1, out, error);
}

static bool write_vti(const json_t *figure, const struct aob_figure_image *from,
                      const struct aob_parts *parts, const char *out, struct aob_error *error)
{
    bool alone = json_is_true(json_object_get(figure, "alone"));
    const struct aob_viz_field all[] = {
        {"AO", channel(figure, from->technique, "technique", "technique.AO", error)},
        {"reference", alone ? NULL : channel(figure, from->reference, "reference", "reference.AO", error)},
        {"error_definition", parts->maps[0]},
        {"error_missing", parts->maps[1]},
        {"error_estimator", parts->maps[2]},
        {"error", alone ? NULL : channel(figure, from->error, "error", "error.AO", error)},
    };
    struct aob_viz_field fields[AOB_COUNT(all)];
    size_t count = 0;
    if (!from->technique || (!alone && (!from->reference || !from->error)))
        return false;
    for (size_t i = 0; i < AOB_COUNT(all); i++)
        if (all[i].pixels)
            fields[count++] = all[i];
    return write_fields(from, fields, count, out, error);
}

static bool draw_vti(const json_t *figure, struct aob_figure_cache *cache, const char *out,
                     struct aob_error *error)
{
    struct aob_figure_image from;
    struct aob_parts parts = {0};
    if (!aob_figure_image_load(&from, cache, figure, error))
        return false;
    if (aob_figure_text(figure, "amount", NULL))
        return write_amount(figure, &from, out, error);
    if (!json_is_true(json_object_get(figure, "alone")) && aob_parts_exist(from.image) &&
        !aob_parts_init(&parts, &from, error))
        return aob_fail_in(error, "%s", aob_figure_text(figure, "image", "?"));
    bool ok = write_vti(figure, &from, &parts, out, error);
    aob_parts_finish(&parts);
    return ok;
}

/* An absent or short list, or null within it, is NaN. */
static double *numbers(const json_t *series, const char *name, size_t count)
{
    const json_t *list = json_object_get(series, name);
    double *values = AOB_NEW_ARRAY(double, count);
    for (size_t i = 0; i < count; i++) {
        const json_t *value = json_array_get(list, i);
        values[i] = json_is_number(value) ? json_number_value(value) : NAN;
    }
    return values;
}

static enum aob_viz_style style_of(const json_t *series)
{
    const char *style = aob_figure_text(series, "style", "curve");
    if (strcmp(style, "points") == 0)
        return AOB_VIZ_POINTS;
    return strcmp(style, "front") == 0 ? AOB_VIZ_FRONT : AOB_VIZ_CURVE;
}

static struct aob_viz_series take_series(const json_t *from)
{
    size_t count = json_array_size(json_object_get(from, "x"));
    json_int_t colour = json_integer_value(json_object_get(from, "colour"));
    return (struct aob_viz_series){
        .name = aob_figure_text(from, "name", ""),
        .style = style_of(from),
        .colour = (int)(colour < 0 ? 0 : colour & 0xffff),
        .count = count,
        .x = numbers(from, "x", count),
        .y = numbers(from, "y", count),
        .low = numbers(from, "low", count),
        .high = numbers(from, "high", count),
    };
}

static struct aob_viz_axis take_axis(const json_t *figure, const char *name)
{
    const json_t *axis = json_object_get(figure, name);
    return (struct aob_viz_axis){aob_figure_text(axis, "label", ""),
                                 json_is_true(json_object_get(axis, "log"))};
}

static void free_series(struct aob_viz_series *series, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        free((double *)series[i].x);
        free((double *)series[i].y);
        free((double *)series[i].low);
        free((double *)series[i].high);
    }
    free(series);
}

static bool ends_with(const char *text, const char *end)
{
    size_t size = strlen(text), tail = strlen(end);
    return size >= tail && strcmp(text + size - tail, end) == 0;
}

static bool draw_chart(const json_t *figure, struct aob_figure_cache *cache, const char *out,
                       struct aob_error *error)
{
    (void)cache;
    bool svg = ends_with(out, ".svg");
    if (!svg && !ends_with(out, ".png"))
        return aob_fail(error, "a chart is written as .svg or .png");
    const json_t *list = json_object_get(figure, "series");
    size_t count = json_array_size(list);
    struct aob_viz_series *series = AOB_NEW_ARRAY(struct aob_viz_series, count);
    for (size_t i = 0; i < count; i++)
        series[i] = take_series(json_array_get(list, i));
    struct aob_viz_chart chart = {aob_figure_text(figure, "title", ""),
                                  aob_figure_text(figure, "subtitle", ""),
                                  take_axis(figure, "x"),
                                  take_axis(figure, "y"),
                                  series,
                                  count};
    char why[AOB_VIZ_ERROR_SIZE] = "";
    int rc = svg ? aob_viz_chart_svg(&chart, out, why) : aob_viz_chart_png(&chart, out, why);
    free_series(series, count);
    return rc == 0 || aob_fail(error, "%s", why);
}

static const struct {
    const char *name;
    bool (*draw)(const json_t *, struct aob_figure_cache *, const char *out, struct aob_error *);
} kinds[] = {
    {"map", draw_map},     {"triptych", draw_triptych}, {"split", draw_split}, {"height", draw_height},
    {"chart", draw_chart}, {"vti", draw_vti},           {NULL, NULL},
};

bool aob_figure_draw(const json_t *figure, struct aob_figure_cache *cache, struct aob_error *error)
{
    const char *kind = aob_figure_text(figure, "kind", ""), *out = aob_figure_text(figure, "out", NULL);
    if (!out)
        return aob_fail(error, "the figure names no file to write (\"out\")");
    for (size_t i = 0; kinds[i].name; i++)
        if (strcmp(kinds[i].name, kind) == 0)
            return kinds[i].draw(figure, cache, out, error);
    return aob_fail(error, "unknown kind of figure \"%s\"; use map, triptych, split, height, chart or vti",
                    kind);
}
