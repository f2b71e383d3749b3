#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>
#include "base/child.h"
#include "base/memory.h"
#include "base/text.h"

struct lines {
    struct aob_text text; /* lines joined by '|' */
    size_t count, longest;
};

static void keep_line(void *user, const char *line)
{
    struct lines *lines = user;
    size_t size = strlen(line);
    lines->count++;
    lines->longest = size > lines->longest ? size : lines->longest;
    if (size < 1000)
        aob_text_add(&lines->text, "%s|", line);
}

static struct aob_child_result run_shell(const char *script, struct aob_child_desc desc, struct lines *lines)
{
    const char *argv[] = {"/bin/sh", "-c", script, NULL};
    struct aob_child_result result;
    struct aob_error error = {""};
    desc.argv = argv;
    desc.on_line = lines ? keep_line : NULL;
    desc.user = lines;
    if (!aob_child_run(&desc, &result, &error))
        fail_msg("%s", error.text);
    return result;
}

static void gives_lines_and_exit_code(void **state)
{
    (void)state;
    struct lines lines = {0};
    struct aob_child_result result =
        run_shell("echo one; echo; echo two; printf three; exit 7", (struct aob_child_desc){0}, &lines);
    assert_int_equal(result.exit_code, 7);
    assert_int_equal(result.signal, 0);
    assert_false(result.timed_out);
    assert_string_equal(lines.text.data, "one||two|three|");
    assert_string_equal(result.complaint, "");
    aob_text_finish(&lines.text);
}

static void feeds_big_input_and_takes_long_lines(void **state)
{
    (void)state;
    size_t size = 8u << 20;
    char *input = aob_alloc(size + 1, 1);
    memset(input, 'x', size);
    input[0] = input[size - 1] = '\n';
    struct lines lines = {0};
    struct aob_child_result result =
        run_shell("cat", (struct aob_child_desc){.input = input, .input_size = size}, &lines);
    assert_int_equal(result.exit_code, 0);
    assert_int_equal(lines.count, 2);
    assert_int_equal(lines.longest, size - 2);
    aob_text_finish(&lines.text);
    free(input);
}

static void ignores_input_that_is_not_read(void **state)
{
    (void)state;
    size_t size = 1u << 20;
    char *input = aob_alloc(size, 1);
    struct aob_child_desc desc = {.input = input, .input_size = size};
    assert_int_equal(run_shell("exit 0", desc, NULL).exit_code, 0);
    free(input);
}

static void empty_input_ends_at_once(void **state)
{
    (void)state;
    assert_int_equal(run_shell("! read line", (struct aob_child_desc){.timeout_s = 10}, NULL).exit_code, 0);
}

static void sets_environment(void **state)
{
    (void)state;
    setenv("AOB_TEST_OLD", "old", 1);
    setenv("AOB_TEST_KEPT", "kept", 1);
    const char *env[] = {"AOB_TEST_OLD=new", "AOB_TEST_MORE=a=b", NULL};
    struct lines lines = {0};
    run_shell("echo $AOB_TEST_OLD $AOB_TEST_MORE $AOB_TEST_KEPT", (struct aob_child_desc){.env = env},
              &lines);
    assert_string_equal(lines.text.data, "new a=b kept|");
    assert_string_equal(getenv("AOB_TEST_OLD"), "old");
    aob_text_finish(&lines.text);
}

static void kills_at_the_time_limit(void **state)
{
    (void)state;
    struct aob_child_desc desc = {.timeout_s = 0.2};
    struct lines lines = {0};
    struct aob_child_result result = run_shell("echo begin; printf part; sleep 100", desc, &lines);
    assert_true(result.timed_out);
    assert_int_equal(result.exit_code, -1);
    assert_string_equal(lines.text.data, "begin|");
    char text[256];
    aob_child_explain(&desc, &result, text, sizeof text);
    assert_string_equal(text, "did nothing for 0.2 s");
    aob_text_finish(&lines.text);
}

/* It would end by itself before 20 limits have gone by. */
static void kills_a_child_that_sleeps(void **state)
{
    (void)state;
    assert_string_equal(run_shell("exec sleep 15", (struct aob_child_desc){.timeout_s = 1}, NULL).limit,
                        "did nothing for 1 s");
}

static void kills_a_child_that_closed_its_outputs(void **state)
{
    (void)state;
    struct aob_child_desc desc = {.timeout_s = 0.2};
    assert_true(run_shell("exec >&- 2>&-; sleep 100", desc, NULL).timed_out);
}

