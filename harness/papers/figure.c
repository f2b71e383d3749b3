#include "figure.h"
#include <math.h>

struct aob_paper_figure aob_paper_exact(double value)
{
    return (struct aob_paper_figure){value, value, value};
}

struct aob_paper_figure aob_paper_sum(struct aob_paper_figure a, struct aob_paper_figure b)
{
    return (struct aob_paper_figure){a.value + b.value, a.low + b.low, a.high + b.high};
}

struct aob_paper_figure aob_paper_difference(struct aob_paper_figure a, struct aob_paper_figure b)
{
    return aob_paper_sum(a, aob_paper_scaled(b, -1));
}

/* A divisor whose interval reaches 0 leaves the quotient unbounded. */
struct aob_paper_figure aob_paper_quotient(struct aob_paper_figure a, struct aob_paper_figure b)
{
    if (!(b.low > 0))
        return (struct aob_paper_figure){a.value / b.value, -INFINITY, INFINITY};
    return (struct aob_paper_figure){a.value / b.value, a.low / (a.low > 0 ? b.high : b.low),
                                     a.high / (a.high > 0 ? b.low : b.high)};
}

struct aob_paper_figure aob_paper_scaled(struct aob_paper_figure a, double factor)
{
    double low = factor > 0 ? a.low : a.high, high = factor > 0 ? a.high : a.low;
    return (struct aob_paper_figure){a.value * factor, low * factor, high * factor};
}

enum aob_paper_answer aob_paper_above(struct aob_paper_figure figure, double bar)
{
    return figure.low > bar ? AOB_PAPER_YES : figure.high <= bar ? AOB_PAPER_NO : AOB_PAPER_OPEN;
}

enum aob_paper_answer aob_paper_below(struct aob_paper_figure figure, double bar)
{
    return aob_paper_above(aob_paper_scaled(figure, -1), -bar);
}

enum aob_paper_answer aob_paper_within(struct aob_paper_figure figure, double low, double high)
{
    if (figure.low >= low && figure.high <= high)
        return AOB_PAPER_YES;
    return figure.high < low || figure.low > high ? AOB_PAPER_NO : AOB_PAPER_OPEN;
}

enum aob_paper_answer aob_paper_both(enum aob_paper_answer a, enum aob_paper_answer b)
{
    return a < b ? a : b;
}

enum aob_paper_answer aob_paper_either(enum aob_paper_answer a, enum aob_paper_answer b)
{
    return a > b ? a : b;
}

void aob_paper_figure_print(struct aob_paper_figure figure, struct aob_text *text)
{
    aob_text_add(text, "%.3g", figure.value);
    if (figure.low < figure.high)
        aob_text_add(text, " [%.3g, %.3g]", figure.low, figure.high);
}
