#include "gltf_node.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

static double quaternion_length(const double q[4])
{
    return sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

bool aob_gltf_is_turn(const double turn[4])
{
    return fabs(quaternion_length(turn) - 1) < 0.05;
}

struct aob_affine aob_gltf_trs(const double move[3], const double turn[4], const double scale[3])
{
    double s = 1 / quaternion_length(turn), x = turn[0] * s, y = turn[1] * s, z = turn[2] * s,
           w = turn[3] * s;
    const double rotation[3][3] = {
        {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
        {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
        {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)},
    };
    struct aob_affine a;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++)
            a.m[i][j] = rotation[i][j] * scale[j];
        a.m[i][3] = move[i];
    }
    return a;
}

struct aob_affine aob_gltf_matrix(const double columns[16])
{
    struct aob_affine a;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            a.m[i][j] = columns[4 * j + i];
    return a;
}

/* The fourth row of a matrix is 0 0 0 1 but for rounding: another one would be a perspective. */
static bool is_affine(const double columns[16])
{
    return fabs(columns[3]) < 1e-6 && fabs(columns[7]) < 1e-6 && fabs(columns[11]) < 1e-6 &&
           fabs(columns[15] - 1) < 1e-6;
}

/* The map of a node in its parent's space. */
static bool own_map(const struct aob_gltf *gltf, size_t index, struct aob_affine *map,
                    struct aob_error *error)
{
    const json_t *node = aob_gltf_element(gltf, "nodes", index, error);
    struct aob_gltf_label label = aob_gltf_label("node", index);
    double columns[16] = {[0] = 1, [5] = 1, [10] = 1, [15] = 1}, move[3] = {0}, turn[4] = {0, 0, 0, 1},
           scale[3] = {1, 1, 1};
    if (!node || !aob_gltf_vector(gltf, node, label.text, "matrix", columns, 16, error) ||
        !aob_gltf_vector(gltf, node, label.text, "translation", move, 3, error) ||
        !aob_gltf_vector(gltf, node, label.text, "rotation", turn, 4, error) ||
        !aob_gltf_vector(gltf, node, label.text, "scale", scale, 3, error))
        return false;
    if (!is_affine(columns))
        return aob_fail(error, "%s: node %zu: the last row of its matrix is not 0 0 0 1: the file is damaged",
                        gltf->file->path, index);
    if (!aob_gltf_is_turn(turn))
        return aob_fail(error, "%s: the rotation of node %zu is no unit quaternion: the file is damaged",
                        gltf->file->path, index);
    *map = json_object_get(node, "matrix") ? aob_gltf_matrix(columns) : aob_gltf_trs(move, turn, scale);
    return true;
}

static bool is_hidden(const json_t *node)
{
    return json_is_false(json_object_get(aob_gltf_extension(node, "KHR_node_visibility"), "visible"));
}

/* While nodes are read. */
struct walk {
    struct aob_gltf *gltf;
    size_t *parent; /* aob_gltf_none: it has none */
    size_t *stack;  /* of nodes whose place is known and whose children are to come */
    size_t depth;
    bool *seen;
};

/* An entry of a list of nodes. */
static bool read_index(struct aob_gltf *gltf, const json_t *list, size_t at, size_t *node,
                       struct aob_error *error)
{
    const json_t *entry = json_array_get(list, at);
    *node = json_is_integer(entry) && json_integer_value(entry) >= 0 ? (size_t)json_integer_value(entry)
                                                                     : aob_gltf_none;
    return aob_gltf_element(gltf, "nodes", *node, error);
}

static bool read_parents(struct walk *walk, size_t node_count, struct aob_error *error)
{
    for (size_t i = 0; i < node_count; i++)
        walk->parent[i] = aob_gltf_none;
    for (size_t i = 0; i < node_count; i++) {
        struct aob_affine map;
        if (!own_map(walk->gltf, i, &map, error))
            return false;
        const json_t *element = aob_gltf_element(walk->gltf, "nodes", i, error);
        const json_t *children = json_object_get(element, "children");
        for (size_t k = 0; k < json_array_size(children); k++) {
            size_t child;
            if (!read_index(walk->gltf, children, k, &child, error))
                return false;
            if (walk->parent[child] != aob_gltf_none)
                return aob_fail(error, "%s: node %zu has two parents: the file is damaged",
                                walk->gltf->file->path, child);
            walk->parent[child] = i;
        }
    }
    return true;
}

