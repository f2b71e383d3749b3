#include "sweep.h"
#include <string.h>
#include "captures.h"

/* One line a scene: what is said of it holds for its other cases too. */
static void warn_of_units(const struct aob_sweep *sweep)
{
    const char *told = NULL;
    for (size_t i = 0; i < sweep->plan.case_count; i++) {
        const struct aob_case *c = &sweep->plan.cases[i];
        struct aob_error line;
        if ((told && strcmp(told, c->scene->name) == 0) || !aob_case_mixes_units(c, &sweep->config, &line))
            continue;
        aob_warn("%s", line.text);
        told = c->scene->name;
    }
}

bool aob_sweep_expand(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error)
{
    bool ok = aob_dispatch_describe(dispatch, &sweep->techniques, error) &&
              aob_captures_load(&sweep->config, dispatch, error) &&
              aob_plan_create(&sweep->plan, &sweep->config, &sweep->techniques, error);
    if (ok)
        warn_of_units(sweep);
    return ok;
}

void aob_sweep_finish(struct aob_sweep *sweep)
{
    aob_plan_finish(&sweep->plan);
    aob_technique_list_finish(&sweep->techniques);
    aob_config_finish(&sweep->config);
}
