/* One axis of a chart: what it spans and where its ticks are. */
#ifndef AOB_REPORTS_PLOT_VIZ_SCALE_HPP
#define AOB_REPORTS_PLOT_VIZ_SCALE_HPP
#include "viz.h"
#include <cmath>
#include <string>
#include <vector>

namespace aob_viz
{
class scale
{
  public:
    scale() = default;
    explicit scale(const aob_viz_axis &axis) : Label(axis.label ? axis.label : ""), Log(axis.logarithmic != 0)
    {
    }
    bool Takes(double value) const
    {
        return std::isfinite(value) && (!Log || value > 0);
    }
    void Include(double value)
    {
        if (Takes(value)) {
            Low = std::min(Low, To(value));
            High = std::max(High, To(value));
        }
    }
    void Finish();
    /* 0 at the low end, 1 at the high end. */
    double Place(double value) const
    {
        return (To(value) - Low) / (High - Low);
    }
    struct mark {
        double value;
        bool strong;
        std::string label;
    };
    std::vector<mark> Marks(int wanted) const;

    std::string Label;

  private:
    double To(double value) const
    {
        return Log ? std::log10(value) : value;
    }
    std::vector<mark> Decades() const;

    bool Log = false;
    double Low = HUGE_VAL, High = -HUGE_VAL;
};
} // namespace aob_viz
#endif
