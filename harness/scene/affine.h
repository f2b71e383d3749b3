/* Affine maps of space, in double precision: node transforms of files. */
#ifndef AOB_SCENE_AFFINE_H
#define AOB_SCENE_AFFINE_H
#include "base/vec.h"

/* The upper three rows of a 4 x 4 matrix whose last row is 0 0 0 1; a point is a column to its right. */
struct aob_affine {
    double m[3][4];
};

static inline struct aob_affine aob_affine_identity(void)
{
    return (struct aob_affine){{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
}

/* The map that does b first, then a. */
static inline struct aob_affine aob_affine_multiply(const struct aob_affine *a, const struct aob_affine *b)
{
    struct aob_affine r;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            r.m[i][j] = a->m[i][0] * b->m[0][j] + a->m[i][1] * b->m[1][j] + a->m[i][2] * b->m[2][j] +
                        (j == 3 ? a->m[i][3] : 0);
    return r;
}

static inline struct aob_vec3 aob_affine_point(const struct aob_affine *a, struct aob_vec3 p)
{
    return aob_vec(a->m[0][0] * p.x + a->m[0][1] * p.y + a->m[0][2] * p.z + a->m[0][3],
                   a->m[1][0] * p.x + a->m[1][1] * p.y + a->m[1][2] * p.z + a->m[1][3],
                   a->m[2][0] * p.x + a->m[2][1] * p.y + a->m[2][2] * p.z + a->m[2][3]);
}

static inline struct aob_vec3 aob_affine_row(const struct aob_affine *a, int row)
{
    return aob_vec(a->m[row][0], a->m[row][1], a->m[row][2]);
}

/* Negative where the map mirrors. */
static inline double aob_affine_determinant(const struct aob_affine *a)
{
    return aob_vec_dot(aob_affine_row(a, 0), aob_vec_cross(aob_affine_row(a, 1), aob_affine_row(a, 2)));
}

/* A normal, which the inverse of the transpose maps, up to its length. It keeps its side of the surface where the map
 * mirrors as well. */
static inline struct aob_vec3 aob_affine_normal(const struct aob_affine *a, struct aob_vec3 n)
{
    struct aob_vec3 x = aob_affine_row(a, 0), y = aob_affine_row(a, 1), z = aob_affine_row(a, 2);
    struct aob_vec3 cofactors[3] = {aob_vec_cross(y, z), aob_vec_cross(z, x), aob_vec_cross(x, y)};
    double sign = aob_affine_determinant(a) < 0 ? -1 : 1;
    return aob_vec(sign * aob_vec_dot(cofactors[0], n), sign * aob_vec_dot(cofactors[1], n),
                   sign * aob_vec_dot(cofactors[2], n));
}
#endif
