#include "profile_rates.h"
#include <string.h>
#include "model.h"
#include "profile_fact.h"

enum {
    CLOCK,
    ALU_CLOCK,
    LANES,
    SPECIAL,
    SPECIAL_BLOCKS,
    TEXTURE_UNITS,
    TAGS,
    POINT_64,
    ROPS,
    MEMORY,
    LAUNCH
};

#define OF(name) offsetof(struct aob_rates, name)
static const struct aob_field fields[] = {
    [CLOCK] = {"clock", AOB_FIELD_REAL, 0.001, 100, OF(clock), true},
    [ALU_CLOCK] = {"alu_clock", AOB_FIELD_REAL, 0.001, 100, OF(alu_clock), false},
    [LANES] = {"lanes", AOB_FIELD_REAL, 1, 1e6, OF(lanes), true},
    [SPECIAL] = {"special", AOB_FIELD_REAL, 0.001, 1, OF(special), true},
    [SPECIAL_BLOCKS] = {"special_blocks", AOB_FIELD_BOOL, 0, 0, OF(special_blocks), true},
    [TEXTURE_UNITS] = {"texture_units", AOB_FIELD_REAL, 1, 1e6, OF(texture_units), true},
    [TAGS] = {"tags", AOB_FIELD_REAL, 1, 16, OF(tags), true},
    [POINT_64] = {"point_64", AOB_FIELD_REAL, 1, 2, OF(point_64), false},
    [ROPS] = {"rops", AOB_FIELD_REAL, 1, 1e6, OF(rops), true},
    [MEMORY] = {"memory", AOB_FIELD_REAL, 0.01, 1e6, OF(memory), true},
    [LAUNCH] = {"launch", AOB_FIELD_REAL, 0, 1e6, OF(launch), true},
    {0},
};

static bool judge_choice(struct aob_yaml *yaml, const yaml_node_t *node, double value, const double *choices)
{
    for (; *choices; choices++)
        if (*choices == value)
            return true;
    return aob_yaml_fail(yaml, node, "%g is no power of two within its bounds", value);
}

bool aob_profile_rates_read(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_profile *profile)
{
    static const char *const keys[] = {"clock",          "alu_clock",     "lanes",  "special",
                                       "special_blocks", "texture_units", "tags",   "point_64",
                                       "rops",           "memory",        "launch", NULL};
    static const double tags[] = {1, 2, 4, 8, 16, 0}, point_64[] = {1, 2, 0};
    struct aob_rates *rates = &profile->rates;
    struct aob_field_reader reader = {profile, "rates.", fields, rates, {NULL}};
    if (!aob_yaml_mapping(yaml, node, keys, aob_field_read, &reader) || !aob_field_need(yaml, node, &reader))
        return false;
    if (!reader.nodes[ALU_CLOCK])
        rates->alu_clock = rates->clock;
    if (!reader.nodes[POINT_64])
        rates->point_64 = 2;
    aob_field_default(&reader, POINT_64, "2", "default: as a filtered one");
    return judge_choice(yaml, reader.nodes[TAGS], rates->tags, tags) &&
           judge_choice(yaml, reader.nodes[POINT_64], rates->point_64, point_64);
}

/* The times of levels stand beside those of the other resources, by their names. */
static bool is_resource(const char *name)
{
    static const struct aob_profile no_levels;
    for (int r = 0; r < AOB_RESOURCE_COUNT; r++) {
        const char *other = aob_model_resource_name(&no_levels, (enum aob_resource)r);
        if (other && strcmp(name, other) == 0)
            return true;
    }
    return false;
}

/* A fault is shown where the level is written, at the value of `key` where it has that one. */
static const yaml_node_t *level_node(struct aob_yaml *yaml, const yaml_node_t *levels, int number,
                                     const char *key)
{
    const yaml_node_t *level = levels;
    if (levels->type == YAML_SEQUENCE_NODE)
        level = yaml_document_get_node(&yaml->document, levels->data.sequence.items.start[number]);
    const yaml_node_t *value = aob_yaml_find(yaml, level, key);
    return value ? value : level;
}

/* Beside rates. */
static bool judge_fed(struct aob_yaml *yaml, const yaml_node_t *levels, const struct aob_profile *profile,
                      int l)
{
    const struct aob_profile_level *level = &profile->levels[l];
    bool last = l + 1 == profile->level_count;
    if (is_resource(level->name))
        return aob_yaml_fail(yaml, level_node(yaml, levels, l, "name"),
                             "no level beside rates is called '%s', which is another resource", level->name);
    if (!last && !(level->fill && level->ports))
        return aob_yaml_fail(yaml, level_node(yaml, levels, l, ""),
                             "level '%s' has no 'fill' and 'ports', which are needed beside rates",
                             level->name);
    if (last && (level->fill || level->ports))
        return aob_yaml_fail(yaml, level_node(yaml, levels, l, level->fill ? "fill" : "ports"),
                             "level '%s' is filled from memory: it has no 'fill' and no 'ports'",
                             level->name);
    return true;
}

static bool judge_unfed(struct aob_yaml *yaml, const yaml_node_t *levels, const struct aob_profile *profile,
                        int l)
{
    const struct aob_profile_level *level = &profile->levels[l];
    return (!level->fill && !level->ports) ||
           aob_yaml_fail(yaml, level_node(yaml, levels, l, level->fill ? "fill" : "ports"),
                         "level '%s' has a 'fill' or 'ports', and the profile has no 'rates'", level->name);
}

bool aob_profile_rates_judge(struct aob_yaml *yaml, const yaml_node_t *root,
                             const struct aob_profile *profile)
{
    const yaml_node_t *rates = aob_yaml_find(yaml, root, "rates"),
                      *levels = aob_yaml_find(yaml, root, "levels");
    if (rates && aob_yaml_find(yaml, levels, "value"))
        return aob_yaml_fail(yaml, levels,
                             "levels that the machine tells have no 'fill', which is needed beside rates: "
                             "write the levels, or leave the rates out");
    for (int l = 0; l < profile->level_count; l++)
        if (rates ? !judge_fed(yaml, levels, profile, l) : !judge_unfed(yaml, levels, profile, l))
            return false;
    return true;
}
