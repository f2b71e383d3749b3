#include "gather.h"
#include <stdlib.h>
#include "base/memory.h"
#include "base/table.h"

typedef void describe_group(const struct aob_plan *plan, const struct aob_case *c, struct aob_text *text);

static void describe_block(const struct aob_plan *plan, const struct aob_case *c, struct aob_text *text)
{
    struct aob_options o = aob_case_options(c);
    aob_text_add(text, "%zu %dx%d %s %d %d %d", (size_t)(c->scene - plan->scenes), c->width, c->height,
                 c->backend, o.guard_band, o.gbuffer, o.threads);
}

static void describe_builds(const struct aob_plan *plan, const struct aob_case *c, struct aob_text *text)
{
    aob_text_add(text, "%zu ", (size_t)(c->scene - plan->scenes));
    aob_case_settings(c, text);
}

/* What has the same description lies together, where the first of it was, in its order. `block` becomes the number of the
 * group. */
static void gather(struct aob_plan *plan, describe_group *describe)
{
    struct aob_table groups = {0};
    size_t *starts =
        AOB_NEW_ARRAY(size_t, plan->case_count + 1); /* of a group; first its cases counted, one place on */
    struct aob_case *sorted = AOB_NEW_ARRAY(struct aob_case, plan->case_count);
    for (size_t i = 0; i < plan->case_count; i++) {
        struct aob_case *c = &plan->cases[i];
        struct aob_text text = {0};
        describe(plan, c, &text);
        c->block = aob_table_put(&groups, text.data, groups.count);
        starts[c->block + 1]++;
        aob_text_finish(&text);
    }
    for (size_t g = 0; g < groups.count; g++)
        starts[g + 1] += starts[g];
    for (size_t i = 0; i < plan->case_count; i++)
        sorted[starts[plan->cases[i].block]++] = plan->cases[i];
    free(plan->cases);
    plan->cases = sorted;
    plan->case_capacity = plan->case_count;
    free(starts);
    aob_table_finish(&groups);
}

void aob_plan_gather(struct aob_plan *plan)
{
    gather(plan, describe_builds);
    gather(plan, describe_block);
}
