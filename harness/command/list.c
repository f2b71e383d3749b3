#include <math.h>
#include <string.h>
#include "base/json.h"
#include "base/shelf.h"
#include "budget/budget.h"
#include "command.h"
#include "gpu/gpu.h"
#include "list_scene.h"
#include "profile/profile.h"
#include "technique/option.h"
#include "technique/param.h"

static bool write_document(json_t *document, const char *json, struct aob_error *error)
{
    bool ok = aob_json_write(document, json, error);
    json_decref(document);
    return ok;
}

static json_t *params_to_json(const struct aob_param *params, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, aob_param_to_json(&params[i]));
    return array;
}

static json_t *techniques_to_json(const struct aob_technique_list *list)
{
    json_t *array = json_array();
    for (size_t i = 0; i < list->count; i++)
        json_array_append_new(array, aob_technique_info_to_json(&list->items[i]));
    return json_pack("{s:o, s:o}", "techniques", array, "options",
                     params_to_json(aob_option_params, AOB_OPTION_COUNT));
}

static void print_params(const struct aob_param *params, size_t count, struct aob_text *out)
{
    for (size_t i = 0; i < count; i++) {
        struct aob_text text = {0};
        aob_param_print(&params[i], params[i].initial, &text);
        if (params[i].choices)
            for (int c = 0; params[i].choices[c]; c++)
                aob_text_add(&text, "%s%s", c ? "|" : "  of ", params[i].choices[c]);
        else
            aob_text_add(&text, "%s  in %g .. %g %s",
                         params[i].unit == AOB_UNIT_LENGTH && params[i].initial > 0 ? " m" : "",
                         params[i].min, params[i].max, aob_unit_name(params[i].unit));
        if (aob_param_rule(&params[i]))
            aob_text_add(&text, ", %s", aob_param_rule(&params[i]));
        aob_text_add_line(out, "    %-12s %s", params[i].name, text.data);
        aob_text_add_line(out, "                 %s", params[i].doc);
        aob_text_finish(&text);
    }
}

static void print_techniques(const struct aob_technique_list *list, struct aob_text *out)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct aob_technique_info *t = &list->items[i];
        aob_text_add_line(out, "%s: %s (revision %u%s%s)", t->name, t->title, t->revision,
                          t->module ? ", " : "", t->module ? t->module : "");
        aob_text_add_line(out, "    %s", t->citation);
        if (t->summary)
            aob_text_add_line(out, "    %s", t->summary);
        if (t->notes)
            aob_text_add_line(out, "    Notes: %s", t->notes);
        print_params(t->params, t->param_count, out);
    }
    aob_text_add_line(out, "options of every run");
    print_params(aob_option_params, AOB_OPTION_COUNT, out);
}

static json_t *backends_to_json(const struct aob_dispatch *dispatch)
{
    json_t *array = json_array();
    for (const struct aob_gpu_fns *const *b = aob_gpu_backends; *b; b++) {
        struct aob_error error = {{0}};
        json_t *devices = aob_dispatch_devices(dispatch, (*b)->name, &error);
        json_array_append_new(array,
                              json_pack("{s:s, s:s, s:o, s:s}", "name", (*b)->name, "title", (*b)->title,
                                        "devices", devices ? devices : json_array(), "reason", error.text));
    }
    return json_pack("{s:o}", "backends", array);
}

static const char *text_of(const json_t *object, const char *name)
{
    return json_string_value(json_object_get(object, name));
}

/* One a line; a star before the one that is used. */
static void print_devices(const json_t *devices, struct aob_text *out)
{
    for (size_t i = 0; i < json_array_size(devices); i++) {
        const json_t *d = json_array_get(devices, i);
        bool software = json_is_true(json_object_get(d, "software"));
        const char *lacks = text_of(d, "lacks");
        aob_text_add_line(out, "  %c %zu  %s: %s%s; %s; %s%s%s",
                          json_is_true(json_object_get(d, "chosen")) ? '*' : ' ', i, text_of(d, "name"),
                          text_of(d, "class"), software ? ", software" : "", text_of(d, "driver"),
                          json_is_true(json_object_get(d, "timer")) ? "timer" : "no timer",
                          *lacks ? "; it lacks " : "", lacks);
    }
}

static void print_backends(const json_t *document, struct aob_text *out)
{
    const json_t *array = json_object_get(document, "backends");
    for (size_t i = 0; i < json_array_size(array); i++) {
        const json_t *backend = json_array_get(array, i);
        aob_text_add_line(out, "%-12s %s", text_of(backend, "name"), text_of(backend, "title"));
        print_devices(json_object_get(backend, "devices"), out);
        if (*text_of(backend, "reason"))
            aob_text_add_line(out, "    %s", text_of(backend, "reason"));
    }
}

static bool list_techniques(struct aob_common *common, struct aob_error *error)
{
    struct aob_technique_list list;
    bool ok = aob_dispatch_describe(&common->dispatch, &common->dispatch.modules, &list, error);
    if (ok && common->json)
        ok = write_document(techniques_to_json(&list), common->json, error);
    else if (ok)
        print_techniques(&list, &common->out);
    aob_technique_list_finish(&list);
    return ok;
}

static bool list_backends(struct aob_common *common, struct aob_error *error)
{
    json_t *document = backends_to_json(&common->dispatch);
    if (common->json)
        return write_document(document, common->json, error);
    print_backends(document, &common->out);
    json_decref(document);
    return true;
}

