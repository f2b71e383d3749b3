#include "record.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/metric.h"
#include "technique/usual.h"

static char *text_of(struct aob_text *text)
{
    return text->data ? text->data : aob_strdup("");
}

static void add_part(struct aob_text *text, const char *between, const char *part)
{
    if (*part)
        aob_text_add(text, "%s%s", text->size ? between : "", part);
}

/* "2 x Intel ...": a number, which an old record may lack, before a noun. */
static void add_counted(struct aob_text *text, const json_t *number, const char *format, const char *noun)
{
    if (json_is_integer(number) && *noun)
        aob_text_add(text, format, text->size ? ", " : "", (int)json_integer_value(number), noun);
    else
        add_part(text, ", ", noun);
}

char *aob_record_machine(const json_t *record)
{
    const json_t *print = json_object_get(record, "fingerprint"),
                 *pass = json_object_get(print, "fixed_pass");
    struct aob_text text = {0};
    if (!*aob_member_text(print, "device"))
        return aob_strdup("");
    add_part(&text, ", ", aob_member_text(print, "class"));
    add_counted(&text, json_object_get(print, "cores"), "%s%d x %s", aob_member_text(print, "cpu"));
    add_part(&text, ", ", aob_member_text(print, "device"));
    add_part(&text, ", ", aob_member_text(print, "driver"));
    if (json_is_integer(pass))
        aob_text_add(&text, ", fixed pass %d", (int)json_integer_value(pass));
    return text_of(&text);
}

char *aob_record_clock(const json_t *record)
{
    const json_t *time = json_object_get(record, "time");
    struct aob_text text = {0};
    if (!*aob_member_text(time, "clock"))
        return aob_strdup("");
    char *threads = aob_member_show(json_object_get(time, "threads"));
    aob_text_add(&text, "%s thread%s, %s time", threads, strcmp(threads, "1") == 0 ? "" : "s",
                 aob_member_text(time, "clock"));
    free(threads);
    return text.data;
}

char *aob_record_timed_as(const json_t *record)
{
    const json_t *threads = json_object_get(json_object_get(record, "options"), "threads");
    char *shown = aob_member_show(threads);
    struct aob_text text = {0};
    aob_text_add(&text, "%s %s", aob_member_text(record, "backend"), shown);
    free(shown);
    return text.data;
}

static void add_pair(struct aob_text *text, const char *name, const json_t *value)
{
    char *shown = aob_member_show(value);
    aob_text_add(text, "%s%s=%s", text->size ? " " : "", name, shown);
    free(shown);
}

/* All but those at their default; all of them without defaults. */
static void add_values(struct aob_text *text, const json_t *record, const char *list, const json_t *usual)
{
    double metre = aob_member_number(record, "metre");
    const char *name;
    json_t *value;
    json_object_foreach(json_object_get(record, list), name, value)
    {
        const json_t *initial = json_object_get(usual, name);
        if (!initial || !aob_usual_is(initial, value, metre))
            add_pair(text, name, value);
    }
}

static void add_light(struct aob_text *text, const json_t *record)
{
    const json_t *name = json_object_get(json_object_get(record, "light"), "name");
    if (json_is_string(name))
        add_pair(text, "light", name);
}

char *aob_record_params(const json_t *record)
{
    struct aob_text text = {0};
    add_values(&text, record, "params", NULL);
    return text_of(&text);
}

char *aob_record_options(const json_t *record)
{
    struct aob_text text = {0};
    add_values(&text, record, "options", NULL);
    add_light(&text, record);
    return text_of(&text);
}

char *aob_record_size(const json_t *record)
{
    double width = aob_member_number(record, "width"), height = aob_member_number(record, "height");
    struct aob_text text = {0};
    if (width >= 1 && height >= 1 && width <= 65536 && height <= 65536)
        aob_text_add(&text, "%.0fx%.0f", width, height);
    return text_of(&text);
}

