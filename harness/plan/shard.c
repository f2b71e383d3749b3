#include "shard.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "block.h"

bool aob_shard_parse(const char *text, struct aob_shard *shard, struct aob_error *error)
{
    int end = 0;
    if (strcmp(text, "env") == 0)
        return aob_shard_from_environment(shard, error);
    bool plain = strspn(text, "0123456789/") == strlen(text);
    if (plain && sscanf(text, "%5d/%5d%n", &shard->index, &shard->count, &end) == 2 && !text[end] &&
        shard->index >= 1 && shard->index <= shard->count && shard->count <= AOB_SHARD_MOST)
        return true;
    *shard = (struct aob_shard){0};
    return aob_fail(
        error,
        "'%s' is no shard: give 2/4 for the second of four, at most of %d, or env for the task of "
        "the array that this runs in",
        text, AOB_SHARD_MOST);
}

static int shard_of(const struct aob_plan *plan, const size_t *block, size_t size, int count)
{
    char key[AOB_KEY_SIZE];
    struct aob_hash hash;
    aob_hash_begin(&hash);
    for (size_t i = 0; i < size; i++)
        aob_hash_add(&hash, plan->cases[block[i]].key, sizeof plan->cases[block[i]].key);
    aob_hash_end(&hash, key);
    key[8] = 0;
    return (int)(strtoul(key, NULL, 16) % (unsigned)count) + 1;
}

/* Each block of the whole plan becomes one by itself, so that those which stay are not packed anew. */
static void mark_shard(struct aob_plan *plan, const struct aob_shard *shard, bool *mine)
{
    size_t block[AOB_BLOCK_MAX], number = 0;
    size_t *blocks = AOB_NEW_ARRAY(size_t, plan->case_count);
    for (size_t at = 0; at < plan->case_count; number++) {
        size_t size = aob_plan_next_block(plan, NULL, &at, block);
        bool here = shard_of(plan, block, size, shard->count) == shard->index;
        for (size_t i = 0; i < size; i++) {
            mine[block[i]] = here;
            blocks[block[i]] = number;
        }
    }
    for (size_t i = 0; i < plan->case_count; i++)
        plan->cases[i].block = blocks[i];
    free(blocks);
}

void aob_plan_keep_shard(struct aob_plan *plan, const struct aob_shard *shard)
{
    size_t kept = 0;
    if (!shard->count)
        return;
    bool *mine = AOB_NEW_ARRAY(bool, plan->case_count);
    mark_shard(plan, shard, mine);
    for (size_t i = 0; i < plan->case_count; i++)
        if (mine[i])
            plan->cases[kept++] = plan->cases[i];
        else
            free(plan->cases[i].params);
    plan->case_count = kept;
    free(mine);
}
