/* aobudget/technique.h: everything a technique module may include.
 *
 * A module describes, the harness runs: it is const data (a parameter table, GLSL texts, a definition of what
 * it claims to compute) and one pure function, build(), that lays out passes and textures before any device
 * exists. So a sweep is validated without a GPU, no module code is on the timed path, and times per pass,
 * memory, and a cache key come without a line of the module's.
 *
 * Units: lengths in scene units (1 unit = 1 m unless the scene says otherwise), angles in radians, image
 *   positions in pixels. View space is right-handed, +X right, +Y up, looking along -Z; depth is the positive
 *   distance along the view axis. Image row 0 is the top row.
 * Ownership: a technique and everything that it points to is static const; what a graph hands out is the graph's.
 * Errors: a graph function that returns false (or a texture with id 0) has already kept the reason, with the
 *   names of technique, pass and object; build() then just returns false.
 * Threads: a technique is read by any thread; a graph is used by one thread at a time.
 * Language: C11. A module has no undefined symbols: it reaches the harness through a table. */
#ifndef AOBUDGET_TECHNIQUE_H
#define AOBUDGET_TECHNIQUE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define AOB_ABI 11u /* raised by every change to this file: modules of another number are refused */
enum {
    AOB_MAX_PARAM = 32,
    AOB_MAX_IN = 8,
    AOB_MAX_OUT = 8,
    AOB_MAX_DEFINE = 6,
    AOB_MAX_PASS = 32,
    AOB_MAX_TEXTURE = 64,
    AOB_MAX_LEVEL = 12,
    AOB_MAX_VERTICES = 36
};

/* --- Parameters: one table serves config, command line, sweep, GLSL, `list` and report ------------------- */

enum aob_type {
    AOB_FLOAT,
    AOB_INT, /* int32_t. Both types have four bytes, so the C struct is the std140 uniform block */
};
enum aob_unit {
    AOB_UNIT_NONE,
    AOB_UNIT_LENGTH, /* scene units */
    AOB_UNIT_PIXEL,
    AOB_UNIT_RADIAN,
    AOB_UNIT_COUNT,
};
enum aob_scale {
    AOB_LINEAR,
    AOB_LOG2
}; /* how values are best spaced; `list` says so to whoever writes a sweep */
enum aob_stage {
    AOB_UNIFORM,  /* in GLSL: param.name, a value that may change from frame to frame */
    AOB_CONSTANT, /* in GLSL: the upper-case name, a compile-time constant. Whatever bounds a loop or steers a
                     branch must be one: some drivers recompile per frame when a uniform does */
    AOB_HOST,     /* for build(), check() and the definition only */
};
/* What bounds cannot say of a whole number; a config that breaks it is told where. */
enum aob_rule {
    AOB_ANY,
    AOB_ODD, /* or 0 */
    AOB_POWER_OF_TWO,
};

struct aob_param {
    const char *name;   /* lower_snake; the same word in config, C, GLSL and report */
    const char *doc;    /* one sentence: what raising the value does; the text's own symbol goes here */
    enum aob_type type; /* filled in by AOB_PARAM from the C field */
    enum aob_unit unit;
    enum aob_scale scale;
    enum aob_stage stage;
    double min, max;    /* inclusive, in `unit` */
    double initial;     /* the text's default. A length in metres: the harness turns it into scene units */
    enum aob_rule rule; /* of an AOB_INT without choices; rules across parameters are check()'s */
    const char *const *
        choices; /* NULL, or NULL-ended names of 0, 1, 2...; min and max are then unused: leave them 0. What is off
                                   or on has the choices off, on */
    /* enum aob_output that alone it shapes. Where that is not wanted the parameter decides nothing: it is in no key, and a sweep over
     * it is one case. 0, the visibility, which is always wanted: it always counts */
    int output;
    size_t offset; /* of the field in the technique's values struct */
};
#define AOB_PARAM(T, field, ...)                                                                             \
    {                                                                                                        \
        .name = #field, .offset = offsetof(T, field),                                                        \
        .type = _Generic(((T *)0)->field, float                                                              \
                         : AOB_FLOAT, int32_t                                                                \
                         : AOB_INT),                                                                         \
        __VA_ARGS__                                                                                          \
    }

