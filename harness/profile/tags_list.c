/* A ring of ways a set, in order of their last use, and a table that says where each line is: a step costs the same
 * however many ways there are. A line that comes new takes the oldest way, which then is the latest by turning the ring. */
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
    uint32_t *place;  /* of each line its way + 1; 0: it is not here */
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

/* Fresh zeros cost memory only where lines are met. */
void aob_tags_list_clear(struct aob_tags_list *list)
{
    free(list->place);
    list->place = AOB_NEW_ARRAY(uint32_t, list->lines);
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

static void make_latest(struct aob_tags_list *list, uint32_t *latest, uint32_t w)
{
    struct way *ring = list->ring, *way = &ring[w];
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

static uint32_t replace_oldest(struct aob_tags_list *list, uint32_t *latest, uint32_t line)
{
    uint32_t w = *latest = list->ring[*latest].newer;
    struct way *way = &list->ring[w];
    if (way->line != AOB_TAGS_EMPTY)
        list->place[way->line] = 0;
    way->line = line;
    way->sectors = 0;
    list->place[line] = w + 1;
    return w;
}

size_t aob_tags_list_access(struct aob_tags_list *list, const struct aob_tags_accesses *accesses)
{
    size_t misses = 0;
    for (size_t i = 0; i < accesses->count; i++) {
        size_t soon = i + AHEAD < accesses->count ? i + AHEAD : i;
        __builtin_prefetch(&list->place[accesses->lines[soon] >> list->sector_shift]);
        uint32_t line = accesses->lines[i] >> list->sector_shift, *latest = &list->latest[accesses->sets[i]];
        uint32_t sector = 1u << (accesses->lines[i] - (line << list->sector_shift)), w = list->place[line];
        if (w)
            make_latest(list, latest, --w);
        else
            w = replace_oldest(list, latest, line);
        accesses->missed[misses] = accesses->first + (uint32_t)i;
        misses += !(list->ring[w].sectors & sector);
        list->ring[w].sectors |= sector;
    }
    return misses;
}
