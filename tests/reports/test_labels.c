/* What is read off all cases: labels, and the lines of cases.csv. */
#include "run_text.h"

/* Varying first (radius, of gtao only), then what is not at its default (blur; not steps), options likewise. */
static void test_labels(void **state)
{
    struct aob_rows rows;
    (void)state;
    write_run();
    read_rows(&rows);
    assert_string_equal(rows.list[0].label, "radius=0.25 blur=0 guard_band=64");
    assert_string_equal(rows.list[1].label, "radius=1 blur=0 guard_band=64");
    assert_string_equal(rows.list[2].label,
                        "guard_band=64"); /* run.json has no hbao: its defaults are not known */
    aob_rows_finish(&rows);
    char *page = make_page();
    assert_non_null(
        strstr(page, "title=\"radius=0.25 steps=6 blur=0 fetch=sampled guard_band=64\">radius=0.25 blur=0"));
    free(page);
}

static void write_builds(const char *first, const char *second)
{
    struct aob_text journal = {0};
    static const char format[] =
        "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"front\",\"technique\":\"gtao\",%s"
        "\"params\":{\"steps\":%s},\"status\":\"ok\"}\n";
    aob_text_add(&journal, format, "a", first, "6");
    aob_text_add(&journal, format, "b", second, "7");
    put("journal.jsonl", journal.data);
    put("run.json",
        "{\"techniques\":[{\"name\":\"gtao\",\"params\":[{\"name\":\"steps\",\"initial\":6}]},"
        "{\"name\":\"gtao\",\"module\":\"new.so\",\"params\":[{\"name\":\"steps\",\"initial\":8}]}]}");
    aob_text_finish(&journal);
}

/* Two builds of one technique are two techniques on the page, each with its own defaults; one alone is called by its
 * name. */
static void test_builds(void **state)
{
    struct aob_rows rows;
    (void)state;
    write_builds("", "\"module\":\"new.so\",");
    read_rows(&rows);
    assert_int_equal(rows.technique_count, 2);
    assert_string_equal(rows.list[0].technique, "gtao");
    assert_string_equal(rows.list[0].label, "");
    assert_string_equal(rows.list[1].technique, "gtao (new.so)");
    assert_string_equal(rows.list[1].label, "steps=7");
    aob_rows_finish(&rows);
    char *page = make_page();
    assert_non_null(strstr(page, "gtao (new.so)"));
    free(page);
    write_builds("\"module\":\"new.so\",", "\"module\":\"new.so\",");
    read_rows(&rows);
    assert_int_equal(rows.technique_count, 1);
    assert_string_equal(rows.list[0].technique, "gtao");
    assert_string_equal(rows.list[0].label, "steps=6");
    aob_rows_finish(&rows);
}

static char *concat(const char *format, const char *a, const char *b, const char *c)
{
    struct aob_text text = {0};
    aob_text_add(&text, format, a, b, c);
    return text.data;
}

static size_t count_fields(const char *line)
{
    size_t count = 1;
    for (; *line != '\r'; line++)
        count += *line == ',';
    return count;
}

/* Commas, quotes and line ends in a field; a record without anything. */
static const char odd_journal[] =
    "{\"key\":\"k\",\"series\":\"s\",\"scene\":\"a \\\"b\\\", "
    "c\",\"view\":\"two\\nlines\",\"technique\":\"gtao\","
    "\"module\":\"old.so\","
    "\"params\":{\"radius\":0.5,\"mode\":\"x\"},\"backend\":\"vulkan\",\"width\":64,"
    "\"height\":32,\"status\":\"ok\",\"options\":{\"fetch\":\"sampled\",\"guard_band\":64},"
    "\"memory_bytes\":2048,\"time\":{\"clock\":\"device\",\"wall_ms\":9,\"cpu_ms\":8,\"device_ms\":1.5,"
    "\"ratio_to_"
    "ref\":2,\"ci_low\":1.75,\"ci_high\":"
    "null},\"errors\":[{\"target\":{\"radius\":\"inf\",\"weighting\":\"uniform\"},"
    "\"reference\":\"screen\",\"rmse\":0.125,\"pixels\":2048},"
    "{\"target\":{\"radius\":0.1,\"weighting\":\"cosine\"},\"rmse\":0.25}]}\n"
    "{\"key\":\"l\",\"status\":\"failed\",\"reason\":\"no image\"}\n";

/* The lines of cases.csv from the second on, up to the metrics after band_rmse, which are empty. */
static void test_csv(void **state)
{
    (void)state;
    put("run.json", "{}");
    put("journal.jsonl", odd_journal);
    free(make_page());
    char *csv = get("report/cases.csv"), *line = strstr(csv, "\r\n");
    static const char head[] =
        "key,series,run,scene,view,technique,module,params,options,backend,size,status,reason,target_radius,"
        "target_weighting,reference,time_ms,ratio_to_ref,ci_low,ci_high,memory_bytes,rmse,band_rmse,";
    static const char *const parts[] = {
        ",\"a \"\"b\"\", c\",\"two\nlines\",gtao,old.so,radius=0.5 mode=x,fetch=sampled "
        "guard_band=64,vulkan,64x32,ok,,",
        "0.1,cosine,ray-traced,1.5,2,1.75,,2048,0.25,,",
        "inf,uniform,screen,1.5,2,1.75,,2048,0.125,,",
    };
    char *first = concat("\r\nk,s,%s%s%s", folder, parts[0], parts[1]),
         *second = concat("\r\nk,s,%s%s%s", folder, parts[0], parts[2]),
         *third = concat("\r\nl,,%s%s%s", folder, ",,,,,,,,,failed,no image,,,,,,,,,,", "");
    assert_memory_equal(csv, head, sizeof head - 1);
    assert_memory_equal(line, first, strlen(first));
    line = strstr(line + 2, "\r\n");
    assert_memory_equal(line, second, strlen(second));
    line = strstr(line + 2, "\r\n");
    assert_memory_equal(line, third, strlen(third));
    assert_string_equal(strstr(line + 2, "\r\n"), "\r\n");
    /* As many fields in the last line as names in the first. */
    assert_int_equal(count_fields(csv), count_fields(line + 2));
    free(csv);
    free(first);
    free(second);
    free(third);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_labels),
        cmocka_unit_test(test_builds),
        cmocka_unit_test(test_csv),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
