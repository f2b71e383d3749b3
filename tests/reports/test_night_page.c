/* What a night says, from items that are made here. */
#include "reports/trend/night_page.h"
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"

static struct aob_line slow = {.id = 7, .class_name = "cpu, llvmpipe", .text = "corner/front gtao a|b"};
static struct aob_line moved = {.id = 8, .class_name = "cpu, llvmpipe", .text = "corner/front ssao"};

static const struct aob_point before = {.band_rmse = .0312, .memory_bytes = 1048576};
static const struct aob_point now = {.band_rmse = .034, .memory_bytes = 1048576 * 1.25};
static const struct aob_point lost = {.band_rmse = NAN, .memory_bytes = 1048576};

static const struct aob_night_item items[] = {
    {.line = &slow,
     .verdict = AOB_NIGHT_SLOWER,
     .said = "The module is dearer.",
     .before_ratio = 1.2,
     .after_ratio = 1.272,
     .beside = 1.05,
     .low = 1.041,
     .high = 1.059},
    {.line = &moved,
     .now = &now,
     .before = &before,
     .verdict = AOB_NIGHT_MOVED,
     .said = "Another image.",
     .map = "moved/8"},
    {.line = &moved,
     .now = &lost,
     .before = &before,
     .verdict = AOB_NIGHT_MACHINE,
     .before_ratio = 2,
     .after_ratio = 1.9,
     .beside = .9999,
     .low = .99,
     .high = 1.01},
};
static const struct aob_night_page page = {.title = "nightly",
                                           .date = "2026-11-30T02:00:00Z",
                                           .old_note = "1 module is not kept.",
                                           .cases = 122,
                                           .ok = 120,
                                           .watched = 118,
                                           .suspects = 3,
                                           .items = items,
                                           .count = AOB_COUNT(items),
                                           .trend = "../index.html",
                                           .run_page = "run/report/index.html"};

static void markdown_of(const struct aob_night_page *of, const char *expected)
{
    struct aob_text text = {0};
    aob_night_page_markdown(of, &text);
    assert_string_equal(text.data, expected);
    aob_text_finish(&text);
}

static void markdown_says_what_changed(void **state)
{
    (void)state;
    markdown_of(
        &page,
        "**nightly 2026-11-30: 1 slower, 1 moved, 1 machine** (120 of 122 cases ok, 118 "
        "series watched, 3 stood "
        "out)\n"
        "\n"
        "| verdict | change | series | before | after | beside the old module | why |\n"
        "|---|---:|---|---:|---:|---|---|\n"
        "| slower | +5.0 % | corner/front gtao a&#124;b | 1.200 | 1.272 | +5.0 % [+4.1 %, "
        "+5.9 %] | The module is "
        "dearer. |\n"
        "| moved | \u2013 | corner/front ssao | \u2013 | \u2013 | \u2013 | Another image. (error in band "
        "0.0312 \u2192 0.0340, 1.00 \u2192 1.25 MiB) |\n"
        "| machine | \u22125.0 % | corner/front ssao | 2.000 | 1.900 | +0.0 % [\u22121.0 %, +1.0 %] |  |\n"
        "\n"
        "1 module is not kept.\n"
        "\n"
        "[trend](../index.html) \u00b7 [run](run/report/index.html)\n");
    markdown_of(&(struct aob_night_page){0},
                "**Night: nothing changed** (0 of 0 cases ok, 0 series watched, 0 stood out)\n");
}

static void screen_of(const struct aob_night_page *of, const char *expected)
{
    struct aob_text text = {0};
    aob_night_page_screen(of, &text);
    assert_string_equal(text.data, expected);
    aob_text_finish(&text);
}

static void the_screen_says_what_changed(void **state)
{
    (void)state;
    screen_of(&page, "nightly 2026-11-30: 1 slower, 1 moved, 1 machine\n"
                     "120 of 122 cases ok, 118 series watched, 3 stood out\n"
                     "1 module is not kept.\n"
                     "slower     +5.0 %  corner/front gtao a|b\n"
                     "                   The module is dearer.\n"
                     "moved           \u2013  corner/front ssao\n"
                     "                   Another image.\n"
                     "machine    \u22125.0 %  corner/front ssao\n");
    screen_of(&(struct aob_night_page){0}, "Night: nothing changed\n"
                                           "0 of 0 cases ok, 0 series watched, 0 stood out\n");
}

static struct aob_night_page many(size_t count)
{
    struct aob_night_item *all = AOB_NEW_ARRAY(struct aob_night_item, count);
    struct aob_night_page of = page;
    for (size_t i = 0; i < count; i++)
        all[i] = items[0];
    of.items = all;
    of.count = count;
    return of;
}

static size_t lines_of(const struct aob_text *text)
{
    size_t count = 0;
    for (size_t i = 0; i < text->size; i++)
        count += text->data[i] == '\n';
    return count;
}

/* Adds what is shown of so many items and returns how many lines it is; it ends in `expected`. */
static size_t length(void (*print)(const struct aob_night_page *, struct aob_text *), size_t count,
                     const char *expected)
{
    struct aob_night_page of = many(count);
    struct aob_text text = {0};
    print(&of, &text);
    assert_contains(text.data, expected);
    size_t lines = lines_of(&text);
    aob_text_finish(&text);
    free((void *)of.items);
    return lines;
}

