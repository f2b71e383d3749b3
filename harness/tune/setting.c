#include "setting.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "technique/param.h"
#include "tune.h"

/* Whether a name stands in a list "a,b". */
static bool holds(const char *list, const char *name)
{
    size_t length = strlen(name);
    while (strncmp(list, name, length) != 0 || (list[length] && list[length] != ',')) {
        list = strchr(list, ',');
        if (!list)
            return false;
        list++;
    }
    return true;
}

static bool is_fitted(const struct aob_settings_desc *desc, const struct aob_axis *axis)
{
    const struct aob_technique_info *t = desc->technique;
    const struct aob_param *param = aob_param_find(t->params, t->param_count, axis->name);
    if (desc->params)
        return holds(desc->params, axis->name);
    return axis->count > 1 && param && aob_tune_axes_wants(param);
}

/* Of a sweep over what is fitted nothing stays; one value of it is where the fit starts. */
static bool is_kept(const struct aob_settings_desc *desc, const struct aob_axis *axis)
{
    return axis->count == 1 || !is_fitted(desc, axis);
}

static void set_value(struct aob_tune_setting *setting, const char *name, const char *text)
{
    struct aob_setting_value *value = &setting->values[setting->value_count++];
    value->name = name;
    snprintf(value->text, sizeof value->text, "%s", text);
}

/* The combination of that number, as an odometer counts; false behind the last one. */
static bool fill_setting(const struct aob_settings_desc *desc, const struct aob_technique_choice *from,
                         size_t number, struct aob_tune_setting *setting)
{
    setting->from = from;
    for (size_t i = 0; i < from->axis_count && setting->value_count < AOB_MAX_PARAM; i++) {
        const struct aob_axis *axis = &from->axes[i];
        if (!is_kept(desc, axis))
            continue;
        set_value(setting, axis->name, axis->values[number % axis->count].text);
        number /= axis->count;
    }
    return number == 0;
}

static bool add_entry(const struct aob_settings_desc *desc, const struct aob_technique_choice *from,
                      struct aob_tune_setting **settings, size_t *count, struct aob_error *error)
{
    for (size_t number = 0;; number++) {
        struct aob_tune_setting setting = {.value_count = 0};
        if (!fill_setting(desc, from, number, &setting))
            return true;
        if (*count == AOB_TUNE_MAX_SETTINGS) {
            aob_fail(error,
                     "'%s' has more than %d settings, and each gets a fit of its own: sweep fewer values",
                     desc->technique->name, AOB_TUNE_MAX_SETTINGS);
            return aob_config_fail_at(desc->config, from->name.line, from->name.column, error);
        }
        setting.figures = aob_alloc(desc->view_count, sizeof *setting.figures);
        (*settings)[(*count)++] = setting;
    }
}

bool aob_tune_settings_create(const struct aob_settings_desc *desc, struct aob_tune_setting **settings,
                              size_t *count, struct aob_error *error)
{
    *settings = AOB_NEW_ARRAY(struct aob_tune_setting, AOB_TUNE_MAX_SETTINGS);
    for (size_t i = 0; i < desc->config->technique_count; i++) {
        const struct aob_technique_choice *from = &desc->config->techniques[i];
        if (strcmp(from->name.text, desc->technique->name) == 0 &&
            !add_entry(desc, from, settings, count, error))
            return false;
    }
    return true;
}

void aob_tune_settings_destroy(struct aob_tune_setting *settings, size_t count)
{
    for (size_t i = 0; i < count; i++)
        free(settings[i].figures);
    free(settings);
}

bool aob_tune_setting_states(const struct aob_tune_setting *setting, const char *name)
{
    for (size_t i = 0; i < setting->value_count; i++)
        if (strcmp(setting->values[i].name, name) == 0)
            return true;
    return false;
}

static void add_axis(struct aob_technique_choice *entry, const char *name, const char *text)
{
    aob_axis_add(&entry->axes, &entry->axis_count, &entry->axis_capacity, name, text);
}

static void add_number(struct aob_technique_choice *entry, const struct aob_param *param, double value)
{
    struct aob_text text = {0};
    aob_param_print(param, value, &text);
    add_axis(entry, param->name, text.data);
    aob_text_finish(&text);
}

/* Fitted, and so written as the fit has it. */
static bool is_moved(const struct aob_tune_setting *setting, const struct aob_technique_info *technique,
                     const char *name)
{
    for (size_t i = 0; i < setting->axes.count; i++)
        if (!setting->idle[i] && strcmp(technique->params[setting->axes.items[i].index].name, name) == 0)
            return true;
    return false;
}

void aob_tune_setting_entry(const struct aob_tune_setting *setting,
                            const struct aob_technique_info *technique, enum aob_tune_side side,
                            double radius, struct aob_technique_choice *entry)
{
    const struct aob_technique_choice *from = setting->from;
    const bool fitted = side == AOB_TUNE_FITTED;
    *entry = (struct aob_technique_choice){.name = from->name, .module = from->module};
    entry->name.text = aob_strdup(from->name.text);
    entry->module.text = aob_strdup(from->module.text);
    entry->file = aob_strdup(from->file);
    for (size_t i = 0; i < from->backends.count; i++)
        AOB_PUSH(entry->backends.names, entry->backends.count, entry->backends.capacity)->text =
            aob_strdup(from->backends.names[i].text);
    for (size_t i = 0; i < setting->value_count; i++)
        if (!fitted || !is_moved(setting, technique, setting->values[i].name))
            add_axis(entry, setting->values[i].name, setting->values[i].text);
    const struct aob_param *own = aob_param_find(technique->params, technique->param_count, "radius");
    if (own && isfinite(radius) && !aob_tune_setting_states(setting, "radius") &&
        !(fitted && is_moved(setting, technique, "radius")))
        add_number(entry, own, radius);
    for (size_t i = 0; fitted && i < setting->axes.count; i++)
        if (!setting->idle[i])
            add_number(entry, &technique->params[setting->axes.items[i].index], setting->fitted[i]);
}

double aob_tune_setting_mean(const struct aob_tune_setting *setting, const struct aob_tune_shown *views,
                             size_t count, bool held_out, enum aob_tune_side side)
{
    double sum = 0;
    size_t known = 0;
    for (size_t v = 0; v < count; v++) {
        const struct aob_tune_figures *f = setting->figures[v];
        if (views[v].held_out != held_out || isnan(f[AOB_TUNE_DEFAULT].error) ||
            isnan(f[AOB_TUNE_FITTED].error))
            continue;
        sum += f[side].error;
        known++;
    }
    return known ? sum / (double)known : NAN;
}
