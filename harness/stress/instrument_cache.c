#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "chance.h"
#include "instruments.h"
#include "profile/stack.h"
#include "profile/tags.h"

/* Kinds of accesses: by lot, round and round, rows of an image with their neighbours, and near the last one. */
enum { LINES = 96, ACCESSES = 4000, KINDS = 4, MOST_LINES = 128 };

static void make_accesses(int kind, uint32_t *numbers)
{
    static const char *const names[KINDS] = {"by lot", "rounds", "rows", "near"};
    struct aob_chance chance = aob_chance_of(names[kind]);
    uint32_t last = 0;
    for (uint32_t i = 0; i < ACCESSES; i++) {
        uint32_t lot = (uint32_t)aob_chance_below(&chance, LINES),
                 near = (uint32_t)aob_chance_below(&chance, 5);
        const uint32_t next[KINDS] = {lot, i % 37, (i / 7 + i % 3 * 16) % LINES,
                                      (last + near + LINES - 2) % LINES};
        numbers[i] = last = next[kind];
    }
}

/* Misses of a cache; `missed` may be NULL. */
static size_t misses_of(const struct aob_tags_desc *desc, const uint32_t *numbers, uint32_t *missed)
{
    struct aob_tags *tags = aob_tags_create(desc);
    size_t misses = aob_tags_access(tags, numbers, ACCESSES, missed);
    aob_tags_destroy(tags);
    return misses;
}

static struct aob_tags_desc associative(uint32_t ways)
{
    return (struct aob_tags_desc){.sets = 1, .ways = ways, .numbers = LINES};
}

static double distance(size_t a, size_t b)
{
    return a > b ? (double)(a - b) : (double)(b - a);
}

/* A cache that holds more holds all that the smaller one does (Mattson et al. 1970). */
void aob_ask_cache_inclusion(struct aob_trial *trial)
{
    uint32_t numbers[ACCESSES];
    for (int kind = 0; kind < KINDS; kind++) {
        size_t before = ACCESSES;
        make_accesses(kind, numbers);
        for (uint32_t ways = 1; ways <= MOST_LINES; ways++) {
            const struct aob_tags_desc desc = associative(ways);
            size_t misses = misses_of(&desc, numbers, NULL);
            aob_trial_take(trial, misses > before ? (double)(misses - before) : 0, NULL,
                           "%u lines miss %zu times, one less %zu, kind %d", ways, misses, before, kind);
            before = misses;
        }
    }
}

void aob_ask_cache_cold(struct aob_trial *trial)
{
    uint32_t numbers[ACCESSES];
    const struct aob_tags_desc desc = associative(MOST_LINES);
    for (int kind = 0; kind < KINDS; kind++) {
        bool seen[LINES] = {false};
        size_t distinct = 0;
        make_accesses(kind, numbers);
        for (size_t i = 0; i < ACCESSES; i++) {
            distinct += !seen[numbers[i]];
            seen[numbers[i]] = true;
        }
        size_t misses = misses_of(&desc, numbers, NULL);
        aob_trial_take(trial, distance(misses, distinct), NULL, "%zu misses of %zu lines, kind %d", misses,
                       distinct, kind);
    }
}

void aob_ask_cache_one_line(struct aob_trial *trial)
{
    uint32_t numbers[ACCESSES];
    const struct aob_tags_desc desc = associative(1);
    for (int kind = 0; kind < KINDS; kind++) {
        size_t changes = 1;
        make_accesses(kind, numbers);
        for (size_t i = 1; i < ACCESSES; i++)
            changes += numbers[i] != numbers[i - 1];
        size_t misses = misses_of(&desc, numbers, NULL);
        aob_trial_take(trial, distance(misses, changes), NULL,
                       "%zu misses, the line changes %zu times, kind %d", misses, changes, kind);
    }
}

/* Least recently used, as one would write it down: a list that what is used moves to the front of. */
static bool use_plainly(uint32_t *list, uint32_t *held, uint32_t ways, uint32_t number)
{
    uint32_t at = 0;
    while (at < *held && list[at] != number)
        at++;
    bool hit = at < *held;
    if (!hit && *held < ways)
        at = (*held)++;
    else if (!hit)
        at = ways - 1;
    memmove(list + 1, list, at * sizeof *list);
    list[0] = number;
    return hit;
}

/* Which accesses miss, one by one, in caches of several sets: so misses and hits are the accesses as well. */
void aob_ask_cache_plain(struct aob_trial *trial)
{
    static const struct {
        uint32_t sets, ways;
    } shapes[] = {{1, 4}, {1, 64}, {3, 2}, {8, 4}, {16, 16}, {5, 1}};
    uint32_t numbers[ACCESSES], missed[ACCESSES];
    for (size_t s = 0; s < AOB_COUNT(shapes); s++)
        for (int kind = 0; kind < KINDS; kind++) {
            const struct aob_tags_desc desc = {
                .sets = shapes[s].sets, .ways = shapes[s].ways, .numbers = LINES};
            uint32_t lists[16][MOST_LINES], held[16] = {0};
            size_t wrong = 0, at = 0;
            make_accesses(kind, numbers);
            size_t misses = misses_of(&desc, numbers, missed);
            for (uint32_t i = 0; i < ACCESSES; i++) {
                uint32_t set = numbers[i] % desc.sets;
                bool miss = at < misses && missed[at] == i;
                at += miss;
                wrong += miss == use_plainly(lists[set], &held[set], desc.ways, numbers[i]);
            }
            aob_trial_take(trial, (double)wrong + distance(at, misses), NULL, "%u sets of %u ways, kind %d",
                           desc.sets, desc.ways, kind);
        }
}

/* Each way of searching that this processor has. */
void aob_ask_cache_paths(struct aob_trial *trial)
{
    static const uint32_t ways[] = {1, 2, 4, 7, 8, 12, 16};
    uint32_t numbers[ACCESSES];
    for (size_t w = 0; w < AOB_COUNT(ways); w++)
        for (int index = 0; index < AOB_INDEX_COUNT; index++)
            for (int path = 0; path < AOB_TAGS_PATH_COUNT; path++) {
                struct aob_tags_desc desc = {.sets = 4,
                                             .ways = ways[w],
                                             .index = (enum aob_index)index,
                                             .numbers = LINES,
                                             .path = (enum aob_tags_path)path};
                make_accesses((int)(w % KINDS), numbers);
                if (!aob_tags_can(&desc))
                    continue;
                size_t misses = misses_of(&desc, numbers, NULL);
                desc.path = AOB_TAGS_LIST;
                aob_trial_take(trial, distance(misses, misses_of(&desc, numbers, NULL)), NULL,
                               "path %d, %u ways, %s", path, ways[w], aob_index_name(desc.index));
            }
}

void aob_ask_cache_stack(struct aob_trial *trial)
{
    static const uint32_t sizes[] = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89};
    uint32_t numbers[ACCESSES];
    for (int kind = 0; kind < KINDS; kind++) {
        struct aob_stack *stack = aob_stack_create(
            &(struct aob_stack_desc){.numbers = LINES, .sizes = sizes, .size_count = AOB_COUNT(sizes)});
        make_accesses(kind, numbers);
        aob_stack_access(stack, numbers, ACCESSES);
        for (size_t s = 0; s < AOB_COUNT(sizes); s++) {
            const struct aob_tags_desc desc = associative(sizes[s]);
            aob_trial_take(trial, distance(aob_stack_misses(stack, s), misses_of(&desc, numbers, NULL)), NULL,
                           "%u lines, kind %d", sizes[s], kind);
        }
        aob_stack_destroy(stack);
    }
}
