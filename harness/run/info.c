#include "info.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"

/* Those of the plan, so that a page can say what was measured. */
static json_t *techniques_to_json(const struct aob_sweep *sweep)
{
    json_t *array = json_array();
    for (size_t t = 0; t < sweep->techniques.count; t++) {
        bool used = false;
        for (size_t i = 0; i < sweep->plan.case_count && !used; i++)
            used = sweep->plan.cases[i].technique == &sweep->techniques.items[t];
        if (used)
            json_array_append_new(array, aob_technique_info_to_json(&sweep->techniques.items[t]));
    }
    return array;
}

static json_t *keys_to_json(const struct aob_plan *plan)
{
    json_t *keys = json_array();
    for (size_t i = 0; i < plan->case_count; i++)
        json_array_append_new(keys, json_string(plan->cases[i].key));
    return keys;
}

/* The devices of the backends that the cases name. NULL after a line if a device is asked for that none of them has. */
static json_t *probe_devices(const struct aob_sweep *sweep, const struct aob_dispatch *dispatch,
                             struct aob_error *error)
{
    json_t *devices = json_object();
    bool found = !dispatch->device;
    for (size_t i = 0; i < sweep->plan.case_count; i++) {
        const char *backend = sweep->plan.cases[i].backend;
        if (json_object_get(devices, backend))
            continue;
        json_t *device = aob_dispatch_probe(dispatch, backend, found ? NULL : error);
        found = found || device;
        json_object_set_new(devices, backend, device ? device : json_null());
    }
    if (found)
        return devices;
    json_decref(devices);
    return NULL;
}

json_t *aob_run_info_create(const struct aob_sweep *sweep, const struct aob_dispatch *dispatch,
                            struct aob_error *error)
{
    char date[32], build[AOB_KEY_SIZE];
    time_t now = time(NULL);
    if (!aob_hash_file(dispatch->program, build, error))
        return NULL;
    json_t *devices = probe_devices(sweep, dispatch, error);
    if (!devices)
        return NULL;
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", gmtime(&now));
    char *place = aob_path_absolute(sweep->config.place);
    json_t *info = json_pack("{s:s, s:o, s:s, s:s, s:s, s:s, s:o}", "name", sweep->config.name, "config",
                             aob_json_text(place), "config_hash", sweep->config.hash, "build", build,
                             "program", AOBUDGET_VERSION, "date", date, "devices", devices);
    aob_run_info_plan(info, sweep);
    free(place);
    if (sweep->budget.name)
        json_object_set_new(info, "budget", aob_budget_to_json(&sweep->budget));
    return info;
}

void aob_run_info_plan(json_t *info, const struct aob_sweep *sweep)
{
    json_object_set_new(info, "cases", json_integer((json_int_t)sweep->plan.case_count));
    json_object_set_new(info, "keys", keys_to_json(&sweep->plan));
    json_object_set_new(info, "part", json_boolean(sweep->plan.part));
    json_object_set_new(info, "techniques", techniques_to_json(sweep));
}

void aob_run_info_ask(json_t *info, const struct aob_plan *plan)
{
    json_object_set_new(info, "asked", keys_to_json(plan));
}

/* With as many digits as run.json has; free() it. NULL: there is no budget. */
static char *budget_text(const json_t *info)
{
    const json_t *budget = json_object_get(info, "budget");
    return budget ? json_dumps(budget, JSON_SORT_KEYS | JSON_REAL_PRECISION(6)) : NULL;
}

/* Only a run that has come to its end says its seconds. */
bool aob_run_info_has_page(const json_t *info, const char *folder)
{
    char *path = aob_path_join(folder, "run.json");
    json_t *earlier = json_load_file(path, 0, NULL);
    char *then = budget_text(earlier), *now = budget_text(info);
    bool same = then && now ? strcmp(then, now) == 0 : then == now;
    bool has = json_object_get(earlier, "seconds") && same;
    json_decref(earlier);
    free(then);
    free(now);
    free(path);
    return has;
}
