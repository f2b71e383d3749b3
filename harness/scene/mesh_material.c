#include "base/memory.h"
#include "mesh.h"

/* A scene that comes back to one of the last materials shares its entry. The search goes no farther back, so that a
 * mesh with a colour for each triangle does not search through all of them. */
enum { LOOK_BACK = 8 };

static void start_table(struct aob_mesh *mesh)
{
    *AOB_PUSH(mesh->materials, mesh->material_count, mesh->material_capacity) = aob_material_default;
    mesh->material_of_capacity = mesh->triangle_capacity;
    mesh->material_of = aob_alloc(mesh->material_of_capacity, sizeof *mesh->material_of);
}

void aob_mesh_paint(struct aob_mesh *mesh, struct aob_material material)
{
    mesh->material = 0;
    if (aob_material_equal(&material, &aob_material_default))
        return;
    if (!mesh->materials)
        start_table(mesh);
    for (size_t back = 1; back <= LOOK_BACK && back < mesh->material_count; back++)
        if (aob_material_equal(&material, &mesh->materials[mesh->material_count - back])) {
            mesh->material = (uint32_t)(mesh->material_count - back);
            return;
        }
    mesh->material = (uint32_t)mesh->material_count;
    *AOB_PUSH(mesh->materials, mesh->material_count, mesh->material_capacity) = material;
}

uint32_t aob_mesh_material_index(const struct aob_mesh *mesh, uint32_t triangle)
{
    return mesh->material_of ? mesh->material_of[triangle] : 0;
}

const struct aob_material *aob_mesh_material(const struct aob_mesh *mesh, uint32_t triangle)
{
    return mesh->materials ? &mesh->materials[aob_mesh_material_index(mesh, triangle)]
                           : &aob_material_default;
}
