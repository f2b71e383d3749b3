#include "rows.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/journal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *aob_member_text(const json_t *object, const char *name)
{
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : "";
}

double aob_member_number(const json_t *object, const char *name)
{
    return aob_json_to_number(json_object_get(object, name));
}

char *aob_member_show(const json_t *value)
{
    struct aob_text text = {0};
    if (json_is_string(value))
        aob_text_add(&text, "%s", json_string_value(value));
    else if (json_is_number(value))
        aob_text_add(&text, "%.6g", json_number_value(value));
    else if (json_is_boolean(value))
        aob_text_add(&text, "%s", json_is_true(value) ? "yes" : "no");
    else
        aob_text_add(&text, "%s", "?");
    return text.data ? text.data : aob_strdup("");
}

bool aob_row_is_ok(const struct aob_row *row)
{
    return strcmp(row->status, "ok") == 0;
}

bool aob_row_is_split(const struct aob_row *row)
{
    return isfinite(row->definition_rmse) && isfinite(row->missing_rmse) && isfinite(row->estimator_rmse);
}

bool aob_row_is_captured(const struct aob_row *row)
{
    return strcmp(aob_member_text(json_object_get(row->json, "error"), "reference"), "screen") == 0;
}

static int small_int(double value)
{
    return value >= 1 && value <= 65536 ? (int)value : 0;
}

/* What the case is judged by: processor time on a software driver, wall time on a GPU. */
static double cost_of(const json_t *time)
{
    bool wall = strcmp(aob_member_text(time, "clock"), "wall") == 0;
    return aob_member_number(time, wall ? "wall_ms" : "cpu_ms");
}

static double covariance_of(const json_t *products)
{
    return aob_member_number(products, "definition_missing") +
           aob_member_number(products, "definition_estimator") +
           aob_member_number(products, "missing_estimator");
}

static void take_line(struct aob_row *row, size_t run, const json_t *line)
{
    const json_t *time = json_object_get(line, "time"), *score = json_object_get(line, "error");
    *row = (struct aob_row){
        .run = run,
        .json = line,
        .key = aob_member_text(line, "key"),
        .scene = aob_member_text(line, "scene"),
        .view = aob_member_text(line, "view"),
        .technique = aob_member_text(line, "technique"),
        .backend = aob_member_text(line, "backend"),
        .status = aob_member_text(line, "status"),
        .reason = aob_member_text(line, "reason"),
        .image = aob_member_text(line, "image"),
        .width = small_int(aob_member_number(line, "width")),
        .height = small_int(aob_member_number(line, "height")),
        .cost_ms = cost_of(time),
        .ratio = aob_member_number(time, "ratio_to_ref"),
        .ci_low = aob_member_number(time, "ci_low"),
        .ci_high = aob_member_number(time, "ci_high"),
        .rmse = aob_member_number(score, "rmse"),
        .band_rmse = aob_member_number(score, "band_rmse"),
        .bias = aob_member_number(score, "bias"),
        .p95 = aob_member_number(score, "p95"),
        .flip = aob_member_number(score, "flip"),
        .ssim = aob_member_number(score, "ssim"),
        .reference_se = aob_member_number(score, "reference_se"),
        .definition_rmse = aob_member_number(score, "definition_rmse"),
        .missing_rmse = aob_member_number(score, "missing_rmse"),
        .estimator_rmse = aob_member_number(score, "estimator_rmse"),
        .border_share = aob_member_number(score, "border_share"),
        .covariance = covariance_of(json_object_get(score, "covariance")),
        .memory_bytes = aob_member_number(line, "memory_bytes"),
    };
}

static void read_info(struct aob_run *run)
{
    char *path = aob_path_join(run->folder, "run.json");
    run->info = json_load_file(path, 0, NULL);
    const char *name = aob_member_text(run->info, "name");
    double cases = aob_member_number(run->info, "cases");
    run->name = *name ? name : run->folder;
    run->planned = cases >= 1 && cases < 1e9 ? (size_t)cases : 0;
    free(path);
}

/* A journal may also hold cases of an earlier state of the program or its modules: their keys are not planned. */
static bool is_planned(const struct aob_run *run, const json_t *line)
{
    const json_t *keys = json_object_get(run->info, "keys"), *key;
    size_t i;
    json_array_foreach(keys, i, key)
    {
        if (strcmp(json_string_value(key) ? json_string_value(key) : "", aob_member_text(line, "key")) == 0)
            return true;
    }
    return !keys;
}

static bool read_run(struct aob_rows *rows, size_t index, struct aob_error *error)
{
    struct aob_run *run = &rows->runs[index];
    char *path = aob_path_join(run->folder, "journal.jsonl");
    read_info(run);
    if (!aob_file_exists(path) && !run->info)
        aob_fail(error, "%s: is not the folder of a run: it has no journal.jsonl", run->folder);
    else
        run->lines = aob_journal_read(path, error);
    free(path);
    size_t i;
    json_t *line;
    json_array_foreach(run->lines, i, line)
    {
        if (!is_planned(run, line))
            continue;
        take_line(AOB_PUSH(rows->list, rows->count, rows->capacity), index, line);
        run->cases++;
    }
    return run->lines != NULL;
}

/* The options that are not the same in all rows, as names of an object; decref it. */
static json_t *varying_options(const struct aob_rows *rows)
{
    json_t *varying = json_object(), *value;
    const json_t *first = rows->count ? json_object_get(rows->list[0].json, "options") : NULL;
    const char *name;
    for (size_t i = 0; i < rows->count; i++) {
        json_object_foreach(json_object_get(rows->list[i].json, "options"), name, value)
        {
            const json_t *other = json_object_get(first, name);
            if (!other || !json_equal(other, value))
                json_object_set_new(varying, name, json_true());
        }
    }
    return varying;
}

static void add_pair(struct aob_text *text, const char *name, const json_t *value)
{
    char *shown = aob_member_show(value);
    aob_text_add(text, "%s%s=%s", text->size ? " " : "", name, shown);
    free(shown);
}

static char *label_of(const json_t *line, const json_t *varying)
{
    struct aob_text text = {0};
    const char *name;
    json_t *value;
    json_object_foreach(json_object_get(line, "params"), name, value) add_pair(&text, name, value);
    json_object_foreach(json_object_get(line, "options"), name, value)
    {
        if (json_object_get(varying, name))
            add_pair(&text, name, value);
    }
    return text.data ? text.data : aob_strdup("");
}

bool aob_rows_read(struct aob_rows *rows, const char *const *folders, size_t folder_count,
                   struct aob_error *error)
{
    *rows = (struct aob_rows){.run_count = folder_count};
    rows->runs = AOB_NEW_ARRAY(struct aob_run, folder_count);
    bool ok = true;
    for (size_t i = 0; i < folder_count && ok; i++) {
        rows->runs[i].folder = folders[i];
        ok = read_run(rows, i, error);
    }
    json_t *varying = varying_options(rows);
    for (size_t i = 0; i < rows->count; i++)
        rows->list[i].label = label_of(rows->list[i].json, varying);
    json_decref(varying);
    if (!ok)
        aob_rows_finish(rows);
    return ok;
}

void aob_rows_finish(struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->count; i++)
        free(rows->list[i].label);
    for (size_t i = 0; i < rows->run_count; i++) {
        json_decref(rows->runs[i].info);
        json_decref(rows->runs[i].lines);
    }
    free(rows->list);
    free(rows->runs);
    *rows = (struct aob_rows){0};
}
