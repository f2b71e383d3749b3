#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "graph.h"
#include "registry.h"

static json_t *choices_to_json(const char *const *choices)
{
    json_t *names = json_array();
    for (; *choices; choices++)
        json_array_append_new(names, json_string(*choices));
    return names;
}

/* The words of the enums, in their order. */
static const char *const unit_words[] = {"none", "scene_units", "pixels", "radians", "count", NULL};
static const char *const scale_words[] = {"linear", "log2", NULL};
static const char *const stage_words[] = {"uniform", "constant", "host", NULL};
static const char *const rule_words[] = {"any", "odd", "power_of_two", NULL};
static const char *const sequence_words[] = {"none", "stratified", "independent", NULL};

static int word_index(const char *const *words, const char *word)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(words[i], word) == 0)
            return i;
    return -1;
}

json_t *aob_param_to_json(const struct aob_param *param)
{
    json_t *p = json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:f, s:f, s:f}", "name", param->name, "doc",
                          param->doc, "type", param->type == AOB_INT ? "int" : "float", "unit",
                          unit_words[param->unit], "scale", scale_words[param->scale], "stage",
                          stage_words[param->stage], "rule", rule_words[param->rule], "min", param->min,
                          "max", param->max, "initial", param->initial);
    if (param->choices)
        json_object_set_new(p, "choices", choices_to_json(param->choices));
    if (param->output)
        json_object_set_new(p, "output", json_string(aob_output_name((enum aob_output)param->output)));
    return p;
}

json_t *aob_technique_info_to_json(const struct aob_technique_info *info)
{
    json_t *params = json_array();
    for (size_t i = 0; i < info->param_count; i++)
        json_array_append_new(params, aob_param_to_json(&info->params[i]));
    return json_pack("{s:s, s:s, s:s, s:s?, s:s?, s:i, s:s, s:s?, s:s?, s:s, s:o}", "name", info->name,
                     "title", info->title, "citation", info->citation, "summary", info->summary, "notes",
                     info->notes, "revision", (int)info->revision, "digest", info->digest, "module",
                     info->module, "sampling", info->sampling, "sequence", sequence_words[info->sequence],
                     "params", params);
}

json_t *aob_technique_to_json(const struct aob_registry_entry *entry)
{
    const struct aob_technique *t = entry->technique;
    struct aob_technique_info info = {.name = (char *)(uintptr_t)t->name,
                                      .title = (char *)(uintptr_t)t->title,
                                      .citation = (char *)(uintptr_t)t->citation,
                                      .summary = (char *)(uintptr_t)t->summary,
                                      .notes = (char *)(uintptr_t)t->notes,
                                      .module = (char *)(uintptr_t)entry->module,
                                      .sampling = (char *)(uintptr_t)t->sampling.param,
                                      .sequence = t->sampling.sequence,
                                      .revision = t->revision,
                                      .params = (struct aob_param *)(uintptr_t)t->params,
                                      .param_count = t->param_count};
    memcpy(info.digest, entry->digest, sizeof info.digest);
    return aob_technique_info_to_json(&info);
}

static const char *const *choices_from_json(const json_t *names)
{
    const char **choices = AOB_NEW_ARRAY(const char *, json_array_size(names) + 1);
    for (size_t i = 0; i < json_array_size(names); i++)
        choices[i] = aob_strdup(json_string_value(json_array_get(names, i)));
    return choices;
}

static bool param_from_json(json_t *p, struct aob_param *param)
{
    const char *name, *doc, *type, *unit, *scale, *stage, *rule;
    if (json_unpack(p, "{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:F, s:F, s:F}", "name", &name, "doc", &doc,
                    "type", &type, "unit", &unit, "scale", &scale, "stage", &stage, "rule", &rule, "min",
                    &param->min, "max", &param->max, "initial", &param->initial) != 0)
        return false;
    if (word_index(unit_words, unit) < 0 || word_index(scale_words, scale) < 0 ||
        word_index(stage_words, stage) < 0 || word_index(rule_words, rule) < 0)
        return false;
    param->name = aob_strdup(name);
    param->doc = aob_strdup(doc);
    param->type = strcmp(type, "int") == 0 ? AOB_INT : AOB_FLOAT;
    param->unit = (enum aob_unit)word_index(unit_words, unit);
    param->scale = (enum aob_scale)word_index(scale_words, scale);
    param->stage = (enum aob_stage)word_index(stage_words, stage);
    param->rule = (enum aob_rule)word_index(rule_words, rule);
    if (json_object_get(p, "choices"))
        param->choices = choices_from_json(json_object_get(p, "choices"));
    const char *output = json_string_value(json_object_get(p, "output"));
    while (output && param->output < AOB_OUTPUT_COUNT &&
           strcmp(output, aob_output_name((enum aob_output)param->output)) != 0)
        param->output++;
    return param->output < AOB_OUTPUT_COUNT;
}

static const char *optional(const json_t *described, const char *name)
{
    return json_string_value(json_object_get(described, name));
}

