#include "prelude.h"
#include <ctype.h>
#include <string.h>
#include "frame/texts.h"
#include "geometry.h"
#include "gpu/gpu.h"
#include "planes.h"

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

static void add_upper(const char *name, struct aob_text *text)
{
    for (const char *c = name; *c; c++)
        aob_text_add(text, "%c", toupper((unsigned char)*c));
}

static void add_constants(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    const struct aob_technique *technique = desc->graph->technique;
    const char *seed = "0";
    for (uint32_t i = 0; i < technique->param_count; i++) {
        const struct aob_param *param = &technique->params[i];
        if (strcmp(param->name, "seed") == 0)
            seed = param->stage == AOB_CONSTANT  ? "SEED"
                   : param->stage == AOB_UNIFORM ? "int(param.seed)"
                                                 : "0";
        if (param->stage != AOB_CONSTANT)
            continue;
        aob_text_add(text, "#define ");
        add_upper(param->name, text);
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
                 desc->encoding->perspective, desc->pass->border == AOB_FAR);
    aob_text_add(text, "#define AOB_DEPTH_DIVISOR %d\n#define AOB_DIVISOR %d\n",
                 aob_graph_depth_divisor(desc->graph, desc->pass),
                 aob_graph_target_divisor(desc->graph, desc->pass));
}

/* The pass's own defines, and what a text may ask about each input. */
static void add_defines(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    const struct aob_graph_pass *pass = desc->pass;
    for (int i = 0; i < pass->define_count; i++)
        aob_text_add(text, "#define %s (%d)\n", pass->defines[i].name, pass->defines[i].value);
    for (int i = 0; i < pass->in_count; i++) {
        const struct aob_graph_texture *texture = &desc->graph->textures[pass->in[i].texture];
        aob_text_add(text, "#define AOB_TYPE_");
        add_upper(pass->in[i].name, text);
        aob_text_add(text, " %s\n", type_name(texture->format));
        if (texture->fill)
            continue;
        aob_text_add(text, "#define AOB_DIVISOR_");
        add_upper(pass->in[i].name, text);
        aob_text_add(text, " %d\n", aob_graph_bind_divisor(desc->graph, &pass->in[i]));
    }
}

static void add_uniforms(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    const struct aob_technique *technique = desc->graph->technique;
    aob_text_add(text,
                 "layout(std140, BIND(0)) uniform AobBlock {\n"
                 "    vec4 aob_lens;\n    ivec4 aob_sizes;\n    ivec4 aob_misc;\n    vec4 aob_range;\n");
    if (desc->pass->reads & AOB_LIGHT)
        aob_text_add(text, "    vec4 aob_sh[9];\n");
    if (desc->pass->reads & AOB_VELOCITY)
        aob_text_add(text, "    vec4 aob_then[3];\n");
    for (uint32_t i = 0; i < technique->param_count; i++)
        if (technique->params[i].stage == AOB_UNIFORM)
            aob_text_add(text, "    %s %s;\n", technique->params[i].type == AOB_INT ? "int" : "float",
                         technique->params[i].name);
    aob_text_add(text, "} param;\n");
    if (desc->pass->reads & AOB_LIGHT)
        aob_text_add(text, "vec3 aob_light(int i) { return param.aob_sh[i].xyz; }\n");
}

bool aob_prelude_is_storage(enum aob_fetch fetch, enum aob_filter filter, int levels)
{
    return fetch == AOB_FETCH_STORAGE && filter == AOB_NEAREST && levels == 1;
}

/* What all traced passes have. */
static void add_trace(struct aob_text *text)
{
    aob_text_add(text,
                 "#define AOB_TRACE_NONE 0x%xu\n#define AOB_TRACE_BILINEAR 0x%xu\n"
                 "#define AOB_TRACE_ONE_COLUMN 0x%xu\n#define AOB_TRACE_ONE_ROW 0x%xu\n%s",
                 AOB_TRACE_NONE, AOB_TRACE_BILINEAR, AOB_TRACE_ONE_COLUMN, AOB_TRACE_ONE_ROW,
                 aob_text_frame_trace);
}

/* Of a traced pass, uint aob_number_<name>(ivec2, int): what a texel of a level has as its number. */
static void add_numbers(const struct aob_prelude_desc *desc, const char *name, int binding, int levels,
                        struct aob_text *text)
{
    ptrdiff_t index = desc->pass - desc->graph->passes;
    const struct aob_trace_pass *pass = &desc->planes->passes[index];
    aob_text_add(text, "uint aob_number_%s(ivec2 p, int l) {\n    return ", name);
    for (int l = 0; l < levels; l++) {
        const struct aob_trace_plane *plane = &pass->planes[desc->planes->reads[index][binding][l]];
        if (l < levels - 1)
            aob_text_add(text, "l == %d ? ", l);
        aob_text_add(text, "%uu + uint(p.y * %d + p.x)%s", plane->first, plane->width,
                     l < levels - 1 ? " : " : ";\n}\n");
    }
}

