#include "level.h"
#include <stdlib.h>
#include "base/memory.h"
#include "reuse.h"
#include "stack.h"
#include "tags.h"

struct aob_level {
    struct aob_tags *tags;
    uint64_t *held; /* a bit for each number that was here */
    struct aob_stack *stack;
    struct aob_reuse *reuse;
    uint32_t sizes[AOB_STACK_MAX_SIZE]; /* of the stack */
    size_t size_count, own;             /* own: the place of the level's size */
    uint32_t lines;                     /* of the level */
};

static uint32_t sectors_of(const struct aob_level_desc *desc)
{
    return desc->level->line / desc->level->sector;
}

static struct aob_tags_desc tags_desc(const struct aob_level_desc *desc)
{
    return (struct aob_tags_desc){.sets = desc->level->sets,
                                  .ways = desc->level->ways,
                                  .sectors = sectors_of(desc),
                                  .index = desc->level->index,
                                  .numbers = desc->numbers};
}

static void add_size(struct aob_level *level, uint64_t lines)
{
    level->sizes[level->size_count++] = (uint32_t)lines;
}

/* Powers of two until all lines fit, and the level's own size in its place among them. */
static void list_sizes(struct aob_level *level, const struct aob_level_desc *desc)
{
    uint64_t all = desc->own_size ? 0 : (uint64_t)desc->numbers / sectors_of(desc) + 1;
    for (uint64_t power = 1; power / 2 < all && power < level->lines; power *= 2)
        add_size(level, power);
    level->own = level->size_count;
    add_size(level, level->lines);
    for (uint64_t power = 1; power / 2 < all; power *= 2)
        if (power > level->lines)
            add_size(level, power);
}

struct aob_level *aob_level_create(const struct aob_level_desc *desc)
{
    struct aob_level *level = AOB_NEW(struct aob_level);
    struct aob_tags_desc tags = tags_desc(desc);
    level->lines = desc->level->sets * desc->level->ways;
    level->tags = aob_tags_create(&tags);
    level->held = AOB_NEW_ARRAY(uint64_t, desc->numbers / 64 + 1);
    if (desc->curve == AOB_CURVE_EVERY && !desc->own_size) {
        level->reuse = aob_reuse_create(desc->numbers, tags.sectors);
    } else if (desc->curve != AOB_CURVE_NONE) {
        list_sizes(level, desc);
        level->stack = aob_stack_create(
            &(struct aob_stack_desc){desc->numbers, tags.sectors, level->sizes, level->size_count});
    }
    return level;
}

void aob_level_destroy(struct aob_level *level)
{
    if (!level)
        return;
    aob_tags_destroy(level->tags);
    free(level->held);
    aob_stack_destroy(level->stack);
    aob_reuse_destroy(level->reuse);
    free(level);
}

size_t aob_level_access(struct aob_level *level, const uint32_t *numbers, size_t count, uint32_t *missed,
                        struct aob_misses *misses)
{
    size_t missing = aob_tags_access(level->tags, numbers, count, missed);
    for (size_t i = 0; i < missing; i++) {
        uint32_t number = numbers[missed[i]];
        uint64_t *word = &level->held[number / 64], bit = (uint64_t)1 << number % 64;
        misses->compulsory += !(*word & bit);
        *word |= bit;
    }
    misses->accesses += count;
    misses->misses += missing;
    if (level->stack)
        aob_stack_access(level->stack, numbers, count);
    if (level->reuse)
        aob_reuse_access(level->reuse, numbers, count);
    return missing;
}

void aob_level_curve(const struct aob_level *level, struct aob_curve *curve)
{
    *curve = (struct aob_curve){0};
    if (level->reuse)
        aob_reuse_curve(level->reuse, curve);
    if (!level->stack)
        return;
    curve->lines = AOB_NEW_ARRAY(uint64_t, level->size_count);
    curve->misses = AOB_NEW_ARRAY(uint64_t, level->size_count);
    for (; curve->count < level->size_count; curve->count++) {
        curve->lines[curve->count] = level->sizes[curve->count];
        curve->misses[curve->count] = aob_stack_misses(level->stack, curve->count);
    }
}

uint64_t aob_level_associative(const struct aob_level *level)
{
    if (level->stack)
        return aob_stack_misses(level->stack, level->own);
    struct aob_curve curve;
    aob_level_curve(level, &curve);
    uint64_t misses = aob_curve_at(&curve, level->lines);
    aob_curve_finish(&curve);
    return misses;
}

double aob_level_bytes(const struct aob_level_desc *desc)
{
    struct aob_tags_desc tags = tags_desc(desc);
    double bytes = aob_tags_bytes(&tags) + desc->numbers / 8.0;
    if (desc->curve == AOB_CURVE_NONE)
        return bytes;
    return bytes + (desc->curve == AOB_CURVE_EVERY && !desc->own_size
                        ? aob_reuse_bytes(desc->numbers, tags.sectors)
                        : aob_stack_bytes(desc->numbers, tags.sectors));
}
