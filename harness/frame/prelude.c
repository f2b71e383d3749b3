#include "prelude.h"
#include <ctype.h>
#include <string.h>
#include "gpu/gpu.h"

/* What does not depend on pass or parameters. `aob_texel_*` are written per pass, after this. */
static const char gbuffer_text[] =
    "#define aob_size (param.aob_sizes.xy)\n"
    "#define aob_target_size (param.aob_sizes.zw)\n"
    "#define aob_frame (param.aob_misc.x)\n"
    "#define aob_pixel (ivec2(gl_FragCoord.xy))\n"
    "const float AOB_PI = 3.14159265358979;\n"
    "const float AOB_SKY_Z = 1e9;\n"
    "vec3 aob_position_at(vec2 q, float z) {\n"
    "    float s = AOB_PERSPECTIVE == 1 ? z : 1.0;\n"
    "    vec2 xy = (q - param.aob_lens.zw) * param.aob_lens.xy * s;\n"
    "    return vec3(xy.x, -xy.y, -z);\n"
    "}\n"
    "vec2 aob_project(vec3 v) {\n"
    "    float s = AOB_PERSPECTIVE == 1 ? -v.z : 1.0;\n"
    "    return vec2(v.x, -v.y) / (param.aob_lens.xy * s) + param.aob_lens.zw;\n"
    "}\n"
    "vec3 aob_view_vector(vec3 v) { return AOB_PERSPECTIVE == 1 ? normalize(-v) : vec3(0.0, 0.0, 1.0); }\n"
    "float aob_pixel_radius(float z, float r) { return r / (param.aob_lens.y * (AOB_PERSPECTIVE == 1 ? z : "
    "1.0)); }\n"
    "float aob_random(ivec2 p, int i) {\n"
    "    uvec3 v = uvec3(uint(p.x), uint(p.y), uint(i) + uint(AOB_SEED) * 2654435769u) * 1664525u + "
    "1013904223u;\n"
    "    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;\n"
    "    v ^= v >> 16;\n"
    "    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;\n"
    "    return float(v.x >> 8) * (1.0 / 16777216.0);\n"
    "}\n";

static const char depth_text[] =
    "float aob_view_z(ivec2 p) {\n"
    "    ivec2 q = clamp(p, ivec2(0), aob_size - 1);\n"
    "    float z = aob_texel_depth(q);\n"
    "    return AOB_BORDER_FAR == 0 || q == p ? z : AOB_SKY_Z;\n"
    "}\n"
    "bool aob_is_sky(ivec2 p) { return aob_view_z(p) >= 0.5 * AOB_SKY_Z; }\n"
    "vec3 aob_position(ivec2 p) { return aob_position_at(vec2(p) + 0.5, aob_view_z(p)); }\n";

static const char normal_text[] =
    "vec3 aob_normal(ivec2 p) { return aob_texel_normal(clamp(p, ivec2(0), aob_size - 1)).xyz; }\n";

static const char *type_name(enum aob_format format)
{
    static const char *const names[] = {"", "float", "vec2", "", "vec4"};
    return names[aob_gpu_texel_components(format)];
}

static const char *swizzle(enum aob_format format)
{
    static const char *const names[] = {"", "x", "xy", "", "xyzw"};
    return names[aob_gpu_texel_components(format)];
}

static void add_constants(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    const struct aob_technique *technique = desc->graph->technique;
    const char *seed = "0";
    for (uint32_t i = 0; i < technique->param_count; i++) {
        const struct aob_param *param = &technique->params[i];
        if (strcmp(param->name, "seed") == 0)
            seed = param->stage == AOB_CONSTANT ? "SEED" : "int(param.seed)";
        if (param->stage != AOB_CONSTANT)
            continue;
        aob_text_add(text, "#define ");
        for (const char *c = param->name; *c; c++)
            aob_text_add(text, "%c", toupper((unsigned char)*c));
        int32_t whole;
        float number;
        memcpy(&whole, (const char *)desc->values + param->offset, 4);
        memcpy(&number, (const char *)desc->values + param->offset, 4);
        if (param->type == AOB_INT)
            aob_text_add(text, " (%d)\n", whole);
        else
            aob_text_add(text, " (%.9e)\n", (double)number);
    }
    aob_text_add(text, "#define AOB_SEED %s\n#define AOB_PERSPECTIVE %d\n#define AOB_BORDER_FAR %d\n", seed,
                 desc->perspective, desc->pass->border == AOB_FAR);
}

static void add_defines(const char *defines, struct aob_text *text)
{
    for (const char *c = defines; *c;) {
        size_t size = strcspn(c, " ");
        size_t name = strcspn(c, "= ");
        if (size)
            aob_text_add(text, "#define %.*s %.*s\n", (int)name, c, (int)(size > name ? size - name - 1 : 0),
                         c + name + (size > name));
        c += size + (c[size] == ' ');
    }
}

