#include "triangle.h"
#include <stdbool.h>

static double edge_distance(struct aob_vec3 p, struct aob_vec3 a, struct aob_vec3 b)
{
    struct aob_vec3 along = aob_vec_sub(b, a), from = aob_vec_sub(p, a);
    double t = aob_vec_dot(from, along) / aob_vec_dot(along, along);
    return aob_vec_length(aob_vec_sub(from, aob_vec_scale(along, fmin(fmax(t, 0), 1))));
}

double aob_triangle_distance(struct aob_vec3 p, const struct aob_vec3 corner[3])
{
    struct aob_vec3 normal =
        aob_vec_cross(aob_vec_sub(corner[1], corner[0]), aob_vec_sub(corner[2], corner[0]));
    double nearest = INFINITY;
    bool above = true;
    for (int k = 0; k < 3; k++) {
        struct aob_vec3 a = corner[k], b = corner[(k + 1) % 3];
        struct aob_vec3 inwards = aob_vec_cross(normal, aob_vec_sub(b, a));
        above = above && aob_vec_dot(inwards, aob_vec_sub(p, a)) >= 0;
        nearest = fmin(nearest, edge_distance(p, a, b));
    }
    double height = fabs(aob_vec_dot(normal, aob_vec_sub(p, corner[0]))) / aob_vec_length(normal);
    return above ? height : nearest;
}

void aob_triangle_meet(struct aob_vec3 origin, struct aob_vec3 direction, const struct aob_vec3 corner[3],
                       struct aob_vec3 normal, double *u, double *v)
{
    double det = aob_vec_dot(normal, direction);
    struct aob_vec3 c = aob_vec_cross(aob_vec_sub(corner[0], origin), direction);
    double a = aob_vec_dot(aob_vec_sub(corner[2], corner[0]), c) / det;
    double b = aob_vec_dot(aob_vec_sub(corner[0], corner[1]), c) / det;
    if (isfinite(a) && isfinite(b)) {
        *u = a;
        *v = b;
    }
    *u = fmin(fmax(*u, 0), 1);
    *v = fmin(fmax(*v, 0), 1);
    double sum = *u + *v;
    if (sum > 1) {
        *u /= sum;
        *v /= sum;
    }
}
