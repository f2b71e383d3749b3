#include "frames.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "run/measurement.h"
#include "technique/param.h"

static void add_option(struct aob_config *config, const char *name, const char *value)
{
    aob_axis_add(&config->options, &config->option_count, &config->option_capacity, name, value);
}

/* An axis of two values; cases that no set wants are dropped from the plan. */
static void add_values(struct aob_axis **axes, size_t *count, size_t *capacity, const char *name,
                       const char *first, const char *second)
{
    aob_axis_add(axes, count, capacity, name, first);
    struct aob_axis *axis = &(*axes)[*count - 1];
    axis->values = aob_realloc(axis->values, 2, sizeof *axis->values);
    axis->values[1] = (struct aob_value){.text = aob_strdup(second)};
    axis->count = 2;
}

static bool judge_axes(const struct aob_axis *axes, size_t count, struct aob_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (aob_effect_is_choice(axes[i].name))
            return aob_fail(error, "a plan of effects chooses '%s' itself: leave it out", axes[i].name);
    return true;
}

bool aob_effect_frames_judge(const struct aob_config *config, size_t entry, struct aob_error *error)
{
    const struct aob_technique_choice *technique = &config->techniques[entry];
    return judge_axes(config->options, config->option_count, error) &&
           judge_axes(technique->axes, technique->axis_count, error);
}

void aob_effect_frames_widen(struct aob_config *config, size_t entry, unsigned some, bool unlit)
{
    struct aob_technique_choice *technique = &config->techniques[entry];
    if (!unlit)
        add_option(config, "lit", "on");
    for (int id = 0; id < AOB_EFFECT_COUNT; id++) {
        const struct aob_effect_row *row = &aob_effect_rows[id];
        if (!aob_effect_has(some, (enum aob_effect_id)id))
            continue;
        if (row->option)
            add_values(&config->options, &config->option_count, &config->option_capacity, row->option, "off",
                       "on");
        if (row->param.name)
            add_values(&technique->axes, &technique->axis_count, &technique->axis_capacity, row->param.name,
                       row->param.off, row->param.on);
    }
}

/* The effects that some of the sets have. */
static unsigned some_of(const struct aob_effect_frames_desc *desc)
{
    unsigned some = 0;
    for (size_t i = 0; i < desc->count; i++)
        some |= desc->sets[i];
    return some;
}

static void add_none(struct aob_config *config)
{
    struct aob_technique_choice *none =
        AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity);
    none->name.text = aob_strdup("none");
}

static bool configure(const struct aob_effect_frames_desc *desc, struct aob_config *config,
                      struct aob_error *error)
{
    if (!desc->maker.make(desc->maker.user, config, error))
        return false;
    config->scenes[0].told = true; /* the planner has looked at it before */
    aob_effect_frames_widen(config, 0, some_of(desc), desc->unlit);
    add_none(config);
    if (desc->still_frames && !config->scenes[0].motion.frames)
        config->scenes[0].motion.frames = desc->still_frames;
    config->images = !(desc->seconds > 0) && !desc->profile;
    config->measure_time = desc->seconds > 0;
    config->measure_error = desc->spp > 0;
    if (desc->spp)
        config->spp = desc->spp;
    if (desc->seconds > 0)
        config->seconds = desc->seconds;
    if (desc->profile)
        AOB_PUSH(config->profiles, config->profile_count, config->profile_capacity)->text =
            aob_strdup(desc->profile);
    return true;
}

static double value_of(const struct aob_case *c, const char *name)
{
    const struct aob_param *params = c->technique->params;
    const struct aob_param *param = aob_param_find(params, c->technique->param_count, name);
    return param ? c->params[param - params] : 0;
}

unsigned aob_effect_set_of(const struct aob_case *c)
{
    const unsigned half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), mean = AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL);
    struct aob_options o = aob_case_options(c);
    unsigned set = (o.visibility_rgb ? AOB_EFFECT_BIT(AOB_EFFECT_MULTI_BOUNCE) : 0) |
                   (o.bent_normal ? AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL) : 0) |
                   (o.irradiance ? AOB_EFFECT_BIT(AOB_EFFECT_DIRECTIONAL) : 0) |
                   (o.specular ? AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR) : 0);
    if (strcmp(c->technique->name, "none") == 0)
        return set;
    return set | AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY) | (value_of(c, "divisor") > 1 ? half : 0) |
           (value_of(c, "history") > 1 ? mean : 0);
}

