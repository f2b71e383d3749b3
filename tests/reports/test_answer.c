/* What a run answers to a budget, against brute force over what its journal was made from. */
#include <math.h>
#include "random.h"
#include "reports/page/answer.h"
#include "run_text.h"

enum { JOURNALS = 10000, MOST = 16, SCENES = 2, VIEWS = 2, SIZES = 2, TARGETS = 3, SETTINGS = 4 };
static const double radii[TARGETS] = {0.25, 1, 1}; /* the third is weighted evenly */
static const double budget_ms = 2;

/* A case as the test knows it. Shares of an interval and of a band are exact in binary. */
struct made {
    size_t scene, view, size, setting;
    bool ok, none, timed, bounded, modelled;
    double ms, low, high, model, model_low, model_high; /* low and high: shares of ms */
    double error[TARGETS];                              /* NAN: it has none */
};

static double pick(uint32_t *random, const double *values, size_t count)
{
    return values[random_below(random, count)];
}

static struct made draw(uint32_t *random)
{
    static const double lows[] = {1, 0.75, 0.5}, highs[] = {1, 1.25, 1.5};
    struct made m = {random_below(random, SCENES),
                     random_below(random, VIEWS),
                     random_below(random, SIZES),
                     random_below(random, SETTINGS),
                     random_below(random, 8) > 0,
                     random_below(random, 6) == 0,
                     random_below(random, 8) > 0,
                     random_below(random, 5) > 0,
                     random_below(random, 3) > 0,
                     0.5 * (double)(1 + random_below(random, 7)),
                     pick(random, lows, 3),
                     pick(random, highs, 3),
                     0.5 * (double)(1 + random_below(random, 7)),
                     0,
                     0,
                     {0}};
    m.model_low = m.model * pick(random, lows, 3);
    m.model_high = m.model * pick(random, highs, 3);
    for (size_t t = 0; t < TARGETS; t++)
        m.error[t] = random_below(random, 4) ? 0.03125 * (double)(1 + random_below(random, 6)) : NAN;
    return m;
}

static void add_errors(struct aob_text *line, const struct made *m)
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

static void add_time(struct aob_text *line, const struct made *m)
{
    if (!m->timed)
        return;
    aob_text_add(line, ",\"time\":{\"clock\":\"cpu\",\"cpu_ms\":%g,\"wall_ms\":99,\"ratio_to_ref\":4", m->ms);
    if (m->bounded)
        aob_text_add(line, ",\"ci_low\":%g,\"ci_high\":%g}", 4 * m->low, 4 * m->high);
    else
        aob_text_add(line, ",\"ci_low\":null,\"ci_high\":null}");
}

