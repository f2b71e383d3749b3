#include "mesh_double.h"
#include <stdlib.h>
#include "base/memory.h"
#include "mesh_place.h"

/* The corners by their places, from the smallest on, in the order of the winding. */
static void put_triangle(const uint32_t *places, const uint32_t corner[3], uint64_t words[2])
{
    uint64_t a = places[corner[0]], b = places[corner[1]], c = places[corner[2]];
    while (a > b || a > c) {
        uint64_t first = a;
        a = b;
        b = c;
        c = first;
    }
    words[0] = a << 32 | b;
    words[1] = c;
}

size_t aob_mesh_double_count(const struct aob_mesh *mesh)
{
    uint32_t *places = aob_mesh_places(mesh);
    uint64_t *words = AOB_NEW_ARRAY(uint64_t, 2 * mesh->triangle_count + 1);
    for (size_t i = 0; i < mesh->triangle_count; i++)
        put_triangle(places, mesh->triangles[i], words + 2 * i);
    uint32_t *first = aob_first_equals(words, 2, mesh->triangle_count);
    size_t count = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++)
        count += first[i] != i;
    free(places);
    free(words);
    free(first);
    return count;
}
