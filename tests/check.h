/* Includes cmocka with the headers that it needs in front of it. */
#ifndef AOB_TESTS_CHECK_H
#define AOB_TESTS_CHECK_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <string.h>

#define assert_near(a, b, tolerance) assert_float_equal(a, b, tolerance)
#define assert_contains(text, part)                                                                          \
    do {                                                                                                     \
        if (!strstr((text), (part)))                                                                         \
            fail_msg("'%s' does not say '%s'", (text), (part));                                              \
    } while (0)
#endif
