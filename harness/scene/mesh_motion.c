#include <stdlib.h>
#include "base/memory.h"
#include "mesh.h"

void aob_mesh_start(struct aob_mesh *mesh, struct aob_vec3 step)
{
    mesh->moving_first = mesh->triangle_count;
    mesh->step = step;
}

void aob_mesh_rest(struct aob_mesh *mesh)
{
    mesh->moving_count = mesh->triangle_count - mesh->moving_first;
}

void aob_mesh_move(struct aob_mesh *mesh, int frames)
{
    struct aob_vec3 way = aob_vec_scale(mesh->step, frames);
    bool *moved = AOB_NEW_ARRAY(bool, mesh->vertex_count);
    for (size_t i = mesh->moving_first; i < mesh->moving_first + mesh->moving_count; i++)
        for (int k = 0; k < 3; k++) {
            uint32_t vertex = mesh->triangles[i][k];
            if (!moved[vertex])
                mesh->positions[vertex] = aob_vec_add(mesh->positions[vertex], way);
            moved[vertex] = true;
        }
    mesh->frame = frames;
    free(moved);
}
