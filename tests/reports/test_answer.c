/* What a run answers to a budget, against brute force over what its journal was made from. */
#include "answer_made.h"

static bool is_in(const struct question *q, const struct made *m)
{
    return m->ok && m->scene == q->scene && m->view == q->view && m->size == q->size &&
           m->backend == q->backend && !isnan(m->error[q->target]);
}

/* Only what may be chosen asks, whether or not its cost is known. */
static bool exists(const struct question *q)
{
    bool any = false;
    for (size_t i = 0; i < q->count; i++)
        any = any || (is_in(q, &q->list[i]) && q->list[i].kind == OCCLUSION);
    return any;
}

static bool has_cost(const struct question *q, const struct made *m)
{
    return q->model ? m->modelled : m->timed;
}

/* A case, or a setting in its worst view, as the rules see it. */
struct seen {
    double ms, low, high, error;
    size_t of;
};

static struct seen see(const struct question *q, size_t at)
{
    const struct made *m = &q->list[at];
    double error = m->error[q->target];
    if (q->model)
        return (struct seen){m->model, m->model_low, m->model_high, error, at};
    return m->bounded ? (struct seen){m->ms, m->ms * m->low, m->ms * m->high, error, at}
                      : (struct seen){m->ms, 0, INFINITY, error, at};
}

/* What is left of a size and backend, beside the dearest G-buffer and composite that is known there. */
static double brute_ms(const struct question *q)
{
    double other = 0;
    if (!q->budget)
        return budget_ms;
    for (size_t i = 0; i < q->count; i++) {
        const struct made *m = &q->list[i];
        if (!m->ok || m->kind != DEFERRED || m->size != q->size || m->backend != q->backend ||
            !has_cost(q, m))
            continue;
        struct seen cost = see(q, i);
        other = fmax(other, isinf(cost.high) ? cost.ms : cost.high);
    }
    double left = q->budget->frame_ms - q->budget->rest_ms - other;
    return left < q->budget->ao_ms ? left : q->budget->ao_ms;
}

/* What may be chosen there. */
static size_t see_all(const struct question *q, struct seen list[MOST])
{
    size_t count = 0;
    for (size_t i = 0; i < q->count; i++)
        if (is_in(q, &q->list[i]) && q->list[i].kind == OCCLUSION && has_cost(q, &q->list[i]))
            list[count++] = see(q, i);
    return count;
}

enum rule { ACCURATE, HOPEFUL, CHEAP, LEAST, RULES };

static bool may(enum rule rule, const struct question *q, const struct seen *s)
{
    const bool allowed[RULES] = {s->high <= q->ms, s->ms <= q->ms && s->high > q->ms, s->error <= q->error,
                                 true};
    return allowed[rule];
}

/* Whether a is taken before b, which lies behind it in the list. */
static bool is_before(enum rule rule, const struct seen *a, const struct seen *b)
{
    double by[RULES][3] = {{a->error - b->error, a->ms - b->ms, 0},
                           {a->error - b->error, a->ms - b->ms, 0},
                           {a->ms - b->ms, a->error - b->error, 0},
                           {a->high < b->high ? -1 : a->high > b->high, a->ms - b->ms, a->error - b->error}};
    const double *d = by[rule];
    return d[0] < 0 || (d[0] == 0 && (d[1] < 0 || (d[1] == 0 && d[2] <= 0)));
}

/* The one that the rule takes; NULL: none. */
static const struct seen *brute(enum rule rule, const struct question *q, const struct seen *list,
                                size_t count)
{
    const struct seen *best = NULL;
    for (size_t i = 0; i < count; i++)
        if (may(rule, q, &list[i]) && (!best || !is_before(rule, best, &list[i])))
            best = &list[i];
    if (rule != HOPEFUL || !best)
        return best;
    const struct seen *accurate = brute(ACCURATE, q, list, count);
    return accurate && accurate->error <= best->error ? NULL : best;
}

static size_t chosen(const struct aob_choice *choice, enum rule rule)
{
    const size_t places[RULES] = {choice->accurate, choice->hopeful, choice->cheap, choice->least};
    return places[rule];
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
            v->first->width == 64 * (1 + (int)q->size) && !strcmp(v->first->backend, backends[q->backend]) &&
            target->radius == radii[q->target] && target->uniform == (q->target == 2))
            return v;
    }
    return NULL;
}

static void assert_same(const struct aob_candidate *candidate, const struct seen *expected)
{
    assert_true(candidate->ms == expected->ms && candidate->low == expected->low &&
                candidate->high == expected->high && candidate->error == expected->error);
}

