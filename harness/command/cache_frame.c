#include "cache_frame.h"
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "base/output.h"
#include "cache_map.h"
#include "cache_table.h"

/* Below it a line would be older than it is read. */
static const double worth_telling_s = 3;

static void foretell(void *user, const char *work, double seconds)
{
    (void)user;
    if (seconds >= worth_telling_s)
        aob_note("%s", work);
}

static void choose_profiles(const char *profiles, struct aob_config *config)
{
    char *list = aob_strdup(profiles), *rest = list;
    for (char *name; (name = strsep(&rest, ","));)
        AOB_PUSH(config->profiles, config->profile_count, config->profile_capacity)->text = aob_strdup(name);
    free(list);
}

static bool make_sweep(const struct aob_cache_frame_desc *desc, struct aob_sweep *sweep,
                       struct aob_error *error)
{
    struct aob_config *config = &sweep->config;
    if (!aob_single_config("cache", desc->frame, config, error))
        return false;
    if (!desc->profiles)
        return aob_fail(error, "cache: --profile is needed; see: aobudget list profiles");
    config->measure_time = config->measure_error = config->images = false;
    choose_profiles(desc->profiles, config);
    return aob_single_expand(sweep, &desc->common->dispatch, error);
}

/* The first that has no figures says why for all. */
static bool judge(const json_t *record, struct aob_error *error)
{
    const char *name;
    json_t *figures;
    json_object_foreach(json_object_get(record, "cache"), name, figures)
    {
        const char *status = json_string_value(json_object_get(figures, "status"));
        if (strcmp(status, "ok") != 0)
            return aob_fail(error, "%s: %s: %s", name, status,
                            json_string_value(json_object_get(figures, "reason")));
    }
    return true;
}

static void print(const struct aob_sweep *sweep, const json_t *record, struct aob_text *out)
{
    struct aob_text text = {0};
    const char *name;
    json_t *figures;
    aob_case_describe(&sweep->plan, &sweep->plan.cases[0], &text);
    aob_text_add_line(out, "%s", text.data);
    aob_text_finish(&text);
    json_object_foreach(json_object_get(record, "cache"), name, figures)
        aob_cache_table_print(name, figures, out);
}

/* Every profile has its picture, and its file for ParaView. */
static void draw(const struct aob_cache_frame_desc *desc, const struct aob_sweep *sweep, struct aob_text *out)
{
    struct aob_text title = {0};
    aob_case_describe(&sweep->plan, &sweep->plan.cases[0], &title);
    for (size_t i = 0; i < sweep->plan.profile_count; i++)
        aob_cache_map_draw(&(struct aob_cache_map_desc){.image = desc->out,
                                                        .profile = sweep->plan.profiles[i].name,
                                                        .title = title.data,
                                                        .program = desc->common->dispatch.program},
                           out);
    aob_text_finish(&title);
}

enum aob_exit aob_cache_frame(const struct aob_cache_frame_desc *desc, struct aob_error *error)
{
    struct aob_common *common = desc->common;
    struct aob_sweep sweep = {0};
    json_t *record = NULL;
    const struct aob_single_desc single = {
        .dispatch = &common->dispatch, .map = desc->out, .on_foretold = common->quiet ? NULL : foretell};
    bool ok = make_sweep(desc, &sweep, error) && aob_single_measure(&single, &sweep, &record, error) &&
              judge(record, error);
    if (record && common->json && !aob_json_write(record, common->json, ok ? error : NULL))
        ok = false;
    if (ok && aob_common_speaks(common))
        print(&sweep, record, &common->out);
    if (ok && desc->out)
        draw(desc, &sweep, aob_common_speaks(common) ? &common->out : NULL);
    json_decref(record);
    aob_sweep_finish(&sweep);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
