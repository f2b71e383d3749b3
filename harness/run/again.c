#include "again.h"
#include <stdlib.h>
#include <string.h>
#include "base/member.h"
#include "base/memory.h"
#include "base/table.h"
#include "gone.h"
#include "plan/twins.h"

static size_t count_of_scene(const json_t *records, const char *scene)
{
    size_t count = 0, at;
    json_t *record;
    json_array_foreach((json_t *)(uintptr_t)records, at, record)
    {
        count += strcmp(aob_member_text(record, "scene"), scene) == 0;
    }
    return count;
}

struct gone {
    const json_t *records;
    struct aob_table told; /* scenes; each may have several views */
};

static void warn_of_gone(void *user, const char *scene, const char *why)
{
    struct gone *gone = user;
    size_t count = count_of_scene(gone->records, scene);
    if (!count || aob_table_find(&gone->told, scene, NULL))
        return;
    aob_table_put(&gone->told, scene, 0);
    aob_warn("%s: %zu case%s of it cannot be measured again", why, count, count == 1 ? "" : "s");
}

bool aob_run_again_read(const struct aob_run_again *again, const char *copy, struct aob_config *config,
                        struct aob_error *error)
{
    struct gone gone = {.records = again->records};
    if (!aob_config_read_copy(config, copy, again->place, error))
        return false;
    config->measure_time = config->images = true; /* which is what is compared, and in no key */
    aob_gone_leave(config, warn_of_gone, &gone);
    aob_table_finish(&gone.told);
    return config->scene_count || aob_fail(error, "%s: no scene of it is there any more", again->place);
}

static bool has_scene(const struct aob_plan *plan, const json_t *record)
{
    for (size_t i = 0; i < plan->scene_count; i++)
        if (strcmp(plan->scenes[i].name, aob_member_text(record, "scene")) == 0)
            return true;
    return false;
}

/* Whether the plan has it but for what the scene's file holds, which is all that a config does not say. */
static bool has_like(const struct aob_plan *plan, const json_t *record)
{
    for (size_t i = 0; i < plan->case_count; i++) {
        const struct aob_case *c = &plan->cases[i];
        if (strcmp(c->scene->name, aob_member_text(record, "scene")) == 0 &&
            strcmp(c->scene->view, aob_member_text(record, "view")) == 0 &&
            strcmp(c->technique->name, aob_member_text(record, "technique")) == 0 &&
            strcmp(c->backend, aob_member_text(record, "backend")) == 0 &&
            c->width == json_integer_value(json_object_get(record, "width")) &&
            c->height == json_integer_value(json_object_get(record, "height")))
            return true;
    }
    return false;
}

/* Of a scene that is gone one line was said already. */
static void warn_of_record(const struct aob_plan *plan, const json_t *record)
{
    if (!has_scene(plan, record))
        return;
    aob_warn("%s/%s %s %s %dx%d is not measured again: %s", aob_member_text(record, "scene"),
             aob_member_text(record, "view"), aob_member_text(record, "technique"),
             aob_member_text(record, "backend"), (int)json_integer_value(json_object_get(record, "width")),
             (int)json_integer_value(json_object_get(record, "height")),
             has_like(plan, record)
                 ? "the scene's file, or how this program reads and traces it, has changed since"
                 : "its config does not have it, so it was measured with other settings");
}

/* Marks the cases that the records are of; their number. */
static size_t mark(const json_t *records, const struct aob_plan *plan, bool *kept)
{
    struct aob_table keys = {0};
    size_t count = 0, place, at;
    json_t *record;
    for (size_t i = 0; i < plan->case_count; i++)
        aob_table_put(&keys, plan->cases[i].key, i);
    json_array_foreach((json_t *)(uintptr_t)records, at, record)
    {
        if (!aob_table_find(&keys, aob_member_text(record, "key"), &place)) {
            warn_of_record(plan, record);
            continue;
        }
        count += !kept[place];
        kept[place] = true;
    }
    aob_table_finish(&keys);
    return count;
}

bool aob_run_again_choose(const struct aob_run_again *again, struct aob_sweep *sweep, struct aob_error *error)
{
    bool *kept = AOB_NEW_ARRAY(bool, sweep->plan.case_count + 1);
    bool ok =
        mark(again->records, &sweep->plan, kept)
            ? aob_plan_take_twins(&sweep->plan, kept, again->module, error)
            : aob_fail(error, "none of the %zu cases can be measured again", json_array_size(again->records));
    free(kept);
    return ok;
}