static void add_note(const struct aob_prelude_desc *desc, const char *name, const char *texel,
                     struct aob_text *text)
{
    if (desc->planes)
        aob_text_add(text, "aob_note(aob_number_%s(%s)); ", name, texel);
}

/* Declares image `name` and T aob_texel_<name>(ivec2), for coordinates that are inside it; of a sampled one of several
 * levels also T aob_texel_<name>(ivec2, int), for a level that it shows. */
static void add_image(const struct aob_prelude_desc *desc, const char *name, enum aob_format format,
                      int binding, int levels, enum aob_filter filter, struct aob_text *text)
{
    const char *type = type_name(format), *part = swizzle(format);
    bool storage = aob_prelude_is_storage(desc->fetch, filter, levels);
    if (desc->planes)
        add_numbers(desc, name, binding, levels, text);
    if (storage)
        aob_text_add(text, "layout(%s, BIND(%d)) uniform readonly image2D aob_image_%s;\n",
                     aob_gpu_format_layout(format), binding, name);
    else
        aob_text_add(text, "layout(BIND(%d)) uniform sampler2D aob_image_%s;\n", binding, name);
    aob_text_add(text, "%s aob_texel_%s(ivec2 p) { ", type, name);
    add_note(desc, name, "p, 0", text);
    aob_text_add(text,
                 storage ? "return imageLoad(aob_image_%s, p).%s; }\n"
                         : "return texelFetch(aob_image_%s, p, 0).%s; }\n",
                 name, part);
    if (levels == 1)
        return;
    aob_text_add(text, "%s aob_texel_%s(ivec2 p, int l) { ", type, name);
    add_note(desc, name, "p, l", text);
    aob_text_add(text, "return texelFetch(aob_image_%s, p, l).%s; }\n", name, part);
}

/* The last texel of a table, or of what the view fills of a target, whose texture may be larger. */
static void add_edge(const struct aob_graph_texture *texture, int divisor, struct aob_text *text)
{
    if (texture->fill)
        aob_text_add(text, "ivec2(%d, %d)", texture->width - 1, texture->height - 1);
    else
        aob_text_add(text, "aob_divided(%d) - 1", divisor);
}

/* Around a read: frame 0 has no frame before it, whatever its textures hold. It is a choice between values and no branch, since
 * some drivers compile a program again for each value of a uniform that steers a branch. */
static const char *first_frame_begin(const struct aob_graph_bind *bind)
{
    return bind->previous ? "aob_unless_first(" : "";
}

static const char *first_frame_end(const struct aob_graph_bind *bind)
{
    return bind->previous ? ")" : "";
}

static void add_one_level(const struct aob_graph_bind *bind, const struct aob_graph_texture *texture,
                          struct aob_text *text)
{
    const char *type = type_name(texture->format), *name = bind->name;
    aob_text_add(text, "%s aob_fetch_%s(ivec2 p) {\n    return %saob_texel_%s(clamp(p, ivec2(0), ", type,
                 name, first_frame_begin(bind), name);
    add_edge(texture, texture->divisor << bind->level, text);
    aob_text_add(text, "))%s;\n}\n%s aob_fetch_%s(ivec2 p, int level) { return aob_fetch_%s(p); }\n",
                 first_frame_end(bind), type, name, name);
}

static void add_levels(const struct aob_graph_bind *bind, const struct aob_graph_texture *texture,
                       struct aob_text *text)
{
    const char *type = type_name(texture->format), *name = bind->name;
    aob_text_add(text,
                 "%s aob_fetch_%s(ivec2 p, int level) {\n"
                 "    int l = clamp(level, 0, %d);\n"
                 "    ivec2 edge = aob_divided(%d << l) - 1;\n"
                 "    return %saob_texel_%s(clamp(p, ivec2(0), edge), l)%s;\n}\n"
                 "%s aob_fetch_%s(ivec2 p) { return aob_fetch_%s(p, 0); }\n",
                 type, name, bind->level_count - 1, texture->divisor << bind->level, first_frame_begin(bind),
                 name, first_frame_end(bind), type, name, name);
}

