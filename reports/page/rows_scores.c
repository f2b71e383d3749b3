#include "rows_scores.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

const struct aob_score *aob_row_score(const struct aob_row *row, size_t target)
{
    for (size_t i = 0; i < row->score_count; i++)
        if (row->scores[i].target == target)
            return &row->scores[i];
    return NULL;
}

const struct aob_score *aob_row_own_score(const struct aob_row *row)
{
    for (size_t i = 0; i < row->score_count; i++)
        if (row->scores[i].own)
            return &row->scores[i];
    return NULL;
}

bool aob_score_is_split(const struct aob_score *score)
{
    const struct aob_metrics *m = &score->metrics;
    return isfinite(m->definition_rmse) && isfinite(m->missing_rmse) && isfinite(m->estimator_rmse);
}

/* A record's entries; an older one has a single one, its `error`. */
static size_t entry_count(const json_t *record)
{
    const json_t *errors = json_object_get(record, "errors");
    return json_is_array(errors) ? json_array_size(errors)
                                 : (size_t)json_is_object(json_object_get(record, "error"));
}

static const json_t *entry_of(const json_t *record, size_t index)
{
    const json_t *errors = json_object_get(record, "errors");
    return json_is_array(errors) ? json_array_get(errors, index) : json_object_get(record, "error");
}

static int compare(const void *a, const void *b)
{
    return aob_target_compare(a, b);
}

/* All targets are gathered, sorted and thinned out before any score looks for its own. */
static void list_targets(struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->count; i++)
        for (size_t k = 0; k < entry_count(rows->list[i].json); k++)
            if (json_is_object(entry_of(rows->list[i].json, k)))
                *AOB_PUSH(rows->targets, rows->target_count, rows->target_capacity) =
                    aob_target_of(entry_of(rows->list[i].json, k), rows->list[i].json);
    if (!rows->target_count)
        return;
    size_t used = 1;
    qsort(rows->targets, rows->target_count, sizeof *rows->targets, compare);
    for (size_t i = 1; i < rows->target_count; i++)
        if (compare(&rows->targets[i], &rows->targets[used - 1]) != 0)
            rows->targets[used++] = rows->targets[i];
    rows->target_count = used;
}

static size_t find_target(const struct aob_rows *rows, const struct aob_target *target)
{
    const struct aob_target *found =
        bsearch(target, rows->targets, rows->target_count, sizeof *target, compare);
    return (size_t)(found - rows->targets);
}

static void take_entry(const struct aob_rows *rows, struct aob_row *row, const json_t *entry)
{
    struct aob_target target = aob_target_of(entry, row->json);
    const json_t *error = json_object_get(row->json, "error");
    struct aob_target own = aob_target_of(error, row->json);
    size_t place = find_target(rows, &target);
    if (aob_row_score(row, place))
        return;
    struct aob_score *score = &row->scores[row->score_count++];
    *score = (struct aob_score){
        .target = place,
        .json = entry,
        .truth = aob_member_text(entry, "truth"),
        .own = json_is_object(error) && aob_target_compare(&own, &target) == 0,
    };
    aob_metrics_from_json(&score->metrics, entry);
}

static int by_target(const void *a, const void *b)
{
    const struct aob_score *p = a, *q = b;
    return (p->target > q->target) - (p->target < q->target);
}

void aob_rows_read_scores(struct aob_rows *rows)
{
    list_targets(rows);
    for (size_t i = 0; i < rows->count; i++) {
        struct aob_row *row = &rows->list[i];
        size_t count = entry_count(row->json);
        if (!count)
            continue;
        row->scores = AOB_NEW_ARRAY(struct aob_score, count);
        for (size_t k = 0; k < count; k++)
            if (json_is_object(entry_of(row->json, k)))
                take_entry(rows, row, entry_of(row->json, k));
        qsort(row->scores, row->score_count, sizeof *row->scores, by_target);
    }
}
