/* Flat meshes, sealed here: the seal would keep all others away from the reader. */
#include "scene/mesh.h"
#include <stdlib.h>
#include <string.h>
#include "base/sealed.h"
#include "fuzz.h"

static bool same(const void *a, const void *b, size_t count, size_t size)
{
    return count == 0 || !a == !b || memcmp(a, b, count * size) == 0;
}

static void check_same(const struct aob_mesh *a, const struct aob_mesh *b)
{
    fuzz_require(a->vertex_count == b->vertex_count && a->triangle_count == b->triangle_count &&
                     a->material_count == b->material_count && a->source_bytes == b->source_bytes &&
                     a->note_count == b->note_count && !a->normals == !b->normals,
                 "a mesh that is read again has its counts");
    fuzz_require(same(a->positions, b->positions, a->vertex_count, sizeof *a->positions) &&
                     same(a->normals, b->normals, a->normals ? a->vertex_count : 0, sizeof *a->normals) &&
                     same(a->triangles, b->triangles, a->triangle_count, sizeof *a->triangles) &&
                     same(a->materials, b->materials, a->material_count, sizeof *a->materials) &&
                     same(a->material_of, b->material_of, a->materials ? a->triangle_count : 0,
                          sizeof *a->material_of),
                 "a mesh that is read again has its content");
    for (size_t i = 0; i < a->note_count; i++)
        fuzz_require(strcmp(a->notes[i].text, b->notes[i].text) == 0,
                     "a mesh that is read again has its notes");
}

/* What others do with a mesh. */
static void use(const struct aob_mesh *mesh, const char *path)
{
    struct aob_error warnings[AOB_MESH_WARNINGS] = {{{0}}};
    struct aob_vec3 low, high;
    for (size_t i = 0; i < mesh->note_count; i++)
        fuzz_require(memchr(mesh->notes[i].text, 0, sizeof mesh->notes[i].text), "a note has an end");
    for (size_t i = aob_mesh_suspect(mesh, path, warnings); i-- > 0;)
        fuzz_require_line(&warnings[i], path);
    aob_mesh_bounds(mesh, &low, &high);
    fuzz_require(low.x <= high.x && low.y <= high.y && low.z <= high.z, "a mesh has bounds");
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        for (int k = 0; k < 3; k++)
            fuzz_require(mesh->triangles[i][k] < mesh->vertex_count, "a triangle has its vertices");
        fuzz_require(aob_material_valid(aob_mesh_material(mesh, (uint32_t)i)), "a triangle has its material");
    }
}

static void check_again(const struct aob_mesh *mesh)
{
    struct aob_mesh again;
    struct aob_error error = {{0}};
    char *path = fuzz_path("again");
    fuzz_require(aob_mesh_save(mesh, path, &error), "a mesh can be written");
    fuzz_require(aob_mesh_restore(&again, path, &error), "a mesh can be read again");
    check_same(mesh, &again);
    aob_mesh_finish(&again);
    free(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct aob_mesh mesh;
    struct aob_error error = {{0}};
    char *path = fuzz_sealed_file("input", bytes, size);
    if (fuzz_answer(aob_mesh_restore(&mesh, path, &error), &error, path)) {
        use(&mesh, path);
        check_again(&mesh);
        aob_mesh_finish(&mesh);
    }
    free(path);
    return 0;
}
