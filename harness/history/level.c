#include "level.h"
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

struct place {
    double value;
    size_t at;
};

static int compare(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    int order = (x->value > y->value) - (x->value < y->value);
    return order ? order : (x->at > y->at) - (x->at < y->at);
}

static struct place *sorted(const double *values, size_t n)
{
    struct place *places = AOB_NEW_ARRAY(struct place, n);
    for (size_t i = 0; i < n; i++)
        places[i] = (struct place){values[i], i};
    qsort(places, n, sizeof *places, compare);
    return places;
}

double aob_level_value(const double *values, const double *weights, size_t n)
{
    struct place *places = sorted(values, n);
    double total = 0, below = 0, value;
    size_t i = 0;
    for (size_t k = 0; k < n; k++)
        total += weights[k];
    /* Sums of many weights are not exact: within 1e-12 they are half. */
    while (i + 1 < n && below + weights[places[i].at] < total * (0.5 - 1e-12))
        below += weights[places[i++].at];
    value = places[i].value;
    if (i + 1 < n && below + weights[places[i].at] <= total * (0.5 + 1e-12))
        value = 0.5 * (value + places[i + 1].value);
    free(places);
    return value;
}

/* Weights and moments by rank, of which a prefix's sum takes log n steps (a Fenwick tree). Ranks count from 1. */
struct tree {
    double *weight, *moment;
    size_t n, top; /* top: the largest power of two in n */
};

static void tree_add(struct tree *tree, size_t rank, double weight, double moment)
{
    for (; rank <= tree->n; rank += rank & -rank) {
        tree->weight[rank] += weight;
        tree->moment[rank] += moment;
    }
}

/* The sums over ranks whose weights together stay below half of `total`. The next rank is the median. */
static size_t tree_half(const struct tree *tree, double total, double *weight, double *moment)
{
    size_t rank = 0;
    *weight = *moment = 0;
    for (size_t step = tree->top; step; step /= 2)
        if (rank + step <= tree->n && *weight + tree->weight[rank + step] < 0.5 * total) {
            rank += step;
            *weight += tree->weight[rank];
            *moment += tree->moment[rank];
        }
    return rank;
}

/* Place of the cost of a level from l to r, both included. */
static size_t cell(size_t l, size_t r)
{
    return r * (r + 1) / 2 + l;
}

/* The costs of all levels that end at r. */
static void costs_to(size_t r, const double *values, const double *weights, const struct place *places,
                     const size_t *ranks, struct tree *tree, double *costs)
{
    double total = 0, moment = 0, below, low;
    memset(tree->weight, 0, (tree->n + 1) * sizeof(double));
    memset(tree->moment, 0, (tree->n + 1) * sizeof(double));
    for (size_t l = r + 1; l-- > 0;) {
        double part = weights[l] * values[l];
        tree_add(tree, ranks[l], weights[l], part);
        total += weights[l];
        moment += part;
        double median = places[tree_half(tree, total, &below, &low)].value;
        costs[cell(l, r)] = fmax(moment - 2 * low - median * (total - 2 * below), 0);
    }
}

static double *level_costs(const double *values, const double *weights, size_t n)
{
    struct place *places = sorted(values, n);
    size_t *ranks = AOB_NEW_ARRAY(size_t, n);
    double *costs = AOB_NEW_ARRAY(double, n *(n + 1) / 2);
    struct tree tree = {AOB_NEW_ARRAY(double, n + 1), AOB_NEW_ARRAY(double, n + 1), n, 1};
    while (tree.top * 2 <= n)
        tree.top *= 2;
    for (size_t i = 0; i < n; i++)
        ranks[places[i].at] = i + 1;
    for (size_t r = 0; r < n; r++)
        costs_to(r, values, weights, places, ranks, &tree, costs);
    free(places);
    free(ranks);
    free(tree.weight);
    free(tree.moment);
    return costs;
}

/* The least costs of the first r + 1 values in so many levels, and where the last of them starts. Row 0 is one level. */
struct rows {
    const double *costs;
    double *least, *before; /* of this row and of the one before it */
    uint32_t **starts;      /* starts[row][r] */
    size_t n, count, capacity;
};

static void rows_add(struct rows *rows)
{
    size_t n = rows->n, row = rows->count;
    double *swap = rows->before;
    rows->before = rows->least;
    rows->least = swap;
    *AOB_PUSH(rows->starts, rows->count, rows->capacity) = AOB_NEW_ARRAY(uint32_t, n);
    for (size_t r = 0; r < n; r++) {
        const double *costs = rows->costs + cell(0, r);
        double best = row ? INFINITY : costs[0];
        /* A longer level never costs less, so behind one that is too dear alone there is nothing. */
        for (size_t l = r; row && l >= row && costs[l] < best; l--)
            if (rows->before[l - 1] + costs[l] < best) {
                best = rows->before[l - 1] + costs[l];
                rows->starts[row][r] = (uint32_t)l;
            }
        rows->least[r] = best;
    }
}

/* Adds rows for as long as one level more could lessen the criterion, and returns how many levels do best. */
static size_t best_count(struct rows *rows)
{
    double n = (double)rows->n, floor = AOB_LEVEL_FLOOR * n, beta = 4 * log(n) / n, best = INFINITY;
    size_t levels = 1;
    while (rows->count < rows->n && beta * (double)(rows->count + 1) + log(floor) < best) {
        rows_add(rows);
        double criterion = beta * (double)rows->count + log(floor + rows->least[rows->n - 1]);
        if (criterion < best) {
            best = criterion;
            levels = rows->count;
        }
    }
    return levels;
}

static void read_back(const struct rows *rows, const double *values, const double *weights,
                      struct aob_levels *levels)
{
    levels->starts = AOB_NEW_ARRAY(size_t, levels->count);
    levels->values = AOB_NEW_ARRAY(double, levels->count);
    for (size_t row = levels->count, end = rows->n; row-- > 0;) {
        size_t start = rows->starts[row][end - 1];
        levels->starts[row] = start;
        levels->values[row] = aob_level_value(values + start, weights + start, end - start);
        end = start;
    }
}

void aob_levels_fit(const double *values, const double *weights, size_t n, struct aob_levels *levels)
{
    *levels = (struct aob_levels){0};
    if (n == 0)
        return;
    double *costs = level_costs(values, weights, n);
    struct rows rows = {
        .costs = costs, .least = AOB_NEW_ARRAY(double, n), .before = AOB_NEW_ARRAY(double, n), .n = n};
    levels->count = best_count(&rows);
    read_back(&rows, values, weights, levels);
    for (size_t row = 0; row < rows.count; row++)
        free(rows.starts[row]);
    free(rows.starts);
    free(rows.least);
    free(rows.before);
    free(costs);
}

void aob_levels_finish(struct aob_levels *levels)
{
    free(levels->starts);
    free(levels->values);
    *levels = (struct aob_levels){0};
}
