#include "gltf_deform.h"
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"

static void add_displacements(struct aob_vec3 *into, const struct aob_numbers *numbers, double weight)
{
    for (size_t i = 0; i < numbers->count; i++) {
        const double *d = numbers->values + 3 * i;
        into[i] = aob_vec_add(into[i], aob_vec_scale(aob_vec(d[0], d[1], d[2]), weight));
    }
}

static bool add_target(const struct aob_gltf_primitive *primitive, const json_t *target, const char *name,
                       double weight, struct aob_vec3 *into, struct aob_error *error)
{
    struct aob_numbers numbers;
    if (!into)
        return true;
    if (!aob_gltf_attribute_of(primitive->gltf, target, name, 3, &numbers, error))
        return false;
    bool fits = !numbers.values || numbers.count == primitive->vertex_count;
    if (fits)
        add_displacements(into, &numbers, weight);
    free(numbers.values);
    return fits ||
           aob_fail(error, "%s: a morph target has %zu values of %s for %zu vertices: the file is damaged",
                    primitive->gltf->file->path, numbers.count, name, primitive->vertex_count);
}

bool aob_gltf_morph(const struct aob_gltf_primitive *primitive, const json_t *node, const json_t *mesh,
                    struct aob_mesh_part *part, struct aob_error *error)
{
    const json_t *targets = json_object_get(primitive->element, "targets"), *target;
    const json_t *weights = json_object_get(node, "weights");
    size_t at;
    if (!weights)
        weights = json_object_get(mesh, "weights");
    if (weights && json_array_size(targets) && json_array_size(weights) != json_array_size(targets))
        return aob_fail(error, "%s: a mesh has %zu weights for %zu morph targets: the file is damaged",
                        primitive->gltf->file->path, json_array_size(weights), json_array_size(targets));
    json_array_foreach(targets, at, target)
    {
        double weight = json_number_value(json_array_get(weights, at));
        if (weight != 0 && (!add_target(primitive, target, "POSITION", weight, part->positions, error) ||
                            !add_target(primitive, target, "NORMAL", weight, part->normals, error)))
            return false;
    }
    return true;
}

/* The joints' matrices: their places, times the inverses of those that they were bound at. */
struct joints {
    struct aob_affine *map;
    size_t count;
};

static bool read_joints(struct aob_gltf *gltf, size_t skin, const struct aob_gltf_nodes *nodes,
                        struct joints *joints, struct aob_error *error)
{
    const json_t *element = aob_gltf_element(gltf, "skins", skin, error), *entry;
    const json_t *list = json_object_get(element, "joints");
    struct aob_numbers inverse = {0};
    size_t at;
    if (!element || !aob_gltf_attribute_of(gltf, element, "inverseBindMatrices", 16, &inverse, error))
        return false;
    *joints =
        (struct joints){AOB_NEW_ARRAY(struct aob_affine, json_array_size(list) + 1), json_array_size(list)};
    bool ok = !inverse.values || inverse.count >= joints->count ||
              aob_fail(error, "%s: skin %zu has %zu matrices for %zu joints: the file is damaged",
                       gltf->file->path, skin, inverse.count, joints->count);
    json_array_foreach(list, at, entry)
    {
        size_t node = json_is_integer(entry) ? (size_t)json_integer_value(entry) : aob_gltf_none;
        ok = ok && aob_gltf_element(gltf, "nodes", node, error);
        if (!ok)
            break;
        struct aob_affine bound =
            inverse.values ? aob_gltf_matrix(inverse.values + 16 * at) : aob_affine_identity();
        joints->map[at] = aob_affine_multiply(&nodes->place[node], &bound);
    }
    free(inverse.values);
    return ok;
}

static void add_map(struct aob_affine *sum, const struct aob_affine *map, double weight)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            sum->m[i][j] += weight * map->m[i][j];
}

/* The influences of all vertices: their maps summed, and the weights' sum. */
struct influences {
    struct aob_affine *map;
    double *weight;
    size_t *first; /* joint of the first influence */
    size_t sets;   /* that were read */
};

static bool add_set(const struct aob_gltf_primitive *primitive, const struct joints *joints,
                    const struct aob_numbers *joint, const struct aob_numbers *weight,
                    struct influences *influences, struct aob_error *error)
{
    for (size_t i = 0; i < 4 * primitive->vertex_count; i++) {
        double number = joint->values[i], w = weight->values[i];
        if (!(number >= 0 && number < (double)joints->count) && w != 0)
            return aob_fail(error, "%s: a vertex names joint %g of %zu: the file is damaged",
                            primitive->gltf->file->path, number, joints->count);
        if (w != 0)
            add_map(&influences->map[i / 4], &joints->map[(size_t)number], w);
        influences->weight[i / 4] += w;
        if (i % 4 == 0 && !influences->sets && number >= 0 && number < (double)joints->count)
            influences->first[i / 4] = (size_t)number;
    }
    return true;
}

/* JOINTS_0 and WEIGHTS_0, then 1, and so on. */
static bool read_influences(const struct aob_gltf_primitive *primitive, const struct joints *joints,
                            struct influences *influences, struct aob_error *error)
{
    bool ok = true, more = joints->count > 0;
    while (ok && more) {
        char name[2][32];
        struct aob_numbers joint = {0}, weight = {0};
        snprintf(name[0], sizeof name[0], "JOINTS_%zu", influences->sets);
        snprintf(name[1], sizeof name[1], "WEIGHTS_%zu", influences->sets);
        ok = aob_gltf_attribute(primitive, name[0], 4, &joint, error) &&
             aob_gltf_attribute(primitive, name[1], 4, &weight, error);
        more = ok && joint.values && weight.values;
        if (more)
            ok = add_set(primitive, joints, &joint, &weight, influences, error);
        influences->sets += more;
        free(joint.values);
        free(weight.values);
    }
    return ok;
}

static void apply(const struct influences *influences, const struct joints *joints,
                  struct aob_mesh_part *part)
{
    for (size_t i = 0; i < part->vertex_count; i++) {
        struct aob_affine map = {{{0}}};
        if (influences->weight[i] != 0)
            add_map(&map, &influences->map[i], 1 / influences->weight[i]);
        else
            map = joints->map[influences->first[i]];
        part->positions[i] = aob_affine_point(&map, part->positions[i]);
        if (part->normals)
            part->normals[i] = aob_affine_normal(&map, part->normals[i]);
        influences->map[i] = map;
    }
    for (size_t i = 0; i < part->triangle_count; i++) {
        uint32_t *t = part->triangles[i], last = t[2];
        if (aob_affine_determinant(&influences->map[t[0]]) >= 0)
            continue;
        t[2] = t[1];
        t[1] = last;
    }
}

bool aob_gltf_skin(const struct aob_gltf_primitive *primitive, size_t skin,
                   const struct aob_gltf_nodes *nodes, struct aob_mesh_part *part, bool *done,
                   struct aob_error *error)
{
    size_t count = part->vertex_count + 1;
    struct joints joints = {0};
    struct influences influences = {AOB_NEW_ARRAY(struct aob_affine, count), AOB_NEW_ARRAY(double, count),
                                    AOB_NEW_ARRAY(size_t, count), 0};
    bool ok = read_joints(primitive->gltf, skin, nodes, &joints, error) &&
              read_influences(primitive, &joints, &influences, error);
    *done = ok && influences.sets > 0;
    if (*done)
        apply(&influences, &joints, part);
    free(joints.map);
    free(influences.map);
    free(influences.weight);
    free(influences.first);
    return ok;
}
