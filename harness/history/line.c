#include "line.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "database.h"

const char *const aob_night_verdict_names[] = {"none",    "first", "slower", "faster",  "moved",  "outlier",
                                               "machine", "open",  "broken", "changed", "failing"};

static const char sql_lines[] =
    "SELECT line.id, series, class.text, config, scene, view, technique, backend, size, params, options, "
    "module,"
    " line.text, (SELECT count(*) FROM point WHERE line = line.id) AS points FROM line JOIN class ON"
    " class.id = line.class WHERE (?1 IS NULL OR config = ?1) AND points > 0 AND"
    " (?2 = 0 OR EXISTS(SELECT 1 FROM point WHERE line = line.id AND night = ?2)) ORDER BY line.id";
static const char sql_points[] =
    "SELECT night, key, build, image, status, reason, module, ratio, low, high, cost_ms, ref_ms, "
    "memory_bytes,"
    " rmse, band_rmse, reference_se, band_pixels, target_radius, target_weighting, reference, verdict, since,"
    " said FROM point WHERE line = ? ORDER BY night";
static const char sql_figures[] =
    "SELECT night, json FROM figures WHERE line = ? AND night >= ? ORDER BY night";

static int find_verdict(const char *name)
{
    int verdict = AOB_NIGHT_NONE;
    for (int i = 0; i < AOB_NIGHT_VERDICTS; i++)
        if (strcmp(aob_night_verdict_names[i], name) == 0)
            verdict = i;
    return verdict;
}

static void take_line(const struct aob_query *query, struct aob_line *line)
{
    char **const texts[] = {&line->class_name, &line->config,  &line->scene, &line->view,
                            &line->technique,  &line->backend, &line->size,  &line->params,
                            &line->options,    &line->module,  &line->text};
    line->id = aob_query_get_whole(query, 0);
    aob_query_get_text(query, 1, line->series, sizeof line->series);
    for (int i = 0; i < (int)AOB_COUNT(texts); i++)
        *texts[i] = aob_query_copy(query, i + 2);
    line->points = AOB_NEW_ARRAY(struct aob_point, (size_t)aob_query_get_whole(query, 13));
}

static void take_point(const struct aob_query *query, struct aob_point *point)
{
    double *const numbers[] = {&point->ratio,       &point->low,          &point->high,
                               &point->cost_ms,     &point->ref_ms,       &point->memory_bytes,
                               &point->rmse,        &point->band_rmse,    &point->reference_se,
                               &point->band_pixels, &point->target_radius};
    point->night = aob_query_get_whole(query, 0);
    aob_query_get_text(query, 1, point->key, sizeof point->key);
    aob_query_get_text(query, 2, point->build, sizeof point->build);
    aob_query_get_text(query, 3, point->image, sizeof point->image);
    point->status = aob_query_copy(query, 4);
    point->reason = aob_query_copy(query, 5);
    point->module = aob_query_copy(query, 6);
    for (int i = 0; i < (int)AOB_COUNT(numbers); i++)
        *numbers[i] = aob_query_get_number(query, 7 + i);
    point->target_weighting = aob_query_copy(query, 18);
    point->reference = aob_query_copy(query, 19);
    char verdict[16];
    aob_query_get_text(query, 20, verdict, sizeof verdict);
    point->verdict = find_verdict(verdict);
    point->since = aob_query_get_whole(query, 21);
    point->said = aob_query_copy(query, 22);
}

static void read_points(struct aob_query *query, struct aob_line *line)
{
    aob_query_whole(query, line->id);
    while (aob_query_step(query))
        take_point(query, &line->points[line->count++]);
    aob_query_reset(query);
}

static void read_figures(struct aob_query *query, struct aob_line *line, int64_t from)
{
    aob_query_whole(query, line->id);
    aob_query_whole(query, from);
    for (size_t i = 0; aob_query_step(query);) {
        int64_t night = aob_query_get_whole(query, 0);
        while (i < line->count && line->points[i].night < night)
            i++;
        if (i < line->count && line->points[i].night == night)
            line->points[i].figures =
                json_loads((const char *)sqlite3_column_text(query->statement, 1), 0, NULL);
    }
    aob_query_reset(query);
}

