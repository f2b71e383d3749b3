#include "config.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "config_scene.h"
#include "config_size.h"
#include "config_target.h"
#include "yaml.h"

void aob_config_init(struct aob_config *config)
{
    *config = (struct aob_config){.measure_time = true,
                                  .measure_error = true,
                                  .images = true,
                                  .seconds = 1.5,
                                  .precision = 0.03,
                                  .spp = 256,
                                  .thickness = -1};
}

bool aob_config_fail_at(const struct aob_config *config, int line, int column, struct aob_error *error)
{
    if (!config->path)
        return false;
    return line ? aob_fail_in(error, "%s:%d:%d", config->path, line, column)
                : aob_fail_in(error, "%s", config->path);
}

bool aob_config_parse_precision(const char *text, double *precision, struct aob_error *error)
{
    double share;
    if (!aob_parse_percent(text, &share) || !(share >= AOB_CONFIG_MIN_PRECISION) ||
        share > AOB_CONFIG_MAX_PRECISION)
        return aob_fail(error, "'%s' is no precision: write a percentage, such as 3%%, within %g%% .. %g%%",
                        text, 100 * AOB_CONFIG_MIN_PRECISION, 100 * AOB_CONFIG_MAX_PRECISION);
    *precision = share;
    return true;
}

void aob_axis_add(struct aob_axis **axes, size_t *count, size_t *capacity, const char *name,
                  const char *value)
{
    struct aob_axis *axis = AOB_PUSH(*axes, *count, *capacity);
    axis->name = aob_strdup(name);
    axis->values = AOB_NEW(struct aob_value);
    axis->values->text = aob_strdup(value);
    axis->count = 1;
}

struct axis_reader { /* one axis while it is read */
    struct aob_axis *axis;
    size_t capacity;
    double from, to, step, log2;
    const yaml_node_t *node;
};

static bool add_axis_value(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    struct axis_reader *reader = user;
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    *AOB_PUSH(reader->axis->values, reader->axis->count, reader->capacity) = aob_yaml_value(node, text);
    return true;
}

static bool read_axis_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct axis_reader *reader = user;
    const char *text;
    if (strcmp(key, "param") == 0) {
        if (!aob_yaml_text(yaml, node, &text))
            return false;
        reader->axis->name = aob_strdup(text);
        return true;
    }
    if (strcmp(key, "values") == 0)
        return aob_yaml_sequence(yaml, node, add_axis_value, reader);
    double *into = strcmp(key, "from") == 0   ? &reader->from
                   : strcmp(key, "to") == 0   ? &reader->to
                   : strcmp(key, "step") == 0 ? &reader->step
                                              : &reader->log2;
    return aob_yaml_number(yaml, node, into == &reader->step || into == &reader->log2 ? 1e-9 : -1e12, 1e12,
                           into);
}

static bool expand_range(struct aob_yaml *yaml, struct axis_reader *reader)
{
    bool linear = !isnan(reader->step), log = !isnan(reader->log2);
    if (isnan(reader->from) || isnan(reader->to) || linear == log)
        return aob_yaml_fail(yaml, reader->node,
                             "an axis needs values, or from and to with one of step and log2");
    if (reader->to < reader->from || (log && reader->from <= 0))
        return aob_yaml_fail(yaml, reader->node,
                             "the range is empty: from must not exceed to (and log2 needs from > 0)");
    double factor = log ? exp2(reader->log2) : 1, value = reader->from;
    for (int i = 0; value <= reader->to * (1 + 1e-9) + 1e-12; i++) {
        char text[32];
        if (i == 1000)
            return aob_yaml_fail(yaml, reader->node, "the range has more than 1000 values");
        snprintf(text, sizeof text, "%.9g", value);
        *AOB_PUSH(reader->axis->values, reader->axis->count, reader->capacity) =
            aob_yaml_value(reader->node, text);
        value = log ? reader->from * pow(factor, i + 1) : reader->from + reader->step * (i + 1);
    }
    return true;
}

static bool read_sweep_axis(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    static const char *const keys[] = {"param", "values", "from", "to", "step", "log2", NULL};
    struct aob_technique_choice *choice = user;
    struct aob_axis *axis = AOB_PUSH(choice->axes, choice->axis_count, choice->axis_capacity);
    axis->line = (int)node->start_mark.line + 1;
    axis->column = (int)node->start_mark.column + 1;
    struct axis_reader reader = {
        .axis = axis, .from = NAN, .to = NAN, .step = NAN, .log2 = NAN, .node = node};
    if (!aob_yaml_mapping(yaml, node, keys, read_axis_entry, &reader))
        return false;
    if (!axis->name)
        return aob_yaml_fail(yaml, node, "an axis needs param: NAME");
    bool range = !isnan(reader.from) || !isnan(reader.to) || !isnan(reader.step) || !isnan(reader.log2);
    if (axis->count && range)
        return aob_yaml_fail(yaml, node, "give values or a range, not both");
    return axis->count || expand_range(yaml, &reader);
}

