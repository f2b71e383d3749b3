#include "light.h"

/* RINGS is even, so that no ring lies on the equator, where lights have their horizon. */
enum { RINGS = 256, AROUND = 512, HALVINGS = 48 };

/* Legendre's polynomial of degree RINGS at x, and its slope. */
static double legendre(double x, double *slope)
{
    double before = 1, p = x;
    for (int n = 2; n <= RINGS; n++) {
        double next = ((2 * n - 1) * x * p - (n - 1) * before) / n;
        before = p;
        p = next;
    }
    *slope = RINGS * (before - x * p) / (1 - x * x);
    return p;
}

/* The height of ring i and its share of -1..1, the weight of a Gauss-Legendre node; Newton's method from the usual
 * guess. */
static double ring_height(int i, double *weight)
{
    double x = cos(M_PI * (i + 0.75) / (RINGS + 0.5)), slope = 1;
    for (int step = 0; step < 8; step++)
        x -= legendre(x, &slope) / slope;
    legendre(x, &slope);
    *weight = 2 / ((1 - x * x) * slope * slope);
    return x;
}

void aob_light_project(aob_light_radiance_fn *radiance, void *user, struct aob_light_projection *projection)
{
    *projection = (struct aob_light_projection){0};
    double energy = 0;
    for (int i = 0; i < RINGS; i++) {
        double weight, y = ring_height(i, &weight), across = sqrt(1 - y * y);
        double angle = weight * 2 * M_PI / AROUND;
        /* An edge that runs from pole to pole lies elsewhere between the directions of each ring. */
        double stagger = fmod(i * 0.6180339887498949, 1);
        for (int j = 0; j < AROUND; j++) {
            double turn = 2 * M_PI * (j + stagger) / AROUND, basis[9], rgb[3];
            struct aob_vec3 direction = aob_vec(across * cos(turn), y, across * sin(turn));
            radiance(user, direction, rgb);
            aob_light_basis(direction, basis);
            for (int channel = 0; channel < 3; channel++) {
                energy += angle * rgb[channel] * rgb[channel];
                for (int k = 0; k < 9; k++)
                    projection->light.sh[k][channel] += angle * rgb[channel] * basis[k];
            }
        }
    }
    aob_light_window(projection, energy);
}

static struct aob_light weaken(const struct aob_light *light, double w)
{
    struct aob_light weak = *light;
    for (int k = 1; k < 9; k++)
        for (int channel = 0; channel < 3; channel++)
            weak.sh[k][channel] *= k < 4 ? w : w * w * w;
    return weak;
}

/* Whether no channel is below `bound` of its mean. */
static bool not_below(const struct aob_light *light, double bound)
{
    static const double k0 = 0.28209479177387814; /* coefficient 00 to the mean */
    for (int channel = 0; channel < 3; channel++)
        if (!(aob_light_least(light, channel) >= bound * k0 * light->sh[0][channel]))
            return false;
    return true;
}

void aob_light_window(struct aob_light_projection *projection, double energy)
{
    const struct aob_light raw = projection->light;
    double held = 0, kept = 0, lost = 1;
    for (int k = 0; k < 9; k++)
        for (int channel = 0; channel < 3; channel++)
            held += raw.sh[k][channel] * raw.sh[k][channel];
    projection->held = energy > 0 ? fmin(held / energy, 1) : 1;
    if (not_below(&raw, -1e-12))
        kept = 1;
    for (int i = 0; i < HALVINGS && kept < 1; i++) {
        double middle = (kept + lost) / 2;
        struct aob_light weak = weaken(&raw, middle);
        if (not_below(&weak, 0))
            kept = middle;
        else
            lost = middle;
    }
    if (kept < 1)
        projection->light = weaken(&raw, kept);
    projection->factors[0] = kept;
    projection->factors[1] = kept * kept * kept;
}
