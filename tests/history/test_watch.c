#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "history/watch.h"

enum { MOST = 400 };
static struct aob_point points[MOST];
static size_t count;

/* Nights count by tens here, so that a place is no night. */
static void add(double log_ratio, double width)
{
    double ratio = 2 * exp(log_ratio);
    points[count] = (struct aob_point){.night = 10 * (int64_t)(count + 1),
                                       .status = "ok",
                                       .reason = "",
                                       .ratio = ratio,
                                       .low = ratio * exp(-0.5 * width),
                                       .high = ratio * exp(0.5 * width)};
    count++;
}

/* A line about 2 fixed passes whose errors are at most 1 % and whose noise, 1.4826 MAD, is .0089; intervals of 1 %. */
static const double errors[] = {0, .006, -.009, .003, -.006, .01, .002, -.003, .008, -.01};
static void start(size_t n)
{
    count = 0;
    for (size_t i = 0; i < n; i++)
        add(errors[i % 10], .01);
}

static struct aob_watch watch(void)
{
    struct aob_watch w;
    aob_watch_line(points, count, .02, &w);
    return w;
}

/* The verdict of the last point. */
static void judge(enum aob_night_verdict verdict, size_t since)
{
    points[count - 1].verdict = verdict;
    points[count - 1].since = points[since].night;
}

static void quiet(void)
{
    struct aob_watch w = watch();
    assert_false(w.suspect);
    assert_int_equal(w.since, count - 1);
}

static void suspect(size_t since, double shift)
{
    struct aob_watch w = watch();
    assert_true(w.suspect);
    assert_int_equal(w.since, since);
    assert_near(log(w.shift), shift, .008);
    assert_true(fabs(log(w.shift)) > log1p(w.least));
}

static void test_step_tonight(void **state)
{
    (void)state;
    start(30);
    quiet();
    add(.05, .01);
    suspect(30, .05);
    assert_near(log(watch().before / 2), 0, .003);
    start(30);
    add(-.05, .01);
    suspect(30, -.05);
}

/* Three times the noise of .0089 is .027, and a little more for the thirty values that the level is known from. */
static void test_noise_is_the_bar(void **state)
{
    (void)state;
    start(30);
    add(.024, .01);
    quiet();
    assert_near(watch().least, .0275, .0015);
    points[30].ratio = 2 * exp(.031);
    assert_true(watch().suspect);
}

static void test_least_is_the_bar(void **state)
{
    (void)state;
    count = 0;
    for (size_t i = 0; i < 30; i++)
        add(0, 1e-4); /* no spread */
    add(.0195, 1e-4);
    quiet();
    assert_near(watch().least, .02, 1e-9);
    points[30].ratio = 2 * exp(.0205);
    suspect(30, .0205);
}

static void test_interval_is_the_bar(void **state)
{
    (void)state;
    start(30);
    add(.05, .12);
    quiet();
    assert_near(watch().least, expm1(.06), 1e-9);
    start(30);
    add(.07, .12);
    suspect(30, .07);
}

/* 3 % in noise of nearly 1 %: one night hides it, three show it, with the night it began. */
static void test_small_step_over_nights(void **state)
{
    (void)state;
    start(30);
    add(.026, .01);
    quiet();
    add(.03, .01);
    add(.028, .01);
    suspect(30, .028);
}

static void test_step_two_nights_ago(void **state)
{
    (void)state;
    start(30);
    add(.05, .01);
    points[30].verdict = AOB_NIGHT_OPEN;
    add(.054, .01);
    suspect(30, .052);
    points[31].verdict = AOB_NIGHT_OPEN;
    add(.047, .01);
    suspect(30, .05);
}

static void test_outlier_and_back(void **state)
{
    (void)state;
    start(30);
    add(.3, .01);
    suspect(30, .3);
    add(0, .01); /* whatever was said of it */
    quiet();
    points[30].verdict = AOB_NIGHT_OUTLIER;
    quiet();
    add(.006, .01);
    quiet();
}

/* Most of the last three lie beyond, but tonight does not. */
static void test_back_tonight(void **state)
{
    (void)state;
    start(30);
    add(.05, .01);
    add(.05, .01);
    suspect(30, .05);
    add(.003, .01);
    quiet();
}

/* A night of which little is known neither hides a step nor makes one. */
static void test_wide_night(void **state)
{
    (void)state;
    start(30);
    add(.05, .01);
    add(.03, .2);
    suspect(30, .05);
    start(30);
    add(.0, .01);
    add(.15, .2);
    add(.004, .01);
    quiet();
}

/* A night in ten is far off, which half of the distances do not show: that another one is tells nothing. */
static void test_often_disturbed(void **state)
{
    (void)state;
    start(40);
    for (size_t i = 5; i < 40; i += 10) {
        points[i].ratio = 2 * exp(.2);
        points[i].verdict = AOB_NIGHT_OUTLIER;
    }
    add(.15, .01);
    quiet();
    points[40].ratio = 2 * exp(.25);
    suspect(40, .25);
}

/* A night too early in what was told is not told a second time. */
static void test_since_follows_what_was_told(void **state)
{
    (void)state;
    start(30);
    add(.05, .01);
    judge(AOB_NIGHT_SLOWER, 28);
    add(.05, .01);
    assert_true(!watch().suspect || watch().since == 31);
    add(.05, .01);
    assert_true(!watch().suspect || watch().since >= 31);
    add(.05, .01);
    quiet();
}

