#include "viz_scale.hpp"
#include "viz_common.hpp"
#include <algorithm>
#include <cstring>

namespace aob_viz
{
void scale::Finish()
{
    double low = Low, high = High, width = high - low;
    if (!(width > 1e-9 * std::max(std::fabs(low), std::fabs(high))))
        width = Log || low == 0 ? .6 : std::fabs(low), low -= width / 2, high += width / 2;
    bool from_zero = !Log && Low >= 0 && Low < .4 * High;
    Low = from_zero ? 0 : low - .04 * width;
    High = high + .04 * width;
}

std::vector<scale::mark> scale::Decades() const
{
    const char *labelled = High - Low < 1.3 ? "12357" : High - Low < 3 ? "125" : "1";
    std::vector<mark> marks;
    for (int e = static_cast<int>(std::floor(Low)); e <= static_cast<int>(std::ceil(High)); e++)
        for (char digit = '1'; digit <= '9'; digit++) {
            double value = (digit - '0') * std::pow(10, e);
            if (To(value) >= Low && To(value) <= High)
                marks.push_back(
                    {value, digit == '1', std::strchr(labelled, digit) ? short_number(value) : ""});
        }
    return marks;
}

/* A very short logarithmic axis gets round steps, as a linear one does. */
std::vector<scale::mark> scale::Marks(int wanted) const
{
    if (Log && High - Low > .6)
        return Decades();
    double low = Log ? std::pow(10, Low) : Low, high = Log ? std::pow(10, High) : High;
    double step = nice_step(high - low, wanted);
    std::vector<mark> marks;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++)
        marks.push_back({i * step, false, number_text(i * step, decimals_of(step), false)});
    return marks;
}
} // namespace aob_viz
