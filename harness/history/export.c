#include "export.h"
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/csv_field.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/part.h"
#include "base/text.h"
#include "database.h"
#include "store/metric.h"

/* The names of its columns are those of the table's, but the last one, which holds the rest of them. */
static const char sql_points[] =
    "SELECT point.night AS night, night.date AS date, config, class.text AS class, point.build AS build, "
    "image,"
    " verdict, since, said, ref_ms, key, series, folder AS run, scene, view, technique, point.module AS "
    "module,"
    " params, options, backend, size, status, reason, target_radius, target_weighting, reference,"
    " cost_ms AS time_ms, ratio AS ratio_to_ref, low AS ci_low, high AS ci_high, memory_bytes, figures.json"
    " FROM night JOIN point ON point.night = night.id JOIN line ON line.id = point.line"
    " JOIN class ON class.id = line.class LEFT JOIN figures ON figures.line = line.id AND figures.night = "
    "night.id"
    " WHERE (?1 IS NULL OR night.name = ?1) AND (?2 IS NULL OR night.date >= ?2)"
    " ORDER BY point.night, point.line";
static const char sql_caches[] =
    "SELECT DISTINCT each.key FROM night JOIN figures ON figures.night = night.id, json_each(figures.json) "
    "AS each"
    " WHERE (?1 IS NULL OR night.name = ?1) AND (?2 IS NULL OR night.date >= ?2) AND each.key LIKE 'cache.%'"
    " ORDER BY each.key";

/* A table while it is written. */
struct table {
    bool json;
    char **figures; /* names of the columns behind those of the query */
    size_t count, room;
    struct aob_query query;
    struct aob_text line;
    struct aob_part part;
};

static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path), tail = strlen(ending);
    return length > tail && strcmp(path + length - tail, ending) == 0;
}

/* "2026-11-30" and what may follow of a date as a night has it. */
static bool is_date(const char *text)
{
    static const char form[] = "0000-00-00T00:00:00Z";
    size_t length = strlen(text);
    for (size_t i = 0; i < length && i < sizeof form; i++)
        if (form[i] == '0' ? text[i] < '0' || text[i] > '9' : text[i] != form[i])
            return false;
    return length == 10 || length == sizeof form - 1;
}

bool aob_export_check(const struct aob_export_desc *desc, struct aob_error *error)
{
    if (!ends_in(desc->path, ".csv") && !ends_in(desc->path, ".jsonl"))
        return aob_fail(error, "%s: its ending says the form: .csv or .jsonl", desc->path);
    return !desc->from || is_date(desc->from) ||
           aob_fail(error, "'%s' is no date such as 2026-11-30 or 2026-11-30T02:00:00Z", desc->from);
}

static void add_name(struct table *table, const char *name)
{
    *AOB_PUSH(table->figures, table->count, table->room) = aob_strdup(name);
}

static bool name_figures(struct table *table, struct aob_history *history, const struct aob_export_desc *desc,
                         struct aob_error *error)
{
    struct aob_query query;
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        add_name(table, m->name);
    aob_query_begin(&query, history, sql_caches, error);
    aob_query_text(&query, desc->config);
    aob_query_text(&query, desc->from);
    while (aob_query_step(&query)) {
        char *name = aob_query_copy(&query, 0);
        add_name(table, name);
        free(name);
    }
    return aob_query_end(&query);
}

static int own_columns(const struct table *table)
{
    return sqlite3_column_count(table->query.statement) - 1;
}

static bool send_line(struct table *table, const char *end, struct aob_error *error)
{
    aob_text_add(&table->line, "%s", end);
    bool ok = aob_part_write(&table->part, table->line.data, table->line.size, error);
    table->line.size = 0;
    return ok;
}

static void add_comma(struct table *table)
{
    aob_text_add(&table->line, table->line.size ? "," : "");
}

static bool send_names(struct table *table, struct aob_error *error)
{
    for (int i = 0; i < own_columns(table); i++) {
        add_comma(table);
        aob_csv_add_text(&table->line, sqlite3_column_name(table->query.statement, i));
    }
    for (size_t i = 0; i < table->count; i++) {
        add_comma(table);
        aob_csv_add_text(&table->line, table->figures[i]);
    }
    return send_line(table, "\r\n", error);
}

