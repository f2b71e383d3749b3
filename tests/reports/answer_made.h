/* Random journals whose cases the test knows, and what is asked of them. */
#ifndef AOB_TESTS_REPORTS_ANSWER_MADE_H
#define AOB_TESTS_REPORTS_ANSWER_MADE_H
#include <math.h>
#include "random.h"
#include "reports/page/answer.h"
#include "run_text.h"

enum {
    JOURNALS = 10000,
    MOST = 20,
    SCENES = 2,
    VIEWS = 2,
    SIZES = 2,
    BACKENDS = 2,
    TARGETS = 3,
    VALUES = 2,
    OPTIONS = 2,
    MODULES = 2,
    ALL_SETTINGS = VALUES * OPTIONS * MODULES
};
static const double radii[TARGETS] = {0.25, 1, 1}; /* the third is weighted evenly */
static const char *const backends[BACKENDS] = {"null", "vulkan"};
static const double budget_ms = 2;

enum kind { OCCLUSION, NONE, DEFERRED };

/* A case as the test knows it. Shares of an interval and of a band are exact in binary. */
struct made {
    size_t scene, view, size, backend, value, options, module;
    enum kind kind;
    bool ok, timed, bounded, modelled;
    double ms, low, high, model, model_low, model_high; /* low and high: shares of ms */
    double error[TARGETS];                              /* NAN: it has none */
};

/* What is asked of a journal. */
struct question {
    const struct made *list;
    size_t count;
    size_t scene, view, size, backend, target; /* one of them */
    bool model;
    const struct aob_budget *budget; /* NULL: budget_ms is the slice */
    double error, ms;                /* ms: of the size and backend */
};

static inline size_t setting_of(const struct made *m)
{
    return m->value + VALUES * (m->options + OPTIONS * m->module);
}

static inline double pick(uint32_t *random, const double *values, size_t count)
{
    return values[random_below(random, count)];
}

/* Of each axis as many values as the journal has. */
static inline struct made draw(uint32_t *random, const size_t axes[7])
{
    static const double lows[] = {1, 0.75, 0.5}, highs[] = {1, 1.25, 1.5};
    size_t at[7], kind = random_below(random, 12);
    for (size_t i = 0; i < 7; i++)
        at[i] = random_below(random, axes[i]);
    struct made m = {.scene = at[0],
                     .view = at[1],
                     .size = at[2],
                     .backend = at[3],
                     .value = at[4],
                     .options = at[5],
                     .module = at[6],
                     .kind = kind < 9    ? OCCLUSION
                             : kind < 11 ? NONE
                                         : DEFERRED,
                     .ok = random_below(random, 8) > 0,
                     .timed = random_below(random, 8) > 0,
                     .bounded = random_below(random, 5) > 0,
                     .modelled = random_below(random, 3) > 0,
                     .ms = 0.5 * (double)(1 + random_below(random, 7)),
                     .low = pick(random, lows, 3),
                     .high = pick(random, highs, 3),
                     .model = 0.5 * (double)(1 + random_below(random, 7))};
    m.model_low = m.model * pick(random, lows, 3);
    m.model_high = m.model * pick(random, highs, 3);
    for (size_t t = 0; t < TARGETS; t++)
        m.error[t] = random_below(random, 4) ? 0.03125 * (double)(1 + random_below(random, 6)) : NAN;
    return m;
}

static inline void add_errors(struct aob_text *line, const struct made *m)
{
    const char *comma = "";
    aob_text_add(line, ",\"errors\":[");
    for (size_t t = 0; t < TARGETS; t++) {
        if (isnan(m->error[t]))
            continue;
        aob_text_add(line, "%s{\"target\":{\"radius\":%g,\"weighting\":\"%s\"},\"rmse\":%g,\"band_rmse\":%g}",
                     comma, radii[t], t == 2 ? "uniform" : "cosine", m->error[t] / 2, m->error[t]);
        comma = ",";
    }
    aob_text_add(line, "]");
}

static inline void add_time(struct aob_text *line, const struct made *m)
{
    if (!m->timed)
        return;
    aob_text_add(line, ",\"time\":{\"clock\":\"cpu\",\"cpu_ms\":%g,\"wall_ms\":99,\"ratio_to_ref\":4", m->ms);
    if (m->bounded)
        aob_text_add(line, ",\"ci_low\":%g,\"ci_high\":%g}", 4 * m->low, 4 * m->high);
    else
        aob_text_add(line, ",\"ci_low\":null,\"ci_high\":null}");
}

static inline void add_line(struct aob_text *line, const struct made *m, size_t key)
{
    static const char *const names[] = {"gtao", "none", "deferred"}, *const modules[MODULES] = {"a.so",
                                                                                                "b.so"};
    aob_text_add(
        line,
        "{\"key\":\"%zu\",\"scene\":\"s%zu\",\"view\":\"v%zu\",\"technique\":\"%s\",\"module\":\"%s\","
        "\"params\":{\"n\":%zu},\"options\":{\"guard_band\":%zu},\"backend\":\"%s\",\"width\":%zu,"
        "\"height\":32,\"status\":\"%s\"",
        key, m->scene, m->view, names[m->kind], modules[m->module], m->value, m->options,
        backends[m->backend], 64 * (1 + m->size), m->ok ? "ok" : "failed");
    add_errors(line, m);
    add_time(line, m);
    if (m->modelled)
        aob_text_add(
            line,
            ",\"cache\":{\"ps4\":{\"status\":\"ok\",\"modelled\":{\"frame\":{\"ms\":%g,\"low_ms\":%g,"
            "\"high_ms\":%g,\"limit\":\"texture\"}}}}",
            m->model, m->model_low, m->model_high);
    aob_text_add(line, "}\n");
}

/* Without the flush to disk, ten thousand times. */
static inline void write_plainly(const char *name, const char *text)
{
    char *path = aob_path_join(folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
    free(path);
}

static inline void write_journal(uint32_t *random, struct made *list, size_t count)
{
    static const size_t most[7] = {SCENES, VIEWS, SIZES, BACKENDS, VALUES, OPTIONS, MODULES};
    size_t axes[7];
    struct aob_text journal = {0};
    for (size_t i = 0; i < 7; i++)
        axes[i] = 1 + random_below(random, most[i]);
    for (size_t i = 0; i < count; i++) {
        list[i] = draw(random, axes);
        add_line(&journal, &list[i], i);
    }
    write_plainly("journal.jsonl", journal.data);
    aob_text_finish(&journal);
}
#endif