/* An old record names no module: the first technique of its name is meant. */
const json_t *aob_record_technique(const json_t *record, const json_t *info)
{
    const char *module = aob_member_text(record, "module");
    const json_t *named = NULL;
    json_t *technique;
    size_t i;
    json_array_foreach(json_object_get(info, "techniques"), i, technique)
    {
        if (strcmp(aob_member_text(technique, "name"), aob_member_text(record, "technique")) != 0)
            continue;
        if (strcmp(aob_member_text(technique, "module"), module) == 0)
            return technique;
        named = named || *module ? named : technique;
    }
    return named;
}

/* An old record may be of a technique that run.json does not describe: its parameters are all told then. */
char *aob_record_title(const json_t *record, const json_t *info, const char *module)
{
    const json_t *technique = aob_record_technique(record, info);
    json_t *params = technique ? aob_usual_params(technique) : NULL, *options = aob_usual_options();
    char *size = aob_record_size(record);
    struct aob_text text = {0};
    aob_text_add(&text, "%s/%s %s", aob_member_text(record, "scene"), aob_member_text(record, "view"),
                 aob_member_text(record, "technique"));
    if (*module)
        aob_text_add(&text, " (%s)", module);
    add_values(&text, record, "params", params);
    add_values(&text, record, "options", options);
    add_light(&text, record);
    add_part(&text, " ", aob_member_text(record, "backend"));
    add_part(&text, " ", size);
    json_decref(params);
    json_decref(options);
    free(size);
    return text.data;
}

double aob_record_cost_ms(const json_t *record)
{
    const json_t *time = json_object_get(record, "time");
    enum aob_clock clock = AOB_CLOCK_CPU; /* the only one that older records had */
    struct aob_text name = {0};
    aob_clock_find(aob_member_text(time, "clock"), &clock);
    aob_text_add(&name, "%s_ms", aob_clock_name(clock));
    double ms = aob_member_number(time, name.data);
    aob_text_finish(&name);
    return ms;
}

struct aob_record_target aob_record_target(const json_t *record)
{
    const json_t *error = json_object_get(record, "error"), *target = json_object_get(error, "target");
    if (!json_is_object(error))
        return (struct aob_record_target){NAN, "", ""};
    bool uniform = strcmp(aob_member_text(target, "weighting"), "uniform") == 0,
         screen = strcmp(aob_member_text(error, "reference"), "screen") == 0;
    return (struct aob_record_target){json_is_object(target) ? aob_member_number(target, "radius")
                                                             : aob_member_number(record, "reference_radius"),
                                      uniform ? "uniform" : "cosine", screen ? "screen" : "ray-traced"};
}

static void add_figure(json_t *figures, const char *name, double value)
{
    if (!isnan(value))
        json_object_set_new(figures, name, aob_json_number(value));
}

static void add_level(json_t *figures, const char *profile, const json_t *level)
{
    static const char *const flights[] = {"one", "most"};
    static const char *const names[] = {"miss_ratio", "fills_per_pixel", "bytes_per_pixel"};
    for (size_t n = 0; n < AOB_COUNT(names); n++)
        for (size_t f = 0; f < AOB_COUNT(flights); f++) {
            struct aob_text name = {0};
            aob_text_add(&name, "cache.%s.%s.%s.%s", profile, aob_member_text(level, "name"), flights[f],
                         names[n]);
            add_figure(figures, name.data, aob_member_number(json_object_get(level, flights[f]), names[n]));
            aob_text_finish(&name);
        }
}

json_t *aob_record_figures(const json_t *record)
{
    json_t *figures = json_object(), *cache, *level;
    struct aob_metrics metrics;
    const char *profile;
    size_t i;
    aob_metrics_from_json(&metrics, json_object_get(record, "error"));
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        add_figure(figures, m->name, aob_metric_get(&metrics, m));
    json_object_foreach(json_object_get(record, "cache"), profile, cache)
    {
        json_array_foreach(json_object_get(json_object_get(cache, "frame"), "levels"), i, level)
        {
            add_level(figures, profile, level);
        }
    }
    return figures;
}
