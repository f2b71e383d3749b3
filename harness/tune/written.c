#include "written.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/shelf.h"
#include "config/yaml.h"
#include "technique/param.h"

/* A stretch of the config's text with what stands in its place. */
struct patch {
    size_t from, to;
    struct aob_text text;
};
enum { PATCHES = 3 };

char *aob_tune_written_path(const char *config, const char *technique)
{
    const char *slash = strrchr(config, '/'), *dot = strrchr(config, '.');
    size_t stem = dot && (!slash || dot > slash + 1) ? (size_t)(dot - config) : strlen(config);
    struct aob_text text = {0};
    aob_text_add(&text, "%.*s-%s.yaml", (int)stem, config, technique);
    return text.data;
}

/* A path that is seen from the config's folder; NULL: all mean the same everywhere. */
static const char *find_path(const struct aob_config *config)
{
    for (size_t i = 0; i < config->scene_count; i++) {
        const struct aob_scene_choice *scene = &config->scenes[i];
        if (scene->given && *scene->given != '/')
            return scene->given;
        if (scene->light && scene->is_probe && *scene->light != '/')
            return scene->light;
    }
    for (size_t i = 0; i < config->technique_count; i++)
        if (config->techniques[i].file && *config->techniques[i].module.text != '/')
            return config->techniques[i].module.text;
    for (size_t i = 0; i < config->profile_count; i++)
        if (aob_shelf_is_path(config->profiles[i].text) && *config->profiles[i].text != '/')
            return config->profiles[i].text;
    const char *budget = config->budget.text;
    return budget && aob_shelf_is_path(budget) && *budget != '/' ? budget : NULL;
}

static char *folder_of(const char *path)
{
    char *beside = aob_path_beside(path, "."), *folder = realpath(beside, NULL);
    free(beside);
    return folder;
}

static bool same_folder(const char *a, const char *b)
{
    char *p = folder_of(a), *q = folder_of(b);
    bool same = p && q && strcmp(p, q) == 0;
    free(p);
    free(q);
    return same;
}

/* Patches are of keys that stand on lines of their own. */
static bool judge_root(const struct aob_config *config, struct aob_error *error)
{
    struct aob_yaml yaml;
    if (!aob_yaml_load(&yaml, config->path, config->text, config->size, error))
        return false;
    const bool flow =
        yaml_document_get_root_node(&yaml.document)->data.mapping.style == YAML_FLOW_MAPPING_STYLE;
    aob_yaml_finish(&yaml);
    return !flow ||
           aob_fail(error,
                    "%s: it is written in braces, and a fit is written into keys on lines of their own: put "
                    "name, scenes and techniques there",
                    config->path);
}

bool aob_tune_written_check(const struct aob_tune_desc *desc, const char *path, struct aob_error *error)
{
    struct aob_config config;
    if (aob_file_exists(path))
        return aob_fail(
            error, "%s: it exists, and a fit replaces no config: remove it, or give another --out", path);
    if (!aob_config_read(&config, desc->config, error))
        return false;
    const char *seen = find_path(&config);
    bool ok = judge_root(&config, error);
    ok = ok &&
         (!seen || same_folder(desc->config, path) ||
          aob_fail(error, "%s: %s names '%s', which is seen from its own folder: give --out a file there",
                   path, desc->config, seen));
    aob_config_finish(&config);
    return ok && aob_file_check(path, error);
}

