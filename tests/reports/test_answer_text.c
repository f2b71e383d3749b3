/* What an answer to a budget says, of a journal of one case. */
#include <math.h>
#include "reports/page/answer_text.h"
#include "run_text.h"

static char *one_sentence(const char *journal, const struct aob_ask *ask, size_t at)
{
    struct aob_rows rows;
    struct aob_answer answer;
    struct aob_sentences sentences = {0};
    put("journal.jsonl", journal);
    read_rows(&rows);
    aob_answer_make(&answer, &rows, ask);
    assert_int_equal(answer.view_count, 1);
    aob_answer_say_view(&answer, &answer.views[0], &sentences);
    assert_true(at < sentences.count);
    char *text = aob_strdup(sentences.items[at]);
    aob_sentences_finish(&sentences);
    aob_answer_finish(&answer);
    aob_rows_finish(&rows);
    return text;
}

#define CASE                                                                                                 \
    "{\"key\":\"a\",\"scene\":\"s\",\"view\":\"v\",\"technique\":\"gtao\",\"params\":{},\"options\":{},"     \
    "\"backend\":"                                                                                           \
    "\"null\",\"width\":64,\"height\":32,\"status\":\"ok\",\"errors\":[{\"target\":{\"radius\":1,"           \
    "\"weighting\":"                                                                                         \
    "\"cosine\"},\"rmse\":0.01,\"band_rmse\":0.25}],\"time\":{\"clock\":\"wall\",\"cpu_ms\":9,\"wall_ms\":"  \
    "3,"                                                                                                     \
    "\"ratio_to_ref\":6,\"ci_low\":5,\"ci_high\":8,\"passes\":[{\"name\":\"ao\",\"wall_ms\":2,\"cpu_ms\":1}" \
    ",{"                                                                                                     \
    "\"name\":\"blur\",\"wall_ms\":1,\"cpu_ms\":8}]},\"cache\":{\"ps4\":{\"modelled\":{\"frame\":{\"ms\":3," \
    "\"low_ms\":2.25,"                                                                                       \
    "\"high_ms\":5,\"limit\":\"memory\"},\"passes\":[{\"name\":\"ao\",\"ms\":1,\"limit\":\"alu\"},{"         \
    "\"name\":\"blur\","                                                                                     \
    "\"ms\":2,\"limit\":\"texture\"}]}}}}\n"

/* By how much, and where it lies: by the case's own clock, or by the model with the resource. */
static void test_overrun(void **state)
{
    (void)state;
    struct aob_ask ask = {.ms = 2, .error = INFINITY, .radius = NAN};
    char *text = one_sentence(CASE, &ask, 0), *pass = one_sentence(CASE, &ask, 1);
    assert_string_equal(
        text,
        "Nothing fits with its upper end: what is nearest is gtao: error 0.2500, 3 (2.5 .. 4) ms, 1 ms over "
        "(0.5 .. 2).");
    assert_string_equal(pass, "Its pass 'ao' takes most, 2 ms; a measured time names no resource.");
    free(text);
    free(pass);
    ask.profile = "ps4";
    text = one_sentence(CASE, &ask, 0);
    pass = one_sentence(CASE, &ask, 1);
    assert_string_equal(
        text,
        "Nothing fits with its upper end: what is nearest is gtao: error 0.2500, 3 (2.25 .. 5) ms, 1 ms over "
        "(0.25 .. 3).");
    assert_string_equal(pass, "Its pass 'blur' takes most, 2 ms, and is limited by texture.");
    free(text);
    free(pass);
}

static void test_room(void **state)
{
    (void)state;
    struct aob_ask ask = {.ms = 4.5, .error = 0.1, .radius = NAN};
    char *text = one_sentence(CASE, &ask, 0), *error = one_sentence(CASE, &ask, 1);
    assert_string_equal(text,
                        "The most accurate case that fits is gtao: error 0.2500, 3 (2.5 .. 4) ms, 1.5 ms to "
                        "spare (0.5 .. 2).");
    assert_string_equal(error, "Nothing has an error of 0.1 or less.");
    free(text);
    free(error);
    ask.ms = 3.5;
    text = one_sentence(CASE, &ask, 0);
    assert_string_equal(
        text, "More accurate, with a point that fits and an upper end that does not, is gtao: error "
              "0.2500, 3 (2.5 .. 4) ms, 0.5 ms to spare, but perhaps 0.5 ms over.");
    free(text);
}

#define UNTIMED                                                                                              \
    "{\"key\":\"u\",\"scene\":\"s\",\"view\":\"v\",\"technique\":\"gtao\",\"params\":{\"n\":1},"             \
    "\"options\":{},\"backend\":\"null\",\"width\":64,\"height\":32,\"status\":\"ok\",\"errors\":["          \
    "{\"target\":{\"radius\":1,\"weighting\":\"cosine\"},\"rmse\":0.01,\"band_rmse\":0.5}]}\n"