static void add_line(struct aob_text *line, const struct made *m, size_t key)
{
    aob_text_add(
        line,
        "{\"key\":\"%zu\",\"scene\":\"s%zu\",\"view\":\"v%zu\",\"technique\":\"%s\",\"params\":{\"n\":%zu},"
        "\"options\":{},\"backend\":\"null\",\"width\":%zu,\"height\":32,\"status\":\"%s\"",
        key, m->scene, m->view, m->none ? "none" : "gtao", m->setting, 64 * (1 + m->size),
        m->ok ? "ok" : "failed");
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

static void write_plainly(const char *name, const char *text)
{
    char *path = aob_path_join(folder, name);
    FILE *file = fopen(path, "w"); /* without the flush to disk, ten thousand times */
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
    free(path);
}

/* What is asked of a journal. */
struct question {
    const struct made *list;
    size_t count;
    size_t scene, view, size, target; /* one of them */
    bool model;
    double error;
};

static bool is_in(const struct question *q, const struct made *m)
{
    return m->ok && m->scene == q->scene && m->view == q->view && m->size == q->size &&
           !isnan(m->error[q->target]);
}

static bool is_known(const struct question *q, const struct made *m)
{
    return is_in(q, m) && !m->none && (q->model ? m->modelled : m->timed);
}

static double cost(const struct question *q, const struct made *m)
{
    return q->model ? m->model : m->ms;
}

static double upper(const struct question *q, const struct made *m)
{
    return q->model ? m->model_high : m->bounded ? m->ms * m->high : INFINITY;
}

/* The most accurate whose upper end is within the budget; of those, the cheapest; of those, the first. */
static size_t brute_accurate(const struct question *q)
{
    size_t best = AOB_NO_CANDIDATE;
    for (size_t i = 0; i < q->count; i++) {
        const struct made *m = &q->list[i], *b = best == AOB_NO_CANDIDATE ? NULL : &q->list[best];
        if (!is_known(q, m) || upper(q, m) > budget_ms)
            continue;
        if (!b || m->error[q->target] < b->error[q->target] ||
            (m->error[q->target] == b->error[q->target] && cost(q, m) < cost(q, b)))
            best = i;
    }
    return best;
}

static size_t brute_cheap(const struct question *q)
{
    size_t best = AOB_NO_CANDIDATE;
    for (size_t i = 0; i < q->count; i++) {
        const struct made *m = &q->list[i], *b = best == AOB_NO_CANDIDATE ? NULL : &q->list[best];
        if (!is_known(q, m) || m->error[q->target] > q->error)
            continue;
        if (!b || cost(q, m) < cost(q, b) ||
            (cost(q, m) == cost(q, b) && m->error[q->target] < b->error[q->target]))
            best = i;
    }
    return best;
}

static bool exists(const struct question *q)
{
    bool any = false;
    for (size_t i = 0; i < q->count; i++)
        any = any || is_in(q, &q->list[i]);
    return any;
}

static const struct aob_answer_view *find_view(const struct aob_answer *answer, const struct question *q)
{
    char scene[8], view[8];
    snprintf(scene, sizeof scene, "s%zu", q->scene);
    snprintf(view, sizeof view, "v%zu", q->view);
    for (size_t i = 0; i < answer->view_count; i++) {
        const struct aob_answer_view *v = &answer->views[i];
        const struct aob_target *target = &answer->rows->targets[v->target];
        if (!strcmp(v->first->scene, scene) && !strcmp(v->first->view, view) &&
            v->first->width == 64 * (1 + (int)q->size) && target->radius == radii[q->target] &&
            target->uniform == (q->target == 2))
            return v;
    }
    return NULL;
}

static void assert_choice(const struct aob_answer_view *view, size_t choice, size_t expected)
{
    assert_int_equal(choice == AOB_NO_CANDIDATE ? choice : view->list[choice].of, expected);
}

/* Every view by itself; how many there are. */
static size_t check_views(const struct aob_answer *answer, struct question q)
{
    size_t count = 0;
    for (size_t n = 0; n < SCENES * VIEWS * SIZES * TARGETS; n++) {
        q.scene = n % SCENES;
        q.view = n / SCENES % VIEWS;
        q.size = n / SCENES / VIEWS % SIZES;
        q.target = n / SCENES / VIEWS / SIZES;
        const struct aob_answer_view *view = find_view(answer, &q);
        assert_int_equal(view != NULL, exists(&q));
        if (!view)
            continue;
        count++;
        size_t known = 0;
        for (size_t i = 0; i < q.count; i++)
            known += is_known(&q, &q.list[i]);
        assert_int_equal(view->count, known);
        for (size_t i = 0; i < view->count; i++)
            assert_true(view->list[i].error == q.list[view->list[i].of].error[q.target]);
        assert_choice(view, view->choice.accurate, brute_accurate(&q));
        assert_choice(view, view->choice.cheap, brute_cheap(&q));
    }
    return count;
}

/* The largest error and upper end of a setting over the scenes and views of a size and target; false if it lacks one. */
static bool brute_setting(struct question q, size_t setting, double *error, double *high)
{
    *error = *high = 0;
    for (size_t n = 0; n < SCENES * VIEWS; n++) {
        q.scene = n % SCENES;
        q.view = n / SCENES;
        bool has = false;
        for (size_t i = 0; i < q.count; i++)
            if (is_known(&q, &q.list[i]) && q.list[i].setting == setting) {
                has = true;
                *error = fmax(*error, q.list[i].error[q.target]);
                *high = fmax(*high, upper(&q, &q.list[i]));
            }
        if (exists(&q) && !has)
            return false;
    }
    return true;
}

static size_t check_wholes(const struct aob_answer *answer, struct question q)
{
    size_t fitting = 0;
    for (size_t w = 0; w < answer->whole_count; w++) {
        const struct aob_answer_whole *whole = &answer->wholes[w];
        const struct aob_target *target = &answer->rows->targets[whole->target];
        double best = INFINITY, error, high;
        q.size = (size_t)whole->first->width / 64 - 1;
        q.target = target->uniform ? 2 : target->radius == 1;
        for (size_t s = 0; s < SETTINGS; s++)
            if (brute_setting(q, s, &error, &high) && high <= budget_ms)
                best = fmin(best, error);
        size_t choice = whole->choice.accurate;
        assert_int_equal(choice != AOB_NO_CANDIDATE, isfinite(best));
        if (choice == AOB_NO_CANDIDATE)
            continue;
        assert_true(whole->list[choice].error == best);
        fitting++;
    }
    return fitting;
}

static void test_random_journals(void **state)
{
    (void)state;
    uint32_t random = 15;
    size_t fitting = 0;
    for (int n = 0; n < JOURNALS; n++) {
        struct made list[MOST];
        struct aob_text journal = {0};
        struct aob_rows rows;
        struct aob_answer answer;
        struct question q = {.list = list, .count = 1 + random_below(&random, MOST)};
        q.model = random_below(&random, 2);
        q.error = 0.03125 * (double)(1 + random_below(&random, 6));
        for (size_t i = 0; i < q.count; i++) {
            list[i] = draw(&random);
            add_line(&journal, &list[i], i);
        }
        write_plainly("journal.jsonl", journal.data);
        aob_text_finish(&journal);
        read_rows(&rows);
        aob_answer_make(
            &answer, &rows,
            &(struct aob_ask){
                .ms = budget_ms, .error = q.error, .profile = q.model ? "ps4" : NULL, .radius = NAN});
        assert_int_equal(check_views(&answer, q), answer.view_count);
        fitting += check_wholes(&answer, q);
        aob_answer_finish(&answer);
        aob_rows_finish(&rows);
    }
    assert_true(fitting > JOURNALS / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random_journals)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
