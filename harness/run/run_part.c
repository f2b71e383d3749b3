#include "run_part.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "info.h"

char *aob_run_path(const struct aob_run_desc *desc, const struct aob_config *config)
{
    struct aob_text name = {0};
    if (desc->out)
        return aob_strdup(desc->out);
    aob_text_add(&name, "%s", config->name);
    if (desc->shard.count)
        aob_text_add(&name, "-%d-of-%d", desc->shard.index, desc->shard.count);
    char *path = aob_path_join("results", name.data);
    aob_text_finish(&name);
    return path;
}

bool aob_run_part_judge(const struct aob_run_desc *desc, const struct aob_config *config,
                        struct aob_error *error)
{
    return !config->effects.text ||
           aob_fail(
               error,
               "%s: effects: auto chooses its cases by what it measures, so neither --shard nor --truth-only "
               "knows them: run it whole, or give the config of a view's set, which `aobudget effects --out` "
               "writes",
               desc->config);
}

static bool has_match(const struct aob_run_desc *desc, const struct aob_plan *plan, struct aob_error *error)
{
    for (size_t i = 0; i < plan->case_count; i++)
        if (!desc->filter || aob_plan_matches(plan, &plan->cases[i], desc->filter))
            return true;
    return desc->filter && plan->case_count
               ? aob_fail(error, "no case of %s matches '%s'; see: aobudget plan %s", desc->config,
                          desc->filter, desc->config)
               : aob_fail(error, "no case of %s is left to measure", desc->config);
}

bool aob_run_part_choose(const struct aob_run_desc *desc, struct aob_plan *plan, json_t *info,
                         struct aob_error *error)
{
    if (!has_match(desc, plan, error))
        return false;
    aob_plan_keep_shard(plan, &desc->shard);
    if (desc->filter)
        aob_plan_filter(plan, desc->filter);
    if (info && (desc->filter || desc->shard.count))
        aob_run_info_ask(info, plan);
    return true;
}