/* The sampler's own read of place `uv` of level `level`. */
static void add_filtered(const struct aob_prelude_desc *desc, const struct aob_graph_bind *bind,
                         const char *uv, const char *level, const char *part, struct aob_text *text)
{
    const char *name = bind->name;
    if (desc->planes)
        aob_text_add(text,
                     "ivec2 aob_first = aob_upper_left(%s, textureSize(aob_image_%s, %s));\n"
                     "    aob_note(aob_number_%s(max(aob_first, 0), %s) | aob_footprint(aob_first));\n    ",
                     uv, name, level, name, level);
    aob_text_add(text, "return %stextureLod(aob_image_%s, %s, float(%s)).%s%s;", first_frame_begin(bind),
                 name, uv, level, part, first_frame_end(bind));
}

/* A target may be larger than what the view fills of it; its edge is not the sampler's then. */
static void add_sample(const struct aob_prelude_desc *desc, const struct aob_graph_bind *bind,
                       const struct aob_graph_texture *texture, struct aob_text *text)
{
    const char *type = type_name(texture->format), *name = bind->name, *part = swizzle(texture->format);
    if (texture->align > 0) {
        aob_text_add(
            text,
            "%s aob_sample_%s(vec2 uv, int level) {\n"
            "    int l = clamp(level, 0, %d);\n"
            "    vec2 size = vec2(aob_divided(%d << l)), whole = vec2(textureSize(aob_image_%s, l));\n"
            "    vec2 at = clamp(uv * size, vec2(0.5), size - 0.5) / whole;\n    ",
            type, name, bind->level_count - 1, texture->divisor << bind->level, name);
        add_filtered(desc, bind, "at", "l", part, text);
        aob_text_add(text, "\n}\n%s aob_sample_%s(vec2 uv) { return aob_sample_%s(uv, 0); }\n", type, name,
                     name);
    } else {
        aob_text_add(text, "%s aob_sample_%s(vec2 uv) { ", type, name);
        add_filtered(desc, bind, "uv", "0", part, text);
        aob_text_add(text, " }\n%s aob_sample_%s(vec2 uv, int level) { return aob_sample_%s(uv); }\n", type,
                     name, name);
    }
}

static void add_input(const struct aob_prelude_desc *desc, int index, struct aob_text *text)
{
    const struct aob_graph_bind *bind = &desc->pass->in[index];
    const struct aob_graph_texture *texture = &desc->graph->textures[bind->texture];
    add_image(desc, bind->name, texture->format, AOB_BINDING_FIRST_INPUT + index, bind->level_count,
              bind->filter, text);
    if (bind->level_count > 1)
        add_levels(bind, texture, text);
    else
        add_one_level(bind, texture, text);
    if (bind->filter == AOB_BILINEAR)
        add_sample(desc, bind, texture, text);
}

static void add_own_depth(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    int levels = desc->pass->depth_levels;
    enum aob_format format = desc->graph->textures[desc->pass->depth].format;
    /* A half float's greatest value is what a device may make of AOB_SKY_Z. */
    const char *sky = format == AOB_R16F ? "z >= 65504.0 ? AOB_SKY_Z : z" : "z";
    add_image(desc, "own_depth", format, AOB_BINDING_OWN_DEPTH, levels, AOB_NEAREST, text);
    aob_text_add(
        text, "float aob_own_z(ivec2 q) {\n    float z = aob_texel_own_depth(q);\n    return %s;\n}\n", sky);
    if (levels > 1)
        aob_text_add(text,
                     "float aob_own_z(ivec2 q, int l) {\n    float z = aob_texel_own_depth(q, l);\n"
                     "    return %s;\n}\n",
                     sky);
}

static void add_depth(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    add_image(desc, "depth", aob_encoding_depth_format(desc->encoding), AOB_BINDING_DEPTH, 1, AOB_NEAREST,
              text);
    aob_encoding_write_depth(desc->encoding, text);
    if (desc->pass->depth >= 0)
        add_own_depth(desc, text);
    else
        aob_text_add(text, "float aob_own_z(ivec2 q) { return aob_decode_depth(aob_texel_depth(q)); }\n");
    aob_text_add(text, "#define AOB_DEPTH_LEVELS %d\n%s", desc->pass->depth_levels, aob_text_frame_depth);
}

static void add_normal(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    bool derived = desc->encoding->normals == AOB_NORMALS_FROM_DEPTH;
    if (!derived) {
        add_image(desc, "normal", aob_encoding_normal_format(desc->encoding), AOB_BINDING_NORMAL, 1,
                  AOB_NEAREST, text);
        aob_encoding_write_normal(desc->encoding, text);
    }
    aob_text_add(text, "%s%s", derived ? aob_text_frame_normal_from_depth : aob_text_frame_normal_texture,
                 aob_text_frame_normal);
}

