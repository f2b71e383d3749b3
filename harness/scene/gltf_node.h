/* The nodes of a glTF document: which belong to its scene, and their places. */
#ifndef AOB_SCENE_GLTF_NODE_H
#define AOB_SCENE_GLTF_NODE_H
#include "affine.h"
#include "gltf.h"

struct aob_gltf_nodes {
    struct aob_affine *place; /* of each node in the scene's space */
    size_t *order;            /* count: the nodes of the scene, each after its parent */
    size_t count, node_count;
};

/* Reads all nodes, and which belong to the scene: the one that the document names, else its first; without scenes all
 * do. KHR_node_visibility hides a node with all below it. False after a line if nodes form a loop, one has two
 * parents or is twice in the scene, or a rotation is no unit quaternion. aob_gltf_nodes_finish frees after either. */
bool aob_gltf_nodes_init(struct aob_gltf_nodes *nodes, struct aob_gltf *gltf, struct aob_error *error);
void aob_gltf_nodes_finish(struct aob_gltf_nodes *nodes);

/* Whether a quaternion is of length 1, as glTF demands, but for the rounding of bytes. */
bool aob_gltf_is_turn(const double turn[4]);

/* The map that scales, turns by a unit quaternion x y z w, then moves. */
struct aob_affine aob_gltf_trs(const double move[3], const double turn[4], const double scale[3]);
/* The first three rows of a 4 x 4 matrix in columns. */
struct aob_affine aob_gltf_matrix(const double columns[16]);
#endif
