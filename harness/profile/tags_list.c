/* A ring of ways a set, in order of their last use, and a table that says in which way each line was last: a step costs the
 * same however many ways there are. Whether a line is still there, its way tells. A line that comes new takes the oldest
 * way, which then is the latest by turning the ring. */
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "tags_kernel.h"

enum {
    AHEAD = 16
}; /* accesses that the table is fetched before its use: those of many units do not fit in a cache */

struct way {
    uint32_t newer, older;  /* of the ring; the latest one's newer is the oldest */
    uint32_t line, sectors; /* a bit for each that is here */
};
struct aob_tags_list {
    size_t sets, ways, lines;
    uint32_t sector_shift;
    struct way *ring; /* sets x ways */
    uint32_t *latest; /* of each set */
    uint32_t *place;  /* of each line the way that it had; if that holds another line, it is not here */
};

static size_t count_lines(const struct aob_tags_desc *desc)
{
    return desc->numbers / (desc->sectors ? desc->sectors : 1) + 1;
}

struct aob_tags_list *aob_tags_list_create(const struct aob_tags_desc *desc)
{
    struct aob_tags_list *list = AOB_NEW(struct aob_tags_list);
    list->sets = desc->sets;
    list->ways = desc->ways;
    list->lines = count_lines(desc);
    list->sector_shift = (uint32_t)__builtin_ctz(desc->sectors ? desc->sectors : 1);
    list->ring = AOB_NEW_ARRAY(struct way, list->sets * list->ways);
    list->latest = AOB_NEW_ARRAY(uint32_t, list->sets);
    list->place = AOB_NEW_ARRAY(uint32_t, list->lines);
    return list;
}

void aob_tags_list_destroy(struct aob_tags_list *list)
{
    if (!list)
        return;
    free(list->ring);
    free(list->latest);
    free(list->place);
    free(list);
}

void aob_tags_list_clear(struct aob_tags_list *list)
{
    for (size_t s = 0; s < list->sets; s++) {
        uint32_t first = (uint32_t)(s * list->ways), last = first + (uint32_t)list->ways - 1;
        for (uint32_t w = first; w <= last; w++)
            list->ring[w] =
                (struct way){w == first ? last : w - 1, w == last ? first : w + 1, AOB_TAGS_EMPTY, 0};
        list->latest[s] = first;
    }
}

double aob_tags_list_bytes(const struct aob_tags_desc *desc)
{
    return (double)desc->sets * desc->ways * sizeof(struct way) + (double)desc->sets * sizeof(uint32_t) +
           (double)count_lines(desc) * sizeof(uint32_t);
}

static inline void make_latest(struct way *ring, uint32_t *latest, uint32_t w)
{
    struct way *way = &ring[w];
    uint32_t first = *latest, last = ring[first].newer;
    *latest = w;
    if (w == first || w == last)
        return;
    ring[way->newer].older = way->older;
    ring[way->older].newer = way->newer;
    way->newer = last;
    way->older = first;
    ring[last].older = ring[first].newer = w;
}

static inline uint32_t replace_oldest(struct way *ring, uint32_t *latest, uint32_t line)
{
    uint32_t w = *latest = ring[*latest].newer;
    ring[w].line = line;
    ring[w].sectors = 0;
    return w;
}

size_t aob_tags_list_access(struct aob_tags_list *list, const struct aob_tags_accesses *accesses)
{
    struct way *ring = list->ring;
    uint32_t *place = list->place, *missed = accesses->missed, shift = list->sector_shift;
    const uint32_t *numbers = accesses->lines;
    size_t misses = 0, count = accesses->count;
    for (size_t i = 0; i < count; i++) {
        __builtin_prefetch(&place[numbers[i + AHEAD < count ? i + AHEAD : i] >> shift]);
        uint32_t line = numbers[i] >> shift, *latest = &list->latest[accesses->sets[i]], w = place[line];
        uint32_t sector = 1u << (numbers[i] - (line << shift));
        if (ring[w].line == line)
            make_latest(ring, latest, w);
        else
            place[line] = w = replace_oldest(ring, latest, line);
        missed[misses] = accesses->first + (uint32_t)i;
        misses += !(ring[w].sectors & sector);
        ring[w].sectors |= sector;
    }
    return misses;
}
