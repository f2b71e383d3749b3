#include "fuzz_frame.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "technique/param.h"
#include "scene/light_json.h"

enum { FEW_PIXELS = 16 };

static struct aob_chance chance_of(const struct aob_fuzz_name *name, const char *what, uint64_t number)
{
    struct aob_text text = {0};
    aob_text_add(&text, "fuzz %llu %s %s %s %llu", (unsigned long long)name->seed, name->technique->name,
                 name->backend, what, (unsigned long long)number);
    struct aob_chance chance = aob_chance_of(text.data);
    aob_text_finish(&text);
    return chance;
}

/* What frames share of a view. */
struct shared_view {
    bool perspective;
    bool powers[2]; /* width and height with their guard bands are powers of two, or are not */
};

static struct shared_view draw_shared(struct aob_chance *shared)
{
    struct shared_view view;
    view.perspective = !aob_chance_once_in(shared, 3);
    for (int i = 0; i < 2; i++)
        view.powers[i] = aob_chance_once_in(shared, 4);
    return view;
}

/* There is such a side for every guard band: 24 and less, or 32 less the two bands. */
static int draw_side(struct aob_chance *chance, int guard, bool power)
{
    for (;;) {
        int side = (int)aob_chance_log(chance, 1, AOB_FUZZ_SIDE + 0.999), whole = side + 2 * guard;
        if (((whole & (whole - 1)) == 0) == power)
            return side;
    }
}

/* Any field of view, any height, and one view in four shifted as far as half the image. */
static void draw_projection(struct aob_fuzz_frame *frame, struct aob_chance *chance,
                            const struct shared_view *shared, double scale)
{
    struct aob_camera camera = {.target = {0, 0, -1}, .fov_deg = 60};
    int guard = (int)aob_chance_below(chance, AOB_FUZZ_GUARD + 1);
    int width = draw_side(chance, guard, shared->powers[0]),
        height = draw_side(chance, guard, shared->powers[1]);
    if (!shared->perspective)
        camera.ortho_height = scale * aob_chance_log(chance, 1e-3, 1e3);
    else if (!aob_chance_once_in(chance, 3))
        camera.fov_deg = aob_chance_once_in(chance, 8) ? (aob_chance_once_in(chance, 2) ? 1 : 170)
                                                       : aob_chance_between(chance, 1, 170);
    if (aob_chance_once_in(chance, 4))
        for (int i = 0; i < 2; i++)
            camera.shift[i] = aob_chance_between(chance, -2, 2);
    frame->gbuffer.projection = aob_camera_projection(&camera, width, height, guard);
    frame->gbuffer.guard = guard;
}

static void allocate(struct aob_fuzz_frame *frame)
{
    size_t count = aob_fuzz_frame_pixels(frame);
    frame->gbuffer.depth = AOB_NEW_ARRAY(float, count);
    frame->gbuffer.normal = AOB_NEW_ARRAY(float, 4 * count);
    frame->gbuffer.shading = AOB_NEW_ARRAY(float, 4 * count);
    frame->gbuffer.velocity = NULL;
    frame->gbuffer.albedo = AOB_NEW_ARRAY(float, 3 * count);
    frame->gbuffer.shine = AOB_NEW_ARRAY(float, 2 * count);
    frame->pixels = AOB_NEW_ARRAY(unsigned char, count);
    frame->calm_depth = AOB_NEW_ARRAY(float, count);
    frame->calm_normal = AOB_NEW_ARRAY(float, 4 * count);
}

/* A corner in three lies where another one does, or on the line of two: such a triangle has no area. */
static void draw_triangle(struct aob_vec3 corners[3], struct aob_chance *chance, double scale)
{
    struct aob_vec3 about = aob_vec(0, 0, -scale * aob_chance_log(chance, 0.3, 3));
    about = aob_vec_add(about, aob_vec_scale(aob_chance_direction(chance), scale * aob_chance_unit(chance)));
    double size = scale * aob_chance_log(chance, 1e-3, 3);
    for (int k = 0; k < 3; k++)
        corners[k] = aob_vec_add(about, aob_vec_scale(aob_chance_direction(chance), size));
    if (aob_chance_once_in(chance, 6))
        corners[2] = corners[aob_chance_below(chance, 2)];
    else if (aob_chance_once_in(chance, 6))
        corners[2] = aob_vec_scale(aob_vec_add(corners[0], corners[1]), 0.5);
}

void aob_fuzz_frame_init(struct aob_fuzz_frame *frame, const struct aob_fuzz_name *name)
{
    struct aob_chance shared = chance_of(name, "shared", name->index / AOB_FUZZ_SHARED);
    struct aob_chance own = chance_of(name, "frame", name->index);
    double scale = aob_chance_log(&own, 1e-2, 1e3);
    const struct shared_view view = draw_shared(&shared);
    *frame = (struct aob_fuzz_frame){.technique = name->technique};
    draw_projection(frame, &own, &view, scale);
    allocate(frame);
    aob_fuzz_values_fixed(frame, &shared);
    aob_fuzz_values_free(frame, &own, scale);
    aob_fuzz_gbuffer_fill(frame, &own, scale);
    frame->triangle_count = 1 + aob_chance_below(&own, AOB_FUZZ_TRIANGLES);
    for (size_t i = 0; i < frame->triangle_count; i++)
        draw_triangle(frame->corners[i], &own, scale);
    aob_fuzz_light_fill(frame, &own);
}

