#include "check.h"
#include "nightly/suspect.h"

static struct aob_point points[3] = {{.night = 4}, {.night = 6}, {.night = 9}};
static const struct aob_line line = {.points = points, .count = 3};

/* A case whose cost stands out since night 6, or does not. */
static struct aob_suspect made(bool suspect)
{
    return (struct aob_suspect){.line = &line, .now = &points[2], .watch = {.suspect = suspect, .since = 1}};
}

static void say(struct aob_finding *finding, enum aob_night_verdict verdict, enum aob_outcome outcome,
                const char *said)
{
    aob_finding_say(finding, verdict, outcome, "%s", said);
}

static void check(struct aob_suspect *s, enum aob_night_verdict verdict, enum aob_outcome outcome,
                  const char *said, int64_t restart)
{
    aob_suspect_join(s);
    assert_int_equal(s->told.verdict, verdict);
    assert_int_equal(s->told.outcome, outcome);
    assert_string_equal(s->told.said, said);
    assert_int_equal(aob_suspect_restart(s), restart);
}

/* The worse one gives the verdict, the image where both are alike, and all of it is said. */
static void test_verdict_of_both(void **state)
{
    (void)state;
    struct aob_suspect s = made(true);
    say(&s.cost, AOB_NIGHT_SLOWER, AOB_OUTCOME_WORSE, "dearer");
    say(&s.image, AOB_NIGHT_MOVED, AOB_OUTCOME_GOOD, "nearer");
    check(&s, AOB_NIGHT_SLOWER, AOB_OUTCOME_WORSE, "nearer; dearer", 6);
    say(&s.image, AOB_NIGHT_MOVED, AOB_OUTCOME_WORSE, "farther");
    check(&s, AOB_NIGHT_MOVED, AOB_OUTCOME_WORSE, "farther; dearer", 6);
    s = made(false);
    say(&s.image, AOB_NIGHT_MOVED, AOB_OUTCOME_OPEN, "unknown");
    say(&s.counted, AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD, "memory");
    check(&s, AOB_NIGHT_MOVED, AOB_OUTCOME_OPEN, "unknown; memory", 0);
    s = made(false);
    say(&s.counted, AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD, "memory");
    check(&s, AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD, "memory", 0);
    s = made(false);
    check(&s, AOB_NIGHT_NONE, AOB_OUTCOME_GOOD, "", 0);
}

/* Later nights count from a cost that is decided. One that is open is asked again, and none that an image hides restarts. */
static void test_restart(void **state)
{
    (void)state;
    struct aob_suspect s = made(true);
    say(&s.cost, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN, "not known");
    check(&s, AOB_NIGHT_OPEN, AOB_OUTCOME_OPEN, "not known", 6);
    say(&s.image, AOB_NIGHT_MOVED, AOB_OUTCOME_WORSE, "farther");
    check(&s, AOB_NIGHT_MOVED, AOB_OUTCOME_WORSE, "farther; not known", 0);
    s = made(true);
    say(&s.cost, AOB_NIGHT_OUTLIER, AOB_OUTCOME_GOOD, "gone");
    check(&s, AOB_NIGHT_OUTLIER, AOB_OUTCOME_GOOD, "gone", 0);
    say(&s.image, AOB_NIGHT_MOVED, AOB_OUTCOME_GOOD, "nearer");
    check(&s, AOB_NIGHT_MOVED, AOB_OUTCOME_GOOD, "nearer; gone", 0);
    s = made(true);
    say(&s.cost, AOB_NIGHT_MACHINE, AOB_OUTCOME_GOOD, "machine");
    check(&s, AOB_NIGHT_MACHINE, AOB_OUTCOME_GOOD, "machine", 6);
    s = made(false); /* its image alone was asked after, and it is dearer as well */
    say(&s.cost, AOB_NIGHT_SLOWER, AOB_OUTCOME_WORSE, "dearer");
    check(&s, AOB_NIGHT_SLOWER, AOB_OUTCOME_WORSE, "dearer", 9);
}

/* Memory and cache figures do not scatter, so any other value is told: the first cache figure and how many more. Metrics
 * besides them are none of these. What a night before did not have is no change. */
static void test_counted(void **state)
{
    (void)state;
    char ok[] = "ok", none[] = "";
    struct aob_night nights[] = {{.id = 1, .whole = true, .summary = none}, {.id = 2, .summary = none}};
    struct aob_point two[2];
    for (int i = 0; i < 2; i++)
        two[i] = (struct aob_point){
            .night = i + 1, .status = ok, .reason = none, .ratio = NAN, .memory_bytes = 1000};
    two[0].figures = json_pack("{s:f, s:f, s:f}", "cache.ps4.l2.most.miss_ratio", .25,
                               "cache.ps4.l2.one.miss_ratio", .5, "flip", .1);
    two[1].figures =
        json_pack("{s:f, s:f, s:f, s:f}", "cache.ps4.l2.most.miss_ratio", .375, "cache.ps4.l2.one.miss_ratio",
                  .5, "flip", .2, "cache.ps5.l2.one.miss_ratio", .5);
    struct aob_line only = {.points = two, .count = 2};
    struct aob_suspects suspects = {0};
    aob_suspects_choose(&suspects, &(struct aob_lines){&only, 1}, &(struct aob_nights){nights, 2}, .02);
    assert_false(aob_suspect_stands_out(&suspects.items[0]));
    check(&suspects.items[0], AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD,
          "ps4.l2.most.miss_ratio 0.25 before, 0.375 now", 0);
    aob_suspects_finish(&suspects);
    two[1].memory_bytes = 1024;
    json_object_set_new(two[1].figures, "cache.ps4.l2.one.miss_ratio", json_real(.75));
    aob_suspects_choose(&suspects, &(struct aob_lines){&only, 1}, &(struct aob_nights){nights, 2}, .02);
    check(&suspects.items[0], AOB_NIGHT_CHANGED, AOB_OUTCOME_GOOD,
          "memory 1000 bytes before, 1024 now; ps4.l2.most.miss_ratio 0.25 before, 0.375 now, and 1 more "
          "cache figure",
          0);
    aob_suspects_finish(&suspects);
    json_decref(two[0].figures);
    json_decref(two[1].figures);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_verdict_of_both), cmocka_unit_test(test_restart),
                                       cmocka_unit_test(test_counted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