static void add_uniforms(const struct aob_technique *technique, struct aob_text *text)
{
    aob_text_add(text, "layout(std140, BIND(0)) uniform AobBlock {\n"
                       "    vec4 aob_lens;\n    ivec4 aob_sizes;\n    ivec4 aob_misc;\n");
    for (uint32_t i = 0; i < technique->param_count; i++)
        if (technique->params[i].stage == AOB_UNIFORM)
            aob_text_add(text, "    %s %s;\n", technique->params[i].type == AOB_INT ? "int" : "float",
                         technique->params[i].name);
    aob_text_add(text, "} param;\n");
}

/* Declares image `name` and T aob_texel_<name>(ivec2), for coordinates that are inside it. */
static void add_image(const char *name, enum aob_format format, int binding, bool storage,
                      struct aob_text *text)
{
    if (storage)
        aob_text_add(text,
                     "layout(%s, BIND(%d)) uniform readonly image2D aob_image_%s;\n"
                     "%s aob_texel_%s(ivec2 p) { return imageLoad(aob_image_%s, p).%s; }\n",
                     aob_gpu_format_layout(format), binding, name, type_name(format), name, name,
                     swizzle(format));
    else
        aob_text_add(text,
                     "layout(BIND(%d)) uniform sampler2D aob_image_%s;\n"
                     "%s aob_texel_%s(ivec2 p) { return texelFetch(aob_image_%s, p, 0).%s; }\n",
                     binding, name, type_name(format), name, name, swizzle(format));
}

static void add_input(const struct aob_prelude_desc *desc, int index, struct aob_text *text)
{
    const struct aob_graph_bind *bind = &desc->pass->in[index];
    const struct aob_graph_texture *texture = &desc->graph->textures[bind->texture];
    bool storage = desc->fetch == AOB_FETCH_STORAGE && bind->filter == AOB_NEAREST;
    const char *type = type_name(texture->format);
    add_image(bind->name, texture->format, AOB_BINDING_FIRST_INPUT + index, storage, text);
    aob_text_add(text,
                 "%s aob_fetch_%s(ivec2 p) {\n"
                 "    ivec2 edge = (aob_size + %d) / %d - 1;\n"
                 "    return aob_texel_%s(clamp(p, ivec2(0), edge));\n}\n",
                 type, bind->name, texture->divisor - 1, texture->divisor, bind->name);
    if (bind->filter == AOB_BILINEAR)
        aob_text_add(text, "%s aob_sample_%s(vec2 uv) { return textureLod(aob_image_%s, uv, 0.0).%s; }\n",
                     type, bind->name, bind->name, swizzle(texture->format));
}

void aob_prelude_write(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    const struct aob_graph_pass *pass = desc->pass;
    bool storage = desc->fetch == AOB_FETCH_STORAGE;
    add_constants(desc, text);
    add_defines(pass->defines, text);
    add_uniforms(desc->graph->technique, text);
    aob_text_add(text, "%s", gbuffer_text);
    if (pass->reads & AOB_DEPTH) {
        add_image("depth", AOB_R32F, AOB_BINDING_DEPTH, storage, text);
        aob_text_add(text, "%s", depth_text);
    }
    if (pass->reads & AOB_NORMAL) {
        add_image("normal", AOB_RGBA32F, AOB_BINDING_NORMAL, storage, text);
        aob_text_add(text, "%s", normal_text);
    }
    for (int i = 0; i < pass->in_count; i++)
        add_input(desc, i, text);
    for (int o = 0; o < pass->out_count; o++)
        aob_text_add(text, "layout(location=%d) out %s %s;\n", o,
                     type_name(desc->graph->textures[pass->out[o].texture].format), pass->out[o].name);
    for (const struct aob_shader *s = desc->graph->technique->shaders; s->name; s++)
        if (strcmp(s->name, pass->shader) == 0)
            aob_text_add(text, "#line 1\n%s", s->text);
}

size_t aob_prelude_uniforms(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass,
                            const void *values, const struct aob_projection *projection,
                            unsigned char block[AOB_UNIFORM_MAX])
{
    int width, height;
    aob_graph_texture_size(&graph->textures[pass->out[0].texture], projection->width, projection->height,
                           &width, &height);
    float lens[4] = {(float)projection->sx, (float)projection->sy, (float)projection->cx,
                     (float)projection->cy};
    int32_t sizes[8] = {projection->width, projection->height, width, height};
    memset(block, 0, AOB_UNIFORM_MAX);
    memcpy(block, lens, sizeof lens);
    memcpy(block + sizeof lens, sizes, sizeof sizes);
    size_t used = AOB_UNIFORM_HEAD;
    for (uint32_t i = 0; i < graph->technique->param_count; i++)
        if (graph->technique->params[i].stage == AOB_UNIFORM) {
            memcpy(block + used, (const char *)values + graph->technique->params[i].offset, 4);
            used += 4;
        }
    return (used + 15) / 16 * 16;
}