struct axes { /* a mapping of name: value or name: [values] */
    struct aob_axis **items;
    size_t *count, *capacity;
};

static bool read_named_axis(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct axes *axes = user;
    struct aob_axis *axis = AOB_PUSH(*axes->items, *axes->count, *axes->capacity);
    axis->name = aob_strdup(key);
    axis->line = (int)node->start_mark.line + 1;
    axis->column = (int)node->start_mark.column + 1;
    struct axis_reader reader = {.axis = axis};
    return aob_yaml_sequence(yaml, node, add_axis_value, &reader) &&
           (axis->count || aob_yaml_fail(yaml, node, "'%s' has no value", key));
}

static bool read_backend(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    struct aob_backend_choice *choice = user;
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    *AOB_PUSH(choice->names, choice->count, choice->capacity) = aob_yaml_value(node, text);
    return true;
}

static bool read_module(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_technique_choice *choice)
{
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    choice->module = aob_yaml_value(node, text);
    return true;
}

static bool read_technique_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct aob_technique_choice *choice = user;
    const char *text;
    if (strcmp(key, "name") == 0) {
        if (!aob_yaml_text(yaml, node, &text))
            return false;
        choice->name = aob_yaml_value(node, text);
        return true;
    }
    if (strcmp(key, "module") == 0)
        return read_module(yaml, node, choice);
    if (strcmp(key, "backends") == 0)
        return aob_yaml_sequence(yaml, node, read_backend, &choice->backends) &&
               (choice->backends.count || aob_yaml_fail(yaml, node, "the list of backends is empty"));
    struct axes axes = {&choice->axes, &choice->axis_count, &choice->axis_capacity};
    if (strcmp(key, "params") == 0)
        return aob_yaml_mapping(yaml, node, NULL, read_named_axis, &axes);
    return aob_yaml_sequence(yaml, node, read_sweep_axis, choice);
}

static bool read_technique(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    static const char *const keys[] = {"name", "module", "backends", "params", "sweep", NULL};
    struct aob_config *config = user;
    struct aob_technique_choice *choice =
        AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity);
    bool ok = aob_yaml_mapping(yaml, node, keys, read_technique_entry, choice) &&
              (choice->name.text || aob_yaml_fail(yaml, node, "a technique needs name: NAME"));
    if (choice->module.text)
        choice->file = aob_path_beside(config->place, choice->module.text);
    return ok;
}

static bool read_size(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    struct aob_config *config = user;
    struct aob_size *size = AOB_PUSH(config->sizes, config->size_count, config->size_capacity);
    const char *text;
    size->line = (int)node->start_mark.line + 1;
    size->column = (int)node->start_mark.column + 1;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    return aob_parse_size(text, &size->width, &size->height) ||
           aob_yaml_fail(yaml, node, "'%s' is not WIDTHxHEIGHT with 1 .. 16384 pixels each", text);
}

static bool read_precision(struct aob_yaml *yaml, yaml_node_t *node, double *precision)
{
    struct aob_error why = {{0}};
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    return aob_config_parse_precision(text, precision, &why) || aob_yaml_fail(yaml, node, "%s", why.text);
}

static bool read_profile(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    struct aob_config *config = user;
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    *AOB_PUSH(config->profiles, config->profile_count, config->profile_capacity) = aob_yaml_value(node, text);
    return true;
}

static bool read_measure_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct aob_config *config = user;
    if (strcmp(key, "seconds") == 0)
        return aob_yaml_number(yaml, node, 0.01, 3600, &config->seconds);
    if (strcmp(key, "precision") == 0)
        return read_precision(yaml, node, &config->precision);
    if (strcmp(key, "cache") == 0)
        return aob_yaml_sequence(yaml, node, read_profile, config) &&
               (config->profile_count || aob_yaml_fail(yaml, node, "the list of profiles is empty"));
    bool *into = strcmp(key, "time") == 0    ? &config->measure_time
                 : strcmp(key, "error") == 0 ? &config->measure_error
                                             : &config->images;
    return aob_yaml_bool(yaml, node, into);
}

static bool read_reference_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct aob_config *config = user;
    double spp;
    if (strcmp(key, "thickness") == 0)
        return aob_yaml_number(yaml, node, 0, INFINITY, &config->thickness);
    if (!aob_yaml_number(yaml, node, 2, 65536, &spp))
        return false;
    config->spp = (int)spp;
    return (spp == config->spp && config->spp % 2 == 0) ||
           aob_yaml_fail(yaml, node, "spp must be an even whole number: it is traced as two halves");
}

