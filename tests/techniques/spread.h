/* Mean and bounds of an image, for the tests of techniques. */
#ifndef AOB_TESTS_TECHNIQUES_SPREAD_H
#define AOB_TESTS_TECHNIQUES_SPREAD_H
#include <math.h>

struct spread {
    double mean, least, most;
};

static inline struct spread spread_of(const float *values, int count)
{
    struct spread s = {0, INFINITY, -INFINITY};
    for (int i = 0; i < count; i++) {
        s.mean += (double)values[i] / count;
        s.least = fmin(s.least, (double)values[i]);
        s.most = fmax(s.most, (double)values[i]);
    }
    return s;
}
#endif
