#include "curve.h"
#include <stdlib.h>
#include "base/memory.h"

void aob_curve_finish(struct aob_curve *curve)
{
    free(curve->lines);
    free(curve->misses);
    *curve = (struct aob_curve){0};
}

uint64_t aob_curve_at(const struct aob_curve *curve, uint64_t lines)
{
    size_t low = 0, high = curve->count; /* the first size above `lines` */
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (curve->lines[middle] <= lines)
            low = middle + 1;
        else
            high = middle;
    }
    return low ? curve->misses[low - 1] : 0;
}

void aob_curve_add(struct aob_curve *curve, const struct aob_curve *other)
{
    size_t room = curve->count + other->count, a = 0, b = 0;
    struct aob_curve sum = {0, AOB_NEW_ARRAY(uint64_t, room + 1), AOB_NEW_ARRAY(uint64_t, room + 1)};
    while (a < curve->count || b < other->count) {
        uint64_t left = a < curve->count ? curve->lines[a] : UINT64_MAX;
        uint64_t right = b < other->count ? other->lines[b] : UINT64_MAX;
        uint64_t lines = left < right ? left : right;
        a += left == lines;
        b += right == lines;
        sum.lines[sum.count] = lines;
        sum.misses[sum.count++] = (a ? curve->misses[a - 1] : 0) + (b ? other->misses[b - 1] : 0);
    }
    aob_curve_finish(curve);
    *curve = sum;
}
