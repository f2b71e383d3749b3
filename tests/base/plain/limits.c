/* A child's limit of memory, and what its parent takes. AddressSanitizer reserves terabytes and keeps what was freed,
 * so this test is built without it, of the few files that it needs (tests/CMakeLists.txt). */
#include "check.h"
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>
#include "base/child.h"

enum { ROOM = 512 << 20, MORE = 1 << 30 };

/* The exit code of a child that allocates so much: 0 if it got it. */
static int eat(size_t bytes, size_t memory_limit)
{
    char text[32];
    snprintf(text, sizeof text, "%zu", bytes);
    const char *argv[] = {"/proc/self/exe", text, NULL};
    struct aob_child_result result;
    struct aob_error error = {""};
    if (!aob_child_run(&(struct aob_child_desc){.argv = argv, .memory_limit = memory_limit}, &result, &error))
        fail_msg("%s", error.text);
    return result.exit_code;
}

static void holds_its_limit(void **state)
{
    (void)state;
    assert_int_equal(eat(MORE, 0), 0);
    assert_int_equal(eat(MORE, ROOM), 1);
    assert_int_equal(eat(ROOM / 4, ROOM), 0);
}

static long peak_kib(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

/* An endless line: its first 16 MiB are held, in an array that grows. */
static void does_not_grow_with_what_a_child_writes(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        const char *argv[] = {"/bin/sh", "-c", i ? "exec cat /dev/zero >&2" : "exec cat /dev/zero", NULL};
        struct aob_child_result result;
        long before = peak_kib();
        assert_true(aob_child_run(&(struct aob_child_desc){.argv = argv, .timeout_s = 60}, &result, NULL));
        assert_true(*result.excess);
        assert_true(peak_kib() - before < 64 << 10);
    }
}

/* What it says of a child that C++ ended. The narrower limit is the one that was met. */
static void assert_explained(size_t memory_limit, const char *wanted)
{
    char text[128];
    struct aob_child_result result = {.exit_code = -1, .signal = SIGABRT, .complaint = "std::bad_alloc"};
    aob_child_explain(&(struct aob_child_desc){.memory_limit = memory_limit}, &result, text, sizeof text);
    assert_string_equal(text, wanted);
}

/* Last, because a hard limit cannot be raised again, except by root. */
static void keeps_the_narrower_limit(void **state)
{
    (void)state;
    struct rlimit before, soft, hard = {ROOM, ROOM};
    assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
    soft = (struct rlimit){ROOM, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_AS, &soft), 0);
    assert_explained(MORE, "not enough memory (its limit is 512 MiB): std::bad_alloc");
    assert_explained(ROOM / 8, "not enough memory (its limit is 64 MiB): std::bad_alloc");
    assert_explained(0, "not enough memory (its limit is 512 MiB): std::bad_alloc");
    assert_int_equal(eat(MORE, (size_t)4 << 30), 1); /* what the user set is not lifted */
    assert_int_equal(setrlimit(RLIMIT_AS, &hard), 0);
    assert_int_equal(eat(MORE, (size_t)4 << 30), 1); /* and is no reason not to start */
    assert_int_equal(eat(ROOM / 4, (size_t)4 << 30), 0);
    assert_int_equal(eat(ROOM / 4, ROOM / 8), 1); /* ours still holds below it */
    assert_int_equal(eat(ROOM / 4, 0), 0);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        return malloc(strtoull(argv[1], NULL, 10)) ? 0 : 1;
    const struct CMUnitTest tests[] = {cmocka_unit_test(holds_its_limit),
                                       cmocka_unit_test(does_not_grow_with_what_a_child_writes),
                                       cmocka_unit_test(keeps_the_narrower_limit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