/* The clock is that of what is judged, and an untimed case has none. */
static void test_clock(void **state)
{
    (void)state;
    struct aob_rows rows;
    struct aob_answer answer;
    struct aob_text said = {0};
    put("journal.jsonl", UNTIMED CASE);
    read_rows(&rows);
    aob_answer_make(&answer, &rows, &(struct aob_ask){.ms = 2, .error = INFINITY, .radius = NAN});
    assert_int_equal(answer.view_count, 1);
    assert_int_equal(answer.views[0].unknown, 1);
    aob_answer_print_budget(&answer, &answer.views[0], &said);
    assert_string_equal(said.data, "2 ms of wall time, measured here");
    aob_text_finish(&said);
    aob_answer_finish(&answer);
    aob_rows_finish(&rows);
}

static void assert_shown(double value, const char *expected)
{
    struct aob_text text = {0};
    aob_three_digits(value, &text);
    assert_string_equal(text.data, expected);
    aob_text_finish(&text);
}

static void test_digits(void **state)
{
    (void)state;
    assert_shown(0.012345, "0.0123");
    assert_shown(999.4, "999");
    assert_shown(1234.5678, "1235");
    assert_shown(-20000, "-20000");
}

/* `none` of the same options: 6 (5 .. 8) over 2 (1 .. 2.5), by hand through Zou and Donner's formula. */
static void test_frames_of_none(void **state)
{
    (void)state;
    json_t *own = json_loads(CASE, 0, NULL),
           *none = json_loads("{\"time\":{\"ratio_to_ref\":2,\"ci_low\":1,\"ci_high\":2.5}}", 0, NULL);
    struct aob_interval ratio = aob_costs_to_none(own, none);
    assert_near(ratio.at, 3, 1e-12);
    assert_near(ratio.low, 3 * exp(-hypot(log(1.2), log(1.25))), 1e-12);
    assert_near(ratio.high, 3 * exp(hypot(log(8.0 / 6), log(2.0))), 1e-12);
    assert_true(isnan(aob_costs_to_none(own, NULL).at));
    json_decref(own);
    json_decref(none);
}

#define DEFERRED(key, scene, width, ms, interval)                                                            \
    "{\"key\":\"" key "\",\"scene\":\"" scene                                                                \
    "\",\"view\":\"v\",\"technique\":\"deferred\",\"params\":{},\"options\":{},"                             \
    "\"backend\":\"null\",\"width\":" width                                                                  \
    ",\"height\":32,\"status\":\"ok\",\"errors\":[{\"target\":{\"radius\":"                                  \
    "1},\"rmse\":0,"                                                                                         \
    "\"band_rmse\":0}],\"time\":{\"clock\":\"cpu\",\"cpu_ms\":" ms ",\"ratio_to_ref\":1," interval "}}\n"
#define ENDS(low, high) "\"ci_low\":" low ",\"ci_high\":" high

static char text[] = "t";
static const struct aob_budget budget = {.name = text,
                                         .title = text,
                                         .source = text,
                                         .frame_ms = 16,
                                         .rest_ms = 7,
                                         .ao_ms = INFINITY,
                                         .error = INFINITY};

/* What a run says of its frames, one line a frame. */
static void assert_frames(const struct aob_rows *rows, const struct aob_budget *asked, const char *expected)
{
    struct aob_answer answer;
    struct aob_text said = {0};
    struct aob_ask ask = aob_ask_of(asked);
    aob_answer_make(&answer, rows, &ask);
    for (size_t i = 0; i < answer.frame_count; i++) {
        aob_text_add(&said, "%s", i ? "\n" : "");
        aob_answer_print_frame(&answer, &answer.frames[i], &said);
    }
    assert_string_equal(said.data, expected);
    aob_text_finish(&said);
    aob_answer_finish(&answer);
}

static void assert_journal(const char *journal, const struct aob_budget *asked, const char *expected)
{
    struct aob_rows rows;
    put("journal.jsonl", journal);
    read_rows(&rows);
    assert_frames(&rows, asked, expected);
    aob_rows_finish(&rows);
}

