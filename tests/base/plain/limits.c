/* A child's limit of memory, and what its parent holds of its words. AddressSanitizer reserves terabytes and cannot run under
 * a limit, and it keeps what was freed. So this test is built without it, of the few files that it needs
 * (tests/CMakeLists.txt). */
#include "check.h"
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>
#include "base/child.h"
#include "base/memory.h"

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

static long peak_mib(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss >> 10;
}

/* A line may be of 16 MiB, and its place grows by doubling. */
static void holds_one_line_of_an_endless_child(void **state)
{
    (void)state;
    const char *const scripts[] = {"exec cat /dev/zero", "exec cat /dev/zero >&2", "exec yes",
                                   "exec yes >&2"};
    long before = peak_mib();
    for (size_t i = 0; i < AOB_COUNT(scripts); i++) {
        const char *argv[] = {"/bin/sh", "-c", scripts[i], NULL};
        struct aob_child_result result;
        assert_true(aob_child_run(&(struct aob_child_desc){.argv = argv, .timeout_s = 600}, &result, NULL));
        assert_true(*result.excess);
    }
    assert_in_range(peak_mib() - before, 16, 100);
}

/* Last, because a hard limit cannot be raised again, except by root. */
static void keeps_the_narrower_limit(void **state)
{
    (void)state;
    struct rlimit before, soft, hard = {ROOM, ROOM};
    assert_int_equal(getrlimit(RLIMIT_AS, &before), 0);
    soft = (struct rlimit){ROOM, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_AS, &soft), 0);
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
                                       cmocka_unit_test(holds_one_line_of_an_endless_child),
                                       cmocka_unit_test(keeps_the_narrower_limit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
