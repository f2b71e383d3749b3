#include "reuse.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

enum { WORD = 64, BLOCK_WORDS = 8, BLOCK = WORD * BLOCK_WORDS, FIRST_WINDOW = 1 << 16 };

/* Points in time are counted from 0 to `window`, then what is still set is moved to the front. */
struct aob_reuse {
    uint32_t *last; /* of each line 1 + when it was used last; 0: never */
    uint64_t *bits; /* of each point whether it is the last of its line */
    uint32_t *line; /* that was used then */
    uint32_t *tree; /* bits set in each block before the open one, in Fenwick's order, from 1 */
    uint32_t window, now;
    uint32_t live, open; /* bits set; of those in the block that is being filled, which is not in the tree */
    uint32_t sector_shift;
    uint32_t
        *worst; /* of each sector the largest distance of its line since it was used; 0: it never was. NULL: a
                               * line is one sector */
    uint64_t *found; /* accesses by distance; 0: first uses */
};

static void open_window(struct aob_reuse *reuse, uint32_t window)
{
    reuse->window = window;
    reuse->bits = AOB_NEW_ARRAY(uint64_t, window / WORD);
    reuse->line = AOB_NEW_ARRAY(uint32_t, window);
    reuse->tree = AOB_NEW_ARRAY(uint32_t, window / BLOCK + 1);
    reuse->now = reuse->open = 0;
}

struct aob_reuse *aob_reuse_create(uint32_t numbers, uint32_t sectors)
{
    struct aob_reuse *reuse = AOB_NEW(struct aob_reuse);
    size_t lines = (size_t)numbers / (sectors ? sectors : 1) + 1;
    reuse->sector_shift = (uint32_t)__builtin_ctz(sectors ? sectors : 1);
    reuse->last = AOB_NEW_ARRAY(uint32_t, lines);
    reuse->found = AOB_NEW_ARRAY(uint64_t, lines + 1);
    if (reuse->sector_shift)
        reuse->worst = AOB_NEW_ARRAY(uint32_t, (size_t)numbers + sectors);
    open_window(reuse, FIRST_WINDOW);
    return reuse;
}

/* A window is doubled when more than half of it is in use, so it has fewer than four points a line; and two windows stand
 * while one is moved into the next. */
double aob_reuse_bytes(uint32_t numbers, uint32_t sectors)
{
    double lines = (double)(numbers / (sectors ? sectors : 1)) + 2;
    double point = 1.0 / 8 + sizeof(uint32_t) + (double)sizeof(uint32_t) / BLOCK;
    double points = 4 * lines > FIRST_WINDOW ? 4 * lines : FIRST_WINDOW;
    return lines * (sizeof(uint32_t) + sizeof(uint64_t)) + 2 * points * point +
           (sectors > 1 ? ((double)numbers + sectors) * sizeof(uint32_t) : 0);
}

void aob_reuse_destroy(struct aob_reuse *reuse)
{
    if (!reuse)
        return;
    free(reuse->last);
    free(reuse->bits);
    free(reuse->line);
    free(reuse->tree);
    free(reuse->worst);
    free(reuse->found);
    free(reuse);
}

static inline void add_to_block(struct aob_reuse *reuse, uint32_t block, uint32_t count)
{
    for (uint32_t b = block + 1; b <= reuse->window / BLOCK; b += b & -b)
        reuse->tree[b] += count;
}

static inline uint32_t sum_to_block(const struct aob_reuse *reuse, uint32_t block) /* itself too */
{
    uint32_t sum = 0;
    for (uint32_t b = block + 1; b; b &= b - 1)
        sum += reuse->tree[b];
    return sum;
}

static inline void tick(struct aob_reuse *reuse, uint32_t line)
{
    uint32_t now = reuse->now++;
    reuse->bits[now / WORD] |= (uint64_t)1 << now % WORD;
    reuse->line[now] = line;
    reuse->last[line] = now + 1;
    reuse->open++;
    if (reuse->now % BLOCK == 0) {
        add_to_block(reuse, now / BLOCK, reuse->open);
        reuse->open = 0;
    }
}