static void test_alarm_is_not_repeated(void **state)
{
    (void)state;
    const enum aob_night_verdict verdicts[] = {AOB_NIGHT_SLOWER, AOB_NIGHT_FASTER, AOB_NIGHT_MOVED,
                                               AOB_NIGHT_MACHINE};
    for (size_t v = 0; v < 4; v++) {
        start(30);
        add(.05, .01);
        judge(verdicts[v], 30);
        for (size_t i = 0; i < 10; i++) {
            add(.05 + errors[i], .01);
            quiet();
        }
        add(.1, .01);
        suspect(41, .05);
    }
}

static void test_slower_then_faster_back(void **state)
{
    (void)state;
    start(30);
    add(.05, .01);
    add(.05, .01);
    judge(AOB_NIGHT_SLOWER, 30);
    add(.052, .01);
    quiet();
    add(.001, .01);
    suspect(33, -.05);
    judge(AOB_NIGHT_FASTER, 33);
    for (size_t i = 0; i < 10; i++) {
        add(errors[i], .01);
        quiet();
    }
}

/* Verdicts that tell of no level restart nothing. */
static void test_open_is_asked_again(void **state)
{
    (void)state;
    const enum aob_night_verdict verdicts[] = {AOB_NIGHT_OPEN, AOB_NIGHT_NONE, AOB_NIGHT_BROKEN};
    for (size_t v = 0; v < 3; v++) {
        start(30);
        add(.05, .01);
        judge(verdicts[v], 30);
        add(.05, .01);
        suspect(30, .05);
    }
}

/* .05 % a night within the 7 nights that are set beside the level before them never gets to 2 %; .7 % does. */
static void test_drift(void **state)
{
    (void)state;
    count = 0;
    for (size_t i = 0; i < 120; i++) {
        add(.0005 * (double)i + .2 * errors[i % 10], .01);
        quiet();
    }
    count = 0;
    for (size_t i = 0; i < 40; i++)
        add(.2 * errors[i % 10], .01);
    for (size_t i = 1; i < 7; i++)
        add(.007 * (double)i, .01);
    assert_true(watch().suspect);
    assert_in_range(watch().since, 40, 43);
}

static void test_gaps(void **state)
{
    (void)state;
    start(30);
    points[10].status = "failed";
    points[20].ratio = NAN; /* untimed */
    points[21].status = NULL;
    points[22].ratio = INFINITY;
    points[23].ratio = 0;
    points[24].low = points[24].high = NAN;
    add(.05, .01);
    add(9, .01);
    points[31].status = "invalid";
    quiet();
    assert_true(isnan(watch().before) && isnan(watch().shift) && isnan(watch().least));
    add(.052, .01);
    suspect(30, .051);
}

static void test_no_ratio_at_all(void **state)
{
    (void)state;
    start(5);
    for (size_t i = 0; i < 5; i++)
        points[i].ratio = points[i].low = points[i].high = NAN;
    quiet();
    assert_true(isnan(watch().before));
    points[4].ratio = 2; /* the first that was timed */
    quiet();
    assert_true(isnan(watch().before));
    struct aob_watch w;
    aob_watch_line(NULL, 0, .02, &w);
    assert_false(w.suspect);
    assert_int_equal(w.since, 0);
}

/* As long as nothing is known of the noise, what tonight differs by must be more than both intervals explain. */
static void test_few_points(void **state)
{
    (void)state;
    count = 0;
    add(0, .05);
    quiet();
    assert_true(isnan(watch().before));
    add(.045, .05);
    quiet();
    assert_near(watch().before, 2, 1e-9);
    assert_near(watch().least, expm1(.05), 1e-9);
    points[1].ratio = 2 * exp(.055);
    suspect(1, .055);
    points[1].low = NAN;
    quiet();
}

/* The noise is the line's, before a restart too. */
static void test_noise_outlives_a_restart(void **state)
{
    (void)state;
    start(30);
    add(.1, .01);
    judge(AOB_NIGHT_SLOWER, 30);
    add(.12, .01); /* beyond the intervals and 2 %, not beyond the noise of two values */
    add(.1, .01);
    add(.124, .01);
    quiet();
    add(.15, .01);
    assert_true(watch().suspect);
}

/* Only the latest values count: what was a year ago is no noise of today. */
static void test_old_values(void **state)
{
    (void)state;
    count = 0;
    for (size_t i = 0; i < 30; i++)
        add(i % 2 ? -1 : 1, .01);
    for (size_t i = 0; i < AOB_WATCH_LINE; i++)
        add(errors[i % 10], .01);
    add(.05, .01);
    suspect(count - 1, .05);
    assert_near(watch().least, .0275, .0015);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_step_tonight),
        cmocka_unit_test(test_noise_is_the_bar),
        cmocka_unit_test(test_least_is_the_bar),
        cmocka_unit_test(test_interval_is_the_bar),
        cmocka_unit_test(test_small_step_over_nights),
        cmocka_unit_test(test_step_two_nights_ago),
        cmocka_unit_test(test_outlier_and_back),
        cmocka_unit_test(test_back_tonight),
        cmocka_unit_test(test_wide_night),
        cmocka_unit_test(test_often_disturbed),
        cmocka_unit_test(test_since_follows_what_was_told),
        cmocka_unit_test(test_alarm_is_not_repeated),
        cmocka_unit_test(test_slower_then_faster_back),
        cmocka_unit_test(test_open_is_asked_again),
        cmocka_unit_test(test_drift),
        cmocka_unit_test(test_gaps),
        cmocka_unit_test(test_no_ratio_at_all),
        cmocka_unit_test(test_few_points),
        cmocka_unit_test(test_noise_outlives_a_restart),
        cmocka_unit_test(test_old_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
