#include <stdio.h>
#include <stdlib.h>
#include "base/hash.h"
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "base/text.h"
#include "record.h"
#include "take.h"

/* A record on its way to its point. */
struct item {
    const json_t *record;
    char *machine, *clock, *params, *options, *size;
    const char *series, *module; /* of its line */
    int64_t class, line;
};

/* What is asked again for each record. */
struct points {
    struct aob_taking *taking;
    json_t *clocks;               /* how this run timed, by aob_record_timed_as */
    json_t *machines;             /* on what, by backend */
    json_t *builds;               /* of its plan: technique to an object of module files */
    size_t left_out;              /* cases whose line had a point of this night already */
    char first_out[AOB_KEY_SIZE]; /* key of one */
    struct aob_query find_class, add_class, find_line, follow_series, follow_case, add_line, add_point,
        add_figures;
};

static const char sql_find_class[] = "SELECT id FROM class WHERE text = ?",
                  sql_add_class[] = "INSERT INTO class(text, machine, clock) VALUES(?, ?, ?)",
                  sql_find_line[] =
                      "SELECT id FROM line WHERE series = ? AND class = ? AND config = ? AND module = ?",
                  sql_add_line[] =
                      "INSERT INTO line(series, class, config, module, scene, view, technique, backend, size,"
                      " params, options, text) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                  sql_add_point[] =
                      "INSERT INTO point(line, night, key, build, image, status, reason, module,"
                      " ratio, low, high, cost_ms, ref_ms, memory_bytes, rmse, band_rmse, reference_se,"
                      " band_pixels, target_radius, target_weighting, reference)"
                      " VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"
                      " ON CONFLICT DO NOTHING",
                  sql_add_figures[] = "INSERT INTO figures VALUES(?, ?, ?)";

/* The line of the case that this night has no point of yet: of the machine and clock that the run's other cases name, if there
 * is one, and then the one whose last point is the latest. */
#define FOLLOW(which)                                                                                        \
    "SELECT line.id FROM line JOIN class ON class.id = line.class WHERE config = ?1 AND module = ?2 AND "    \
    "(?3 = '' OR machine = ?3) AND NOT EXISTS(SELECT 1 FROM point WHERE line = line.id AND night = ?4) "     \
    "AND " which " ORDER BY ?5 IN ('', machine) DESC, ?6 IN ('', clock) DESC,"                               \
    " (SELECT max(night) FROM point WHERE line = line.id) DESC, line.id DESC LIMIT 1"
static const char sql_follow_series[] = FOLLOW("series = ?7"),
                  sql_follow_case[] =
                      FOLLOW("technique = ?7 AND params = ?8 AND scene = ?9 AND view = ?10 AND "
                             "backend = ?11 AND size = ?12 AND options = ?13");

static void prepare(struct points *points, struct aob_error *error)
{
    struct aob_history *history = points->taking->history;
    aob_query_begin(&points->find_class, history, sql_find_class, error);
    aob_query_begin(&points->add_class, history, sql_add_class, error);
    aob_query_begin(&points->find_line, history, sql_find_line, error);
    aob_query_begin(&points->follow_series, history, sql_follow_series, error);
    aob_query_begin(&points->follow_case, history, sql_follow_case, error);
    aob_query_begin(&points->add_line, history, sql_add_line, error);
    aob_query_begin(&points->add_point, history, sql_add_point, error);
    aob_query_begin(&points->add_figures, history, sql_add_figures, error);
}

static bool finish(struct points *points)
{
    struct aob_query *const queries[] = {&points->find_class,    &points->add_class,   &points->find_line,
                                         &points->follow_series, &points->follow_case, &points->add_line,
                                         &points->add_point,     &points->add_figures};
    bool ok = true;
    for (size_t i = 0; i < AOB_COUNT(queries); i++)
        ok = aob_query_end(queries[i]) && ok;
    json_decref(points->clocks);
    json_decref(points->machines);
    json_decref(points->builds);
    return ok;
}

/* The id in the first row, or 0. */
static int64_t ask(struct aob_query *query)
{
    int64_t id = aob_query_step(query) ? aob_query_get_whole(query, 0) : 0;
    aob_query_reset(query);
    return id;
}

static int64_t add(struct aob_query *query)
{
    return aob_query_run(query) ? sqlite3_last_insert_rowid(query->history->db) : 0;
}

/* Which files of a technique the run was planned with, whether or not a case of each has come. Without a plan the records are
 * one. */