static int place_of(const struct aob_effect_frames_desc *desc, unsigned set)
{
    for (size_t i = 0; i < desc->count; i++)
        if (desc->sets[i] == set)
            return (int)i;
    return -1;
}

static void keep_wanted(const struct aob_effect_frames_desc *desc, struct aob_plan *plan)
{
    size_t kept = 0;
    for (size_t i = 0; i < plan->case_count; i++)
        if (place_of(desc, aob_effect_set_of(&plan->cases[i])) >= 0)
            plan->cases[kept++] = plan->cases[i];
        else
            free(plan->cases[i].params);
    plan->case_count = kept;
}

struct keeper {
    const struct aob_effect_frames_desc *desc;
    const struct aob_plan *plan;
    json_t *records;
    struct aob_error *error;
};

static void keep(void *user, size_t index, json_t *record)
{
    struct keeper *keeper = user;
    const struct aob_case *c = &keeper->plan->cases[index];
    const char *status = json_string_value(json_object_get(record, "status"));
    json_array_set(keeper->records, (size_t)place_of(keeper->desc, aob_effect_set_of(c)), record);
    if (strcmp(status, "unsupported") == 0 && keeper->desc->unsupported)
        *keeper->desc->unsupported = true;
    if (strcmp(status, "ok") != 0 && !*keeper->error->text)
        aob_fail(keeper->error, "%s: %s: %s", c->technique->name, status,
                 json_string_value(json_object_get(record, "reason")));
}

static bool make_folders(const char *folder, struct aob_error *error)
{
    static const char *const names[] = {"images", "truths", "rounds", "graphs", "shaders"};
    bool ok = true;
    for (size_t i = 0; i < AOB_COUNT(names) && ok; i++) {
        char *path = aob_path_join(folder, names[i]);
        ok = aob_folder_create(path, error);
        free(path);
    }
    return ok;
}

/* What the module refuses has its reason in its state; it is a record like any other. */
static void take_refused(struct aob_measurement *m, struct keeper *keeper)
{
    for (size_t i = 0; i < m->plan->case_count; i++)
        if (m->states[i].stage == AOB_REFUSED && !*keeper->error->text)
            aob_fail(keeper->error, "%s: %s: %s", m->plan->cases[i].technique->name, m->states[i].status,
                     m->states[i].reason);
}

static bool measure(const struct aob_effect_frames_desc *desc, struct aob_plan *plan, json_t *records,
                    struct aob_error *error)
{
    static const size_t indices[AOB_BLOCK_MAX] = {0, 1, 2, 3, 4, 5};
    struct aob_measurement m;
    struct keeper keeper = {desc, plan, records, error};
    if (!make_folders(desc->folder, error) || !aob_measurement_init(&m, desc->dispatch, plan, error))
        return false;
    char *shaders = aob_path_join(desc->folder, "shaders");
    m.folder = desc->folder;
    m.shaders = shaders;
    m.on_record = keep;
    m.user = &keeper;
    aob_measurement_layout(&m);
    take_refused(&m, &keeper);
    if (!*error->text)
        aob_measurement_block(&m, indices, plan->case_count);
    aob_measurement_finish(&m);
    free(shaders);
    return !*error->text;
}

json_t *aob_effect_frames_measure(const struct aob_effect_frames_desc *desc, struct aob_sweep *sweep,
                                  struct aob_error *error)
{
    json_t *records = json_array();
    for (size_t i = 0; i < desc->count; i++)
        json_array_append_new(records, json_null());
    bool ok = configure(desc, &sweep->config, error) && aob_sweep_expand(sweep, desc->dispatch, error);
    if (ok)
        keep_wanted(desc, &sweep->plan);
    if (ok && sweep->plan.case_count == desc->count && measure(desc, &sweep->plan, records, error))
        return records;
    if (!*error->text)
        aob_fail(error,
                 "a plan of effects chooses these options itself: leave lit, visibility_rgb, bent_normal, "
                 "irradiance, specular, history and divisor out");
    json_decref(records);
    return NULL;
}

char *aob_effect_frames_image(const struct aob_effect_frames_desc *desc, const json_t *record)
{
    const char *name = json_string_value(json_object_get(record, "image"));
    return name ? aob_path_join(desc->folder, name) : NULL;
}
