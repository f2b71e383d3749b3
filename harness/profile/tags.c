#include "tags.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "tags_kernel.h"

enum { BLOCK = 256, MAX_REGISTER_WAYS = 16 };

struct aob_tags {
    struct aob_tags_desc desc;
    struct aob_tags_way way; /* no kernel: `list` */
    uint32_t *tags;
    struct aob_tags_list *list;
    uint32_t sector_shift;
};

/* The scan moves what it passes one place back, so that it is done when it finds the line. */
static size_t access_portable(uint32_t *tags, uint32_t ways, const struct aob_tags_accesses *accesses)
{
    size_t misses = 0;
    for (size_t i = 0; i < accesses->count; i++) {
        uint32_t *set = tags + (size_t)accesses->sets[i] * ways, line = accesses->lines[i], moved = line;
        bool hit = false;
        for (uint32_t w = 0; !hit && w < ways; w++) {
            uint32_t held = set[w];
            set[w] = moved;
            moved = held;
            hit = held == line;
        }
        accesses->missed[misses] = accesses->first + (uint32_t)i;
        misses += !hit;
    }
    return misses;
}

static uint32_t sectors_of(const struct aob_tags_desc *desc)
{
    return desc->sectors ? desc->sectors : 1;
}

static struct aob_tags_way find_way(const struct aob_tags_desc *desc, enum aob_tags_path path)
{
    if (sectors_of(desc) > 1 || desc->ways > MAX_REGISTER_WAYS)
        return (struct aob_tags_way){0};
    if (path == AOB_TAGS_PORTABLE)
        return (struct aob_tags_way){access_portable, desc->ways};
    return aob_tags_simd(path, desc->ways);
}

bool aob_tags_can(const struct aob_tags_desc *desc)
{
    return desc->path == AOB_TAGS_BEST || desc->path == AOB_TAGS_LIST || find_way(desc, desc->path).kernel;
}

/* By speed. A set of up to eight ways takes half of what AVX-512 loads, and so half of the host's cache. */
static struct aob_tags_desc choose(struct aob_tags_desc desc)
{
    static const enum aob_tags_path few[] = {AOB_TAGS_SSE41, AOB_TAGS_AVX2, AOB_TAGS_PORTABLE, AOB_TAGS_LIST};
    static const enum aob_tags_path many[] = {AOB_TAGS_AVX512, AOB_TAGS_AVX2, AOB_TAGS_PORTABLE,
                                              AOB_TAGS_LIST};
    const enum aob_tags_path *by_speed = desc.ways <= 8 ? few : many;
    for (size_t i = 0; desc.path == AOB_TAGS_BEST; i++) {
        struct aob_tags_desc tried = desc;
        tried.path = by_speed[i];
        if (aob_tags_can(&tried))
            desc = tried;
    }
    return desc;
}

double aob_tags_bytes(const struct aob_tags_desc *desc)
{
    struct aob_tags_desc chosen = choose(*desc);
    return chosen.path == AOB_TAGS_LIST
               ? aob_tags_list_bytes(&chosen)
               : (double)chosen.sets * find_way(&chosen, chosen.path).stride * sizeof(uint32_t);
}

struct aob_tags *aob_tags_create(const struct aob_tags_desc *desc)
{
    struct aob_tags *tags = AOB_NEW(struct aob_tags);
    tags->desc = choose(*desc);
    tags->sector_shift = (uint32_t)__builtin_ctz(sectors_of(desc));
    tags->way = find_way(&tags->desc, tags->desc.path);
    if (tags->way.kernel)
        tags->tags = AOB_NEW_ARRAY(uint32_t, (size_t)desc->sets * tags->way.stride);
    else
        tags->list = aob_tags_list_create(&tags->desc);
    aob_tags_clear(tags);
    return tags;
}

void aob_tags_destroy(struct aob_tags *tags)
{
    if (!tags)
        return;
    free(tags->tags);
    aob_tags_list_destroy(tags->list);
    free(tags);
}

void aob_tags_clear(struct aob_tags *tags)
{
    if (tags->list)
        aob_tags_list_clear(tags->list);
    else
        memset(tags->tags, 0xff, (size_t)tags->desc.sets * tags->way.stride * sizeof *tags->tags);
}

/* The remainder without a division: Lemire, Kaser, Kurz: Faster Remainder by Direct Computation (2019). Exact for all
 * 32-bit numbers and more than one set. */
static void modulo_sets(uint32_t sets, const uint32_t *lines, size_t count, uint32_t *out)
{
    uint64_t inverse = UINT64_MAX / sets + 1;
    for (size_t i = 0; i < count; i++)
        out[i] = (uint32_t)((unsigned __int128)(inverse * lines[i]) * sets >> 64);
}

static void low_sets(uint32_t sets, const uint32_t *lines, size_t count, uint32_t *out)
{
    for (size_t i = 0; i < count; i++)
        out[i] = lines[i] & (sets - 1);
}

static void xor_sets(uint32_t sets, const uint32_t *lines, size_t count, uint32_t *out)
{
    int bits = __builtin_ctz(sets);
    for (size_t i = 0; i < count; i++) {
        uint64_t line = lines[i];
        out[i] = (uint32_t)(line ^ line >> bits ^ line >> 2 * bits) & (sets - 1);
    }
}

void aob_index_sets(const struct aob_tags_desc *desc, const uint32_t *lines, size_t count, uint32_t *sets)
{
    if (desc->index == AOB_INDEX_XOR)
        xor_sets(desc->sets, lines, count, sets);
    else if ((desc->sets & (desc->sets - 1)) == 0)
        low_sets(desc->sets, lines, count, sets);
    else
        modulo_sets(desc->sets, lines, count, sets);
}

static size_t access_block(struct aob_tags *tags, const struct aob_tags_accesses *accesses)
{
    return tags->list ? aob_tags_list_access(tags->list, accesses)
                      : tags->way.kernel(tags->tags, tags->desc.ways, accesses);
}

/* Sets are found block by block, so that a kernel does nothing but look for its line. */
static void find_sets(const struct aob_tags *tags, const uint32_t *numbers, size_t count, uint32_t *sets)
{
    uint32_t lines[BLOCK];
    for (size_t i = 0; i < count; i++)
        lines[i] = numbers[i] >> tags->sector_shift;
    aob_index_sets(&tags->desc, lines, count, sets);
}

size_t aob_tags_access_in(struct aob_tags *tags, const uint32_t *numbers, const uint32_t *sets, size_t count,
                          uint32_t *missed)
{
    size_t misses = 0;
    uint32_t nobody[BLOCK], found[BLOCK];
    for (size_t first = 0; first < count; first += BLOCK) {
        struct aob_tags_accesses block = {numbers + first, sets ? sets + first : found,
                                          count - first < BLOCK ? count - first : BLOCK, (uint32_t)first,
                                          missed ? missed + misses : nobody};
        if (!sets)
            find_sets(tags, block.lines, block.count, found);
        misses += access_block(tags, &block);
    }
    return misses;
}

size_t aob_tags_access(struct aob_tags *tags, const uint32_t *numbers, size_t count, uint32_t *missed)
{
    return aob_tags_access_in(tags, numbers, NULL, count, missed);
}

static const char *const index_names[AOB_INDEX_COUNT] = {"modulo", "xor"};

const char *aob_index_name(enum aob_index index)
{
    return index_names[index];
}

bool aob_index_find(const char *name, enum aob_index *index)
{
    for (int i = 0; i < AOB_INDEX_COUNT; i++)
        if (strcmp(name, index_names[i]) == 0) {
            *index = (enum aob_index)i;
            return true;
        }
    return false;
}
