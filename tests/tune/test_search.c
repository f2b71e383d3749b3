/* The search finds planted places, and never comes back with a worse one than it began at. */
#include "check.h"
#include "tune/search.h"

struct planted {
    const double *place;
    size_t count;
    int measured;
    double refuse_below; /* nothing can be drawn where the first coordinate is less */
};

static double bowl(void *user, const double *place)
{
    struct planted *p = user;
    double sum = 0;
    p->measured++;
    if (place[0] < p->refuse_below)
        return INFINITY;
    for (size_t i = 0; i < p->count; i++) {
        assert_true(place[i] >= 0 && place[i] <= 1);
        sum += (place[i] - p->place[i]) * (place[i] - p->place[i]);
    }
    return sqrt(sum);
}

/* Two lows: the one near the start is the shallower. */
static double two_lows(void *user, const double *place)
{
    const double near[2] = {0.2, 0.2}, far[2] = {0.8, 0.7};
    struct planted a = {near, 2, 0, 0}, b = {far, 2, 0, 0};
    ((struct planted *)user)->measured++;
    return fmin(0.1 + bowl(&a, place), bowl(&b, place));
}

/* Two coordinates do nearly the same, so that a bent valley leads to (0.3, 0.6). */
static double valley(void *user, const double *place)
{
    double product = place[0] * place[1] - 0.18, along = place[0] - 0.3;
    ((struct planted *)user)->measured++;
    return sqrt(product * product + 1e-3 * along * along);
}

static void planted_places(void **state)
{
    (void)state;
    const double places[][4] = {{0.1, 0.9, 0.4, 0.6}, {0, 1, 0.5, 0.02}}, start[4] = {0.5, 0.5, 0.5, 0.5};
    for (size_t count = 1; count <= 4; count++)
        for (size_t i = 0; i < 2; i++) {
            struct planted planted = {places[i], count, 0, 0};
            const struct aob_search_desc desc = {.count = count,
                                                 .start = start,
                                                 .global = 60,
                                                 .local = 100,
                                                 .step = 0.1,
                                                 .measure = bowl,
                                                 .user = &planted};
            double best[4];
            double least = aob_search_run(&desc, best);
            for (size_t c = 0; c < count; c++)
                assert_near(best[c], places[i][c], 0.005);
            assert_near(least, bowl(&planted, best), 1e-12);
            assert_in_range(planted.measured, 20, 1 + 60 + 100 + 1);
        }
}

static void the_deeper_low(void **state)
{
    (void)state;
    const double start[2] = {0.2, 0.2};
    struct planted planted = {NULL, 2, 0, 0};
    struct aob_search_desc desc = {
        .count = 2, .start = start, .local = 60, .step = 0.1, .measure = two_lows, .user = &planted};
    double best[2];
    assert_near(aob_search_run(&desc, best), 0.1, 1e-6); /* it began in the other one */
    desc.global = 60;
    assert_near(aob_search_run(&desc, best), 0, 0.005);
    assert_near(best[0], 0.8, 0.005);
    assert_near(best[1], 0.7, 0.005);
}

static void a_bent_valley(void **state)
{
    (void)state;
    const double start[2] = {0.9, 0.2};
    struct planted planted = {NULL, 2, 0, 0};
    const struct aob_search_desc desc = {
        .count = 2, .start = start, .local = 120, .step = 0.1, .measure = valley, .user = &planted};
    double best[2];
    aob_search_run(&desc, best);
    assert_near(best[0], 0.3, 0.01);
    assert_near(best[1], 0.6, 0.02);
}

static void what_cannot_be_drawn(void **state)
{
    (void)state;
    const double place[2] = {0.1, 0.4}, start[2] = {0.6, 0.6};
    struct planted planted = {place, 2, 0, 0.3};
    struct aob_search_desc desc = {.count = 2,
                                   .start = start,
                                   .global = 60,
                                   .local = 80,
                                   .step = 0.1,
                                   .measure = bowl,
                                   .user = &planted};
    double best[2], least = aob_search_run(&desc, best);
    assert_true(best[0] >= 0.3);
    assert_true(least < 0.25); /* 0.2 at the border */
    planted.refuse_below = 2;
    assert_true(isinf(aob_search_run(&desc, best)));
    assert_near(best[0], 0.6, 0); /* the start */
}

static void the_start_is_kept(void **state)
{
    (void)state;
    const double start[3] = {0.25, 0.75, 0.5};
    struct planted planted = {start, 3, 0, 0};
    const struct aob_search_desc desc = {.count = 3,
                                         .start = start,
                                         .global = 20,
                                         .local = 20,
                                         .step = 0.1,
                                         .measure = bowl,
                                         .user = &planted};
    double best[3];
    assert_near(aob_search_run(&desc, best), 0, 0);
    assert_memory_equal(best, start, sizeof start);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planted_places),    cmocka_unit_test(the_deeper_low),
        cmocka_unit_test(a_bent_valley),     cmocka_unit_test(what_cannot_be_drawn),
        cmocka_unit_test(the_start_is_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
