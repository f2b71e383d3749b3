/* Triangles in scene units. */
#ifndef AOB_SCENE_MESH_H
#define AOB_SCENE_MESH_H
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"
#include "base/hash.h"
#include "base/vec.h"
#include "material.h"

/* A line about a thing that a mesh file has and the mesh has not. */
struct aob_mesh_note {
    char text[160];
};
enum { AOB_MESH_NOTES = 8 };

struct aob_mesh {
    struct aob_vec3 *positions; /* vertex_count */
    struct aob_vec3 *normals;   /* vertex_count shading normals, unit; NULL: the geometric ones serve */
    uint32_t (*triangles)[3];   /* triangle_count; the front is counter-clockwise */
    size_t vertex_count, triangle_count, vertex_capacity, triangle_capacity;
    struct aob_material *materials; /* material_count, [0] the default one; NULL: all is of that */
    uint32_t *material_of;          /* of a triangle, its place in `materials`; NULL with them */
    size_t material_count, material_capacity, material_of_capacity;
    uint32_t material;   /* of the triangles to come; see aob_mesh_paint */
    size_t source_bytes; /* of the file that it was loaded from, if that says how much is in it; else 0 */
    struct aob_mesh_note notes[AOB_MESH_NOTES]; /* note_count */
    size_t note_count;
    /* Triangles that move, moving_count of them from moving_first on, with vertices of their own; each frame shifts them by
     * `step`. Only procedural scenes have any. A mesh is built as it is in frame 0. */
    size_t moving_first, moving_count;
    struct aob_vec3 step; /* scene units a frame */
    int frame;            /* that the mesh is in (aob_mesh_move) */
};

void aob_mesh_finish(struct aob_mesh *mesh);

/* These build a mesh. Each shape is added with vertices of its own, and all lengths are in scene units. */
uint32_t aob_mesh_add_vertex(struct aob_mesh *mesh, struct aob_vec3 position);
void aob_mesh_add_triangle(struct aob_mesh *mesh, uint32_t a, uint32_t b, uint32_t c);
void aob_mesh_add_quad(struct aob_mesh *mesh, struct aob_vec3 corner, struct aob_vec3 edge_u,
                       struct aob_vec3 edge_v); /* front: u x v */
void aob_mesh_add_box(struct aob_mesh *mesh, struct aob_vec3 low, struct aob_vec3 high,
                      double turn_y_deg); /* about its own centre */
void aob_mesh_add_sphere(struct aob_mesh *mesh, struct aob_vec3 centre, double radius,
                         int segments); /* >= 3 round the equator */
void aob_mesh_add_disc(struct aob_mesh *mesh, struct aob_vec3 centre, struct aob_vec3 normal, double radius,
                       int segments);

/* Gives this material to the triangles that are added from here on. Before the first call they have the default one. */
void aob_mesh_paint(struct aob_mesh *mesh, struct aob_material material);

/* The material of a triangle, and its place in the table (0 without a table). */
const struct aob_material *aob_mesh_material(const struct aob_mesh *mesh, uint32_t triangle);
uint32_t aob_mesh_material_index(const struct aob_mesh *mesh, uint32_t triangle);

/* Makes the triangles that are added from here on move by `step` a frame, and aob_mesh_rest those after it stand still. One
 * stretch of a mesh moves. */
void aob_mesh_start(struct aob_mesh *mesh, struct aob_vec3 step);
void aob_mesh_rest(struct aob_mesh *mesh);

/* Puts what moves where it is in the frame of that number. The mesh is in frame 0. A mesh in a later frame than 0 came there
 * by a step, and the tracer's velocities say so. */
void aob_mesh_move(struct aob_mesh *mesh, int frames);

/* The bounds of all vertices; an empty mesh has zeros. */
void aob_mesh_bounds(const struct aob_mesh *mesh, struct aob_vec3 *low, struct aob_vec3 *high);

/* Checks that every index is in range, every vertex finite, every material within 0..1, and that there is a triangle.
 * False after one line that begins with `name`. */
bool aob_mesh_check(const struct aob_mesh *mesh, const char *name, struct aob_error *error);

/* The digest of vertices and triangles, of materials if there are any (a cached G-buffer holds their colour), and of what
 * moves if anything does. It is the part of a cache key that says which geometry. */
void aob_mesh_digest(const struct aob_mesh *mesh, char key[AOB_KEY_SIZE]);

/* Writes and reads the flat file in which a loaded mesh passes from the loader's process to the others. It is sealed
 * (base/sealed.h), so what is read is what was written. */
bool aob_mesh_save(const struct aob_mesh *mesh, const char *path, struct aob_error *error);
bool aob_mesh_restore(struct aob_mesh *mesh, const char *path, struct aob_error *error);
extern const char
    aob_mesh_flat_version[8]; /* of the form of these files; a part of their names in the cache */

/* Notes a thing that is left out of the mesh. The same line counts once; what is beyond AOB_MESH_NOTES is dropped. */
void aob_mesh_note(struct aob_mesh *mesh, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Reads a mesh file: glTF 2.0 by a reader of the program's own (gltf_import.h), OBJ, PLY, STL, 3DS and all else that
 * assimp knows by assimp. It triangulates, applies node transforms (one that mirrors turns the winding), keeps shading
 * normals or makes them (60 degrees, not across materials), and joins vertices that are equal to the bit. Materials
 * are glTF's factors, with glTF's own defaults for what a material leaves out; OBJ's Kd (0.6 if left out), Pr and Pm;
 * and the diffuse colour of other formats. Textures are not read. Vertex colours are averaged over each triangle and
 * multiply the base colour; without a material they are the base colour. Numbers are taken as linear and clamped to
 * 0..1; what is missing is as in aob_material_default. It runs hostile parsers over hostile bytes: only ever call it
 * in a child process with limits. */
bool aob_mesh_import(struct aob_mesh *mesh, const char *path, struct aob_error *error);

/* Writes a line, which begins with `name`, for each thing that makes a loaded mesh suspicious, and returns how many
 * it wrote. They are its notes and two more. One is more than 400 bytes of the file for each triangle: assimp did not
 * understand its strips. The other is a centre 5000 longest sides or more from the origin: 32-bit floats have lost
 * detail, since a side has 3,400 steps at most; the line says how large a step is. */
enum { AOB_MESH_WARNINGS = AOB_MESH_NOTES + 2 };
size_t aob_mesh_suspect(const struct aob_mesh *mesh, const char *name,
                        struct aob_error warnings[AOB_MESH_WARNINGS]);

/* The version is raised when the importer would make other geometry or materials of the same file. It is part of
 * cache keys. */
extern const char aob_mesh_importer_version[];
#endif
