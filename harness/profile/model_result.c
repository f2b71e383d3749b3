#include "model_result.h"
#include <string.h>

bool aob_model_result_known(const struct aob_cache_result *result)
{
    return result->frame.counted && result->profile->rates.clock > 0;
}

struct aob_model_time aob_model_result_pass(const struct aob_cache_result *result,
                                            const struct aob_cache_pass *pass)
{
    struct aob_model_input input = {.operations = pass->operations,
                                    .issue = pass->issue,
                                    .written = (double)pass->bytes_written,
                                    .pixels = (double)pass->target_pixels};
    for (int l = 0; l < result->profile->level_count; l++)
        for (int f = 0; f < AOB_FLIGHT_COUNT; f++)
            input.filled[l][f] = (double)aob_cache_filled(result, pass, l, (enum aob_flight)f);
    return aob_model_pass(result->profile, &input);
}

struct aob_model_time aob_model_result_frame(const struct aob_cache_result *result)
{
    struct aob_model_time frame = {0};
    for (size_t p = 0; p < result->pass_count; p++) {
        struct aob_model_time pass = aob_model_result_pass(result, &result->passes[p]);
        aob_model_add(&frame, &pass);
    }
    return frame;
}

static json_t *times_to_json(const struct aob_profile *profile, const struct aob_model_time *modelled)
{
    json_t *resources = json_object();
    for (int r = 0; r < AOB_RESOURCE_COUNT; r++) {
        const char *name = aob_model_resource_name(profile, (enum aob_resource)r);
        if (name)
            json_object_set_new(resources, name, json_real(modelled->resources[r]));
    }
    return json_pack("{s:f, s:f, s:f, s:f, s:s, s:o}", "ms", modelled->ms, "low_ms", modelled->low_ms,
                     "high_ms", modelled->high_ms, "launch_ms", modelled->launch_ms, "limit",
                     aob_model_resource_name(profile, aob_model_limit(modelled)), "resources", resources);
}

/* The numbers that no source confirms: what a reader has to doubt first. Those of caches and warps decide the fills. */
static json_t *unverified_to_json(const struct aob_profile *profile)
{
    json_t *keys = json_array();
    for (size_t f = 0; f < profile->fact_count; f++)
        if (!profile->facts[f].confirmed)
            json_array_append_new(keys, json_string(profile->facts[f].key));
    return keys;
}

json_t *aob_model_result_to_json(const struct aob_cache_result *result)
{
    if (!aob_model_result_known(result))
        return json_null();
    json_t *passes = json_array();
    for (size_t p = 0; p < result->pass_count; p++) {
        struct aob_model_time modelled = aob_model_result_pass(result, &result->passes[p]);
        json_t *pass = times_to_json(result->profile, &modelled);
        json_object_set_new(pass, "name", json_string(result->passes[p].name));
        json_array_append_new(passes, pass);
    }
    struct aob_model_time frame = aob_model_result_frame(result);
    return json_pack("{s:o, s:o, s:o}", "frame", times_to_json(result->profile, &frame), "passes", passes,
                     "unverified", unverified_to_json(result->profile));
}
