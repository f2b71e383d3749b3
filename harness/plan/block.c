#include "block.h"

static bool is_wanted(const bool *wanted, size_t i)
{
    return !wanted || wanted[i];
}

/* How many cases from `at` on are builds of one case, as far as they are wanted. */
static size_t count_builds(const struct aob_plan *plan, const bool *wanted, size_t at, size_t *behind)
{
    size_t count = 0, i = at;
    for (; i < plan->case_count && aob_case_same_but_build(&plan->cases[at], &plan->cases[i]); i++)
        count += is_wanted(wanted, i);
    *behind = i;
    return count;
}

size_t aob_plan_next_block(const struct aob_plan *plan, const bool *wanted, size_t *at,
                           size_t indices[AOB_BLOCK_MAX])
{
    size_t first = *at, used = 0, behind;
    while (*at < plan->case_count && used < AOB_BLOCK_MAX &&
           aob_case_same_block(&plan->cases[first], &plan->cases[*at])) {
        size_t builds = count_builds(plan, wanted, *at, &behind);
        if (used && used + builds > AOB_BLOCK_MAX)
            break;
        for (; *at < behind && used < AOB_BLOCK_MAX; (*at)++)
            if (is_wanted(wanted, *at))
                indices[used++] = *at;
    }
    return used;
}
