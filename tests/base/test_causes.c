#include "check.h"
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "base/causes.h"
#include "base/file.h"
#include "base/memory.h"

static int64_t steal_of(const char *text)
{
    char path[] = "/tmp/aobudget-stat-XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0 && aob_file_send(file, text, strlen(text)));
    close(file);
    int64_t steal = aob_causes_read_steal(path);
    unlink(path);
    return steal;
}

/* The eighth number is steal (proc(5)); kernels before 2.6.11 have seven. */
static void test_steal(void **state)
{
    (void)state;
    assert_int_equal(steal_of("cpu  1 2 3 4 5 6 7 88 9 10\ncpu0 1 2 3 4 5 6 7 8 9 10\n"), 88);
    assert_int_equal(steal_of("cpu  1 2 3 4 5 6 7 0 0 0\n"), 0);
    assert_int_equal(steal_of("cpu  1 2 3 4 5 6 7\ncpu0 1 2 3 4 5 6 7\n"), AOB_CAUSE_UNKNOWN);
    assert_int_equal(steal_of("cpu0 1 2 3 4 5 6 7 8 9 10\n"), AOB_CAUSE_UNKNOWN);
    assert_int_equal(steal_of("something else"), AOB_CAUSE_UNKNOWN);
    assert_int_equal(steal_of(""), AOB_CAUSE_UNKNOWN);
    assert_int_equal(aob_causes_read_steal("/no/such/file"), AOB_CAUSE_UNKNOWN);
}

static void test_between(void **state)
{
    (void)state;
    struct aob_causes before = {1, 2, 3, 4, 5}, after = {11, 22, 33, 44, 55};
    struct aob_causes spent = aob_causes_between(&before, &after);
    assert_int_equal(spent.involuntary, 10);
    assert_int_equal(spent.voluntary, 20);
    assert_int_equal(spent.minor_faults, 30);
    assert_int_equal(spent.major_faults, 40);
    assert_int_equal(spent.steal_ticks, 50);
    before.steal_ticks = AOB_CAUSE_UNKNOWN;
    assert_int_equal(aob_causes_between(&before, &after).steal_ticks, AOB_CAUSE_UNKNOWN);
    before.steal_ticks = 56; /* the host's counter went back */
    assert_int_equal(aob_causes_between(&before, &after).steal_ticks, AOB_CAUSE_UNKNOWN);
}

/* A thread that sleeps gives its processor away once; pages that are touched first fault once each. */
static void test_of_this_process(void **state)
{
    (void)state;
    enum { PAGES = 64 };
    size_t size = (size_t)sysconf(_SC_PAGESIZE);
    struct aob_causes before = aob_causes_now();
    char *pages = mmap(NULL, PAGES * size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(pages != MAP_FAILED);
    madvise(pages, PAGES * size, MADV_NOHUGEPAGE);
    for (size_t i = 0; i < PAGES; i++)
        pages[i * size] = 1;
    for (int i = 0; i < 5; i++)
        usleep(1000);
    struct aob_causes after = aob_causes_now(), spent = aob_causes_between(&before, &after);
    munmap(pages, PAGES * size);
    assert_true(spent.minor_faults >= PAGES);
    assert_true(spent.voluntary >= 5);
    assert_true(spent.involuntary >= 0 && spent.major_faults >= 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_steal), cmocka_unit_test(test_between),
                                       cmocka_unit_test(test_of_this_process)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