/* --- Graph: what build() fills in; plain data ------------------------------------------------------------ */

struct aob_graph; /* the harness's, valid during build() only */
typedef struct {
    uint32_t id; /* 0 is none; belongs to the graph that made it */
} aob_tex;

/* Parts of the G-buffer that a pass reads through the prelude; a renderer has them anyway. */
enum aob_read {
    AOB_DEPTH = 1 << 0,     /* aob_view_z, aob_position, aob_is_sky */
    AOB_NORMAL = 1 << 1,    /* aob_normal */
    AOB_VELOCITY = 1 << 2,  /* aob_before, and the places and directions of before and now; with AOB_DEPTH */
    AOB_MATERIAL = 1 << 3,  /* aob_albedo, aob_roughness, aob_metalness */
    AOB_LIGHT = 1 << 4,     /* aob_light */
    AOB_CLEARANCE = 1 << 5, /* aob_is_clear; with AOB_DEPTH */
};
/* What the harness reads back, all of full size. */
enum aob_output {
    /* r: visibility in the technique's own sense, 1 open to 0 closed. Every technique gives it. */
    AOB_OUT_VISIBILITY,
    /* xyz: mean open direction, view space; 0 where closed. Optional; a target of rgba16f or rgba32f. A vector that is
     * not finite, or longer than 1 (within 1 %), makes the case `invalid`. Its angle to the traced mean is scored, not
     * its length. Visibility may be given as the same texture: it is then read from w. */
    AOB_OUT_BENT_NORMAL,
    /* rgb: what reaches the surface, for each channel, of a light that is 1 from everywhere, once what is closed has reflected
     * its own share of it: visibility after bounces, 0 to 1. A target of rgba8, rgba16f or rgba32f. */
    AOB_OUT_VISIBILITY_RGB,
    /* r: open share of what the surface's GGX lobe reflects towards the eye (alpha = roughness^2, Fresnel 1), 0 to 1. */
    AOB_OUT_SPECULAR,
    /* rgb: irradiance of the scene's light that what is closed leaves, over pi: what a white matt surface shows; not negative, and
     * within a half float (a light's mean is within 1e-3 .. 1.6e4). A
     * target of rgba16f or rgba32f. */
    AOB_OUT_IRRADIANCE,
    /* rgb: the surface in the scene's light, by what the outputs above leave of that. The harness composes it behind the
     * technique's passes, of those outputs that are wanted: no technique gives it. */
    AOB_OUT_LIT,
    AOB_OUTPUT_COUNT,
};
enum aob_format {
    AOB_R8,
    AOB_R16,
    AOB_R16F,
    AOB_R32F,
    AOB_RG8,
    AOB_RG16F,
    AOB_RG32F,
    AOB_RGBA8,
    AOB_RGBA16F,
    AOB_RGBA32F,
    AOB_FORMAT_COUNT
};
enum aob_filter { AOB_NEAREST, AOB_BILINEAR }; /* BILINEAR inputs get aob_sample_<bind> as well */
enum aob_border {
    AOB_CLAMP,
    AOB_FAR
}; /* G-buffer reads outside the image: the edge texel, or nothing there */

enum aob_draw {
    AOB_SCREEN,    /* every pixel of the outputs once */
    AOB_TRIANGLES, /* vertices that the text `vertex` places for each triangle of the scene; what the fragments
                      write is added up, in the order of the triangles and in the output's own format, from 0 */
};

