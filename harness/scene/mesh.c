#include "mesh.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/sealed.h"
#include "base/text.h"

/* A flat file holds this header, positions, normals if any, triangles, and materials and their indices if any.
 * Only this machine reads it, so its own number formats serve. */
struct flat_header {
    char magic[8];
    uint64_t vertex_count, triangle_count, has_normals, source_bytes, material_count, note_count;
    struct aob_mesh_note notes[AOB_MESH_NOTES];
};
const char aob_mesh_flat_version[8] = "aobmsh5";

void aob_mesh_finish(struct aob_mesh *mesh)
{
    free(mesh->positions);
    free(mesh->normals);
    free(mesh->triangles);
    free(mesh->materials);
    free(mesh->material_of);
    *mesh = (struct aob_mesh){0};
}

void aob_mesh_bounds(const struct aob_mesh *mesh, struct aob_vec3 *low, struct aob_vec3 *high)
{
    *low = *high = mesh->vertex_count ? mesh->positions[0] : aob_vec(0, 0, 0);
    for (size_t i = 1; i < mesh->vertex_count; i++) {
        struct aob_vec3 p = mesh->positions[i];
        *low = aob_vec(fmin(low->x, p.x), fmin(low->y, p.y), fmin(low->z, p.z));
        *high = aob_vec(fmax(high->x, p.x), fmax(high->y, p.y), fmax(high->z, p.z));
    }
}