/* G-buffer and composite of the dearest scene go off the frame by their upper end. */
static void test_frame(void **state)
{
    (void)state;
    struct aob_budget bare = budget, narrow = budget, late = budget;
    bare.rest_ms = 0;
    narrow.frame_ms = 15.99;
    narrow.rest_ms = 15.984;
    late.rest_ms = 12;
    const char *two = CASE DEFERRED("b", "s", "64", "2", ENDS("0.75", "1.5"))
        DEFERRED("c", "t", "64", "4", ENDS("0.875", "1.25"));
    assert_journal(
        two, &budget,
        "The frame has 16 ms: the rest takes 7 ms, G-buffer and composite take 4 (3.5 .. 5) ms, and "
        "ambient occlusion has 4 ms.");
    assert_journal(
        two, &late,
        "The frame has 16 ms: the rest takes 12 ms, G-buffer and composite take 4 (3.5 .. 5) ms, and "
        "nothing is left for ambient occlusion: the frame is 1 ms over.");
    assert_journal(
        CASE, &bare,
        "The frame has 16 ms: what the rest takes is not said, G-buffer and composite are not known, "
        "and ambient occlusion has 16 ms.");
    assert_journal(
        CASE, &narrow,
        "The frame has 15.99 ms: the rest takes 15.984 ms, G-buffer and composite are not known, and "
        "ambient occlusion has 0.006 ms.");
}

/* A case without an interval counts by its point, and takes none from the others. */
static void test_frame_without_interval(void **state)
{
    (void)state;
    assert_journal(
        CASE DEFERRED("b", "s", "64", "2", ENDS("0.75", "1.5"))
            DEFERRED("c", "t", "64", "1", ENDS("null", "null")),
        &budget,
        "The frame has 16 ms: the rest takes 7 ms, G-buffer and composite take 2 (1.5 .. 3) ms, and "
        "ambient occlusion has 6 ms.");
    assert_journal(
        CASE DEFERRED("c", "t", "64", "1", ENDS("null", "null")), &budget,
        "The frame has 16 ms: the rest takes 7 ms, G-buffer and composite take 1 (no interval) ms, "
        "and ambient occlusion has 8 ms.");
}

/* The budget of a size is what the frame of that size leaves. */
static void test_frame_of_each_size(void **state)
{
    (void)state;
    struct aob_rows rows;
    struct aob_answer answer;
    const struct aob_ask ask = aob_ask_of(&budget);
    assert_journal(
        CASE DEFERRED("b", "s", "64", "2", ENDS("1", "1")) DEFERRED("c", "s", "128", "8", ENDS("1", "1")),
        &budget,
        "The frame has 16 ms on null 64x32: the rest takes 7 ms, G-buffer and composite take 2 (2 .. "
        "2) ms, and ambient occlusion has 7 ms.\n"
        "The frame has 16 ms on null 128x32: the rest takes 7 ms, G-buffer and composite take 8 (8 .. "
        "8) ms, and ambient occlusion has 1 ms.");
    read_rows(&rows);
    aob_answer_make(&answer, &rows, &ask);
    assert_int_equal(answer.views[0].count, 1); /* without `deferred`, which is never chosen */
    assert_int_equal(answer.views[0].choice.accurate, 0);
    assert_near(answer.views[0].ms, 7, 0);
    assert_near(answer.frames[1].ms, 1, 0);
    assert_int_equal(answer.whole_count, 1); /* of the other size nothing may be chosen */
    aob_answer_finish(&answer);
    aob_rows_finish(&rows);
}

/* Of several runs each is judged by its own, and named. */
static void test_frame_of_each_run(void **state)
{
    (void)state;
    struct aob_rows rows;
    struct aob_error error;
    char *first = aob_path_join(folder, "first"), *second = aob_path_join(folder, "second");
    const char *const folders[] = {first, second};
    assert_true(aob_folder_create(first, NULL) && aob_folder_create(second, NULL));
    put("first/run.json", "{\"name\":\"A\",\"cases\":2}");
    put("second/run.json", "{\"name\":\"B\",\"cases\":1}");
    put("first/journal.jsonl", CASE);
    put("second/journal.jsonl", CASE DEFERRED("b", "s", "64", "2", ENDS("1", "1")));
    assert_true(aob_rows_read(&rows, folders, 2, &error));
    assert_frames(
        &rows, &budget,
        "A: The frame has 16 ms on null 64x32: the rest takes 7 ms, G-buffer and composite are not "
        "known, and ambient occlusion has 9 ms.\n"
        "B: The frame has 16 ms on null 64x32: the rest takes 7 ms, G-buffer and composite take 2 (2 .. "
        "2) ms, and ambient occlusion has 7 ms.");
    aob_rows_finish(&rows);
    free(first);
    free(second);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_overrun),
                                       cmocka_unit_test(test_room),
                                       cmocka_unit_test(test_clock),
                                       cmocka_unit_test(test_digits),
                                       cmocka_unit_test(test_frames_of_none),
                                       cmocka_unit_test(test_frame),
                                       cmocka_unit_test(test_frame_without_interval),
                                       cmocka_unit_test(test_frame_of_each_size),
                                       cmocka_unit_test(test_frame_of_each_run)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