/* The time limit is there for the test's sake; none of these gets near it. base/limits holds what this process
 * takes meanwhile. */
static void stops_a_child_that_writes_too_much(void **state)
{
    (void)state;
    static const struct {
        const char *script, *excess;
    } rows[] = {
        {"exec cat /dev/zero", "a line of more than 16 MiB on standard output"},
        {"exec cat /dev/zero >&2", "a line of more than 16 MiB on standard error"},
        {"exec yes", "more than 64 MiB on standard output"},
        {"exec yes >&2", "more than 64 MiB on standard error"},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_child_desc desc = {.timeout_s = 60};
        struct aob_child_result result = run_shell(rows[i].script, desc, NULL);
        assert_string_equal(result.excess, rows[i].excess);
        assert_false(result.timed_out);
        char text[256], wanted[256];
        aob_child_explain(&desc, &result, text, sizeof text);
        snprintf(wanted, sizeof wanted, "wrote %s, and was stopped", rows[i].excess);
        assert_string_equal(text, wanted);
    }
    struct aob_child_result result =
        run_shell("exec yes", (struct aob_child_desc){.timeout_s = 60, .output_limit = 4 << 20}, NULL);
    assert_string_equal(result.excess, "more than 4 MiB on standard output");
}

static void pin_to_one_processor(cpu_set_t *before)
{
    cpu_set_t one;
    assert_int_equal(sched_getaffinity(0, sizeof *before, before), 0);
    CPU_ZERO(&one);
    for (size_t cpu = 0; cpu < CPU_SETSIZE; cpu++)
        if (CPU_ISSET(cpu, before)) {
            CPU_SET(cpu, &one);
            break;
        }
    assert_int_equal(sched_setaffinity(0, sizeof one, &one), 0);
}

static struct aob_child_result run_self(const char *how, const char *seconds, struct aob_child_desc desc)
{
    const char *argv[] = {"/proc/self/exe", how, seconds, NULL};
    struct aob_child_result result;
    desc.argv = argv;
    assert_true(aob_child_run(&desc, &result, NULL));
    return result;
}

/* It works half a millisecond in twenty, and would end by itself before 20 limits have gone by. Where the machine is so
 * busy that it hardly gets there, it does nothing. */
static void stops_a_child_that_naps(void **state)
{
    (void)state;
    struct aob_child_desc desc = {.timeout_s = 1};
    struct aob_child_result result = run_self("nap", "0.3", desc);
    char text[256];
    aob_child_explain(&desc, &result, text, sizeof text);
    if (strcmp(text, "did next to nothing for 3 s") != 0)
        assert_string_equal(text, "did nothing for 1 s");
}

/* Six threads share a processor, and each gets its third of a second of it after two: twice the limit, of which none has
 * used more than a third. */
static void does_not_count_the_load_of_the_machine(void **state)
{
    (void)state;
    cpu_set_t before;
    pin_to_one_processor(&before);
    struct aob_child_result result = run_self("six", "0.33", (struct aob_child_desc){.timeout_s = 1});
    assert_int_equal(sched_setaffinity(0, sizeof before, &before), 0);
    assert_false(result.timed_out);
    assert_int_equal(result.exit_code, 0);
}

static double seconds_of_children(void)
{
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)usage.ru_utime.tv_sec + (double)usage.ru_stime.tv_sec +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static void counts_the_work_of_a_thread(void **state)
{
    (void)state;
    double before = seconds_of_children();
    struct aob_child_result result = run_self("one", "1000", (struct aob_child_desc){.timeout_s = 0.5});
    double worked = seconds_of_children() - before;
    assert_true(result.timed_out);
    assert_string_equal(result.limit, "took longer than 0.5 s of work");
    assert_true(worked > 0.45 && worked < 2); /* what starts counts too; 20 times the limit would be 10 s */
}

static void reports_a_crash(void **state)
{
    (void)state;
    struct aob_child_desc desc = {0};
    struct aob_child_result result = run_shell("echo last words >&2; kill -SEGV $$", desc, NULL);
    assert_int_equal(result.signal, SIGSEGV);
    assert_int_equal(result.exit_code, -1);
    char text[256];
    aob_child_explain(&desc, &result, text, sizeof text);
    assert_string_equal(text, "crashed (signal 11, segmentation fault): last words");
}

static void prefers_the_complaint_that_says_error(void **state)
{
    (void)state;
    struct aob_child_desc desc = {0};
    struct aob_child_result result =
        run_shell("(echo hello; echo 'Error: broken'; echo bye; echo) >&2; exit 2", desc, NULL);
    assert_string_equal(result.complaint, "Error: broken");
    char text[256];
    aob_child_explain(&desc, &result, text, sizeof text);
    assert_string_equal(text, "exit code 2: Error: broken");
}

