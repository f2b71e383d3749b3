#include "processes.h"
#include <math.h>
#include "estimate.h"
#include "summary.h"

/* The finaliser of SplitMix64, by which neighbouring numbers have nothing in common. */
uint32_t aob_process_seed(uint32_t seed, int index)
{
    uint64_t x = ((uint64_t)seed << 32 | (uint32_t)index) + 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return (uint32_t)((x ^ x >> 31) >> 32);
}

int aob_processes_least(const struct aob_processes_desc *desc)
{
    return desc->least > AOB_PROCESSES_LEAST ? desc->least : AOB_PROCESSES_LEAST;
}

static double slice_of(const struct aob_processes_desc *desc)
{
    return fmax(fmin(desc->seconds / AOB_PROCESSES_LEAST, AOB_PROCESS_SECONDS),
                desc->seconds / AOB_PROCESSES_MOST);
}

struct aob_process_desc aob_process_describe(const struct aob_processes_desc *desc, int index)
{
    return (struct aob_process_desc){index, aob_process_seed(desc->seed, index), slice_of(desc)};
}

static bool is_precise(const struct aob_processes_desc *desc, const struct aob_round_list *rounds)
{
    if (rounds->count < AOB_PROCESSES_ROUNDS)
        return false;
    for (size_t i = 0; i < desc->case_count; i++) {
        struct aob_ratio ratio = aob_rounds_ratio(rounds, AOB_SLOT_CASES + i);
        if (aob_estimate_half_width(&ratio) > desc->precision)
            return false;
    }
    return true;
}

static bool is_done(const struct aob_processes_desc *desc, const struct aob_processes *result)
{
    if (result->good < aob_processes_least(desc))
        return false;
    return result->measured_s >= desc->seconds * (double)desc->case_count ||
           is_precise(desc, &result->rounds);
}

/* A process whose rounds are not of this block has failed as one that ended early has. */
static bool judge_rounds(const struct aob_processes_desc *desc, const struct aob_round_list *rounds,
                         size_t first, struct aob_error *error)
{
    if (rounds->count == first)
        return aob_fail(error, "it gave no rounds");
    for (size_t r = first; r < rounds->count; r++)
        if (rounds->items[r].slot_count != AOB_SLOT_CASES + desc->case_count ||
            !aob_round_fits(&rounds->items[r], &rounds->items[0]))
            return aob_fail(error, "it gave rounds of another block");
    return true;
}

static void add_process(const struct aob_processes_desc *desc, int index, struct aob_processes *result,
                        struct aob_error *error)
{
    struct aob_round_list *rounds = &result->rounds;
    const size_t first = rounds->count;
    const struct aob_process_desc process = aob_process_describe(desc, index);
    if (!desc->run(desc->user, &process, rounds, error) || !judge_rounds(desc, rounds, first, error)) {
        rounds->count = first;
        result->lost++;
        desc->on_lost(desc->user, index, error->text);
        return;
    }
    result->good++;
    for (size_t r = first; r < rounds->count; r++)
        result->measured_s += aob_round_seconds(&rounds->items[r]);
}

bool aob_processes_run(const struct aob_processes_desc *desc, struct aob_processes *result,
                       struct aob_error *error)
{
    struct aob_error last = {{0}};
    *result = (struct aob_processes){0};
    for (int index = 0; index < AOB_PROCESSES_MOST && !is_done(desc, result); index++) {
        add_process(desc, index, result, &last);
        if (result->lost == AOB_PROCESSES_LOST)
            break;
    }
    return result->good >= AOB_PROCESSES_LEAST || aob_fail(error, "%s", last.text);
}

void aob_processes_finish(struct aob_processes *processes)
{
    aob_rounds_finish(&processes->rounds);
    *processes = (struct aob_processes){0};
}