static bool read_all(struct aob_history *history, const struct aob_lines_ask *ask, struct aob_lines *lines,
                     struct aob_error *error)
{
    struct aob_query query, points, figures;
    size_t room = 0;
    aob_query_begin(&query, history, sql_lines, error);
    aob_query_begin(&points, history, sql_points, error);
    aob_query_begin(&figures, history, sql_figures, error);
    aob_query_text(&query, ask->config);
    aob_query_whole(&query, ask->night);
    while (aob_query_step(&query)) {
        struct aob_line *line = AOB_PUSH(lines->items, lines->count, room);
        take_line(&query, line);
        read_points(&points, line);
        if (ask->figures)
            read_figures(&figures, line, ask->figures);
    }
    bool ok = aob_query_end(&query);
    ok = aob_query_end(&points) && ok;
    return aob_query_end(&figures) && ok;
}

/* In one transaction, since another program may write meanwhile. */
bool aob_lines_read(struct aob_history *history, const struct aob_lines_ask *ask, struct aob_lines *lines,
                    struct aob_error *error)
{
    *lines = (struct aob_lines){0};
    if (!aob_database_run(history, "BEGIN", error))
        return false;
    bool ok = read_all(history, ask, lines, error);
    ok = aob_database_run(history, "COMMIT", ok ? error : NULL) && ok;
    if (!ok)
        aob_lines_finish(lines);
    return ok;
}

static void finish_points(struct aob_line *line)
{
    for (size_t i = 0; i < line->count; i++) {
        struct aob_point *p = &line->points[i];
        free(p->status);
        free(p->reason);
        free(p->module);
        free(p->target_weighting);
        free(p->reference);
        free(p->said);
        json_decref(p->figures);
    }
    free(line->points);
}

void aob_lines_finish(struct aob_lines *lines)
{
    for (size_t i = 0; i < lines->count; i++) {
        struct aob_line *l = &lines->items[i];
        char *const texts[] = {l->class_name, l->config, l->scene,   l->view,   l->technique, l->backend,
                               l->size,       l->params, l->options, l->module, l->text};
        for (size_t k = 0; k < AOB_COUNT(texts); k++)
            free(texts[k]);
        finish_points(l);
    }
    free(lines->items);
    *lines = (struct aob_lines){0};
}

bool aob_lines_count(struct aob_history *history, const char *config, size_t *lines, size_t *points,
                     struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, history,
                    "SELECT count(DISTINCT line), count(*) FROM point JOIN night ON night.id = night"
                    " WHERE ?1 IS NULL OR name = ?1",
                    error);
    aob_query_text(&query, config);
    if (aob_query_step(&query)) {
        *lines = (size_t)aob_query_get_whole(&query, 0);
        *points = (size_t)aob_query_get_whole(&query, 1);
    }
    return aob_query_end(&query);
}

static bool judge(struct aob_query *query, int64_t night, const struct aob_line_verdict *verdict,
                  struct aob_error *error)
{
    struct aob_history *history = query->history;
    aob_query_text(query, aob_night_verdict_names[verdict->verdict]);
    aob_query_whole(query, verdict->since);
    aob_query_text(query, verdict->said ? verdict->said : "");
    aob_query_whole(query, verdict->line);
    aob_query_whole(query, night);
    return aob_query_run(query) && (sqlite3_changes(history->db) == 1 ||
                                    aob_fail(error, "%s: line %lld has no point in night %lld", history->path,
                                             (long long)verdict->line, (long long)night));
}

bool aob_lines_judge(struct aob_history *history, int64_t night, const struct aob_line_verdict *verdicts,
                     size_t count, struct aob_error *error)
{
    struct aob_query query;
    bool ok = true;
    if (!aob_database_begin(history, error))
        return false;
    aob_query_begin(&query, history,
                    "UPDATE point SET verdict = ?, since = ?, said = ? WHERE line = ? AND night = ?", error);
    for (size_t i = 0; ok && i < count; i++)
        ok = judge(&query, night, &verdicts[i], error);
    ok = aob_query_end(&query) && ok;
    return aob_database_end(history, ok, error);
}
