#include "light.h"
#include <math.h>

static const double k0 = 0.28209479177387814;   /* 0.5 sqrt(1/pi) */
static const double k1 = 0.48860251190291992;   /* sqrt(3/(4 pi)) */
static const double k2 = 1.09254843059207907;   /* 0.5 sqrt(15/pi) */
static const double k20 = 0.31539156525252005;  /* 0.25 sqrt(5/pi) */
static const double k22 = 0.546274215296039535; /* 0.25 sqrt(15/pi) */

const struct aob_light aob_light_uniform = {
    .sh = {{3.5449077018110321, 3.5449077018110321, 3.5449077018110321}}}; /* 2 sqrt(pi) */

void aob_light_of_moments(const struct aob_light_moments *moments, double sh[9])
{
    sh[0] = k0 * moments->one;
    sh[1] = k1 * moments->y;
    sh[2] = k1 * moments->z;
    sh[3] = k1 * moments->x;
    sh[4] = k2 * moments->xy;
    sh[5] = k2 * moments->yz;
    sh[6] = k20 * (3 * moments->zz - moments->one);
    sh[7] = k2 * moments->xz;
    sh[8] = k22 * (moments->xx - moments->yy);
}

void aob_light_basis(struct aob_vec3 d, double basis[9])
{
    const struct aob_light_moments point = {
        .one = 1,
        .x = d.x,
        .y = d.y,
        .z = d.z,
        .xy = d.x * d.y,
        .yz = d.y * d.z,
        .xz = d.x * d.z,
        .xx = d.x * d.x,
        .yy = d.y * d.y,
        .zz = d.z * d.z,
    };
    aob_light_of_moments(&point, basis);
}

static void add_up(const struct aob_light *light, struct aob_vec3 direction, const double bands[3],
                   double rgb[3])
{
    double basis[9];
    aob_light_basis(direction, basis);
    for (int channel = 0; channel < 3; channel++) {
        rgb[channel] = 0;
        for (int i = 0; i < 9; i++)
            rgb[channel] += bands[i == 0 ? 0 : i < 4 ? 1 : 2] * basis[i] * light->sh[i][channel];
    }
}

void aob_light_radiance(const struct aob_light *light, struct aob_vec3 direction, double rgb[3])
{
    add_up(light, direction, (const double[3]){1, 1, 1}, rgb);
}

void aob_light_irradiance(const struct aob_light *light, struct aob_vec3 normal, double rgb[3])
{
    add_up(light, normal, (const double[3]){1, 2.0 / 3, 0.25}, rgb);
}

/* A channel as a polynomial of the direction: d' M d + vector . d + constant, M symmetric without trace. */
struct quadric {
    double m[3][3];
    struct aob_vec3 vector;
    double constant;
};

static struct quadric to_quadric(const struct aob_light *light, int channel)
{
    double c[9];
    for (int i = 0; i < 9; i++)
        c[i] = light->sh[i][channel];
    double xy = k2 * c[4] / 2, yz = k2 * c[5] / 2, xz = k2 * c[7] / 2;
    return (struct quadric){
        .m = {{k22 * c[8] - k20 * c[6], xy, xz},
              {xy, -k22 * c[8] - k20 * c[6], yz},
              {xz, yz, 2 * k20 * c[6]}},
        .vector = aob_vec(k1 * c[3], k1 * c[1], k1 * c[2]),
        .constant = k0 * c[0],
    };
}

static void from_quadric(const struct quadric *q, struct aob_light *light, int channel)
{
    const double c[9] = {
        q->constant / k0,     q->vector.y / k1,    q->vector.z / k1,
        q->vector.x / k1,     2 * q->m[0][1] / k2, 2 * q->m[1][2] / k2,
        q->m[2][2] / 2 / k20, 2 * q->m[0][2] / k2, (q->m[0][0] - q->m[1][1]) / 2 / k22,
    };
    for (int i = 0; i < 9; i++)
        light->sh[i][channel] = c[i];
}