static void what_has_no_room_is_counted(void **state)
{
    (void)state;
    assert_int_equal(length(aob_night_page_markdown, 50, "50 slower"), 4 + 50 + 4);
    assert_int_equal(length(aob_night_page_markdown, 90, "\n40 more are on the page.\n"), AOB_NIGHT_MARKDOWN);
    assert_int_equal(length(aob_night_page_screen, 10, "The module is dearer."), 3 + 20);
    assert_int_equal(length(aob_night_page_screen, 11, "11 slower"), 3 + 11);
    assert_int_equal(length(aob_night_page_screen, 21, "a|b\n"), AOB_NIGHT_ROWS);
    assert_int_equal(length(aob_night_page_screen, 90, "\n70 more, of 90\n"), AOB_NIGHT_ROWS);
}

/* 19 columns stand in front of the sentence; characters are counted, not bytes. */
static void a_long_line_is_cut(void **state)
{
    char sentence[83 * 2 + 1] = "", expected[512];
    struct aob_night_item item = items[1];
    struct aob_night_page of = {.items = &item, .count = 1};
    (void)state;
    for (size_t i = 0; i < 83; i++)
        strcat(sentence, "\u00e9");
    item.said = sentence;
    snprintf(expected, sizeof expected,
             "Night: 1 moved\n0 of 0 cases ok, 0 series watched, 0 stood out\n"
             "moved           \u2013  corner/front ssao\n%19s%.*s...\n",
             "", 78 * 2, sentence);
    screen_of(&of, expected);
    sentence[81 * 2] = '\0';
    snprintf(expected, sizeof expected,
             "Night: 1 moved\n0 of 0 cases ok, 0 series watched, 0 stood out\n"
             "moved           \u2013  corner/front ssao\n%19s%s\n",
             "", sentence);
    screen_of(&of, expected);
}

static void the_screen_shows_no_control_characters(void **state)
{
    struct aob_night_item item = items[1];
    (void)state;
    item.said = "a\x1b[2Jb\nc";
    screen_of(&(struct aob_night_page){.items = &item, .count = 1},
              "Night: 1 moved\n0 of 0 cases ok, 0 series watched, 0 stood out\n"
              "moved           \u2013  corner/front ssao\n                   a\\u001b[2Jb c\n");
}

/* The page's text; free() it. */
static char *written(const struct aob_night_page *of)
{
    char folder[] = "/tmp/aobudget-night-XXXXXX";
    struct aob_error error = {{0}};
    assert_non_null(mkdtemp(folder));
    if (!aob_night_page_write(of, folder, &error))
        fail_msg("%s", error.text);
    char *path = aob_path_join(folder, "index.html");
    char *text = aob_file_read(path, 1 << 20, NULL, &error);
    assert_non_null(text);
    unlink(path);
    rmdir(folder);
    free(path);
    return text;
}

static void the_page_says_what_changed(void **state)
{
    (void)state;
    char *text = written(&page);
    assert_contains(text,
                    "<h1>nightly 2026-11-30</h1>\n<p class=lead><b>1 slower, 1 moved, 1 machine</b></p>");
    assert_contains(text, "<p class=banner role=status>1 module is not kept.</p>");
    assert_contains(
        text, "<td class=n>+5.0 %</td><td class=wrap>corner/front gtao a|b<br><small>cpu, llvmpipe</small>"
              "</td><td class=n data-v=\"1.2\">1.200</td><td class=n data-v=\"1.272\">1.272</td>"
              "<td class=n>+5.0 % [+4.1 %, +5.9 %]</td><td class=wrap>The module is dearer.</td></tr>");
    assert_contains(
        text,
        "<img loading=lazy alt=\"\" src=\"moved/8.png\"></a><figcaption>corner/front ssao: Another image.");
    assert_contains(
        text,
        "Another image.<br><small>error in band 0.0312 \u2192 0.0340, 1.00 \u2192 1.25 MiB</small></td>");
    assert_contains(text, "<a href=\"../index.html\">trend</a>");
    free(text);
}

static void the_page_escapes_and_takes_nothing(void **state)
{
    static char script[] = "<script>alert('\"&')</script>";
    struct aob_line line = {.class_name = script, .text = script};
    struct aob_night_item item = {.line = &line, .verdict = AOB_NIGHT_OPEN, .said = script, .map = script};
    (void)state;
    char *text =
        written(&(struct aob_night_page){script, script, script, 0, 0, 0, 0, &item, 1, script, script});
    assert_null(strstr(text, "<script"));
    assert_contains(text, "&lt;script&gt;alert(&#39;&quot;&amp;&#39;)&lt;/script&gt;");
    free(text);
    text = written(&(struct aob_night_page){0});
    assert_contains(text, "<b>nothing changed</b>");
    assert_contains(text, "<nav></nav>");
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(markdown_says_what_changed),
        cmocka_unit_test(the_screen_says_what_changed),
        cmocka_unit_test(what_has_no_room_is_counted),
        cmocka_unit_test(a_long_line_is_cut),
        cmocka_unit_test(the_screen_shows_no_control_characters),
        cmocka_unit_test(the_page_says_what_changed),
        cmocka_unit_test(the_page_escapes_and_takes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
