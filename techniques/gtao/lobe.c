#include "lobe.h"
#include <math.h>
#include <stdint.h>

enum { STEPS = 128 };

static const double pi = 3.14159265358979323846;

/* Radiance of the lobe, theta away from its axis: D of the half vector times G1 of the outgoing direction. */
static double lobe(double theta, double a)
{
    double half = cos(theta / 2), d = half * half * (a * a - 1) + 1, c = cos(theta);
    double g = 2 / (1 + sqrt(1 + a * a * (1 - c * c) / (c * c)));
    return g / (d * d);
}

/* Share of the circle at theta about the lobe's axis that lies in the cone. */
static double circle_share(double theta, double alpha, double beta)
{
    double across = sin(theta) * sin(beta), lack = cos(alpha) - cos(theta) * cos(beta);
    if (lack >= across)
        return 0;
    return lack <= -across ? 1 : acos(lack / across) / pi;
}

/* theta = 2 atan(a tan u): the middles of equal steps of u are dense where the lobe is bright. */
double gtao_lobe_share(double alpha, double beta, double roughness)
{
    double a = roughness * roughness, top = atan(1 / a), inside = 0, all = 0;
    for (int i = 0; i < STEPS; i++) {
        double x = tan((i + 0.5) / STEPS * top), theta = 2 * atan(a * x);
        double weight = lobe(theta, a) * sin(theta) * (1 + x * x) / (1 + a * a * x * x);
        all += weight;
        inside += weight * circle_share(theta, alpha, beta);
    }
    return inside / all;
}

/* The inverse of q(x) = x / (1 + x). */
static double unsquashed(double q)
{
    return q / (1 - fmin(q, 0.9999));
}

void gtao_lobe_fill(const void *values, void *texels)
{
    uint16_t *into = texels;
    (void)values;
    for (int shape = 0; shape < GTAO_LOBE_SHAPES; shape++) {
        double roughness = GTAO_LOBE_LEAST + (1 - GTAO_LOBE_LEAST) * shape / (GTAO_LOBE_SHAPES - 1);
        double w = 4 * atan(roughness * roughness), widest = pi / 2 / (pi / 2 + w);
        for (int cone = 0; cone < GTAO_LOBE_CONES; cone++) {
            double alpha = w * unsquashed(widest * cone / (GTAO_LOBE_CONES - 1));
            for (int edge = 0; edge < GTAO_LOBE_EDGES; edge++) {
                double q = 2.0 * edge / (GTAO_LOBE_EDGES - 1) - 1;
                double beta = alpha + copysign(w * unsquashed(fabs(q)), q);
                *into++ = (uint16_t)lrint(65535 * gtao_lobe_share(alpha, fmin(fmax(beta, 0), pi), roughness));
            }
        }
    }
}
