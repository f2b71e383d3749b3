#include "mesh_place.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

/* The finishing step of MurmurHash3, which lets every bit of x change every bit of the result. */
static uint64_t mixed(uint64_t x)
{
    x = (x ^ x >> 33) * 0xff51afd7ed558ccdu;
    x = (x ^ x >> 33) * 0xc4ceb9fe1a85ec53u;
    return x ^ x >> 33;
}

static uint64_t hash_record(const uint64_t *record, size_t words)
{
    uint64_t hash = 0;
    for (size_t w = 0; w < words; w++)
        hash = mixed(hash + 0x9e3779b97f4a7c15u + record[w]);
    return hash;
}

/* An open table that is at most half full; a slot holds a record's number plus one. */
uint32_t *aob_first_equals(const uint64_t *records, size_t words, size_t count)
{
    uint32_t *first = AOB_NEW_ARRAY(uint32_t, count + 1);
    size_t room = 16;
    while (room < 2 * count)
        room *= 2;
    uint32_t *slots = AOB_NEW_ARRAY(uint32_t, room);
    for (size_t i = 0; i < count; i++) {
        const uint64_t *record = records + i * words;
        size_t at = hash_record(record, words) & (room - 1);
        while (slots[at] && memcmp(records + (slots[at] - 1) * words, record, words * sizeof *record) != 0)
            at = (at + 1) & (room - 1);
        if (!slots[at])
            slots[at] = (uint32_t)i + 1;
        first[i] = slots[at] - 1;
    }
    free(slots);
    return first;
}

/* Adding 0 makes 0 of -0. */
static void put_vec(struct aob_vec3 v, uint64_t words[3])
{
    const double plain[3] = {v.x + 0.0, v.y + 0.0, v.z + 0.0};
    memcpy(words, plain, sizeof plain);
}

static uint32_t *find_equals(const struct aob_mesh *mesh, const struct aob_vec3 *normals)
{
    size_t words = normals ? 6 : 3;
    uint64_t *records = AOB_NEW_ARRAY(uint64_t, words * mesh->vertex_count + 1);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        put_vec(mesh->positions[i], records + i * words);
        if (normals)
            put_vec(normals[i], records + i * words + 3);
    }
    uint32_t *first = aob_first_equals(records, words, mesh->vertex_count);
    free(records);
    return first;
}

uint32_t *aob_mesh_places(const struct aob_mesh *mesh)
{
    return find_equals(mesh, NULL);
}

uint32_t *aob_mesh_equals(const struct aob_mesh *mesh)
{
    return find_equals(mesh, mesh->normals);
}