struct aob_tex_desc {
    const char *name;       /* unique in the graph; for errors and the memory table */
    enum aob_format format; /* all can be drawn to */
    uint32_t divisor;       /* of the screen, rounded up: 1 full (also 0), 2 half, 4 quarter */
    uint32_t levels;        /* of a target: level l has divisor << l; 0 means 1 */
    /* A table in place of a target: width x height texels that fill() writes, tightly packed, row 0 first, in the
     * format's own bits. Called once, when the passes are set up, and billed with the set-up. */
    uint32_t width, height;
    void (*fill)(const void *values, void *texels);
};
struct aob_bind {
    const char *name; /* the GLSL name: aob_fetch_<name>() for an input, the variable <name> for an output */
    aob_tex tex;
    enum aob_filter filter; /* inputs only */
    uint32_t level; /* of an output the level that is written. Of an input the finest that is read: it shows
                               that one and the coarser ones, as far as earlier passes have written them without a gap */
};
struct aob_define {
    const char *name; /* UPPER_SNAKE */
    int value;
};
struct aob_pass {
    const char *name;       /* unique in the graph; the row of the times per pass */
    const char *shader;     /* one of the module's texts, by name */
    uint32_t reads;         /* enum aob_read bits */
    aob_tex depth;          /* read instead of the G-buffer's depth: view-space depth of another divisor
                                         (AOB_R16F or AOB_R32F), whose texel p is the surface of the G-buffer's
                                         pixel p * divisor, or one near it; all levels that earlier passes have
                                         written are read; 0: the G-buffer's */
    enum aob_border border; /* of those reads */
    enum aob_draw draw;
    /* AOB_TRIANGLES only. A captured frame has no triangles: there such a technique is `unsupported`. */
    const char *vertex; /* one of the module's texts, for the vertex stage */
    uint32_t
        per_triangle; /* vertices of each scene triangle, three a drawn one: 3, 6, ... AOB_MAX_VERTICES */
    /* The drawn triangles must stay within the scene triangle's bounding box, enlarged by `reach` on each side (scene
     * units, above 0). The cost estimate relies on it. */
    float reach;
    struct aob_define
        defines[AOB_MAX_DEFINE]; /* compile-time constants; ended by a NULL name, like the next two */
    struct aob_bind in[AOB_MAX_IN];
    struct aob_bind out[AOB_MAX_OUT]; /* colour targets of one size */
};
struct aob_graph_ops {
    bool (*wants)(const struct aob_graph *graph,
                  enum aob_output which); /* lay no pass for what nobody reads */
    aob_tex (*texture)(struct aob_graph *graph, const struct aob_tex_desc *desc);
    bool (*pass)(struct aob_graph *graph, const struct aob_pass *pass); /* runs after the earlier ones */
    bool (*output)(struct aob_graph *graph, enum aob_output which, aob_tex tex); /* full size */
    /* A target of this graph as the frame before left it, 0 throughout in frame 0; for `in` only. A pass may read it before or
     * after the pass that writes the target anew. It costs a second texture. */
    aob_tex (*previous)(struct aob_graph *graph, aob_tex tex);
};
struct aob_graph {
    const struct aob_graph_ops *ops;
};
#define aob_wants(graph, which)       (graph)->ops->wants(graph, which)
#define aob_texture(graph, ...)       (graph)->ops->texture(graph, &(struct aob_tex_desc){__VA_ARGS__})
#define aob_pass(graph, ...)          (graph)->ops->pass(graph, &(struct aob_pass){__VA_ARGS__})
#define aob_pass_add(graph, desc)     (graph)->ops->pass(graph, desc) /* one that is filled in already */
#define aob_output(graph, which, tex) (graph)->ops->output(graph, which, tex)
#define aob_previous(graph, tex)      (graph)->ops->previous(graph, tex)

