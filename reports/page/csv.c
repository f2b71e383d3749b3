#include "csv.h"
#include <math.h>
#include <stdlib.h>
#include "base/csv_field.h"
#include "base/file.h"
#include "base/text.h"
#include "cache_figures.h"
#include "label.h"

static const char names[] =
    "key,series,run,scene,view,technique,module,params,options,backend,size,status,reason,target_radius,"
    "target_weighting,reference,time_ms,ratio_to_ref,ci_low,ci_high,memory_bytes";

static void add_text(struct aob_text *csv, const char *text)
{
    aob_text_add(csv, ",");
    aob_csv_add_text(csv, text);
}

static void add_number(struct aob_text *csv, double value)
{
    aob_text_add(csv, ",");
    aob_csv_add_number(csv, value);
}

static void add_case(struct aob_text *csv, const struct aob_rows *rows, const struct aob_row *row)
{
    char *params = aob_label_params(row), *options = aob_label_options(row);
    aob_csv_add_text(csv, row->key); /* the first field has no comma before it */
    add_text(csv, row->series);
    add_text(csv, rows->runs[row->run].folder); /* two runs may share a name */
    add_text(csv, row->scene);
    add_text(csv, row->view);
    add_text(csv, row->name);
    add_text(csv, row->module);
    add_text(csv, params);
    add_text(csv, options);
    add_text(csv, row->backend);
    if (row->width && row->height)
        aob_text_add(csv, ",%dx%d", row->width, row->height);
    else
        aob_text_add(csv, ",");
    add_text(csv, row->status);
    add_text(csv, row->reason);
    free(params);
    free(options);
}

/* The figures of caches that some row has: their columns come last, as each run has others. */
struct cache_columns {
    struct aob_cache_column *list;
    size_t count;
};

static void add_cache_names(struct aob_text *csv, const struct cache_columns *columns)
{
    for (size_t i = 0; i < columns->count; i++) {
        const struct aob_cache_column *c = &columns->list[i];
        struct aob_text name = {0};
        aob_text_add(&name, "cache.%s.%s.%s.%s", c->profile, c->level, c->flight, c->name);
        add_text(csv, name.data);
        aob_text_finish(&name);
    }
}

static void add_line(struct aob_text *csv, const struct aob_rows *rows, const struct aob_row *row,
                     const struct aob_score *score, const struct cache_columns *columns)
{
    const struct aob_target *target = score ? &rows->targets[score->target] : NULL;
    add_case(csv, rows, row);
    add_number(csv, target ? target->radius : NAN);
    add_text(csv, !target ? "" : target->uniform ? "uniform" : "cosine");
    add_text(csv, !target ? "" : target->screen ? "screen" : "ray-traced");
    add_number(csv, row->cost_ms);
    add_number(csv, row->ratio);
    add_number(csv, row->ci_low);
    add_number(csv, row->ci_high);
    add_number(csv, row->memory_bytes);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        add_number(csv, score ? aob_metric_get(&score->metrics, m) : NAN);
    for (size_t i = 0; i < columns->count; i++)
        add_number(csv, aob_cache_column_value(&columns->list[i], row));
    aob_text_add(csv, "\r\n");
}

bool aob_csv_write(const struct aob_rows *rows, const char *folder, struct aob_error *error)
{
    struct aob_text csv = {0};
    struct cache_columns columns = {0};
    columns.list = aob_cache_columns(rows, &columns.count);
    char *path = aob_path_join(folder, "cases.csv");
    aob_text_add(&csv, "%s", names);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        aob_text_add(&csv, ",%s", m->name);
    add_cache_names(&csv, &columns);
    aob_text_add(&csv, "\r\n");
    for (size_t i = 0; i < rows->count; i++) {
        const struct aob_row *row = &rows->list[i];
        for (size_t k = 0; k < row->score_count; k++)
            add_line(&csv, rows, row, &row->scores[k], &columns);
        if (!row->score_count)
            add_line(&csv, rows, row, NULL, &columns);
    }
    bool ok = aob_file_write(path, csv.data, csv.size, error);
    aob_text_finish(&csv);
    free(columns.list);
    free(path);
    return ok;
}
