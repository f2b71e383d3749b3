/* The trend page, from lines and nights that are made here. */
#include "reports/trend/trend.h"
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"

enum { NIGHTS = 31 };

/* A history of one night a day from the first of October on, of up to three lines. */
struct made {
    struct aob_night nights[NIGHTS];
    char dates[NIGHTS][32];
    struct aob_line lines[3];
    struct aob_point points[3][NIGHTS];
    struct aob_nights all;
    struct aob_lines of;
};

static void make(struct made *made, size_t nights, size_t lines)
{
    *made = (struct made){.all = {made->nights, nights}, .of = {made->lines, lines}};
    for (size_t i = 0; i < nights; i++) {
        snprintf(made->dates[i], sizeof made->dates[i], "2026-10-%02zuT02:00:00Z", i + 1);
        made->nights[i] = (struct aob_night){.id = (int64_t)i + 1,
                                             .date = made->dates[i],
                                             .name = "nightly",
                                             .cases = 2,
                                             .ok = 1,
                                             .whole = true};
    }
    for (size_t i = 0; i < lines; i++) {
        static char *const texts[] = {"corner/front gtao", "corner/front ssao", "corner/front hbao"};
        made->lines[i] = (struct aob_line){.id = (int64_t)i + 7,
                                           .class_name = "cpu, llvmpipe",
                                           .config = "nightly",
                                           .scene = "corner",
                                           .view = "front",
                                           .text = texts[i],
                                           .points = made->points[i]};
    }
}

/* Half of the interval is a share `half` of the ratio; NAN: it has none. */
static struct aob_point *add(struct made *made, size_t line, int64_t night, double ratio, double half)
{
    struct aob_point *point = &made->points[line][made->lines[line].count++];
    *point = (struct aob_point){.night = night,
                                .status = isnan(ratio) ? "failed" : "ok",
                                .reason = "",
                                .module = "",
                                .said = "",
                                .ratio = ratio,
                                .low = ratio * (1 - half),
                                .high = ratio * (1 + half),
                                .memory_bytes = NAN,
                                .band_rmse = NAN};
    return point;
}

static void tell(struct aob_point *point, enum aob_night_verdict verdict, int64_t since, char *said)
{
    point->verdict = verdict;
    point->since = since;
    point->said = said;
}

/* The page's text; free() it. */
static char *page_of(const struct made *made, const char *title)
{
    char folder[] = "/tmp/aobudget-trend-XXXXXX";
    struct aob_error error = {{0}};
    assert_non_null(mkdtemp(folder));
    if (!aob_trend_write(&(struct aob_trend_desc){&made->of, &made->all, folder, title}, &error))
        fail_msg("%s", error.text);
    char *path = aob_path_join(folder, "index.html");
    char *text = aob_file_read(path, 1 << 22, NULL, &error);
    assert_non_null(text);
    unlink(path);
    rmdir(folder);
    free(path);
    return text;
}