static void cuts_a_long_complaint(void **state)
{
    (void)state;
    struct aob_child_result result =
        run_shell("head -c 100000 /dev/zero | tr '\\0' 'e' >&2", (struct aob_child_desc){0}, NULL);
    assert_int_equal(strlen(result.complaint), sizeof result.complaint - 1);
}

static void leaves_no_grandchild(void **state)
{
    (void)state;
    struct lines lines = {0};
    run_shell("sleep 100 & echo $!", (struct aob_child_desc){.timeout_s = 20}, &lines);
    pid_t grandchild = (pid_t)strtol(lines.text.data, NULL, 10);
    assert_true(grandchild > 1);
    /* It may stay a zombie for as long as this machine's init takes; what counts is that it does not run. */
    char path[64], stat[256] = "";
    snprintf(path, sizeof path, "/proc/%d/stat", (int)grandchild);
    for (int i = 0; i < 500; i++) {
        FILE *file = fopen(path, "r");
        bool gone = !file || !fgets(stat, sizeof stat, file) || strstr(stat, ") Z ") || strstr(stat, ") X ");
        if (file)
            fclose(file);
        if (gone)
            break;
        usleep(10000);
        assert_int_not_equal(i, 499);
    }
    aob_text_finish(&lines.text);
}

static void refuses_a_missing_program(void **state)
{
    (void)state;
    const char *argv[] = {"/nowhere/program", NULL};
    struct aob_child_result result;
    struct aob_error error = {""};
    assert_false(aob_child_run(&(struct aob_child_desc){.argv = argv}, &result, &error));
    assert_string_equal(error.text, "/nowhere/program: cannot start this program: No such file or directory");
}

static void explains_a_lack_of_memory(void **state)
{
    (void)state;
    struct aob_child_desc desc = {0};
    struct aob_child_result result =
        run_shell("echo '  what(): \t std::bad_alloc' >&2; kill -ABRT $$", desc, NULL);
    assert_int_equal(result.signal, SIGABRT);
    assert_string_equal(result.complaint, "what(): std::bad_alloc");
    char text[256];
    desc.memory_limit = 300000 << 10;
    aob_child_explain(&desc, &result, text, sizeof text);
    assert_string_equal(text, "not enough memory (its limit is 292 MiB): what(): std::bad_alloc");
}

static void *work(void *seconds)
{
    struct timespec now;
    do
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    while ((double)now.tv_sec + 1e-9 * (double)now.tv_nsec < *(double *)seconds);
    return NULL;
}

static int work_in_threads(size_t count, double seconds)
{
    pthread_t threads[6];
    for (size_t i = 0; i < count; i++)
        if (pthread_create(&threads[i], NULL, work, &seconds) != 0)
            return 1;
    for (size_t i = 0; i < count; i++)
        pthread_join(threads[i], NULL);
    return 0;
}

static int nap(double seconds)
{
    for (double worked = 5e-4; worked < seconds; worked += 5e-4) {
        work(&worked);
        usleep(20000);
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "nap") == 0)
        return nap(strtod(argv[2], NULL));
    if (argc > 2)
        return work_in_threads(strcmp(argv[1], "six") == 0 ? 6 : 1, strtod(argv[2], NULL));
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gives_lines_and_exit_code),
        cmocka_unit_test(feeds_big_input_and_takes_long_lines),
        cmocka_unit_test(ignores_input_that_is_not_read),
        cmocka_unit_test(empty_input_ends_at_once),
        cmocka_unit_test(sets_environment),
        cmocka_unit_test(kills_at_the_time_limit),
        cmocka_unit_test(kills_a_child_that_sleeps),
        cmocka_unit_test(kills_a_child_that_closed_its_outputs),
        cmocka_unit_test(stops_a_child_that_writes_too_much),
        cmocka_unit_test(does_not_count_the_load_of_the_machine),
        cmocka_unit_test(stops_a_child_that_naps),
        cmocka_unit_test(counts_the_work_of_a_thread),
        cmocka_unit_test(reports_a_crash),
        cmocka_unit_test(explains_a_lack_of_memory),
        cmocka_unit_test(prefers_the_complaint_that_says_error),
        cmocka_unit_test(cuts_a_long_complaint),
        cmocka_unit_test(leaves_no_grandchild),
        cmocka_unit_test(refuses_a_missing_program),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