static void visit(struct walk *walk, struct aob_gltf_nodes *nodes, size_t node)
{
    struct aob_affine own = aob_affine_identity();
    own_map(walk->gltf, node, &own, NULL);
    size_t parent = walk->parent[node];
    nodes->place[node] = parent == aob_gltf_none ? own : aob_affine_multiply(&nodes->place[parent], &own);
    walk->seen[node] = true;
    walk->stack[walk->depth++] = node;
}

/* Places of all nodes below those without a parent. Nodes of a loop all have one, so they are not reached. */
static bool place_nodes(struct walk *walk, struct aob_gltf_nodes *nodes, struct aob_error *error)
{
    for (size_t i = 0; i < nodes->node_count; i++)
        if (walk->parent[i] == aob_gltf_none)
            visit(walk, nodes, i);
    while (walk->depth) {
        const json_t *element = aob_gltf_element(walk->gltf, "nodes", walk->stack[--walk->depth], NULL);
        const json_t *children = json_object_get(element, "children");
        for (size_t k = 0; k < json_array_size(children); k++)
            visit(walk, nodes, (size_t)json_integer_value(json_array_get(children, k)));
    }
    for (size_t i = 0; i < nodes->node_count; i++)
        if (!walk->seen[i])
            return aob_fail(error, "%s: node %zu is below itself: the file is damaged",
                            walk->gltf->file->path, i);
    return true;
}

static void add_root(struct walk *walk, struct aob_gltf_nodes *nodes, size_t root)
{
    walk->seen[root] = true;
    walk->stack[walk->depth++] = root;
    while (walk->depth) {
        size_t node = walk->stack[--walk->depth];
        const json_t *element = aob_gltf_element(walk->gltf, "nodes", node, NULL);
        const json_t *children = json_object_get(element, "children");
        if (is_hidden(element))
            continue;
        nodes->order[nodes->count++] = node;
        for (size_t k = json_array_size(children); k-- > 0;)
            walk->stack[walk->depth++] = (size_t)json_integer_value(json_array_get(children, k));
    }
}

/* A node that is drawn twice is a mistake of the file (glTF 2.0, 5.26.1), and readers differ on it. */
static bool check_root(const struct walk *walk, size_t root, struct aob_error *error)
{
    if (walk->parent[root] != aob_gltf_none)
        return aob_fail(error, "%s: node %zu is in its scene's list and below node %zu: the file is damaged",
                        walk->gltf->file->path, root, walk->parent[root]);
    return !walk->seen[root] ||
           aob_fail(error, "%s: node %zu is twice in its scene's list: the file is damaged",
                    walk->gltf->file->path, root);
}

static bool choose_nodes(struct walk *walk, struct aob_gltf_nodes *nodes, struct aob_error *error)
{
    struct aob_gltf *gltf = walk->gltf;
    size_t scene, root;
    for (size_t i = 0; i < nodes->node_count; i++)
        walk->seen[i] = false;
    if (!aob_gltf_whole(gltf, gltf->file->root, "the document", "scene", 0, &scene, error))
        return false;
    if (!aob_gltf_count(gltf, "scenes")) {
        for (size_t i = 0; i < nodes->node_count; i++)
            if (walk->parent[i] == aob_gltf_none)
                add_root(walk, nodes, i);
        return true;
    }
    const json_t *element = aob_gltf_element(gltf, "scenes", scene, error);
    const json_t *roots = json_object_get(element, "nodes");
    for (size_t k = 0; k < json_array_size(roots); k++) {
        if (!read_index(gltf, roots, k, &root, error) || !check_root(walk, root, error))
            return false;
        add_root(walk, nodes, root);
    }
    return element;
}

bool aob_gltf_nodes_init(struct aob_gltf_nodes *nodes, struct aob_gltf *gltf, struct aob_error *error)
{
    size_t count = aob_gltf_count(gltf, "nodes");
    struct walk walk = {.gltf = gltf,
                        .parent = AOB_NEW_ARRAY(size_t, count + 1),
                        .stack = AOB_NEW_ARRAY(size_t, count + 1),
                        .seen = AOB_NEW_ARRAY(bool, count + 1)};
    *nodes = (struct aob_gltf_nodes){.place = AOB_NEW_ARRAY(struct aob_affine, count + 1),
                                     .order = AOB_NEW_ARRAY(size_t, count + 1),
                                     .node_count = count};
    bool ok = read_parents(&walk, count, error) && place_nodes(&walk, nodes, error) &&
              choose_nodes(&walk, nodes, error);
    free(walk.parent);
    free(walk.stack);
    free(walk.seen);
    return ok;
}

void aob_gltf_nodes_finish(struct aob_gltf_nodes *nodes)
{
    free(nodes->place);
    free(nodes->order);
    *nodes = (struct aob_gltf_nodes){0};
}
