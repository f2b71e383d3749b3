/* Three-vectors in double precision. World and view space are right-handed, +Y up; a view looks along -Z. */
#ifndef AOB_BASE_VEC_H
#define AOB_BASE_VEC_H
#include <math.h>

struct aob_vec3 {
    double x, y, z;
};

static inline struct aob_vec3 aob_vec(double x, double y, double z)
{
    return (struct aob_vec3){x, y, z};
}
static inline struct aob_vec3 aob_vec_add(struct aob_vec3 a, struct aob_vec3 b)
{
    return aob_vec(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline struct aob_vec3 aob_vec_sub(struct aob_vec3 a, struct aob_vec3 b)
{
    return aob_vec(a.x - b.x, a.y - b.y, a.z - b.z);
}
static inline struct aob_vec3 aob_vec_scale(struct aob_vec3 a, double s)
{
    return aob_vec(a.x * s, a.y * s, a.z * s);
}
static inline double aob_vec_dot(struct aob_vec3 a, struct aob_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline struct aob_vec3 aob_vec_cross(struct aob_vec3 a, struct aob_vec3 b)
{
    return aob_vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline double aob_vec_length(struct aob_vec3 a)
{
    return sqrt(aob_vec_dot(a, a));
}
/* The zero vector stays zero. */
static inline struct aob_vec3 aob_vec_normalize(struct aob_vec3 a)
{
    double l = aob_vec_length(a);
    return l > 0 ? aob_vec_scale(a, 1 / l) : a;
}
/* The unit vector n turned towards the unit vector v, in the plane of both, until n.v is `least` (-1 < least < 1); n
 * itself if n.v is that already. -v, which has no such plane, becomes v. */
static inline struct aob_vec3 aob_vec_bend(struct aob_vec3 n, struct aob_vec3 v, double least)
{
    double along = aob_vec_dot(n, v);
    struct aob_vec3 across = aob_vec_sub(n, aob_vec_scale(v, along));
    double length = aob_vec_length(across);
    if (along >= least)
        return n;
    if (!(length > 1e-9))
        return v;
    return aob_vec_add(aob_vec_scale(across, sqrt(1 - least * least) / length), aob_vec_scale(v, least));
}
#endif