static void add_quoted(const char *text, struct aob_text *into)
{
    aob_text_add(into, "\"");
    for (; *text; text++)
        aob_text_add(into, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    aob_text_add(into, "\"");
}

static void add_values(const struct aob_axis *axis, struct aob_text *into)
{
    for (size_t v = 0; v < axis->count; v++) {
        aob_text_add(into, v ? ", " : "");
        add_quoted(axis->values[v].text, into);
    }
}

static void add_axes(const struct aob_technique_choice *entry, bool sweep, struct aob_text *into)
{
    const char *between = "";
    for (size_t i = 0; i < entry->axis_count; i++) {
        const struct aob_axis *axis = &entry->axes[i];
        if ((axis->count > 1) != sweep)
            continue;
        aob_text_add(into, sweep ? "%s{param: %s, values: [" : "%s%s: ", between, axis->name);
        add_values(axis, into);
        aob_text_add(into, sweep ? "]}" : "");
        between = ", ";
    }
}

static bool sweeps(const struct aob_technique_choice *entry)
{
    for (size_t i = 0; i < entry->axis_count; i++)
        if (entry->axes[i].count > 1)
            return true;
    return false;
}

static void add_entry(const struct aob_technique_choice *entry, struct aob_text *into)
{
    aob_text_add(into, "  - {name: %s", entry->name.text);
    if (entry->module.text) {
        aob_text_add(into, ", module: ");
        add_quoted(entry->module.text, into);
    }
    for (size_t i = 0; i < entry->backends.count; i++)
        aob_text_add(into, "%s\"%s\"", i ? ", " : ", backends: [", entry->backends.names[i].text);
    aob_text_add(into, "%s, params: {", entry->backends.count ? "]" : "");
    add_axes(entry, false, into);
    aob_text_add(into, "}");
    if (sweeps(entry)) {
        aob_text_add(into, ", sweep: [");
        add_axes(entry, true, into);
        aob_text_add(into, "]");
    }
    aob_text_add(into, "}\n");
}

/* The entries of other techniques keep what they are, and their place before those of the fit. */
static void add_techniques(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                           const struct aob_config *config, struct aob_text *into)
{
    const struct aob_tune_setting *setting = &tune->settings[tune->chosen];
    aob_text_add(into, "\n");
    for (size_t i = 0; i < config->technique_count; i++)
        if (strcmp(config->techniques[i].name.text, desc->technique) != 0)
            add_entry(&config->techniques[i], into);
    for (int side = 0; side < AOB_TUNE_SIDES; side++) {
        struct aob_technique_choice entry;
        aob_tune_setting_entry(setting, tune->technique, (enum aob_tune_side)side, tune->target.radius,
                               &entry);
        aob_text_add(into, "  # %s, by `aobudget tune`\n", side ? "the fit" : "without the fit");
        add_entry(&entry, into);
        aob_technique_choice_finish(&entry);
    }
}

static void add_target(const struct aob_target *target, struct aob_text *into)
{
    static const struct aob_param radius = {.type = AOB_FLOAT, .min = 0, .max = INFINITY};
    aob_text_add(into, "{radius: ");
    if (isinf(target->radius))
        aob_text_add(into, "inf");
    else
        aob_param_print(&radius, target->radius, into);
    aob_text_add(into, ", weighting: %s}", target->uniform ? "uniform" : "cosine");
}

/* The end of the last thing that a node holds. That of a block list is where the next key begins, behind comments which are none of it. */
static size_t end_of(yaml_document_t *document, const yaml_node_t *node)
{
    size_t end = node->start_mark.index;
    if (node->type == YAML_SCALAR_NODE ||
        (node->type == YAML_MAPPING_NODE && node->data.mapping.style == YAML_FLOW_MAPPING_STYLE) ||
        (node->type == YAML_SEQUENCE_NODE && node->data.sequence.style == YAML_FLOW_SEQUENCE_STYLE))
        return node->end_mark.index;
    if (node->type == YAML_SEQUENCE_NODE)
        for (const yaml_node_item_t *i = node->data.sequence.items.start; i < node->data.sequence.items.top;
             i++) {
            size_t at = end_of(document, yaml_document_get_node(document, *i));
            end = at > end ? at : end;
        }
    if (node->type == YAML_MAPPING_NODE)
        for (const yaml_node_pair_t *p = node->data.mapping.pairs.start; p < node->data.mapping.pairs.top;
             p++) {
            size_t at = end_of(document, yaml_document_get_node(document, p->value));
            end = at > end ? at : end;
        }
    return end;
}

static struct patch patch_of(struct aob_yaml *yaml, const yaml_node_t *node)
{
    return (struct patch){.from = node->start_mark.index, .to = end_of(&yaml->document, node)};
}

/* libyaml counts characters where a file counts bytes. */
static size_t byte_of(const char *text, size_t character)
{
    size_t byte = 0;
    while (character && text[byte]) {
        do
            byte++;
        while (((unsigned char)text[byte] & 0xc0) == 0x80);
        character--;
    }
    return byte;
}

static void add_patched(const struct aob_config *config, struct patch *patches, size_t count,
                        struct aob_text *into)
{
    size_t at = 0;
    for (;;) {
        struct patch *next = NULL;
        for (size_t i = 0; i < count; i++)
            if (patches[i].text.data && (!next || patches[i].from < next->from))
                next = &patches[i];
        if (!next)
            break;
        size_t from = byte_of(config->text, next->from);
        aob_text_add_bytes(into, config->text + at, from - at);
        aob_text_add_bytes(into, next->text.data, next->text.size);
        at = byte_of(config->text, next->to);
        aob_text_finish(&next->text);
    }
    aob_text_add_bytes(into, config->text + at, config->size - at);
}

/* Name, techniques and target of the root, in the text of the config. */
static bool compose(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                    const struct aob_config *config, struct aob_text *into, struct aob_error *error)
{
    struct aob_yaml yaml;
    struct patch patches[PATCHES] = {{.from = 0}};
    if (!aob_yaml_load(&yaml, config->path, config->text, config->size, error))
        return false;
    const yaml_node_t *root = yaml_document_get_root_node(&yaml.document),
                      *name = aob_yaml_find(&yaml, root, "name"),
                      *techniques = aob_yaml_find(&yaml, root, "techniques"),
                      *target = aob_yaml_find(&yaml, root, "target");
    if (name && techniques) {
        patches[0] = patch_of(&yaml, name);
        aob_text_add(&patches[0].text, "%s-%s", config->name, desc->technique);
        patches[1] = patch_of(&yaml, techniques);
        add_techniques(desc, tune, config, &patches[1].text);
        patches[2] = target ? patch_of(&yaml, target) : (struct patch){.from = SIZE_MAX, .to = SIZE_MAX};
        aob_text_add(&patches[2].text, target ? "" : "\ntarget: ");
        add_target(&tune->target, &patches[2].text);
        aob_text_add(into, "# Written by `aobudget tune %s` from %s.\n", desc->technique, desc->config);
        add_patched(config, patches, PATCHES, into);
        aob_text_add(into, "\n");
    }
    aob_yaml_finish(&yaml);
    return true;
}

/* What no patch foresees, such as an alias in the list of techniques, makes another config of it. */
static bool judge_text(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                       const struct aob_text *text, struct aob_error *error)
{
    struct aob_config config;
    char *path = aob_path_join(desc->folder, "written.yaml");
    bool wrote = aob_file_write(path, text->data, text->size, error),
         ok = wrote && aob_config_read_copy(&config, path, desc->config, NULL);
    free(path);
    if (ok) {
        size_t own = 0;
        for (size_t i = 0; i < config.technique_count; i++)
            own += strcmp(config.techniques[i].name.text, desc->technique) == 0;
        ok = own == AOB_TUNE_SIDES && config.target_count == 1 &&
             config.targets[0].radius == tune->target.radius;
        aob_config_finish(&config);
    }
    if (!wrote)
        return false;
    return ok ||
           aob_fail(error,
                    "%s: a fit cannot be written into it: write its name, target and techniques without "
                    "anchors and aliases",
                    desc->config);
}

bool aob_tune_written_save(const struct aob_tune_desc *desc, const struct aob_tune *tune, const char *path,
                           struct aob_error *error)
{
    struct aob_config config;
    struct aob_text text = {0};
    if (!aob_config_read(&config, desc->config, error))
        return false;
    bool ok = compose(desc, tune, &config, &text, error) && judge_text(desc, tune, &text, error) &&
              aob_file_write(path, text.data, text.size, error);
    aob_text_finish(&text);
    aob_config_finish(&config);
    return ok;
}
