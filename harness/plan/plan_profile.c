#include "plan_profile.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/shelf.h"
#include "profile/profile.h"

static bool read_profile(const struct aob_config *config, const char *name, struct aob_profile *profile,
                         struct aob_error *error)
{
    if (!config->place || !aob_shelf_is_path(name))
        return aob_profile_find(profile, name, error);
    char *file = aob_path_beside(config->place, name);
    bool ok = aob_profile_read(profile, file, error);
    free(file);
    return ok;
}

/* Records call the figures of a profile by its name. */
static bool judge_name(const struct aob_plan *plan, const struct aob_profile *profile,
                       struct aob_error *error)
{
    for (size_t i = 0; i < plan->profile_count; i++)
        if (strcmp(plan->profiles[i].name, profile->name) == 0)
            return aob_fail(error, "two profiles are called '%s', %s and %s: name one of their files anew",
                            profile->name, plan->profiles[i].path, profile->path);
    return true;
}

static bool add_profile(struct aob_plan *plan, const struct aob_value *value, struct aob_error *error)
{
    struct aob_profile profile = {0};
    bool ok = read_profile(plan->config, value->text, &profile, error) && judge_name(plan, &profile, error);
    if (ok) {
        struct aob_plan_profile *added = &plan->profiles[plan->profile_count++];
        *added = (struct aob_plan_profile){.name = aob_strdup(profile.name),
                                           .path = aob_strdup(profile.path),
                                           .rates = profile.rates.clock > 0};
        aob_profile_digest(&profile, added->digest);
    }
    aob_profile_finish(&profile);
    return ok || aob_config_fail_at(plan->config, value->line, value->column, error);
}

bool aob_plan_choose_profiles(struct aob_plan *plan, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    plan->profiles = AOB_NEW_ARRAY(struct aob_plan_profile, config->profile_count);
    for (size_t i = 0; i < config->profile_count; i++)
        if (!add_profile(plan, &config->profiles[i], error))
            return false;
    return true;
}

void aob_plan_profiles_finish(struct aob_plan *plan)
{
    for (size_t i = 0; i < plan->profile_count; i++) {
        free(plan->profiles[i].name);
        free(plan->profiles[i].path);
    }
    free(plan->profiles);
}

static bool has_rates(const struct aob_plan *plan)
{
    bool rates = false;
    for (size_t i = 0; i < plan->profile_count; i++)
        rates |= plan->profiles[i].rates;
    return rates;
}

double aob_plan_estimate_cache_s(const struct aob_plan *plan, const struct aob_case *c)
{
    const double case_s = 0.5, trace_pixel_s = 5e-7, profile_pixel_s = 2e-6, count_s = 0.4,
                 count_pixel_s = 5e-7;
    double pixels = (double)c->width * c->height, profiles = (double)plan->profile_count;
    double counting_s = has_rates(plan) ? count_s + count_pixel_s * pixels : 0;
    return profiles > 0 ? case_s + (trace_pixel_s + profile_pixel_s * profiles) * pixels + counting_s : 0;
}