/* The Pareto set: of equal ones the first. */
static void check_front(const struct aob_answer_view *view, const struct seen *list, size_t count)
{
    size_t used = 0;
    for (size_t i = 0; i < count; i++) {
        bool beaten = false;
        for (size_t k = 0; k < count; k++) {
            bool equal = list[k].ms == list[i].ms && list[k].error == list[i].error;
            beaten = beaten || (equal ? k < i : list[k].ms <= list[i].ms && list[k].error <= list[i].error);
        }
        bool found = false;
        for (size_t f = 0; f < view->front_count; f++)
            found = found || view->list[view->front[f]].of == list[i].of;
        assert_int_equal(found, !beaten);
        used += !beaten;
    }
    assert_int_equal(view->front_count, used);
    for (size_t f = 1; f < view->front_count; f++)
        assert_true(view->list[view->front[f - 1]].ms < view->list[view->front[f]].ms);
}

/* The first `none` with the same options there. */
static void check_none(const struct aob_answer *answer, const struct aob_answer_view *view,
                       const struct question *q, size_t of)
{
    const struct aob_row *expected = NULL;
    for (size_t i = 0; i < q->count && !expected; i++)
        if (is_in(q, &q->list[i]) && q->list[i].kind == NONE && q->list[i].options == q->list[of].options)
            expected = &answer->rows->list[i];
    assert_ptr_equal(aob_answer_none(answer, view, &answer->rows->list[of]), expected);
}

static void check_view(const struct aob_answer *answer, const struct aob_answer_view *view,
                       const struct question *q)
{
    struct seen list[MOST];
    size_t count = see_all(q, list);
    assert_true(view->ms == q->ms);
    assert_int_equal(view->count, count);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(view->list[i].of, list[i].of);
        assert_same(&view->list[i], &list[i]);
        check_none(answer, view, q, list[i].of);
    }
    for (enum rule rule = 0; rule < RULES; rule++) {
        const struct seen *best = brute(rule, q, list, count);
        size_t place = chosen(&view->choice, rule);
        assert_int_equal(place == AOB_NO_CANDIDATE ? place : view->list[place].of,
                         best ? best->of : AOB_NO_CANDIDATE);
    }
    check_front(view, list, count);
}

static size_t check_views(const struct aob_answer *answer, struct question q)
{
    size_t count = 0;
    for (size_t n = 0; n < SCENES * VIEWS * SIZES * BACKENDS * TARGETS; n++) {
        q.scene = n % SCENES;
        q.view = n / SCENES % VIEWS;
        q.size = n / SCENES / VIEWS % SIZES;
        q.backend = n / SCENES / VIEWS / SIZES % BACKENDS;
        q.target = n / SCENES / VIEWS / SIZES / BACKENDS;
        q.ms = brute_ms(&q);
        const struct aob_answer_view *view = find_view(answer, &q);
        assert_int_equal(view != NULL, exists(&q));
        if (!view)
            continue;
        count++;
        check_view(answer, view, &q);
    }
    return count;
}

/* Of a setting the largest of each figure over the scenes and views of a size, backend and target; false if it lacks one.
 * `of` is the case that costs most. */
static bool brute_setting(struct question q, size_t setting, struct seen *worst)
{
    *worst = (struct seen){0};
    for (size_t n = 0; n < SCENES * VIEWS; n++) {
        struct seen list[MOST];
        bool has = false;
        q.scene = n % SCENES;
        q.view = n / SCENES;
        size_t count = see_all(&q, list);
        for (size_t i = 0; i < count; i++) {
            if (setting_of(&q.list[list[i].of]) != setting)
                continue;
            has = true;
            *worst = (struct seen){fmax(worst->ms, list[i].ms), fmax(worst->low, list[i].low),
                                   fmax(worst->high, list[i].high), fmax(worst->error, list[i].error),
                                   list[i].ms > worst->ms ? list[i].of : worst->of};
        }
        if (exists(&q) && !has)
            return false;
    }
    return true;
}

/* Scenes and views of a size, backend and target that have something to be chosen. */
static size_t brute_views(struct question q)
{
    size_t count = 0;
    for (size_t n = 0; n < SCENES * VIEWS; n++) {
        q.scene = n % SCENES;
        q.view = n / SCENES;
        count += exists(&q);
    }
    return count;
}

/* Whether the rule has no preference between them. */
static void assert_equal(enum rule rule, const struct aob_candidate *candidate, const struct seen *best)
{
    const struct seen own = {candidate->ms, candidate->low, candidate->high, candidate->error, 0};
    assert_true(is_before(rule, &own, best) && is_before(rule, best, &own));
}

