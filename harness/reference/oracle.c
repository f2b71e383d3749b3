#include "oracle.h"
#include <math.h>

double aob_oracle_corner(double d, double r)
{
    double t = d / r;
    if (!(t < 1))
        return 1;
    return 1 - (acos(t) - t * sqrt(1 - t * t)) / M_PI;
}

double aob_oracle_wall(double d, double h)
{
    double diagonal = hypot(d, h);
    return diagonal > 0 ? 0.5 * (1 + d / diagonal) : 1;
}

double aob_oracle_sheet_edge(double h, double r)
{
    double t = h / r;
    return t < 1 ? 0.5 * (1 + t * t) : 1;
}

double aob_oracle_disc(double a, double h)
{
    return a > 0 ? 1 - a * a / (a * a + h * h) : 1;
}