static json_t *profile_to_json(const struct aob_profile *profile)
{
    json_t *facts = json_array();
    for (size_t i = 0; i < profile->fact_count; i++) {
        const struct aob_profile_fact *fact = &profile->facts[i];
        json_array_append_new(facts, json_pack("{s:s, s:s, s:s, s:b}", "key", fact->key, "value", fact->value,
                                               "source", fact->source, "confirmed", fact->confirmed));
    }
    return json_pack("{s:s, s:s, s:s, s:o, s:s}", "name", profile->name, "title", profile->title, "file",
                     profile->path, "facts", facts, "reason", "");
}

static void print_profile(const struct aob_profile *profile, struct aob_text *out)
{
    aob_text_add_line(out, "%s: %s", profile->name, profile->title);
    for (size_t i = 0; i < profile->fact_count; i++) {
        const struct aob_profile_fact *fact = &profile->facts[i];
        aob_text_add_line(out, "    %-20s %-12s %-10s %s", fact->key, fact->value,
                          fact->confirmed ? "confirmed" : "unverified", fact->source);
    }
}

/* One that cannot be read says why in place of its numbers, as a backend without a device does. */
static void add_profile(const char *name, json_t *array, struct aob_text *out)
{
    struct aob_profile profile;
    struct aob_error error = {{0}};
    if (aob_profile_find(&profile, name, &error)) {
        json_array_append_new(array, profile_to_json(&profile));
        print_profile(&profile, out);
        aob_profile_finish(&profile);
        return;
    }
    json_array_append_new(array, json_pack("{s:s, s:n, s:n, s:[], s:s}", "name", name, "title", "file",
                                           "facts", "reason", error.text));
    aob_text_add_line(out, "%s: cannot be used", name);
    aob_text_add_line(out, "    %s", error.text);
}

static bool list_profiles(struct aob_common *common, struct aob_error *error)
{
    struct aob_shelf_names names;
    struct aob_text out = {0};
    if (!aob_shelf_list(AOB_PROFILE_SHELF, &names, error))
        return false;
    json_t *array = json_array();
    for (size_t i = 0; i < names.count; i++)
        add_profile(names.items[i], array, common->json ? &out : &common->out);
    aob_shelf_names_finish(&names);
    aob_text_finish(&out);
    json_t *document = json_pack("{s:o}", "profiles", array);
    if (common->json)
        return write_document(document, common->json, error);
    json_decref(document);
    return true;
}

static void print_budget(const struct aob_budget *budget, struct aob_text *out)
{
    aob_text_add_line(out, "%s: %s", budget->name, budget->title);
    aob_text_add(out, "    frame %g ms", budget->frame_ms);
    if (budget->rest_ms > 0)
        aob_text_add(out, ", rest %g ms", budget->rest_ms);
    if (isfinite(budget->ao_ms))
        aob_text_add(out, ", ambient occlusion %g ms", budget->ao_ms);
    if (budget->width)
        aob_text_add(out, ", %dx%d", budget->width, budget->height);
    aob_text_add_line(out, "%s%s", budget->device ? ", modelled on " : "",
                      budget->device ? budget->device : "");
    aob_text_add_line(out, "    %s", budget->source);
}

static bool list_budgets(struct aob_common *common, struct aob_error *error)
{
    struct aob_shelf_names names;
    json_t *array = json_array();
    bool ok = aob_shelf_list(AOB_BUDGET_SHELF, &names, error);
    for (size_t i = 0; ok && i < names.count; i++) {
        struct aob_budget budget;
        ok = aob_budget_find(&budget, names.items[i], error);
        if (ok && common->json)
            json_array_append_new(array, aob_budget_to_json(&budget));
        else if (ok)
            print_budget(&budget, &common->out);
        if (ok)
            aob_budget_finish(&budget);
    }
    aob_shelf_names_finish(&names);
    json_t *document = json_pack("{s:o}", "budgets", array);
    if (ok && common->json)
        return write_document(document, common->json, error);
    json_decref(document);
    return ok;
}

/* What can be listed. */
static const struct listed {
    const char *name;
    bool (*print)(struct aob_common *common, struct aob_error *error);
} lists[] = {{"techniques", list_techniques},
             {"scenes", aob_list_scenes},
             {"backends", list_backends},
             {"profiles", list_profiles},
             {"budgets", list_budgets},
             {"lights", aob_list_lights},
             {0}};

static enum aob_exit list(void *options, struct aob_error *error)
{
    struct aob_common *common = options;
    const char *what = common->words.items[0];
    const struct listed *listed = lists;
    while (listed->name && strcmp(listed->name, what) != 0)
        listed++;
    if (!listed->name)
        return aob_fail(error,
                        "list: '%s' is not one of techniques, scenes, lights, backends, profiles, budgets",
                        what),
               AOB_EXIT_USAGE;
    return listed->print(common, error) ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_command aob_command_list = {
    .name = "list",
    .help = "what there is: techniques, scenes, lights, backends, profiles, budgets",
    .usage = "techniques|scenes|lights|backends|profiles|budgets [--device NAME|N] [--json FILE]",
    .summary = "What there is, with parameters, units, bounds, geometry and light.",
    .modules = true,
    .devices = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct aob_common),
    .run = list,
};
