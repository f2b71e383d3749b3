/* What the backends share of a run: how long a submit may be, and what a device's timestamps mean. */
#include "check.h"
#include "gpu/backends.h"

static void test_short_lists_share_a_submit(void **state)
{
    (void)state;
    const int64_t ms = 1000000;
    assert_int_equal(aob_gpu_submit_repeats(0, 3, 50), 1);           /* not known yet: once, to find out */
    assert_int_equal(aob_gpu_submit_repeats(ms / 50, 1, 400), 400);  /* 20 us: all of them */
    assert_int_equal(aob_gpu_submit_repeats(ms / 50, 1, 4000), 512); /* as many passes as a submit holds */
    assert_int_equal(aob_gpu_submit_repeats(ms / 50, 20, 4000), 25); /* which are whole lists */
    assert_int_equal(aob_gpu_submit_repeats(7 * ms, 2, 4000), 14);   /* 98 of 100 ms */
    assert_int_equal(aob_gpu_submit_repeats(7 * ms, 2, 5), 5);
    assert_int_equal(aob_gpu_submit_repeats(3000 * ms, 32, 4), 1); /* a list is never cut */
}

static void test_ticks(void **state)
{
    (void)state;
    assert_int_equal(aob_gpu_ticks_ns(1000, 5000, 64, 1), 4000);
    assert_int_equal(aob_gpu_ticks_ns(1000, 5000, 36, 10), 40000);
    assert_int_equal(aob_gpu_ticks_ns(0, 24000000, 64, 1e9 / 24e6),
                     1000000000);                                       /* of 41.67 ns, as Intel's are */
    assert_int_equal(aob_gpu_ticks_ns(0xffffffff0, 0x10, 36, 1), 0x20); /* it wrapped on the way */
    assert_int_equal(aob_gpu_ticks_ns(UINT64_MAX - 1, 2, 64, 1), 4);
    assert_int_equal(aob_gpu_ticks_ns(0xabc0000000000010, 0x1230000000000030, 36, 1),
                     0x20); /* bits beyond 36 */
    /* A clock that ran for years keeps its nanoseconds. */
    assert_int_equal(aob_gpu_ticks_ns(1ull << 62, (1ull << 62) + 7, 64, 1), 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_short_lists_share_a_submit),
        cmocka_unit_test(test_ticks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