static void add_material(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    add_image(desc, "albedo", AOB_RGBA8, AOB_BINDING_ALBEDO, 1, AOB_NEAREST, text);
    add_image(desc, "shine", AOB_RG8, AOB_BINDING_SHINE, 1, AOB_NEAREST, text);
    aob_text_add(text, "%s", aob_text_frame_material);
}

/* What the vertices hand on: the triangle's corners, and its number among all that are drawn to a trace. */
static void add_corners(const struct aob_prelude_desc *desc, const char *direction, struct aob_text *text)
{
    for (int k = 0; k < 3; k++)
        aob_text_add(text, "layout(location=%d) flat %s vec4 aob_corner_%d;\n", k, direction, k);
    if (desc->planes)
        aob_text_add(text, "layout(location=3) flat %s uint aob_primitive;\n", direction);
}

static void add_shader(const char *shader, struct aob_text *text)
{
    aob_text_add(text, "#line 1\n%s", shader);
}

/* What both stages of a pass have. */
static void add_head(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    add_constants(desc, text);
    add_defines(desc, text);
    add_uniforms(desc, text);
    aob_text_add(text, "%s", aob_text_frame_prelude);
}

void aob_prelude_write_vertex(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    struct aob_prelude_desc plain = *desc;
    plain.planes = NULL; /* its reads are not traced */
    add_head(desc, text);
    for (int i = 0; i < desc->pass->in_count; i++)
        add_input(&plain, i, text);
    add_corners(desc, "out", text);
    aob_text_add(text, "#define AOB_ROW %d\nlayout(BIND(%d)) uniform sampler2D aob_triangles;\n%s",
                 AOB_GEOMETRY_ROW, AOB_BINDING_TRIANGLES, aob_text_frame_triangle_vertex);
    add_shader(desc->pass->vertex_text, text);
    aob_text_add(text,
                 "\n#line 1 1\nvoid main() {\n"
                 "    int triangle = VERTEX_ID / %u;\n"
                 "    aob_corner_0 = aob_triangle_texel(triangle, 0);\n"
                 "    aob_corner_1 = aob_triangle_texel(triangle, 1);\n"
                 "    aob_corner_2 = aob_triangle_texel(triangle, 2);\n"
                 "%s    gl_Position = place(triangle, VERTEX_ID %% %u);\n}\n",
                 desc->pass->per_triangle, desc->planes ? "    aob_primitive = uint(VERTEX_ID / 3);\n" : "",
                 desc->pass->per_triangle);
}

/* The body of a traced pass is a function that a main() of ours calls. */
static void add_traced_shader(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    aob_text_add(text, "%s#define main aob_body\n",
                 desc->pass->draw == AOB_TRIANGLES ? aob_text_frame_trace_fragments
                                                   : aob_text_frame_trace_screen);
    add_shader(desc->pass->text, text);
    aob_text_add(text, "\n#line 1 1\n#undef main\nvoid main() { aob_open(); aob_body(); aob_close(); }\n");
}

void aob_prelude_write(const struct aob_prelude_desc *desc, struct aob_text *text)
{
    const struct aob_graph_pass *pass = desc->pass;
    bool derived = desc->encoding->normals == AOB_NORMALS_FROM_DEPTH;
    add_head(desc, text);
    if (desc->planes)
        add_trace(text);
    if (pass->reads & AOB_DEPTH || (pass->reads && derived))
        add_depth(desc, text);
    if (pass->reads & AOB_NORMAL)
        add_normal(desc, text);
    if (pass->reads & AOB_MATERIAL)
        add_material(desc, text);
    if (pass->reads & AOB_VELOCITY) {
        add_image(desc, "velocity", AOB_RGBA16F, AOB_BINDING_VELOCITY, 1, AOB_NEAREST, text);
        aob_text_add(text, "%s", aob_text_frame_velocity);
    }
    for (int i = 0; i < pass->in_count; i++)
        add_input(desc, i, text);
    if (pass->reads & AOB_CLEARANCE)
        aob_text_add(text, "%s",
                     desc->graph->clear < 0 ? "bool aob_is_clear(ivec2 p) { return false; }\n"
                                            : aob_text_frame_clearance);
    for (int o = 0; o < pass->out_count; o++)
        aob_text_add(text, "layout(location=%d) out %s %s;\n", o,
                     type_name(desc->graph->textures[pass->out[o].texture].format), pass->out[o].name);
    if (pass->draw == AOB_TRIANGLES) {
        add_corners(desc, "in", text);
        aob_text_add(text, "%s", aob_text_frame_triangle_fragment);
    }
    if (desc->planes)
        add_traced_shader(desc, text);
    else
        add_shader(pass->text, text);
}