static bool finite_vec(struct aob_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool check_materials(const struct aob_mesh *mesh, const char *name, struct aob_error *error)
{
    for (size_t i = 0; i < mesh->material_count; i++)
        if (!aob_material_valid(&mesh->materials[i]))
            return aob_fail(error, "%s: material %zu has a number outside 0 .. 1: the file is damaged", name,
                            i);
    for (size_t i = 0; mesh->material_of && i < mesh->triangle_count; i++)
        if (mesh->material_of[i] >= mesh->material_count)
            return aob_fail(error, "%s: triangle %zu is of material %u of %zu: the file is damaged", name, i,
                            mesh->material_of[i], mesh->material_count);
    return true;
}

bool aob_mesh_check(const struct aob_mesh *mesh, const char *name, struct aob_error *error)
{
    if (!mesh->triangle_count)
        return aob_fail(error, "%s: it has no triangles: there is nothing to render", name);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        if (!finite_vec(mesh->positions[i]) || (mesh->normals && !finite_vec(mesh->normals[i])))
            return aob_fail(
                error, "%s: vertex %zu is not finite: the file is damaged or was exported wrongly", name, i);
    for (size_t i = 0; i < mesh->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            if (mesh->triangles[i][k] >= mesh->vertex_count)
                return aob_fail(error, "%s: triangle %zu names vertex %u of %zu: the file is damaged", name,
                                i, mesh->triangles[i][k], mesh->vertex_count);
    return check_materials(mesh, name, error);
}

void aob_mesh_digest(const struct aob_mesh *mesh, char key[AOB_KEY_SIZE])
{
    char parts[6 * (AOB_KEY_SIZE - 1) + 1];
    char *part = parts;
    aob_hash_bytes(mesh->positions, mesh->vertex_count * sizeof *mesh->positions, part);
    part += AOB_KEY_SIZE - 1;
    aob_hash_bytes(mesh->triangles, mesh->triangle_count * sizeof *mesh->triangles, part);
    part += AOB_KEY_SIZE - 1;
    aob_hash_bytes(mesh->normals, mesh->normals ? mesh->vertex_count * sizeof *mesh->normals : 0, part);
    if (mesh->materials) {
        part += AOB_KEY_SIZE - 1;
        aob_hash_bytes(mesh->materials, mesh->material_count * sizeof *mesh->materials, part);
        part += AOB_KEY_SIZE - 1;
        aob_hash_bytes(mesh->material_of, mesh->triangle_count * sizeof *mesh->material_of, part);
    }
    if (mesh->moving_count) {
        const double motion[5] = {(double)mesh->moving_first, (double)mesh->moving_count, mesh->step.x,
                                  mesh->step.y, mesh->step.z};
        part += AOB_KEY_SIZE - 1;
        aob_hash_bytes(motion, sizeof motion, part);
    }
    aob_hash_text(parts, key);
}

bool aob_mesh_save(const struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    struct flat_header header = {.vertex_count = mesh->vertex_count,
                                 .triangle_count = mesh->triangle_count,
                                 .has_normals = mesh->normals != NULL,
                                 .source_bytes = mesh->source_bytes,
                                 .material_count = mesh->material_count,
                                 .note_count = mesh->note_count};
    memcpy(header.notes, mesh->notes, sizeof header.notes);
    memcpy(header.magic, aob_mesh_flat_version, sizeof header.magic);
    const struct aob_piece pieces[] = {
        {&header, sizeof header},
        {mesh->positions, mesh->vertex_count * sizeof *mesh->positions},
        {mesh->normals, mesh->normals ? mesh->vertex_count * sizeof *mesh->normals : 0},
        {mesh->triangles, mesh->triangle_count * sizeof *mesh->triangles},
        {mesh->materials, mesh->material_count * sizeof *mesh->materials},
        {mesh->material_of, mesh->materials ? mesh->triangle_count * sizeof *mesh->material_of : 0}};
    return aob_sealed_write(path, pieces, AOB_COUNT(pieces), error);
}

static bool notes_end(const struct flat_header *header)
{
    bool ok = header->note_count <= AOB_MESH_NOTES;
    for (size_t i = 0; ok && i < header->note_count; i++)
        ok = memchr(header->notes[i].text, '\0', sizeof header->notes[i].text) != NULL;
    return ok;
}

static bool header_fits(const struct flat_header *header, size_t size)
{
    if (memcmp(header->magic, aob_mesh_flat_version, sizeof header->magic) || header->has_normals > 1 ||
        !notes_end(header))
        return false;
    if (header->vertex_count > size || header->triangle_count > size ||
        header->material_count > size) /* so that the sum below cannot wrap */
        return false;
    uint64_t per_triangle = sizeof(uint32_t) * (header->material_count ? 4 : 3);
    uint64_t per_vertex = sizeof(struct aob_vec3) * (1 + header->has_normals);
    return size == sizeof *header + header->vertex_count * per_vertex +
                       header->triangle_count * per_triangle +
                       header->material_count * sizeof(struct aob_material);
}

/* Reads the next `count` elements of the file into memory of their own. */
static void *take(const char **at, size_t count, size_t size)
{
    void *part = aob_alloc(count, size);
    if (count)
        memcpy(part, *at, count * size);
    *at += count * size;
    return part;
}

bool aob_mesh_restore(struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    size_t size = 0;
    char *bytes = aob_sealed_read(path, &size, error);
    *mesh = (struct aob_mesh){0};
    if (!bytes)
        return false;
    struct flat_header header = {.magic = ""};
    memcpy(&header, bytes, size < sizeof header ? size : sizeof header);
    bool ok = size >= sizeof header && header_fits(&header, size);
    if (ok) {
        const char *at = bytes + sizeof header;
        mesh->vertex_count = mesh->vertex_capacity = header.vertex_count;
        mesh->triangle_count = mesh->triangle_capacity = header.triangle_count;
        mesh->source_bytes = header.source_bytes;
        mesh->note_count = header.note_count;
        memcpy(mesh->notes, header.notes, sizeof mesh->notes);
        mesh->positions = take(&at, mesh->vertex_count, sizeof *mesh->positions);
        if (header.has_normals)
            mesh->normals = take(&at, mesh->vertex_count, sizeof *mesh->normals);
        mesh->triangles = take(&at, mesh->triangle_count, sizeof *mesh->triangles);
        if (header.material_count) {
            mesh->material_count = mesh->material_capacity = header.material_count;
            mesh->materials = take(&at, mesh->material_count, sizeof *mesh->materials);
            mesh->material_of_capacity = mesh->triangle_count;
            mesh->material_of = take(&at, mesh->triangle_count, sizeof *mesh->material_of);
        }
    }
    free(bytes);
    if (ok && aob_mesh_check(mesh, path, error))
        return true;
    aob_mesh_finish(mesh);
    return ok ? false : aob_fail(error, "%s: it is not a flat mesh of this version", path);
}

void aob_mesh_note(struct aob_mesh *mesh, const char *format, ...)
{
    struct aob_mesh_note note = {""};
    va_list args;
    va_start(args, format);
    aob_line_print_list(note.text, sizeof note.text, format, args);
    va_end(args);
    for (size_t i = 0; i < mesh->note_count; i++)
        if (strcmp(mesh->notes[i].text, note.text) == 0)
            return;
    if (mesh->note_count < AOB_MESH_NOTES)
        mesh->notes[mesh->note_count++] = note;
}

size_t aob_mesh_suspect(const struct aob_mesh *mesh, const char *name,
                        struct aob_error warnings[AOB_MESH_WARNINGS])
{
    size_t count = 0;
    struct aob_vec3 low, high;
    for (size_t i = 0; i < mesh->note_count; i++)
        aob_fail(&warnings[count++], "%s: %s", name, mesh->notes[i].text);
    aob_mesh_bounds(mesh, &low, &high);
    struct aob_vec3 box = aob_vec_sub(high, low);
    double extent = fmax(box.x, fmax(box.y, box.z)), away = aob_vec_length(aob_vec_add(low, high)) / 2;
    float far = (float)fmax(fmax(fabs(low.x + high.x), fabs(low.y + high.y)), fabs(low.z + high.z)) / 2;
    if (mesh->source_bytes > 512 + 400 * mesh->triangle_count)
        aob_fail(&warnings[count++],
                 "%s: the file has %zu bytes but only %zu triangles: much of the file was not understood "
                 "(strips?)",
                 name, mesh->source_bytes, mesh->triangle_count);
    if (away >= 5e3 * extent)
        aob_fail(&warnings[count++],
                 "%s: it lies %g from the origin and is %g large: its vertices are rounded to steps of %.2g; "
                 "move it to "
                 "the origin before exporting",
                 name, away, extent, (double)(nextafterf(far, INFINITY) - far));
    return count;
}
