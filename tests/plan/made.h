/* Plans made of the texts of configs, with the built-in techniques. For tests of one program: it holds one file's path. */
#ifndef AOB_TESTS_PLAN_MADE_H
#define AOB_TESTS_PLAN_MADE_H
#include <unistd.h>
#include "base/file.h"
#include "check.h"
#include "plan/plan.h"

static char path[256]; /* of the config */
static struct aob_technique_list techniques;

static int set_up(void **state)
{
    (void)state;
    struct aob_registry registry;
    aob_registry_init(&registry);
    for (size_t i = 0; i < registry.count; i++) {
        json_t *json = aob_technique_to_json(&registry.entries[i]);
        aob_technique_list_add(&techniques, json);
        json_decref(json);
    }
    aob_registry_finish(&registry);
    snprintf(path, sizeof path, "/tmp/aobudget-plan-%ld.yaml", (long)getpid());
    return 0;
}
static int tear_down(void **state)
{
    (void)state;
    aob_technique_list_finish(&techniques);
    return unlink(path);
}

static inline bool make_config(const char *text, struct aob_config *config, struct aob_error *error)
{
    *error = (struct aob_error){{0}};
    aob_file_write(path, text, strlen(text), error);
    return aob_config_read(config, path, error);
}

static inline bool make(const char *text, struct aob_config *config, struct aob_plan *plan,
                        struct aob_error *error)
{
    if (!make_config(text, config, error))
        return false;
    if (aob_plan_create(plan, config, &techniques, error))
        return true;
    aob_config_finish(config);
    return false;
}
#endif
