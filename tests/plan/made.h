/* Plans made of the texts of configs, with the built-in techniques. For tests of one program: it holds one file's path. */
#ifndef AOB_TESTS_PLAN_MADE_H
#define AOB_TESTS_PLAN_MADE_H
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
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

/* gtao once more, as a module of that path would bring it. */
static inline void add_build(const char *file, char digit)
{
    size_t at = 0;
    while (strcmp(techniques.items[at].name, "gtao") != 0 || techniques.items[at].module)
        at++;
    json_t *json = aob_technique_info_to_json(&techniques.items[at]);
    json_object_del(json, "module");
    assert_true(aob_technique_list_add(&techniques, json));
    json_decref(json);
    struct aob_technique_info *info = &techniques.items[techniques.count - 1];
    info->module = aob_strdup(file);
    info->file = aob_strdup(file);
    info->offered = false;
    memset(info->digest, digit, sizeof info->digest - 1);
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