static void look_at_plan(struct points *points)
{
    const json_t *plan = json_object_get(points->taking->info, "techniques");
    json_t *technique;
    size_t i;
    json_array_foreach(plan ? plan : points->taking->records, i, technique)
    {
        const char *name = aob_member_text(technique, plan ? "name" : "technique");
        if (!json_object_get(points->builds, name))
            json_object_set_new(points->builds, name, json_object());
        json_object_set_new(json_object_get(points->builds, name), aob_member_text(technique, "module"),
                            json_true());
    }
}

/* What the run's records tell of each other. */
static void look_around(struct points *points)
{
    json_t *record;
    size_t i;
    json_array_foreach(points->taking->records, i, record)
    {
        char *alike = aob_record_timed_as(record), *clock = aob_record_clock(record),
             *machine = aob_record_machine(record);
        if (*clock)
            json_object_set_new(points->clocks, alike, json_string(clock));
        if (*machine)
            json_object_set_new(points->machines, aob_member_text(record, "backend"), json_string(machine));
        free(machine);
        free(alike);
        free(clock);
    }
}

/* A case that broke before it was timed would have been timed as the others were. */
static char *clock_of(const struct points *points, const json_t *record)
{
    char *alike = aob_record_timed_as(record), *clock = aob_record_clock(record);
    const char *usual = json_string_value(json_object_get(points->clocks, alike));
    if (!*clock && usual) {
        free(clock);
        clock = aob_strdup(usual);
    }
    free(alike);
    return clock;
}

/* Two builds of one technique are two lines, told apart by their files. */
static const char *module_of(const struct points *points, const json_t *record)
{
    const json_t *builds = json_object_get(points->builds, aob_member_text(record, "technique"));
    return json_object_size(builds) > 1 ? aob_member_text(record, "module") : "";
}

static struct item begin_item(const struct points *points, const json_t *record)
{
    const char *series = aob_member_text(record, "series");
    return (struct item){.record = record,
                         .machine = aob_record_machine(record),
                         .clock = clock_of(points, record),
                         .params = aob_record_params(record),
                         .options = aob_record_options(record),
                         .size = aob_record_size(record),
                         .series = *series ? series : aob_member_text(record, "key"),
                         .module = module_of(points, record)};
}

static void finish_item(struct item *item)
{
    free(item->machine);
    free(item->clock);
    free(item->params);
    free(item->options);
    free(item->size);
}

static int64_t class_of(struct points *points, const struct item *item)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s%s%s", *item->machine ? item->machine : "no device", *item->clock ? ", " : "",
                 item->clock);
    aob_query_text(&points->find_class, text.data);
    int64_t id = ask(&points->find_class);
    if (!id) {
        aob_query_text(&points->add_class, text.data);
        aob_query_text(&points->add_class, item->machine);
        aob_query_text(&points->add_class, item->clock);
        id = add(&points->add_class);
    }
    aob_text_finish(&text);
    return id;
}

static void bind_identity(struct aob_query *query, const struct points *points, const struct item *item)
{
    aob_query_text(query, item->series);
    aob_query_whole(query, item->class);
    aob_query_text(query, points->taking->config);
    aob_query_text(query, item->module);
}

static int64_t add_line(struct points *points, const struct item *item)
{
    static const char *const names[] = {"scene", "view", "technique", "backend"};
    struct aob_query *query = &points->add_line;
    char *title = aob_record_title(item->record, points->taking->info, item->module);
    bind_identity(query, points, item);
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        aob_query_text(query, aob_member_text(item->record, names[i]));
    aob_query_text(query, item->size);
    aob_query_text(query, item->params);
    aob_query_text(query, item->options);
    aob_query_text(query, title);
    int64_t id = add(query);
    free(title);
    return id;
}

static int64_t line_of(struct points *points, const struct item *item)
{
    bind_identity(&points->find_line, points, item);
    int64_t id = ask(&points->find_line);
    return id ? id : add_line(points, item);
}

static void bind_follow(struct aob_query *query, const struct points *points, const struct item *item)
{
    aob_query_text(query, points->taking->config);
    aob_query_text(query, item->module);
    aob_query_text(query, item->machine);
    aob_query_whole(query, points->taking->night);
    aob_query_text(query, aob_member_text(points->machines, aob_member_text(item->record, "backend")));
    aob_query_text(query, item->clock);
}