/* --- The prelude: the other half of the interface -------------------------------------------------------- *
 * A shader text is the body of a fragment shader: functions and `void main()`. It never says #version, layout
 * or binding; the harness writes those in front, with these names (GLSL 4.50, the same on every backend):
 *
 *   ivec2 aob_pixel             the pixel of the outputs that this invocation writes
 *   ivec2 aob_target_size       pixels of the pass's outputs
 *   int   aob_frame             frame number, 0 for a single shot and for the first of a sequence
 *   AOB_DIVISOR                 divisor of the outputs, their level counted; AOB_DEPTH_DIVISOR of the depth below
 *   AOB_DIVISOR_<IN>            divisor of an input that is no table, in the level that it is read from
 *   AOB_TYPE_<IN>               float, vec2 or vec4: what an input's texels are, so that one text can filter
 *                               visibilities and bent normals
 * The surface that pixel p of the outputs stands for: the G-buffer's pixel p * divisor of the outputs.
 *   vec3  aob_surface(ivec2 p)               its view-space point
 *   vec3  aob_surface_normal(ivec2 p)        its normal, view space, as the G-buffer holds it: in a right one a unit vector
 *                                            towards the camera (common/facing.glsl mends others)
 *   float aob_surface_z(ivec2 p)             its depth, scene units; AOB_SKY_Z where there is no surface
 *   bool  aob_surface_is_sky(ivec2 p)        no surface: sky, or a depth that is not above 0 and finite. What is read
 *                                            about such a pixel may be no number: phrase tests of a tap so that NaN fails
 *   vec3  aob_albedo(ivec2 p)                its base colour, linear, 0..1 (AOB_MATERIAL, as the next two); times 1 - metalness it is
 *                                            what the surface reflects diffusely. Held in 8 bits, as its square root
 *   float aob_roughness(ivec2 p)             0 a mirror to 1
 *   float aob_metalness(ivec2 p)             0 to 1
 *   vec3  aob_light(int i)                   the scene's light: coefficient i = 0..8 of spherical harmonics (l, m) = 00, 1-1, 10,
 *                                            11, 2-2, 2-1, 20, 21, 22, R G B, view space (AOB_LIGHT; common/harmonics.glsl)
 *   bool  aob_is_clear(ivec2 p)              nothing can occlude it (struct aob_clearance), or it is sky: write what an open surface
 *                                            has, and return. False throughout unless the run option `thrift` is on (AOB_CLEARANCE)
 *   vec2  aob_image(ivec2 p)                 where it lies among the pixels of the depth below (centres at +.5)
 * What was in the frame before (AOB_VELOCITY). The first counts the pixels of the whole G-buffer, p * AOB_DIVISOR of the outputs'.
 *   vec3  aob_before(ivec2 f)                where the surface of pixel f was: x and y the place in the image (centres at +.5), z its
 *                                            depth then; z is AOB_SKY_Z of the sky, and of what was behind the camera. Held in half
 *                                            floats: x, y and the change of depth to one part in 2048 of themselves
 *   vec3  aob_place_before(vec3 v)           the place in the frame before, view space of then, of what stands still and is at v now
 *   vec3  aob_direction_before(vec3 d)       the same of a direction
 *   vec3  aob_place_now(vec3 v)              the other way, as is vec3 aob_direction_now(vec3 d)
 * The depth that the pass reads: the G-buffer's, or `depth`. Where its divisor is the outputs', p means the same
 * pixel in both.
 *   ivec2 aob_size              its pixels, guard band included
 *   float aob_view_z(ivec2 p)   depth of the surface in pixel p, scene units; AOB_SKY_Z where there is none
 *   bool  aob_is_sky(ivec2 p)                likewise
 *   float aob_depth_error(float z)           how far the G-buffer's encoding may have rounded such a depth; 0 where it holds floats as
 *                                            fine as a shader's own, and then AOB_DEPTH_EXACT is 1, else 0
 *   vec3  aob_position(ivec2 p)              view-space point of the surface in pixel p, at the pixel's centre
 *   vec3  aob_position_at(vec2 q, float z)   the same at image position q and depth z
 *   vec3  aob_normal(ivec2 p)                normal of the surface in pixel p, likewise
 *   vec2  aob_project(vec3 v)                image position of a view-space point with v.z < 0
 *   vec3  aob_view_vector(vec3 v)            unit vector from view-space point v to the eye
 *   float aob_pixel_radius(float z, float r) pixels that a length r covers at depth z, parallel to the image
 *   float aob_random(ivec2 p, int i)         uniform in [0, 1): hash of pixel, i, and the seed `param.seed`
 *                                            where the technique has such a parameter
 *   T     aob_fetch_<in>(ivec2 p)            texel of an input, clamped to its edge; T is float, vec2 or vec4
 *   T     aob_sample_<in>(vec2 uv)           AOB_BILINEAR inputs only; uv in 0..1, clamped
 * Each of the two, and aob_view_z, also takes a level after its argument: 0 is the finest that the pass reads, and p
 * counts that level's pixels. A level beyond the coarsest that is shown is the coarsest.
 *   param.<name>                AOB_UNIFORM parameters; <NAME> the AOB_CONSTANT ones; <out> the variables
 *                               that the body assigns
 *   AOB_PERSPECTIVE             1 or 0 (orthographic); the functions above serve both, and off-centre frusta
 *   AOB_PI, AOB_SKY_Z           constants
 * The text `vertex` of an AOB_TRIANGLES pass defines, in place of main(),
 *   vec4 place(int triangle, int vertex)     clip-space place of one of the per_triangle vertices; 0 <= z <= w is
 *                                            seen, both sides alike. A drawn triangle without area covers nothing
 * and has the names above but those of the G-buffer (reads) and aob_pixel. In addition it has
 *   vec3  aob_corner(int triangle, int k)    view-space corner k = 0, 1, 2; counter-clockwise seen from the front
 *   vec3  aob_front(int triangle)            unit normal of its front, view space; 0 where it has no area
 *   vec4  aob_clip(vec2 q)                   the clip-space place of image position q (aob_project)
 * and the pass's fragment text has aob_corner(int k) and aob_front() of the triangle whose vertices cover the pixel.
 * Names that start with aob_ or AOB_ are the prelude's. Reads of depth and normal outside the image follow
 * `border`. How a run encodes depth and normals (options depth_encoding, normal_encoding, normals) does not show
 * here but in the values. */

