/* A part of a mesh file, as its reader gives it: one material, vertices and triangles of its own. */
#ifndef AOB_SCENE_MESH_PART_H
#define AOB_SCENE_MESH_PART_H
#include "affine.h"
#include "mesh.h"

struct aob_mesh_part {
    struct aob_vec3 *positions; /* vertex_count */
    struct aob_vec3 *normals;   /* of any length; NULL, or one that is zero or not finite: one is made */
    float (*colours)[3];        /* linear; NULL: none */
    uint32_t (*triangles)[3];   /* triangle_count; the front is counter-clockwise */
    size_t vertex_count, triangle_count;
    struct aob_material material;
    bool painted; /* the file says the material, and colours multiply it; else they are the base colour */
};

void aob_mesh_part_finish(struct aob_mesh_part *part); /* frees the arrays */

/* Adds the part to the mesh, mapped by `place`. A map that mirrors turns the winding, so that a front stays one (glTF
 * 2.0, 3.7.4; other formats mean the same). Colours are averaged over each triangle; numbers are clamped to 0..1, which
 * a note says of a material; NAN stays, so that aob_mesh_check refuses the mesh. False after a line that begins with `name` if a triangle names a
 * vertex that is not there. */
bool aob_mesh_part_add(const struct aob_mesh_part *part, const struct aob_affine *place,
                       struct aob_mesh *mesh, const char *name, struct aob_error *error);

/* When all parts are added: drops triangles whose corners are not three places, makes the normals that are missing,
 * and joins vertices of the same place and normal. All comparisons are exact, so the mesh's size does not matter; what
 * no triangle names is dropped. A normal that is made is the mean of the triangles' unit normals at its place that are
 * within 60 degrees of its own triangle's, of one material, and lack normals as well. */
void aob_mesh_tidy(struct aob_mesh *mesh);
#endif
