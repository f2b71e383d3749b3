/* What a run makes of its blocks' workers, where they die, or say of a device what no device here does. Between the run and the
 * real program stands a script that reads each job and changes the answers. */
#include <jansson.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/text.h"
#include "check.h"
#include "run/run.h"
#include "store/journal.h"

static const char config[] = "name: block\n"
                             "scenes: [{name: corner, views: [front, far]}]\n"
                             "resolutions: [16x9]\n"
                             "backends: [\"null\"]\n"
                             "techniques: [{name: none}, {name: gtao}]\n"
                             "measure: {seconds: 0.01, error: false, images: false}\n";

static char *folder; /* of the test */

static char *path_of(const char *name)
{
    return aob_path_join(folder, name);
}

static void write_file(const char *name, const char *text, mode_t mode)
{
    struct aob_error error = {""};
    char *path = path_of(name);
    if (!aob_file_write(path, text, strlen(text), &error) || chmod(path, mode) != 0)
        fail_msg("%s", error.text);
    free(path);
}

/* The program that is run as `worker`: "$job" is what it reads, `ask` gives it to the real one. Jobs are kept in jobs. */
static void write_worker(const char *script)
{
    struct aob_text text = {0};
    aob_text_add(&text,
                 "#!/bin/bash\ncd '%s'\njob=$(cat)\nprintf '%%s\\n' \"$job\" >>jobs\n"
                 "ask() { printf '%%s' \"$job\" | \"$AOBUDGET_BUILD/aobudget\" worker; }\n"
                 "is() { [[ $job == *\"$1\"* ]]; }\n%s\n",
                 folder, script);
    write_file("worker", text.data, 0700);
    aob_text_finish(&text);
}

/* Runs the config with that worker. What is printed on standard error goes to the file `told`. The journal; decref it. */
static json_t *run_with(const char *script)
{
    struct aob_error error = {""};
    char *told = path_of("told"), *out = path_of("out"), *yaml = path_of("block.yaml"),
         *program = path_of("worker"), *journal = path_of("out/journal.jsonl"), *jobs = path_of("jobs");
    write_worker(script);
    unlink(jobs);
    fflush(stderr);
    int before = dup(STDERR_FILENO);
    assert_non_null(freopen(told, "w", stderr));
    aob_run(&(struct aob_run_desc){.dispatch = {.program = program},
                                   .config = yaml,
                                   .out = out,
                                   .fresh = true,
                                   .quiet = true,
                                   .no_page = true},
            &error);
    fflush(stderr);
    dup2(before, STDERR_FILENO);
    close(before);
    json_t *records = aob_journal_read(journal, NULL, &error);
    if (!records)
        fail_msg("%s", error.text);
    free(told);
    free(out);
    free(yaml);
    free(program);
    free(journal);
    free(jobs);
    return records;
}

/* How many lines of a file hold the text. */
static int count_lines(const char *name, const char *text)
{
    int count = 0;
    char *path = path_of(name), *line = NULL;
    size_t room = 0;
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (getline(&line, &room, file) > 0)
        count += strstr(line, text) != NULL;
    fclose(file);
    free(line);
    free(path);
    return count;
}

static const json_t *time_of(const json_t *records, size_t i)
{
    const json_t *time = json_object_get(json_array_get(records, i), "time");
    if (!json_is_object(time))
        fail_msg("record %zu has no time: %s", i,
                 json_string_value(json_object_get(json_array_get(records, i), "reason")));
    return time;
}

static void expect_text(const json_t *object, const char *name, const char *expected)
{
    assert_string_equal(json_string_value(json_object_get(object, name)), expected);
}

/* All is as it should be: two blocks of two cases, and the first process of the run chooses the clock. */
static void test_a_good_worker(void **state)
{
    (void)state;
    json_t *records = run_with("ask");
    assert_int_equal(json_array_size(records), 4);
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(json_array_size(json_object_get(time_of(records, i), "slots")), 4);
        expect_text(time_of(records, i), "clock", "cpu");
        expect_text(time_of(records, i), "clock_reason", "");
    }
    assert_int_equal(count_lines("told", ""), 0);
    assert_int_equal(count_lines("jobs", "\"job\":\"block\""), 6);
    assert_int_equal(count_lines("jobs", "\"clock\":null"), 1);
    assert_int_equal(count_lines("jobs", "\"clock\":\"cpu\""), 5);
    json_decref(records);
}

/* A device whose clock is not trusted, though no test of it can fail here: the first process says so. All blocks have the
 * clock that it chose, each record says why, and the user is told once. */
static void test_a_clock_that_is_not_trusted(void **state)
{
    (void)state;
    json_t *records = run_with("if is '\"clock\":null'; then\n"
                               "  ask | sed 's/\"clock\":\"cpu\",\"clock_reason\":\"\"/"
                               "\"clock\":\"wall\",\"clock_reason\":\"its clock says 0.5\"/; "
                               "s/\"clock\":\"cpu\"/\"clock\":\"wall\"/'\n"
                               "else ask; fi");
    assert_int_equal(json_array_size(records), 4);
    for (size_t i = 0; i < 4; i++) {
        expect_text(time_of(records, i), "clock", "wall");
        expect_text(time_of(records, i), "clock_reason", "its clock says 0.5");
    }
    assert_int_equal(count_lines("told", ""), 1);
    assert_int_equal(count_lines("told", "warning: null: costs are wall time, the way to the device and back "
                                         "included, as the device's own clock cannot be trusted: its clock "
                                         "says 0.5"),
                     1);
    assert_int_equal(count_lines("jobs", "\"clock\":null"), 1);
    assert_int_equal(count_lines("jobs", "\"clock\":\"wall\",\"clock_reason\":\"its clock says 0.5\""), 5);
    json_decref(records);
}

/* A process that dies when it has scored and before it says what it times knows nothing of what is dear: each case is timed
 * apart. */
static void test_a_worker_that_dies_before_it_times(void **state)
{
    (void)state;
    json_t *records =
        run_with("if is '\"score\":true'; then ask | sed '/\"timed\"/,$d'; kill -KILL $$; fi\nask");
    assert_int_equal(json_array_size(records), 4);
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(json_array_size(json_object_get(time_of(records, i), "slots")), 3);
        assert_int_equal(json_integer_value(json_object_get(time_of(records, i), "processes")), 3);
    }
    assert_int_equal(count_lines("told", " and its block: process 0 is lost: crashed (signal 9"), 2);
    assert_int_equal(count_lines("told", ""), 2);
    json_decref(records);
}

static int make_folder(void **state)
{
    char name[] = "/tmp/aobudget-block-XXXXXX", *lock;
    (void)state;
    folder = strdup(mkdtemp(name));
    lock = path_of("lock");
    setenv("AOBUDGET_LOCK", lock, 1);
    write_file("block.yaml", config, 0600);
    free(lock);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    struct aob_text command = {0};
    aob_text_add(&command, "rm -rf '%s'", folder);
    int code = system(command.data);
    aob_text_finish(&command);
    free(folder);
    return code;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_good_worker),
                                       cmocka_unit_test(test_a_clock_that_is_not_trusted),
                                       cmocka_unit_test(test_a_worker_that_dies_before_it_times)};
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