/* `radius` was a key here; whoever has it in a config is told the word that it has now. */
static bool read_reference(struct aob_yaml *yaml, yaml_node_t *node, struct aob_config *config)
{
    static const char *const keys[] = {"spp", "thickness", NULL};
    const yaml_node_t *radius = aob_yaml_find(yaml, node, "radius");
    if (radius)
        return aob_yaml_fail(yaml, radius,
                             "reference has no radius any more: write target: {radius: R} beside it");
    return aob_yaml_mapping(yaml, node, keys, read_reference_entry, config);
}

static bool read_name(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_config *config)
{
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    if (strlen(text) > 60 ||
        strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") != strlen(text))
        return aob_yaml_fail(yaml, node, "a name is at most 60 letters, digits, - and _");
    config->name = aob_strdup(text);
    return true;
}

static bool read_budget(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_config *config)
{
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    config->budget = aob_yaml_value(node, text);
    return true;
}

/* What `run` plans by itself. */
static bool read_effects(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_config *config)
{
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    config->effects = aob_yaml_value(node, text);
    return strcmp(text, "auto") == 0 || aob_yaml_fail(yaml, node, "'%s' is not auto", text);
}

static bool read_config_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    static const char *const measure_keys[] = {"time",      "error", "images", "seconds",
                                               "precision", "cache", NULL};
    struct aob_config *config = user;
    struct axes options = {&config->options, &config->option_count, &config->option_capacity};
    if (strcmp(key, "name") == 0)
        return read_name(yaml, node, config);
    if (strcmp(key, "scenes") == 0)
        return aob_yaml_sequence(yaml, node, aob_config_read_scene, config);
    if (strcmp(key, "resolutions") == 0)
        return aob_yaml_sequence(yaml, node, read_size, config);
    if (strcmp(key, "backends") == 0)
        return aob_yaml_sequence(yaml, node, read_backend, &config->backends);
    if (strcmp(key, "options") == 0)
        return aob_yaml_mapping(yaml, node, NULL, read_named_axis, &options);
    if (strcmp(key, "techniques") == 0)
        return aob_yaml_sequence(yaml, node, read_technique, config);
    if (strcmp(key, "measure") == 0)
        return aob_yaml_mapping(yaml, node, measure_keys, read_measure_entry, config);
    if (strcmp(key, "budget") == 0)
        return read_budget(yaml, node, config);
    if (strcmp(key, "effects") == 0)
        return read_effects(yaml, node, config);
    if (strcmp(key, "target") == 0)
        return aob_yaml_sequence(yaml, node, aob_config_read_target, config) &&
               (config->target_count || aob_yaml_fail(yaml, node, "the list of targets is empty"));
    return read_reference(yaml, node, config);
}

static bool judge_config(const struct aob_config *config, struct aob_error *error)
{
    bool sized = true, placed = true; /* a capture has its own size, a technique may have its own backends */
    for (size_t i = 0; i < config->scene_count; i++)
        sized = sized && config->scenes[i].capture;
    for (size_t i = 0; i < config->technique_count; i++)
        placed = placed && config->techniques[i].backends.count;
    const char *missing = !config->name                        ? "name"
                          : !config->scene_count               ? "scenes"
                          : !config->size_count && !sized      ? "resolutions"
                          : !config->technique_count           ? "techniques"
                          : !config->backends.count && !placed ? "backends"
                                                               : NULL;
    return !missing || aob_fail(error, "%s: '%s' is missing or empty", config->path, missing);
}

bool aob_config_read(struct aob_config *config, const char *path, struct aob_error *error)
{
    return aob_config_read_copy(config, path, path, error);
}

bool aob_config_read_copy(struct aob_config *config, const char *path, const char *place,
                          struct aob_error *error)
{
    static const char *const keys[] = {"name",      "scenes",     "resolutions", "backends",
                                       "options",   "techniques", "measure",     "target",
                                       "reference", "budget",     "effects",     NULL};
    struct aob_yaml yaml;
    aob_config_init(config);
    config->text = aob_file_read(path, 1 << 20, &config->size, error);
    if (!config->text)
        return false;
    bool ok = aob_yaml_load(&yaml, path, config->text, config->size, error);
    if (ok) {
        config->path = aob_strdup(path);
        config->place = aob_strdup(place);
        aob_hash_bytes(config->text, config->size, config->hash);
        ok = aob_yaml_mapping(&yaml, yaml_document_get_root_node(&yaml.document), keys, read_config_entry,
                              config) &&
             judge_config(config, error) && aob_config_judge_size(config, error);
        aob_yaml_finish(&yaml);
    }
    if (!ok)
        aob_config_finish(config);
    return ok;
}