static struct aob_vec3 times(const struct quadric *q, struct aob_vec3 d)
{
    return aob_vec(q->m[0][0] * d.x + q->m[0][1] * d.y + q->m[0][2] * d.z,
                   q->m[1][0] * d.x + q->m[1][1] * d.y + q->m[1][2] * d.z,
                   q->m[2][0] * d.x + q->m[2][1] * d.y + q->m[2][2] * d.z);
}

void aob_light_turn(const struct aob_light *light, const struct aob_frame_axes *axes,
                    struct aob_light *turned)
{
    const struct aob_vec3 axis[3] = {axes->right, axes->up, axes->back};
    for (int channel = 0; channel < 3; channel++) {
        struct quadric world = to_quadric(light, channel), view = {.constant = world.constant};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                view.m[i][j] = aob_vec_dot(axis[i], times(&world, axis[j]));
        view.vector = aob_vec(aob_vec_dot(axis[0], world.vector), aob_vec_dot(axis[1], world.vector),
                              aob_vec_dot(axis[2], world.vector));
        from_quadric(&view, turned, channel);
    }
}

/* One rotation of Jacobi's method: it makes m[i][j] zero, and turns `along` into the new axes. */
static void rotate(double m[3][3], double along[3], int i, int j)
{
    int other = 3 - i - j;
    double angle = atan2(2 * m[i][j], m[i][i] - m[j][j]) / 2, c = cos(angle), s = sin(angle);
    double a = m[i][i], b = m[j][j], mixed = m[i][j], u = m[i][other], v = m[j][other], p = along[i];
    m[i][i] = c * c * a + 2 * c * s * mixed + s * s * b;
    m[j][j] = s * s * a - 2 * c * s * mixed + c * c * b;
    m[i][j] = m[j][i] = 0;
    m[i][other] = m[other][i] = c * u + s * v;
    m[j][other] = m[other][j] = c * v - s * u;
    along[i] = c * p + s * along[j];
    along[j] = c * along[j] - s * p;
}

/* Over unit vectors the least of d' M d + v . d is the greatest of -L - sum of v_i^2 / (4 (m_i + L)) over all L above
 * -(the least m_i), in the axes of M with its eigenvalues m_i; each L gives a lower bound. The sum's slope falls with L,
 * so its zero is bisected. */
static double least_on_sphere(const double m[3], const double v[3])
{
    double least = fmin(m[0], fmin(m[1], m[2])), length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    double low = 0, high = length / 2, bound = least; /* of L + least */
    for (int step = 0; step < 60 && high > 0; step++) {
        double middle = (low + high) / 2, slope = -1;
        for (int i = 0; i < 3; i++) {
            double share = v[i] / (2 * (m[i] - least + middle));
            slope += share * share;
        }
        if (slope > 0)
            low = middle;
        else
            high = middle;
    }
    bound -= high;
    for (int i = 0; i < 3; i++)
        if (v[i] != 0)
            bound -= v[i] * v[i] / (4 * (m[i] - least + high));
    return bound;
}

double aob_light_least(const struct aob_light *light, int channel)
{
    struct quadric q = to_quadric(light, channel);
    double along[3] = {q.vector.x, q.vector.y, q.vector.z};
    for (int sweep = 0; sweep < 12; sweep++) {
        rotate(q.m, along, 0, 1);
        rotate(q.m, along, 1, 2);
        rotate(q.m, along, 0, 2);
    }
    const double m[3] = {q.m[0][0], q.m[1][1], q.m[2][2]};
    return q.constant + least_on_sphere(m, along);
}

double aob_light_exposure(const struct aob_light *light)
{
    double largest = 0;
    struct aob_light dark; /* the least of what is negated is the largest */
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            dark.sh[i][c] = -(i == 0 ? 1 : i < 4 ? 2.0 / 3 : 0.25) * light->sh[i][c];
    for (int c = 0; c < 3; c++)
        largest = fmax(largest, -aob_light_least(&dark, c));
    return largest > 0 ? 1 / largest : 1;
}