static bool send_csv(struct table *table, const json_t *figures, struct aob_error *error)
{
    for (int i = 0; i < own_columns(table); i++) {
        if (i)
            aob_text_add(&table->line, ",");
        if (sqlite3_column_type(table->query.statement, i) == SQLITE_TEXT)
            aob_csv_add_text(&table->line, (const char *)sqlite3_column_text(table->query.statement, i));
        else
            aob_csv_add_number(&table->line, aob_query_get_number(&table->query, i));
    }
    for (size_t i = 0; i < table->count; i++) {
        aob_text_add(&table->line, ",");
        aob_csv_add_number(&table->line, aob_json_to_number(json_object_get(figures, table->figures[i])));
    }
    return send_line(table, "\r\n", error);
}

static void add_json(struct aob_text *line, const char *text)
{
    json_t *value = json_string(text);
    char *shown = aob_json_line(value ? value : json_null(), 17);
    aob_text_add(line, "%s", shown);
    free(shown);
    json_decref(value);
}

/* As in CSV, so that both say the same, but for what JSON has no word for. */
static void add_json_number(struct aob_text *line, double value)
{
    if (isnan(value))
        aob_text_add(line, "null");
    else if (isinf(value))
        aob_text_add(line, value > 0 ? "1e999" : "-1e999");
    else
        aob_csv_add_number(line, value);
}

static void add_member(struct table *table, const char *name)
{
    aob_text_add(&table->line, table->line.size ? "," : "{");
    add_json(&table->line, name);
    aob_text_add(&table->line, ":");
}

static bool send_json(struct table *table, const json_t *figures, struct aob_error *error)
{
    sqlite3_stmt *row = table->query.statement;
    for (int i = 0; i < own_columns(table); i++) {
        add_member(table, sqlite3_column_name(row, i));
        if (sqlite3_column_type(row, i) == SQLITE_TEXT)
            add_json(&table->line, (const char *)sqlite3_column_text(row, i));
        else
            add_json_number(&table->line, aob_query_get_number(&table->query, i));
    }
    for (size_t i = 0; i < table->count; i++) {
        add_member(table, table->figures[i]);
        add_json_number(&table->line, aob_json_to_number(json_object_get(figures, table->figures[i])));
    }
    return send_line(table, "}\n", error);
}

static bool send_row(struct table *table, struct aob_error *error)
{
    const char *text = (const char *)sqlite3_column_text(table->query.statement, own_columns(table));
    json_t *figures = json_loads(text ? text : "", 0, NULL);
    bool ok = table->json ? send_json(table, figures, error) : send_csv(table, figures, error);
    json_decref(figures);
    return ok;
}

static bool send_all(struct table *table, size_t *rows, struct aob_error *error)
{
    bool ok = !table->query.failed && (table->json || send_names(table, error));
    for (*rows = 0; ok && aob_query_step(&table->query); ++*rows)
        ok = send_row(table, error);
    return ok;
}

static bool write_table(struct table *table, struct aob_history *history, const struct aob_export_desc *desc,
                        size_t *rows, struct aob_error *error)
{
    char *target = aob_file_target(desc->path, error);
    if (!target || !aob_part_create(&table->part, target, error)) {
        free(target);
        return false;
    }
    aob_query_begin(&table->query, history, sql_points, error);
    aob_query_text(&table->query, desc->config);
    aob_query_text(&table->query, desc->from);
    bool ok = send_all(table, rows, error);
    ok = aob_query_end(&table->query) && ok;
    if (ok)
        ok = aob_part_keep(&table->part, error);
    else
        aob_part_drop(&table->part);
    free(target);
    return ok;
}

/* In one transaction, since another program may write meanwhile. */
bool aob_history_export(struct aob_history *history, const struct aob_export_desc *desc, size_t *rows,
                        struct aob_error *error)
{
    struct table table = {.json = ends_in(desc->path, ".jsonl")};
    if (!aob_export_check(desc, error) || !aob_database_run(history, "BEGIN", error))
        return false;
    bool ok = name_figures(&table, history, desc, error) && write_table(&table, history, desc, rows, error);
    ok = aob_database_run(history, "COMMIT", ok ? error : NULL) && ok;
    for (size_t i = 0; i < table.count; i++)
        free(table.figures[i]);
    free(table.figures);
    aob_text_finish(&table.line);
    return ok;
}