bool aob_technique_list_add(struct aob_technique_list *list, const json_t *described)
{
    const char *name, *title, *citation, *digest, *sequence;
    int revision;
    json_t *params;
    if (json_unpack((json_t *)(uintptr_t)described, "{s:s, s:s, s:s, s:i, s:s, s:s, s:o}", "name", &name,
                    "title", &title, "citation", &citation, "revision", &revision, "digest", &digest,
                    "sequence", &sequence, "params", &params) != 0 ||
        word_index(sequence_words, sequence) < 0)
        return false;
    list->items = aob_realloc(list->items, list->count + 1, sizeof *list->items);
    struct aob_technique_info *info = &list->items[list->count++];
    *info = (struct aob_technique_info){.name = aob_strdup(name),
                                        .title = aob_strdup(title),
                                        .citation = aob_strdup(citation),
                                        .summary = aob_strdup(optional(described, "summary")),
                                        .notes = aob_strdup(optional(described, "notes")),
                                        .module = aob_strdup(optional(described, "module")),
                                        .file = aob_strdup(optional(described, "module")),
                                        .offered = true,
                                        .sampling = aob_strdup(optional(described, "sampling")),
                                        .sequence = (enum aob_sequence)word_index(sequence_words, sequence),
                                        .revision = (uint32_t)revision};
    strncpy(info->digest, digest, AOB_KEY_SIZE - 1);
    info->param_count = json_array_size(params);
    info->params = AOB_NEW_ARRAY(struct aob_param, info->param_count);
    for (size_t i = 0; i < info->param_count; i++)
        if (!param_from_json(json_array_get(params, i), &info->params[i]))
            return false;
    return true;
}

static bool is_of(const struct aob_technique_info *info, const char *module)
{
    return info->module && strcmp(info->module, module) == 0;
}

static void fail_in_module(const struct aob_technique_list *list, const char *module, const char *name,
                           struct aob_error *error)
{
    struct aob_text has = {0};
    for (size_t i = 0; i < list->count; i++)
        if (is_of(&list->items[i], module))
            aob_text_add(&has, "%s%s", has.size ? ", " : "", list->items[i].name);
    aob_fail(error, "%s has no technique '%s'; it has %s", module, name, has.data);
    aob_text_finish(&has);
}

static const struct aob_technique_info *find_in_module(const struct aob_technique_list *list,
                                                       const char *module, const char *name,
                                                       struct aob_error *error)
{
    for (size_t i = 0; i < list->count; i++)
        if (is_of(&list->items[i], module) && strcmp(list->items[i].name, name) == 0)
            return &list->items[i];
    fail_in_module(list, module, name, error);
    return NULL;
}

static const struct aob_technique_info *
fail_between(const struct aob_technique_info *a, const struct aob_technique_info *b, struct aob_error *error)
{
    aob_fail(error,
             "technique '%s' is in %s and in %s: load one of them, or write module: FILE.so beside its name",
             a->name, a->module, b->module);
    return NULL;
}

static void fail_unknown(const struct aob_technique_info *elsewhere, const char *name,
                         struct aob_error *error)
{
    if (elsewhere)
        aob_fail(error, "unknown technique '%s' without a module; write module: %s beside its name", name,
                 elsewhere->module);
    else
        aob_fail(error, "unknown technique '%s'; see: aobudget list techniques", name);
}

const struct aob_technique_info *aob_technique_list_find(const struct aob_technique_list *list,
                                                         const char *module, const char *name,
                                                         struct aob_error *error)
{
    const struct aob_technique_info *found = NULL, *elsewhere = NULL;
    if (module)
        return find_in_module(list, module, name, error);
    for (size_t i = 0; i < list->count; i++) {
        const struct aob_technique_info *info = &list->items[i];
        if (strcmp(info->name, name) != 0)
            continue;
        if (!info->offered)
            elsewhere = info;
        else if (!found || !found->module) /* the built-in one comes first */
            found = info;
        else if (strcmp(found->digest, info->digest) != 0) /* else two names of one build */
            return fail_between(found, info, error);
    }
    if (!found)
        fail_unknown(elsewhere, name, error);
    return found;
}

struct aob_address aob_technique_address(const struct aob_technique_info *info)
{
    return (struct aob_address){.technique = info->name, .module = info->file, .digest = info->digest};
}

static void free_param(struct aob_param *param)
{
    for (size_t i = 0; param->choices && param->choices[i]; i++)
        free((void *)(uintptr_t)param->choices[i]);
    free((void *)(uintptr_t)param->choices);
    free((void *)(uintptr_t)param->name);
    free((void *)(uintptr_t)param->doc);
}

void aob_technique_list_finish(struct aob_technique_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        struct aob_technique_info *info = &list->items[i];
        for (size_t p = 0; p < info->param_count; p++)
            free_param(&info->params[p]);
        free(info->params);
        free(info->name);
        free(info->title);
        free(info->citation);
        free(info->summary);
        free(info->notes);
        free(info->module);
        free(info->file);
        free(info->sampling);
    }
    free(list->items);
    *list = (struct aob_technique_list){0};
}
