#include "run_effects.h"
#include <stdlib.h>
#include "base/file.h"
#include "base/json.h"
#include "info.h"
#include "run_part.h"
#include "store/run_folder.h"

static bool judge_filter(const struct aob_run_desc *desc, const struct aob_plan *plan, const char *whose,
                         struct aob_error *error)
{
    for (size_t i = 0; i < plan->case_count; i++)
        if (!desc->filter || aob_plan_matches(plan, &plan->cases[i], desc->filter))
            return true;
    return aob_fail(error,
                    "no case of %s matches '%s', %s: give --filter a part of the name of a scene, a view, a "
                    "size, a backend or a technique",
                    desc->config, desc->filter ? desc->filter : "", whose);
}

/* An earlier run stays as it is until the plan is made. */
static bool judge_folder(const struct aob_run_desc *desc, const struct aob_config *config, const json_t *info,
                         struct aob_error *error)
{
    char *path = aob_run_path(desc, config);
    bool ok = aob_folder_create(path, error) && aob_json_check(desc->json, error) &&
              (desc->fresh || aob_run_folder_judge(path, info, error));
    free(path);
    return ok;
}

bool aob_run_effects_choose(const struct aob_run_desc *desc, struct aob_sweep *sweep, json_t *info,
                            struct aob_error *error)
{
    if (!sweep->config.effects.text)
        return true;
    if (!judge_filter(desc, &sweep->plan, "whichever effects are chosen", error) ||
        !judge_folder(desc, &sweep->config, info, error) || !aob_sweep_choose(sweep, desc->filter, error) ||
        !judge_filter(desc, &sweep->plan, "with the effects that are chosen", error))
        return false;
    aob_run_info_plan(info, sweep);
    return true;
}