void aob_fuzz_frame_copy(struct aob_fuzz_frame *into, const struct aob_fuzz_frame *from)
{
    size_t count = aob_fuzz_frame_pixels(from);
    *into = *from;
    allocate(into);
    memcpy(into->gbuffer.depth, from->gbuffer.depth, count * sizeof(float));
    memcpy(into->gbuffer.normal, from->gbuffer.normal, 4 * count * sizeof(float));
    memcpy(into->gbuffer.shading, from->gbuffer.shading, 4 * count * sizeof(float));
    memcpy(into->gbuffer.albedo, from->gbuffer.albedo, 3 * count * sizeof(float));
    memcpy(into->gbuffer.shine, from->gbuffer.shine, 2 * count * sizeof(float));
    memcpy(into->pixels, from->pixels, count);
    memcpy(into->calm_depth, from->calm_depth, count * sizeof(float));
    memcpy(into->calm_normal, from->calm_normal, 4 * count * sizeof(float));
}

void aob_fuzz_frame_finish(struct aob_fuzz_frame *frame)
{
    aob_gbuffer_finish(&frame->gbuffer);
    free(frame->pixels);
    free(frame->calm_depth);
    free(frame->calm_normal);
    *frame = (struct aob_fuzz_frame){0};
}

int aob_fuzz_frame_width(const struct aob_fuzz_frame *frame)
{
    return frame->gbuffer.projection.width - 2 * frame->gbuffer.guard;
}

int aob_fuzz_frame_height(const struct aob_fuzz_frame *frame)
{
    return frame->gbuffer.projection.height - 2 * frame->gbuffer.guard;
}

size_t aob_fuzz_frame_pixels(const struct aob_fuzz_frame *frame)
{
    return (size_t)frame->gbuffer.projection.width * (size_t)frame->gbuffer.projection.height;
}

size_t aob_fuzz_frame_place(const struct aob_fuzz_frame *frame, size_t i)
{
    size_t width = (size_t)aob_fuzz_frame_width(frame), guard = (size_t)frame->gbuffer.guard;
    return (i / width + guard) * (width + 2 * guard) + i % width + guard;
}

size_t aob_fuzz_frame_hostile(const struct aob_fuzz_frame *frame)
{
    size_t hostile = 0;
    for (size_t i = 0; i < aob_fuzz_frame_pixels(frame); i++)
        hostile += frame->pixels[i] == AOB_FUZZ_HOSTILE;
    return hostile;
}

void aob_fuzz_frame_pack(const struct aob_fuzz_frame *frame, void *values, struct aob_options *options)
{
    const struct aob_technique *t = frame->technique;
    aob_param_pack(t->params, t->param_count, frame->params, values, 4 * AOB_MAX_PARAM);
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, frame->options, options, sizeof *options);
}

static json_t *values_to_json(const struct aob_param *params, size_t count, const double *values)
{
    json_t *object = json_object();
    for (size_t i = 0; i < count; i++) {
        struct aob_text text = {0};
        aob_param_print(&params[i], values[i], &text);
        json_object_set_new(object, params[i].name, json_string(text.data));
        aob_text_finish(&text);
    }
    return object;
}

static json_t *triangles_to_json(const struct aob_fuzz_frame *frame)
{
    json_t *triangles = json_array();
    for (size_t i = 0; i < frame->triangle_count; i++)
        json_array_append_new(triangles, aob_json_vector(&frame->corners[i][0].x, 9));
    return triangles;
}

static void add_number(json_t *array, float value)
{
    char text[32];
    snprintf(text, sizeof text, "%.9g", (double)value);
    json_array_append_new(array, json_string(text));
}

/* Depth and normal of each pixel of the G-buffer as texts, row by row: there are no such numbers in JSON as hostile ones. */
static json_t *pixels_to_json(const struct aob_fuzz_frame *frame)
{
    static const char *const kinds[] = {"surface", "sky", "hostile"};
    json_t *pixels = json_array();
    for (size_t i = 0; i < aob_fuzz_frame_pixels(frame); i++) {
        json_t *numbers = json_array();
        add_number(numbers, frame->gbuffer.depth[i]);
        for (size_t c = 0; c < 3; c++)
            add_number(numbers, frame->gbuffer.normal[4 * i + c]);
        json_array_append_new(pixels, json_pack("{s:o}", kinds[frame->pixels[i]], numbers));
    }
    return pixels;
}

json_t *aob_fuzz_frame_to_json(const struct aob_fuzz_frame *frame)
{
    const struct aob_projection *p = &frame->gbuffer.projection;
    bool few = aob_fuzz_frame_pixels(frame) <= FEW_PIXELS; /* the images have them all */
    json_t *view =
        json_pack("{s:b, s:i, s:i, s:i, s:f, s:f, s:f, s:f}", "perspective", p->perspective, "width",
                  aob_fuzz_frame_width(frame), "height", aob_fuzz_frame_height(frame), "guard",
                  frame->gbuffer.guard, "sx", p->sx, "sy", p->sy, "cx", p->cx, "cy", p->cy);
    return json_pack("{s:o, s:o, s:o, s:o, s:I, s:o, s:o*}", "params",
                     values_to_json(frame->technique->params, frame->technique->param_count, frame->params),
                     "options", values_to_json(aob_option_params, AOB_OPTION_COUNT, frame->options), "light",
                     aob_light_to_json(&frame->light), "view", view, "hostile_pixels",
                     (json_int_t)aob_fuzz_frame_hostile(frame), "triangles", triangles_to_json(frame),
                     "pixels", few ? pixels_to_json(frame) : NULL);
}
