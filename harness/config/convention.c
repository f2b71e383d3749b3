#include "convention.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"

const char *const aob_convention_keys[AOB_CONVENTION_COUNT + 1] = {"depth",
                                                                   "near",
                                                                   "far",
                                                                   "normals",
                                                                   "handed",
                                                                   "up",
                                                                   "depth_channel",
                                                                   "normal_channel",
                                                                   "materials",
                                                                   "albedo_channel",
                                                                   "roughness_channel",
                                                                   "metalness_channel",
                                                                   NULL};
const char *const aob_material_channel_names[AOB_MATERIAL_CHANNELS] = {"albedo", "roughness", "metalness"};

static const char *const depths[] = {"planar", "distance", "device", "device_reversed", NULL};
static const char *const normals[] = {"view", "world", "derived", NULL};
static const char *const hands[] = {"right", "left", NULL};
static const char *const materials[] = {"file", "none", NULL};

/* -1 after a line if it is none of them. */
static int choose(const char *key, const char *const *words, const char *text, struct aob_error *error)
{
    struct aob_text all = {0};
    for (int i = 0; words[i]; i++) {
        if (strcmp(words[i], text) == 0) {
            aob_text_finish(&all);
            return i;
        }
        aob_text_add(&all, "%s%s", i ? ", " : "", words[i]);
    }
    aob_fail(error, "%s: '%s' is not one of %s", key, text, all.data);
    aob_text_finish(&all);
    return -1;
}

static bool set_length(const char *key, const char *text, double high, double *value, struct aob_error *error)
{
    double v;
    if (!aob_parse_double(text, &v) || !(v >= 1e-9) || v > high)
        return aob_fail(error, "%s: '%s' is not a length above 0", key, text);
    *value = v;
    return true;
}

static bool set_up(const char *text, double up[3], struct aob_error *error)
{
    if (!aob_parse_vec3(text, up))
        return aob_fail(error, "up: '%s' is not x,y,z", text);
    return hypot(hypot(up[0], up[1]), up[2]) > 1e-9 || aob_fail(error, "up: '%s' has no direction", text);
}

static bool set_name(const char *key, const char *text, char name[64], struct aob_error *error)
{
    if (!*text || strlen(text) >= 64)
        return aob_fail(error, "%s: '%s' is not a name of 1 to 63 letters", key, text);
    snprintf(name, 64, "%s", text);
    return true;
}

bool aob_convention_set(struct aob_convention *c, enum aob_convention_key key, const char *text,
                        struct aob_error *error)
{
    const char *name = aob_convention_keys[key];
    int at = 0;
    switch (key) {
    case AOB_CONVENTION_DEPTH:
        c->depth = (at = choose(name, depths, text, error)) > 0 ? at : 0;
        c->depth_stated = at >= 0;
        return at >= 0;
    case AOB_CONVENTION_NORMALS:
        c->normals = (at = choose(name, normals, text, error)) > 0 ? at : 0;
        return at >= 0;
    case AOB_CONVENTION_HANDED:
        c->left_handed = (at = choose(name, hands, text, error)) > 0;
        return at >= 0;
    case AOB_CONVENTION_NEAR:
        return set_length(name, text, 1e12, &c->near, error);
    case AOB_CONVENTION_FAR:
        return set_length(name, text, INFINITY, &c->far, error);
    case AOB_CONVENTION_UP:
        return set_up(text, c->up, error);
    case AOB_CONVENTION_DEPTH_CHANNEL:
        return set_name(name, text, c->depth_channel, error);
    case AOB_CONVENTION_NORMAL_CHANNEL:
        return set_name(name, text, c->normal_channel, error);
    case AOB_CONVENTION_MATERIALS:
        c->no_materials = (at = choose(name, materials, text, error)) > 0;
        return at >= 0;
    default:
        return set_name(name, text, c->material_channels[key - AOB_CONVENTION_ALBEDO_CHANNEL], error);
    }
}

bool aob_convention_check(const struct aob_convention *c, struct aob_error *error)
{
    bool device = c->depth == AOB_DEPTH_DEVICE || c->depth == AOB_DEPTH_DEVICE_REVERSED;
    if (device && !(c->near > 0 && c->far > c->near))
        return aob_fail(error, "depth %s needs near and a far beyond it (inf is allowed)", depths[c->depth]);
    if (!device && c->near > 0)
        return aob_fail(error, "near goes with depth device or device_reversed");
    if (c->normals == AOB_NORMALS_DERIVED && *c->normal_channel)
        return aob_fail(error, "give normal_channel or normals derived, not both");
    for (int m = 0; m < AOB_MATERIAL_CHANNELS && c->no_materials; m++)
        if (*c->material_channels[m])
            return aob_fail(error, "give %s_channel or materials none, not both",
                            aob_material_channel_names[m]);
    return true;
}

void aob_convention_print(const struct aob_convention *c, struct aob_text *text)
{
    aob_text_add(text, "depth=%s near=%.17g far=%.17g normals=%s handed=%s up=%.17g,%.17g,%.17g",
                 depths[c->depth], c->near, c->far, normals[c->normals], hands[c->left_handed], c->up[0],
                 c->up[1], c->up[2]);
    aob_text_add(text, " depth_channel=%s normal_channel=%s", c->depth_channel, c->normal_channel);
    if (c->no_materials)
        aob_text_add(text, " materials=none");
    for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++)
        if (*c->material_channels[m])
            aob_text_add(text, " %s_channel=%s", aob_material_channel_names[m], c->material_channels[m]);
}

const char *aob_capture_file(const char *scene)
{
    static const char prefix[] = "capture:";
    bool is = scene && strncmp(scene, prefix, sizeof prefix - 1) == 0 && scene[sizeof prefix - 1];
    return is ? scene + sizeof prefix - 1 : NULL;
}
