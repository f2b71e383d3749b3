#include "stack.h"
#include <stdlib.h>
#include "base/memory.h"

/* Places are those of lines, from 1; place 0 is none. */
struct node {
    uint32_t newer, older;
    uint32_t group; /* 1 + the number of marks that lie before it; 0: it was never used */
};
struct aob_stack {
    struct node *nodes;
    uint32_t latest, oldest, count;
    uint32_t marks[AOB_STACK_MAX_SIZE]; /* the line at the depth of each size, once there are so many */
    uint32_t sizes[AOB_STACK_MAX_SIZE];
    uint32_t size_count;
    uint32_t sector_shift;
    uint8_t *
        worst; /* of each sector the last group that its line was found in since it was used; 0: it never was.
                     * NULL: a line is one sector */
    uint64_t found[AOB_STACK_MAX_SIZE + 2]; /* accesses by group; 0: first uses */
};

struct aob_stack *aob_stack_create(const struct aob_stack_desc *desc)
{
    struct aob_stack *stack = AOB_NEW(struct aob_stack);
    uint32_t sectors = desc->sectors ? desc->sectors : 1;
    stack->nodes = AOB_NEW_ARRAY(struct node, (size_t)desc->numbers / sectors + 2);
    if (sectors > 1)
        stack->worst = AOB_NEW_ARRAY(uint8_t, (size_t)desc->numbers + sectors);
    stack->sector_shift = (uint32_t)__builtin_ctz(sectors);
    stack->size_count = (uint32_t)desc->size_count;
    for (size_t i = 0; i < desc->size_count; i++)
        stack->sizes[i] = desc->sizes[i];
    return stack;
}

double aob_stack_bytes(uint32_t numbers, uint32_t sectors)
{
    double lines = (double)(numbers / (sectors ? sectors : 1)) + 2;
    return lines * sizeof(struct node) + (sectors > 1 ? (double)numbers + sectors : 0);
}

void aob_stack_destroy(struct aob_stack *stack)
{
    if (!stack)
        return;
    free(stack->nodes);
    free(stack->worst);
    free(stack);
}

static void push(struct aob_stack *stack, uint32_t place)
{
    struct node *nodes = stack->nodes;
    nodes[place].newer = 0;
    nodes[place].older = stack->latest;
    nodes[place].group = 1;
    nodes[stack->latest].newer = place; /* that of place 0 is never read */
    stack->latest = place;
    if (!stack->oldest)
        stack->oldest = place;
}

/* All before the place that was left are one deeper now, so each mark stands on a line that has passed it. */
static inline void move_marks(struct aob_stack *stack, uint32_t count)
{
    struct node *nodes = stack->nodes;
    for (uint32_t m = 0; m < count; m++) {
        struct node *passed = &nodes[stack->marks[m]];
        passed->group = m + 2;
        stack->marks[m] = passed->newer;
    }
}

static void use_new(struct aob_stack *stack, uint32_t place)
{
    uint32_t full = 0;
    while (full < stack->size_count && stack->sizes[full] <= stack->count)
        full++;
    push(stack, place);
    stack->count++;
    move_marks(stack, full);
    if (full < stack->size_count && stack->sizes[full] == stack->count)
        stack->marks[full] = stack->oldest;
}

/* Makes the line the latest; returns the group that it was found in, or 0 where it is new. */
static inline uint32_t use_line(struct aob_stack *stack, uint32_t place)
{
    struct node *nodes = stack->nodes, *node = &nodes[place];
    uint32_t group = node->group;
    if (stack->latest == place)
        return 1;
    if (!group) {
        use_new(stack, place);
        return 0;
    }
    nodes[node->newer].older = node->older;
    if (node->older)
        nodes[node->older].newer = node->newer;
    else
        stack->oldest = node->newer;
    if (group <= stack->size_count && stack->marks[group - 1] == place)
        stack->marks[group - 1] = node->newer;
    push(stack, place);
    move_marks(stack, group - 1);
    return group;
}

/* The sector hits in caches in which its line has stayed since: those of the last group of all. */
static uint32_t use_sector(struct aob_stack *stack, uint32_t number, uint32_t group)
{
    uint8_t *worst = stack->worst + ((number >> stack->sector_shift) << stack->sector_shift);
    for (uint32_t s = 0; s < 1u << stack->sector_shift; s++)
        if (worst[s] && worst[s] < group)
            worst[s] = (uint8_t)group;
    uint32_t found = stack->worst[number];
    stack->worst[number] = 1;
    return found;
}

void aob_stack_access(struct aob_stack *stack, const uint32_t *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t group = use_line(stack, (numbers[i] >> stack->sector_shift) + 1);
        if (stack->worst)
            group = use_sector(stack, numbers[i], group);
        stack->found[group]++;
    }
}

uint64_t aob_stack_misses(const struct aob_stack *stack, size_t size)
{
    uint64_t misses = stack->found[0];
    for (size_t group = size + 2; group <= stack->size_count + 1; group++)
        misses += stack->found[group];
    return misses;
}