static void move_to_front(struct aob_reuse *reuse)
{
    struct aob_reuse old = *reuse;
    open_window(reuse, old.live > old.window / 2 ? 2 * old.window : old.window);
    for (uint32_t w = 0; w < old.window / WORD; w++)
        for (uint64_t bits = old.bits[w]; bits; bits &= bits - 1)
            tick(reuse, old.line[w * WORD + (uint32_t)__builtin_ctzll(bits)]);
    free(old.bits);
    free(old.line);
    free(old.tree);
}

/* Bits of a block that are set from `point` on. */
static inline __attribute__((always_inline)) uint32_t count_rest(const struct aob_reuse *reuse,
                                                                 uint32_t point)
{
    uint32_t word = point / WORD, end = (point / BLOCK + 1) * BLOCK_WORDS;
    uint32_t count = (uint32_t)__builtin_popcountll(reuse->bits[word] >> point % WORD);
    while (++word < end)
        count += (uint32_t)__builtin_popcountll(reuse->bits[word]);
    return count;
}

/* Makes the line the latest; returns its distance: 1 if it was the latest, 0 if it is new. */
static inline __attribute__((always_inline)) uint32_t use_line(struct aob_reuse *reuse, uint32_t line)
{
    uint32_t last = reuse->last[line], distance = 0;
    if (last == reuse->now && last)
        return 1;
    if (reuse->now == reuse->window) {
        move_to_front(reuse);
        last = reuse->last[line];
    }
    if (last) {
        uint32_t point = last - 1, block = point / BLOCK;
        bool closed = block < reuse->now / BLOCK;
        distance = count_rest(reuse, point);
        if (closed) {
            distance += reuse->live - sum_to_block(reuse, block);
            add_to_block(reuse, block, (uint32_t)-1);
        } else
            reuse->open--;
        reuse->bits[point / WORD] &= ~((uint64_t)1 << point % WORD);
    } else
        reuse->live++;
    tick(reuse, line);
    return distance;
}

static uint32_t use_sector(struct aob_reuse *reuse, uint32_t number, uint32_t distance)
{
    uint32_t *worst = reuse->worst + ((number >> reuse->sector_shift) << reuse->sector_shift);
    for (uint32_t s = 0; s < 1u << reuse->sector_shift; s++)
        if (worst[s] && worst[s] < distance)
            worst[s] = distance;
    uint32_t found = reuse->worst[number];
    reuse->worst[number] = 1;
    return found;
}

static inline __attribute__((always_inline)) void use_all(struct aob_reuse *reuse, const uint32_t *numbers,
                                                          size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t distance = use_line(reuse, numbers[i] >> reuse->sector_shift);
        if (reuse->worst)
            distance = use_sector(reuse, numbers[i], distance);
        reuse->found[distance]++;
    }
}

#if defined(__x86_64__)
/* The same, compiled with an instruction that counts bits. */
__attribute__((target("popcnt"))) static void use_all_popcnt(struct aob_reuse *reuse, const uint32_t *numbers,
                                                             size_t count)
{
    use_all(reuse, numbers, count);
}

static bool has_popcnt(void)
{
    return __builtin_cpu_supports("popcnt");
}
#else
static void use_all_popcnt(struct aob_reuse *reuse, const uint32_t *numbers, size_t count)
{
    use_all(reuse, numbers, count);
}

static bool has_popcnt(void)
{
    return false;
}
#endif

void aob_reuse_access(struct aob_reuse *reuse, const uint32_t *numbers, size_t count)
{
    if (has_popcnt())
        use_all_popcnt(reuse, numbers, count);
    else
        use_all(reuse, numbers, count);
}

void aob_reuse_curve(const struct aob_reuse *reuse, struct aob_curve *curve)
{
    uint64_t misses = reuse->found[0];
    size_t count = 1;
    for (uint32_t d = 1; d <= reuse->live; d++) {
        misses += reuse->found[d];
        count += reuse->found[d] != 0;
    }
    *curve = (struct aob_curve){0, AOB_NEW_ARRAY(uint64_t, count), AOB_NEW_ARRAY(uint64_t, count)};
    for (uint32_t d = 1; d <= reuse->live; d++) {
        misses -= reuse->found[d];
        if (d > 1 && !reuse->found[d])
            continue;
        curve->lines[curve->count] = d;
        curve->misses[curve->count++] = misses;
    }
}
