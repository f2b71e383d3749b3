#include "oracle.h"
#include <math.h>

/* The area of the unit disc beyond a chord at distance t from its centre. */
static double segment(double t)
{
    return t < 1 ? acos(t) - t * sqrt(1 - t * t) : 0;
}

double aob_oracle_corner(double d, double r)
{
    return 1 - segment(d / r) / M_PI;
}

double aob_oracle_wall(double d, double h, double r)
{
    double diagonal = hypot(d, h), t = d / r;
    if (!(h > 0))
        return 1;
    double b = d / diagonal;
    return 1 - (segment(t) - (b > 0 ? b * segment(t / b) : 0)) / M_PI;
}

double aob_oracle_sheet(double x, double h, double r)
{
    double b = fabs(x) / hypot(x, h), q2 = 1 - h / r * (h / r), v2 = q2 - x / r * (x / r), outside = 0;
    if (!(h < r))
        return 1;
    if (v2 > 0) {
        double v = sqrt(v2), q = sqrt(q2);
        outside = v * fabs(x) / r + q2 * asin(fmin(1, v / q)) - b * (v * sqrt(1 - v2) + asin(v));
    }
    return 1 - (x < 0 ? M_PI * q2 - outside : outside) / M_PI;
}

double aob_oracle_disc(double x, double a, double h, double r)
{
    double reach = sqrt(fmax(0, r * r - h * h)), s = x * x + h * h + a * a;
    if (!(a > 0) || !(h < r))
        return 1;
    if (x + a <= reach)
        return 1 - 0.5 * (1 - (s - 2 * a * a) / sqrt(s * s - 4 * a * a * x * x));
    return a - x >= reach ? h / r * (h / r) : NAN;
}