static size_t count_text(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

/* The page of `made` has each of the parts, which NULL ends. */
static void expect(const struct made *made, const char *const *parts)
{
    char *text = page_of(made, NULL);
    for (; *parts; parts++)
        assert_contains(text, *parts);
    free(text);
}
#define EXPECT(made, ...) expect(made, (const char *const[]){__VA_ARGS__, NULL})

/* The axis is 1.00 .. 1.02 and a twentieth of that more at each side: .999 .. 1.021 is 100 high, so 1.00 stands
 * 100 / 22 above the bottom, which is 108. Five nights stand 72 apart between 56 and 344. */
static void a_dot_stands_where_its_ratio_is(void **state)
{
    static const double ratios[] = {1.00, 1.02, 1.01, 1.00, 1.01};
    struct made made;
    (void)state;
    make(&made, 5, 1);
    for (size_t i = 0; i < 5; i++)
        add(&made, 0, (int64_t)i + 1, ratios[i], NAN);
    EXPECT(&made, "<path class=d d=\"M56 103.5h0M128 12.5h0M200 58h0M272 103.5h0M344 58h0\"/>",
           "<path class=v d=\"M50 58H350\"/>", "<path class=g d=\"M50 103.5H350M50 58H350M50 12.5H350\"/>",
           "<text x=45 y=61.5>1.01</text>", "now <b>1.010</b>",
           ">2026-10-01</text><text x=350 y=126>2026-10-05<", "<p>Nothing: each series is at one level");
}

static void an_interval_is_a_bar(void **state)
{
    struct made made;
    (void)state;
    make(&made, 1, 1);
    add(&made, 0, 1, 2, .05);
    /* 1.9 .. 2.1 and a tenth: 1.89 .. 2.11. A single night stands in the middle. */
    EXPECT(&made, "<path class=i d=\"M200 103.5V12.5\"/>", "<path class=d d=\"M200 58h0\"/>",
           "now <b>2.000</b> [1.900, 2.100]");
}

static void add_shift(struct made *made, size_t line, double after)
{
    for (int64_t night = 1; night <= 16; night++)
        add(made, line, night, night < 9 ? 1 : after, .002);
}

/* The axis is .998 .. 1.0521 and more: .995295 .. 1.054805. The level changes half way between the nights 8 and 9. */
static void a_shift_is_told_with_its_date(void **state)
{
    struct made made;
    (void)state;
    make(&made, 16, 1);
    add_shift(&made, 0, 1.05);
    tell(&made.points[0][9], AOB_NIGHT_SLOWER, 9, "5.0 % dearer");
    EXPECT(&made, "<path class=v d=\"M50 100.1H200V16.1H350\"/>",
           "<tr><td>2026-10-09</td><td class=n data-v=\"1.05\">+5.0 %</td><td><span class=\"chip v\" "
           "title=\"5.0 % dearer\">",
           "slower</span></td><td class=wrap><a href=#l7>corner/front gtao</a></td>"
           "<td class=n data-v=\"1\">1.000</td><td class=n data-v=\"1.05\">1.050</td><td class=wrap>nightly "
           "\u00b7 "
           "cpu, llvmpipe</td></tr>",
           " \u00b7 +5.0 % since 2026-10-09", "In all 1 change in 1 series over 16 nights.",
           "<g class=\"m slower\"><title>2026-10-10: slower. 5.0 % dearer</title><use href=#m-slower x=228.8 "
           "y=16.1 "
           "/></g>",
           "<summary>1 night told of</summary>");
}

/* A verdict that is given again, and one that comes before it is decided, are one change. */
static void a_change_is_one_row(void **state)
{
    struct made made;
    (void)state;
    make(&made, 16, 1);
    add_shift(&made, 0, 1.05);
    tell(&made.points[0][8], AOB_NIGHT_OPEN, 9, "perhaps");
    tell(&made.points[0][10], AOB_NIGHT_FASTER, 8, "it is");
    tell(&made.points[0][11], AOB_NIGHT_OPEN, 9, "perhaps");
    tell(&made.points[0][9], AOB_NIGHT_MOVED, 0, "it moved"); /* which is another change, as is this */
    tell(&made.points[0][13], AOB_NIGHT_CHANGED, 0, "more memory");
    char *text = page_of(&made, NULL);
    assert_contains(text, "In all 3 changes in 1 series");
    assert_contains(text, "title=\"it is\"");
    assert_contains(text, "title=\"it moved\"");
    assert_contains(text, "title=\"more memory\"");
    free(text);
}

/* What was decided is a border even if the levels alone would not show it; a night alone is a change from the level. */
static void a_decided_change_is_a_border(void **state)
{
    struct made made;
    (void)state;
    make(&made, 8, 2);
    for (int64_t night = 1; night <= 8; night++) {
        add(&made, 0, night, night < 8 ? 1 : 1.01, .02);
        add(&made, 1, night, night < 8 ? 2 : 2.5, .02);
    }
    tell(&made.points[0][7], AOB_NIGHT_SLOWER, 8, "");
    tell(&made.points[1][7], AOB_NIGHT_OPEN, 0, "");
    EXPECT(&made, "<b>1 slower</b>, <b>1 open</b>. In all 2 changes",
           "<tr><td>2026-10-08</td><td class=n data-v=\"1.25\">+25.0 %</td>",
           "<td class=n data-v=\"2\">2.000</td><td class=n data-v=\"2.5\">2.500</td>",
           "<tr><td>2026-10-08</td><td class=n data-v=\"1.01\">+1.0 %</td>",
           "<path class=v d=\"M50 67.2H323.4V49.1H350\"/>");
}

static void what_nobody_judged_is_said_so(void **state)
{
    struct made made;
    (void)state;
    make(&made, 16, 1);
    add_shift(&made, 0, .9);
    EXPECT(&made, "data-v=\"0.9\">\u221210.0 %</td><td><span class=\"chip v\">not judged</span>",
           "latest night 2026-10-16: nothing was told of.");
}

/* The latest first; of one day what broke first, then by size, and another image last. */
static void the_table_has_an_order(void **state)
{
    static const char *const order[] = {
        "2026-10-16</td><td class=n>", "2026-10-09</td><td class=n data-v=\"1.2\"",
        "2026-10-09</td><td class=n data-v=\"0.95\"", "2026-10-05</td><td class=n>"};
    struct made made;
    (void)state;
    make(&made, 16, 3);
    add_shift(&made, 0, .95);
    add_shift(&made, 1, 1.2);
    for (int64_t night = 1; night <= 15; night++)
        add(&made, 2, night, 1, .002);
    tell(&made.points[2][4], AOB_NIGHT_MOVED, 5, "");
    tell(add(&made, 2, 16, NAN, NAN), AOB_NIGHT_BROKEN, 0, "no device");
    char *text = page_of(&made, NULL);
    const char *at = text;
    for (size_t i = 0; i < AOB_COUNT(order); i++) {
        at = strstr(at, order[i]);
        assert_non_null(at);
    }
    assert_contains(text, "title=\"no device\"");
    free(text);
}

/* Its line breaks 6 beside the nights 2 and 4. The last night is the ninth of the month: a day is 36 wide. */
static void a_missing_night_is_a_gap(void **state)
{
    struct made made;
    (void)state;
    make(&made, 5, 1);
    made.nights[4].date = "2026-10-09T02:00:00Z";
    for (int64_t night = 1; night <= 5; night++)
        if (night != 3)
            add(&made, 0, night, 1, NAN);
    EXPECT(&made, "<path class=v d=\"M50 58H98M158 58H350\"/>",
           "<path id=t0 d=\"M56 108v4M92 108v4M128 108v4M164 108v4M344 108v4\"/>");
}

static void a_night_far_off_does_not_widen_the_axis(void **state)
{
    struct made made;
    (void)state;
    make(&made, 5, 1);
    for (int64_t night = 1; night <= 5; night++)
        add(&made, 0, night, night == 3 ? 9 : 1, NAN);
    tell(&made.points[0][2], AOB_NIGHT_OUTLIER, 0, "");
    EXPECT(&made, "<path class=a d=\"M200 8l-3 6h6z\"/>", "<path class=v d=\"M50 58H350\"/>",
           " \u00b7 1 night beyond the scale");
}

/* Error in band steps half way between nights; its strip lies between 117 and 128, that of memory 18 below. */
static void strips_show_error_memory_and_images(void **state)
{
    struct made made;
    (void)state;
    make(&made, 5, 1);
    for (size_t i = 0; i < 5; i++) {
        struct aob_point *point = add(&made, 0, (int64_t)i + 1, 1, NAN);
        point->band_rmse = i < 2 ? .02 : .03;
        point->memory_bytes = 3 * 1048576;
        if (i != 2)
            snprintf(point->image, sizeof point->image, "%s", i < 3 ? "a" : "b");
    }
    EXPECT(&made, "<text x=45 y=126>error</text><path class=s d=\"M50 128H164V117H350\"/>",
           "<text x=45 y=144>memory</text><path class=s d=\"M50 140.5H350\"/>",
           "<text x=45 y=162>image</text><path class=c d=\"M272 153v11\"/>",
           " \u00b7 error in band 0.0300 \u00b7 3.00 MiB \u00b7 another image 1 time, last on 2026-10-04");
}

static void a_series_without_a_ratio_is_drawn(void **state)
{
    struct made made;
    (void)state;
    make(&made, 2, 2);
    add(&made, 0, 1, NAN, NAN);
    struct aob_point *point = add(&made, 0, 2, NAN, NAN);
    point->reason = "no driver";
    tell(point, AOB_NIGHT_BROKEN, 0, "gone");
    EXPECT(&made, "no ratio in any night", "now <b>failed</b>, no driver",
           "<use href=#m-broken x=344 y=108 />",
           "<figure class=series id=l8><p class=name><a href=#l8>corner/front ssao</a></p><p "
           "class=missing>No night of "
           "it is left.</p></figure>");
}

static void an_empty_history_says_so(void **state)
{
    struct made made;
    (void)state;
    make(&made, 0, 0);
    EXPECT(&made, "<h1>Trend</h1>\n<p class=lead>The history holds no night yet.</p>",
           "0 nights, the latest first", "</html>");
    make(&made, 0, 1);
    add(&made, 0, 1, 1, NAN); /* of a night that is not there */
    EXPECT(&made, "The history holds no night yet.", "No night of it is left.");
}

static void groups_stand_together(void **state)
{
    struct made made;
    (void)state;
    make(&made, 1, 3);
    made.lines[1].class_name = "another machine";
    for (size_t i = 0; i < 3; i++)
        add(&made, i, 1, 1, NAN);
    char *text = page_of(&made, NULL);
    assert_int_equal(count_text(text, "<h3>"), 2);
    assert_int_equal(count_text(text, "<h4>corner \u00b7 front</h4>"), 2);
    assert_true(strstr(text, "id=l9>") < strstr(text, "id=l8>"));
    assert_contains(text, "<a href=#m0-1>nightly \u00b7 another machine</a>");
    free(text);
}

static void what_a_history_says_is_escaped(void **state)
{
    static char script[] = "<script>alert('&\"')</script>";
    struct made made;
    (void)state;
    make(&made, 3, 1);
    for (size_t i = 0; i < 3; i++) {
        made.nights[i].name = script;
        struct aob_point *point = add(&made, 0, (int64_t)i + 1, i < 2 ? 1 : NAN, NAN);
        point->reason = script;
        tell(point, i == 1 ? AOB_NIGHT_OPEN : AOB_NIGHT_BROKEN, 0, script);
    }
    made.nights[1].date = script;
    made.points[0][2].status = script;
    made.lines[0].class_name = made.lines[0].config = made.lines[0].text = script;
    made.lines[0].scene = made.lines[0].view = script;
    char *text = page_of(&made, script);
    assert_int_equal(count_text(text, "<script>alert"), 0);
    assert_int_equal(count_text(text, "<script>\n"), 2);
    assert_true(count_text(text, "&lt;script&gt;alert(&#39;&amp;&quot;&#39;)&lt;/script&gt;") > 20);
    free(text);
}

static void the_same_history_gives_the_same_bytes(void **state)
{
    struct made made;
    (void)state;
    make(&made, 16, 3);
    for (size_t i = 0; i < 3; i++)
        add_shift(&made, i, 1.05);
    char *once = page_of(&made, "T"), *again = page_of(&made, "T");
    assert_string_equal(once, again);
    assert_true(strstr(once, "<td class=wrap><a href=#l7>") < strstr(once, "<td class=wrap><a href=#l8>"));
    free(once);
    free(again);
}

static void a_folder_that_is_not_there_is_one_line(void **state)
{
    struct made made;
    struct aob_error error = {{0}};
    (void)state;
    make(&made, 1, 0);
    assert_false(
        aob_trend_write(&(struct aob_trend_desc){&made.of, &made.all, "/nowhere/at/all", NULL}, &error));
    assert_contains(error.text, "/nowhere/at/all/index.html");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_dot_stands_where_its_ratio_is),
        cmocka_unit_test(an_interval_is_a_bar),
        cmocka_unit_test(a_shift_is_told_with_its_date),
        cmocka_unit_test(a_change_is_one_row),
        cmocka_unit_test(a_decided_change_is_a_border),
        cmocka_unit_test(what_nobody_judged_is_said_so),
        cmocka_unit_test(the_table_has_an_order),
        cmocka_unit_test(a_missing_night_is_a_gap),
        cmocka_unit_test(a_night_far_off_does_not_widen_the_axis),
        cmocka_unit_test(strips_show_error_memory_and_images),
        cmocka_unit_test(a_series_without_a_ratio_is_drawn),
        cmocka_unit_test(an_empty_history_says_so),
        cmocka_unit_test(groups_stand_together),
        cmocka_unit_test(what_a_history_says_is_escaped),
        cmocka_unit_test(the_same_history_gives_the_same_bytes),
        cmocka_unit_test(a_folder_that_is_not_there_is_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
