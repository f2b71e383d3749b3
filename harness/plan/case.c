#include <string.h>
#include "plan.h"
#include "technique/param.h"

/* A parameter of an output that is not wanted decides nothing. */
static void add_values(const struct aob_param *params, size_t count, const double *values, uint32_t wanted,
                       struct aob_text *text)
{
    for (size_t i = 0; i < count; i++) {
        if (params[i].output && !(wanted >> params[i].output & 1))
            continue;
        aob_text_add(text, " %s=", params[i].name);
        aob_param_print(&params[i], values[i], text);
    }
}

/* What is off is not named, so that a key lasts when switches are added to the program. */
static void add_switches(const double *options, struct aob_text *text)
{
    for (size_t i = AOB_OPTION_FIRST_SWITCH; i < AOB_OPTION_COUNT; i++)
        if (options[i] != 0)
            add_values(&aob_option_params[i], 1, &options[i], 0, text);
}

void aob_case_settings(const struct aob_case *c, struct aob_text *text)
{
    struct aob_options options = aob_case_options(c);
    aob_text_add(text, "%s", c->technique->name);
    add_values(c->technique->params, c->technique->param_count, c->params, aob_options_wanted(&options),
               text);
    aob_text_add(text, " %s %dx%d", c->backend, c->width, c->height);
    add_values(aob_option_params, AOB_OPTION_FIRST_SWITCH, c->options, 0, text);
    add_switches(c->options, text);
}

struct aob_options aob_case_options(const struct aob_case *c)
{
    struct aob_options options;
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, c->options, &options, sizeof options);
    return options;
}

bool aob_case_is_lit(const struct aob_case *c)
{
    struct aob_options options = aob_case_options(c);
    return aob_options_wanted(&options) & (1u << AOB_OUT_IRRADIANCE | 1u << AOB_OUT_LIT);
}

/* What no view can be encoded in; planes that follow the view are judged when it is known. */
static bool judge_encoding(const struct aob_case *c, struct aob_error *error)
{
    struct aob_options o = aob_case_options(c);
    bool infinite =
        o.depth_encoding == AOB_DEPTH_DEVICE24_INFINITE || o.depth_encoding == AOB_DEPTH_DEVICE32_INFINITE;
    if (infinite && c->scene->camera.ortho_height > 0)
        return aob_fail(error,
                        "%s: an infinite far plane needs a perspective view: choose another depth_encoding",
                        c->scene->name);
    return o.depth_encoding < AOB_DEPTH_DEVICE24 || infinite ||
           !(o.near > 0 && o.far > 0 && o.near >= o.far) ||
           aob_fail(error, "near %g is not below far %g", (double)o.near, (double)o.far);
}

/* What of a capture's materials an output is made of. Without metalness nothing is metal. */
static const unsigned materials_of[AOB_OUTPUT_COUNT] = {
    [AOB_OUT_VISIBILITY_RGB] = AOB_MATERIAL_BIT(AOB_MATERIAL_ALBEDO),
    [AOB_OUT_SPECULAR] = AOB_MATERIAL_BIT(AOB_MATERIAL_ROUGHNESS),
    [AOB_OUT_LIT] = AOB_MATERIAL_BIT(AOB_MATERIAL_ALBEDO) | AOB_MATERIAL_BIT(AOB_MATERIAL_ROUGHNESS),
};

static bool fail_material(const struct aob_case *c, const char *option, enum aob_material_channel lacks,
                          struct aob_error *error)
{
    bool colour = lacks == AOB_MATERIAL_ALBEDO;
    return aob_fail(error,
                    "%s: %s needs the %s of the surfaces, and the file has no %s: write %s, name %s by "
                    "%s_channel, or leave %s off",
                    c->scene->name, option, colour ? "base colour" : "roughness",
                    colour ? "channels albedo.R .G .B" : "channel roughness", colour ? "them" : "it",
                    colour ? "them" : "it", aob_material_channel_names[lacks], option);
}

static bool judge_materials(const struct aob_case *c, struct aob_error *error)
{
    for (int which = AOB_OUT_VISIBILITY + 1; which < AOB_OUTPUT_COUNT; which++) {
        size_t option = AOB_OPTION_FIRST_OUTPUT + (size_t)which - 1;
        unsigned lacks = materials_of[which] & ~c->scene->materials;
        if (c->options[option] != 0 && lacks)
            return fail_material(c, aob_option_params[option].name,
                                 lacks & AOB_MATERIAL_BIT(AOB_MATERIAL_ALBEDO) ? AOB_MATERIAL_ALBEDO
                                                                               : AOB_MATERIAL_ROUGHNESS,
                                 error);
    }
    return true;
}

/* About 150 bytes of memory a pixel, and one view has to fit. */
bool aob_case_judge(const struct aob_case *c, struct aob_error *error)
{
    double guard = aob_case_options(c).guard_band;
    if (!judge_encoding(c, error))
        return false;
    if (c->scene->gbuffer && guard > 0)
        return aob_fail(error, "%s: a capture ends at its edge: guard_band must be 0, not %g", c->scene->name,
                        guard);
    if (c->scene->gbuffer && aob_case_options(c).gbuffer == AOB_GBUFFER_RASTER)
        return aob_fail(error, "%s: a capture has no triangles to draw: gbuffer must be canonical",
                        c->scene->name);
    if (c->scene->gbuffer && !judge_materials(c, error))
        return false;
    return (c->width + 2 * guard) * (c->height + 2 * guard) <= 4e7 ||
           aob_fail(error, "%dx%d with a guard band of %g is more than 40 million pixels", c->width,
                    c->height, guard);
}

bool aob_case_same_block(const struct aob_case *a, const struct aob_case *b)
{
    return a->block == b->block;
}

bool aob_case_same_but_build(const struct aob_case *a, const struct aob_case *b)
{
    struct aob_text p = {0}, q = {0};
    aob_case_settings(a, &p);
    aob_case_settings(b, &q);
    bool same = a->scene == b->scene && strcmp(p.data, q.data) == 0;
    aob_text_finish(&p);
    aob_text_finish(&q);
    return same;
}
