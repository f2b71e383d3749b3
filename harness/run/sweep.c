#include "sweep.h"
#include "captures.h"

bool aob_sweep_expand(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error)
{
    return aob_dispatch_describe(dispatch, &sweep->techniques, error) &&
           aob_captures_load(&sweep->config, dispatch, error) &&
           aob_plan_create(&sweep->plan, &sweep->config, &sweep->techniques, error);
}

void aob_sweep_finish(struct aob_sweep *sweep)
{
    aob_plan_finish(&sweep->plan);
    aob_technique_list_finish(&sweep->techniques);
    aob_config_finish(&sweep->config);
}
