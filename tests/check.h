/* Includes cmocka with the headers that it needs in front of it. */
#ifndef AOB_TESTS_CHECK_H
#define AOB_TESTS_CHECK_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A NAN is near a NAN only: the comparison of cmocka takes it for near anything. */
#define assert_near(a, b, tolerance)                                                                         \
    do {                                                                                                     \
        double near_a = (double)(a), near_b = (double)(b);                                                   \
        assert_int_equal(!isnan(near_a), !isnan(near_b));                                                    \
        assert_float_equal(near_a, near_b, tolerance);                                                       \
    } while (0)
#define assert_contains(text, part)                                                                          \
    do {                                                                                                     \
        if (!strstr((text), (part)))                                                                         \
            fail_msg("'%s' does not say '%s'", (text), (part));                                              \
    } while (0)
#endif