/* --- What the technique claims to compute, so that the ray tracer can compute exactly that --------------- */

enum aob_weight {
    AOB_WEIGHT_COSINE,  /* of the directions on the hemisphere: cos/pi */
    AOB_WEIGHT_UNIFORM, /* 1/(2 pi) */
};
enum aob_distance {
    AOB_DISTANCE_RAY, /* of an occluder: along the ray that meets it */
    AOB_DISTANCE_TRIANGLE, /* to the nearest point of the triangle that the ray meets, however far along the ray; for
                              techniques that draw triangles, whose image depends on how surfaces are cut into them */
};
struct aob_definition {
    enum aob_weight weight; /* a choice parameter `weighting` (cosine, uniform) takes its place */
    float (*radius)(const void *values); /* scene units; NULL: the parameter `radius`; NAN where these
                                                      values' claim cannot be said in the terms below */
    float (*falloff)(const void *values, float t);     /* what an occluder at distance t * radius counts, t in
                                                      [0, 1]; NULL: 1, the hard cutoff */
    enum aob_distance (*distance)(const void *values); /* NULL: AOB_DISTANCE_RAY */
    float (*map)(const void *values, float v); /* of the traced value, where the text maps it; NULL: none */
};

/* --- How it samples: what a convergence study raises, and what it may expect ------------------------------ */

enum aob_sequence {
    AOB_SEQUENCE_NONE,        /* it does not sample */
    AOB_SEQUENCE_STRATIFIED,  /* stratified or of low discrepancy: the error falls faster than the root */
    AOB_SEQUENCE_INDEPENDENT, /* independent random samples: the error falls as the root of their number */
};
struct aob_sampling {
    const char *param; /* the AOB_INT parameter that counts them, such as "slices"; NULL: none */
    enum aob_sequence sequence;
};

/* --- What may be left out ----------------------------------------------------------------------------------- */

