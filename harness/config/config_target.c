#include "config_target.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"

/* A radius is rounded to a float, as a technique's parameter is: so 0.3 here is the 0.3 of the technique. */
static bool add_target(struct aob_config *config, double radius, bool uniform, struct aob_error *error)
{
    if (isfinite(radius) && isinf((float)radius))
        return aob_fail(error, "the radius %g is beyond the largest float: give inf, or a smaller one",
                        radius);
    radius = (double)(float)radius;
    for (size_t i = 0; i < config->target_count; i++)
        if (config->targets[i].radius == radius && config->targets[i].uniform == uniform)
            return aob_fail(error, "the target of radius %g and weighting %s is given twice", radius,
                            uniform ? "uniform" : "cosine");
    if (config->target_count == AOB_CONFIG_MAX_TARGETS)
        return aob_fail(error, "more than %d targets: name the few that the question is about",
                        AOB_CONFIG_MAX_TARGETS);
    *AOB_PUSH(config->targets, config->target_count, config->target_capacity) =
        (struct aob_target){radius, uniform};
    return true;
}

static bool parse_weighting(const char *text, bool *uniform, struct aob_error *error)
{
    *uniform = strcmp(text, "uniform") == 0;
    return *uniform || strcmp(text, "cosine") == 0 ||
           aob_fail(error, "'%s' is not one of cosine, uniform", text);
}

struct target_reader {
    double radius;
    bool uniform;
};

static bool read_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct target_reader *reader = user;
    struct aob_error error = {{0}};
    const char *text;
    if (strcmp(key, "radius") == 0)
        return aob_yaml_number(yaml, node, AOB_TARGET_MIN_RADIUS, INFINITY, &reader->radius);
    return aob_yaml_text(yaml, node, &text) &&
           (parse_weighting(text, &reader->uniform, &error) || aob_yaml_fail(yaml, node, "%s", error.text));
}

bool aob_config_read_target(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    static const char *const keys[] = {"radius", "weighting", NULL};
    struct target_reader reader = {0};
    struct aob_error error = {{0}};
    if (!aob_yaml_mapping(yaml, node, keys, read_entry, &reader))
        return false;
    if (!(reader.radius > 0))
        return aob_yaml_fail(yaml, node, "a target needs radius: R in scene units, or inf");
    return add_target(user, reader.radius, reader.uniform, &error) ||
           aob_yaml_fail(yaml, node, "%s", error.text);
}

bool aob_config_add_targets(struct aob_config *config, const char *radii, const char *weighting,
                            struct aob_error *error)
{
    bool uniform, ok = parse_weighting(weighting, &uniform, error);
    char *copy = aob_strdup(radii), *rest = copy;
    for (char *text; ok && (text = strsep(&rest, ","));) {
        double radius;
        ok = (aob_parse_double(text, &radius) && radius >= AOB_TARGET_MIN_RADIUS) ||
             aob_fail(error, "'%s' is not a radius of at least %g, or inf", text, AOB_TARGET_MIN_RADIUS);
        ok = ok && add_target(config, radius, uniform, error);
    }
    free(copy);
    return ok;
}