/* By figures: settings of equal ones are taken in the order of their numbers, which is the answer's own. */
static void check_whole(const struct aob_answer_whole *whole, const struct question *q)
{
    struct seen list[ALL_SETTINGS];
    size_t count = 0;
    assert_int_equal(whole->views, brute_views(*q));
    for (size_t s = 0; s < ALL_SETTINGS; s++)
        count += brute_setting(*q, s, &list[count]);
    assert_true(whole->ms == q->ms);
    assert_int_equal(whole->count, count);
    for (size_t i = 0; i < whole->count; i++) {
        struct seen worst, most = see(q, whole->list[i].of);
        assert_true(brute_setting(*q, setting_of(&q->list[whole->list[i].of]), &worst));
        assert_same(&whole->list[i], &worst);
        assert_true(most.ms == worst.ms);
    }
    for (enum rule rule = 0; rule < RULES; rule++) {
        const struct seen *best = brute(rule, q, list, count);
        size_t place = chosen(&whole->choice, rule);
        assert_int_equal(place != AOB_NO_CANDIDATE, best != NULL);
        if (best)
            assert_equal(rule, &whole->list[place], best);
    }
}

static size_t check_wholes(const struct aob_answer *answer, struct question q)
{
    size_t fitting = 0;
    for (size_t w = 0; w < answer->whole_count; w++) {
        const struct aob_answer_whole *whole = &answer->wholes[w];
        const struct aob_target *target = &answer->rows->targets[whole->target];
        q.size = (size_t)whole->first->width / 64 - 1;
        q.backend = strcmp(whole->first->backend, backends[0]) != 0;
        q.target = target->uniform ? 2 : target->radius == 1;
        q.ms = brute_ms(&q);
        check_whole(whole, &q);
        fitting += whole->choice.accurate != AOB_NO_CANDIDATE;
    }
    return fitting;
}

/* The questions that a scene and view at a size on a backend has, and what may be chosen there. */
static void check_place(const struct aob_answer_place *place, struct question q)
{
    size_t candidates = 0, questions = 0;
    q.scene = (size_t)(place->first->scene[1] - '0');
    q.view = (size_t)(place->first->view[1] - '0');
    q.size = (size_t)place->first->width / 64 - 1;
    q.backend = strcmp(place->first->backend, backends[0]) != 0;
    for (size_t i = 0; i < q.count; i++) {
        const struct made *m = &q.list[i];
        candidates += m->ok && m->kind == OCCLUSION && m->scene == q.scene && m->view == q.view &&
                      m->size == q.size && m->backend == q.backend;
    }
    for (q.target = 0; q.target < TARGETS; q.target++)
        questions += exists(&q);
    assert_int_equal(place->candidates, candidates);
    assert_int_equal(place->questions, questions);
}

/* Good cases and others of a scene and view. */
static void check_places(const struct aob_answer *answer, const struct question *q)
{
    size_t ok = 0, failed = 0, good = 0;
    bool known = true;
    for (size_t i = 0; i < answer->place_count; i++) {
        ok += answer->places[i].cases.ok;
        failed += answer->places[i].cases.failed;
        known = known && answer->places[i].candidates;
        check_place(&answer->places[i], *q);
    }
    assert_int_equal(aob_answer_is_known(answer), known);
    for (size_t i = 0; i < q->count; i++)
        good += q->list[i].ok;
    assert_int_equal(ok, good);
    assert_int_equal(failed, q->count - good);
    assert_int_equal(answer->cases.failed, failed);
}

static size_t check_journal(uint32_t *random)
{
    struct made list[MOST];
    struct aob_rows rows;
    struct aob_answer answer;
    struct aob_budget budget = {.frame_ms = 8, .rest_ms = 4, .ao_ms = random_below(random, 2) ? 2 : INFINITY};
    struct question q = {.list = list, .count = 1 + random_below(random, MOST)};
    q.model = random_below(random, 2);
    q.budget = random_below(random, 2) ? &budget : NULL;
    q.error = 0.03125 * (double)(1 + random_below(random, 6));
    write_journal(random, list, q.count);
    read_rows(&rows);
    aob_answer_make(&answer, &rows,
                    &(struct aob_ask){.ms = budget_ms,
                                      .budget = q.budget,
                                      .error = q.error,
                                      .profile = q.model ? "ps4" : NULL,
                                      .radius = NAN});
    assert_int_equal(check_views(&answer, q), answer.view_count);
    size_t fitting = check_wholes(&answer, q);
    check_places(&answer, &q);
    aob_answer_finish(&answer);
    aob_rows_finish(&rows);
    return fitting;
}

static void test_random_journals(void **state)
{
    (void)state;
    uint32_t random = 15;
    size_t fitting = 0;
    for (int n = 0; n < JOURNALS; n++)
        fitting += check_journal(&random);
    assert_true(fitting > JOURNALS / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random_journals)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
