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

/* Circles about the axis of a lobe. theta = 2 atan(a tan u): the middles of equal steps of u are dense where the lobe is
 * bright. */
struct circles {
    double weight[STEPS], cosine[STEPS], sine[STEPS], all;
};

static void place_circles(double roughness, struct circles *circles)
{
    double a = roughness * roughness, top = atan(1 / a);
    circles->all = 0;
    for (int i = 0; i < STEPS; i++) {
        double x = tan((i + 0.5) / STEPS * top), theta = 2 * atan(a * x);
        circles->cosine[i] = cos(theta);
        circles->sine[i] = sin(theta);
        circles->weight[i] = lobe(theta, a) * sin(theta) * (1 + x * x) / (1 + a * a * x * x);
        circles->all += circles->weight[i];
    }
}

/* The share of them that lies in a cone. */
static double share_in_cone(const struct circles *circles, double alpha, double beta)
{
    double edge = cos(alpha), along = cos(beta), aside = sin(beta), inside = 0;
    for (int i = 0; i < STEPS; i++) {
        double across = circles->sine[i] * aside, lack = edge - circles->cosine[i] * along;
        if (lack < across)
            inside += circles->weight[i] * (lack <= -across ? 1 : acos(lack / across) / pi);
    }
    return inside / circles->all;
}

double gtao_lobe_share(double alpha, double beta, double roughness)
{
    struct circles circles;
    place_circles(roughness, &circles);
    return share_in_cone(&circles, alpha, beta);
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
        struct circles circles;
        place_circles(roughness, &circles);
        for (int cone = 0; cone < GTAO_LOBE_CONES; cone++) {
            double alpha = w * unsquashed(widest * cone / (GTAO_LOBE_CONES - 1));
            for (int edge = 0; edge < GTAO_LOBE_EDGES; edge++) {
                double q = 2.0 * edge / (GTAO_LOBE_EDGES - 1) - 1;
                double beta = alpha + copysign(w * unsquashed(fabs(q)), q);
                *into++ = (uint16_t)lrint(65535 * share_in_cone(&circles, alpha, fmin(fmax(beta, 0), pi)));
            }
        }
    }
}