/* The line that a case without a time, or one that reached no device, goes on; 0: there is none. */
static int64_t followed(struct points *points, const struct item *item)
{
    struct aob_query *query = &points->follow_series;
    if (*aob_member_text(item->record, "series")) {
        bind_follow(query, points, item);
        aob_query_text(query, item->series);
        return ask(query);
    }
    query = &points->follow_case;
    bind_follow(query, points, item);
    aob_query_text(query, aob_member_text(item->record, "technique"));
    aob_query_text(query, item->params);
    aob_query_text(query, aob_member_text(item->record, "scene"));
    aob_query_text(query, aob_member_text(item->record, "view"));
    aob_query_text(query, aob_member_text(item->record, "backend"));
    aob_query_text(query, item->size);
    aob_query_text(query, item->options);
    return ask(query);
}

static void bind_time(struct aob_query *query, const json_t *record)
{
    static const char *const names[] = {"ratio_to_ref", "ci_low", "ci_high"};
    const json_t *time = json_object_get(record, "time");
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        aob_query_number(query, aob_member_number(time, names[i]));
    aob_query_number(query, aob_record_cost_ms(record));
    aob_query_number(query, aob_member_number(time, "ref_ms"));
}

static void bind_error(struct aob_query *query, const json_t *record)
{
    static const char *const names[] = {"rmse", "band_rmse", "reference_se", "band_pixels"};
    const json_t *error = json_object_get(record, "error");
    struct aob_record_target target = aob_record_target(record);
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        aob_query_number(query, aob_member_number(error, names[i]));
    aob_query_number(query, target.radius);
    aob_query_text(query, target.weighting);
    aob_query_text(query, target.reference);
}

static void add_figures(struct points *points, const struct item *item)
{
    json_t *figures = aob_record_figures(item->record);
    char *text = aob_json_line(figures, 9);
    struct aob_query *query = &points->add_figures;
    aob_query_whole(query, item->line);
    aob_query_whole(query, points->taking->night);
    aob_query_text(query, text);
    aob_query_run(query);
    free(text);
    json_decref(figures);
}

static void add_point(struct points *points, const struct item *item)
{
    const json_t *record = item->record;
    struct aob_query *query = &points->add_point;
    aob_query_whole(query, item->line);
    aob_query_whole(query, points->taking->night);
    aob_query_text(query, aob_member_text(record, "key"));
    aob_query_text(query, aob_member_text(aob_record_technique(record, points->taking->info), "digest"));
    aob_query_text(query, aob_member_text(record, "image_digest"));
    aob_query_text(query, aob_member_text(record, "status"));
    aob_query_text(query, aob_member_text(record, "reason"));
    aob_query_text(query, aob_member_text(record, "module"));
    bind_time(query, record);
    aob_query_number(query, aob_member_number(record, "memory_bytes"));
    bind_error(query, record);
    bool added = aob_query_run(query) && sqlite3_changes(query->history->db) == 1;
    if (added)
        add_figures(points, item);
    else if (!query->failed && !points->left_out++)
        snprintf(points->first_out, sizeof points->first_out, "%s", aob_member_text(record, "key"));
}

static void take_record(struct points *points, const json_t *record, bool following)
{
    struct item item = begin_item(points, record);
    if (following)
        item.line = followed(points, &item);
    if (!item.line) {
        item.class = class_of(points, &item);
        item.line = line_of(points, &item);
    }
    add_point(points, &item);
    finish_item(&item);
}

/* That is no reason to lose the night. */
static void tell_left_out(const struct points *points)
{
    if (points->left_out)
        aob_warn(
            "%s: %zu of its cases (the first has the key %s) would be a second point of a line in one night: "
            "the first point stays, and the kept journal has them all",
            points->taking->folder, points->left_out, points->first_out);
}

/* What a record says of its line decides; those that do not say enough come after them. */
bool aob_take_points(struct aob_taking *taking, struct aob_error *error)
{
    struct points points = {
        .taking = taking, .clocks = json_object(), .machines = json_object(), .builds = json_object()};
    json_t *record;
    size_t i;
    prepare(&points, error);
    look_at_plan(&points);
    look_around(&points);
    for (int following = 0; following < 2; following++)
        json_array_foreach(taking->records, i, record)
        {
            char *clock = clock_of(&points, record);
            bool says = *clock && *aob_member_text(record, "series");
            free(clock);
            if (says == !following)
                take_record(&points, record, following);
        }
    tell_left_out(&points);
    return finish(&points);
}