/* The run option `thrift` leaves out what nothing can occlude: see AOB_CLEARANCE. It is for techniques that have one value on all
 * open planes. Such a technique says which surfaces can darken another one, by `param.radius`, a uniform parameter, and how much of
 * that changes the value by less than 1/255. */
enum aob_occluders {
    AOB_OCCLUDERS_NEAR, /* those within the radius */
    AOB_OCCLUDERS_IN_FRONT, /* those that are drawn where the ball of the radius is, and lie in front of the surface's plane, however
                               far in front. What lies behind the ball darkens nothing: behind a surface at depth z by
                               r z / (z - r) with perspective, and by r without */
};
struct aob_clearance {
    enum aob_occluders occluders;
    /* How steeply a surface may rise above another's plane, everywhere about it and beginning at the next pixel: the sine of that
     * elevation. 0 where the technique leaves nothing out with these values: they are `unsupported` with the option. */
    float sine;
    /* The next three are for AOB_OCCLUDERS_IN_FRONT. How far at most a surface may lie in front of that plane, along the view axis
     * and along the plane's normal, as a share of the radius; 0: `sine` alone says it. Between 0 and a millionth, which a shader cannot
     * tell from 0, nothing is left out, as where sine is 0. A rise below 0 or that is no number is refused with a line. */
    float rise;
    int32_t least_pixels; /* that the radius must cover in the image */
    bool inside; /* the ball must not leave the image, since reads outside it find the edge (AOB_CLAMP) */
    const char
        *because; /* where sine is 0, why nothing is left out; it follows "X leaves nothing out, because" */
};

/* --- Where its text wants what a hard case calls a fault --------------------------------------------------- */

/* The command `stress` puts every technique to the same properties, whose names `aobudget stress --list` prints. Where the
 * text of a technique makes one fail, the technique says so here with that sentence: the cell is then "by definition". It is
 * measured all the same, so that a line which nothing needs is told. */
struct aob_by_definition {
    const char *property; /* by its name */
    const char *because;  /* what the text does, one sentence, with its place in the text */
};

/* --- Module: const data. A .so exports one symbol, aob_module --------------------------------------------- */

struct aob_shader {
    const char *name, *text;
};
struct aob_technique {
    uint32_t abi, size;           /* AOB_TECHNIQUE sets both; read before any other field */
    const char *name;             /* lower_snake; the config key and the folder in techniques/ and shaders/ */
    const char *title, *citation; /* for `list` and the report */
    const char *summary;          /* what it computes, in one to three sentences; may be NULL */
    const char
        *notes; /* where it departs from its text (slips of a listing, what the text leaves open); or NULL */
    uint32_t revision; /* raise when results should change; part of every case's key */
    const struct aob_param *params;
    uint32_t param_count;
    size_t values_size;               /* sizeof the values struct that params index */
    const struct aob_shader *shaders; /* ended by a NULL name */
    struct aob_definition definition;
    struct aob_sampling sampling;
    struct aob_clearance (*clearance)(const void *values);      /* as above; NULL: it leaves nothing out */
    const struct aob_by_definition *by_definition;              /* ended by a NULL property; NULL: none */
    bool (*check)(const void *values, const char **why);        /* rules across parameters; may be NULL */
    bool (*build)(struct aob_graph *graph, const void *values); /* lay the passes; pure, repeatable */
};
#define AOB_TECHNIQUE(id, ...)                                                                               \
    extern const struct aob_technique aob_technique_##id;                                                    \
    const struct aob_technique aob_technique_##id = {                                                        \
        .abi = AOB_ABI, .size = sizeof(struct aob_technique), .name = #id, __VA_ARGS__}

struct aob_module {
    uint32_t abi, size;
    const struct aob_technique *const *techniques; /* NULL-ended */
};
#define AOB_MODULE(...)                                                                                      \
    extern const struct aob_module aob_module;                                                               \
    const struct aob_module aob_module = {AOB_ABI, sizeof(struct aob_module),                                \
                                          (const struct aob_technique *const[]){__VA_ARGS__, NULL}}
#endif
