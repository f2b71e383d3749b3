#include "fuzz_draw.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "frame/frame.h"
#include "score/bent.h"
#include "score/effect.h"

static const char *const fault_words[AOB_FUZZ_FAULT_COUNT] = {
    "fine",         "refused", "error", "not finite", "out of range", "sky not open", "not the same again",
    "worker ended",
};

const char *aob_fuzz_fault_word(enum aob_fuzz_fault fault)
{
    return fault_words[fault];
}

enum aob_fuzz_fault aob_fuzz_fault_find(const char *word)
{
    for (int i = 0; word && i < AOB_FUZZ_FAULT_COUNT; i++)
        if (strcmp(word, fault_words[i]) == 0)
            return (enum aob_fuzz_fault)i;
    return AOB_FUZZ_FINE;
}

static void make_geometry(const struct aob_fuzz_frame *frame, struct aob_geometry *geometry)
{
    const struct aob_camera camera = {.target = {0, 0, -1}, .fov_deg = 60};
    struct aob_mesh mesh = {0};
    for (size_t i = 0; i < frame->triangle_count; i++) {
        uint32_t first = aob_mesh_add_vertex(&mesh, frame->corners[i][0]);
        aob_mesh_add_vertex(&mesh, frame->corners[i][1]);
        aob_mesh_add_vertex(&mesh, frame->corners[i][2]);
        aob_mesh_add_triangle(&mesh, first, first + 1, first + 2);
    }
    aob_geometry_init(geometry, &mesh, &camera);
    aob_mesh_finish(&mesh);
}

/* A frame that nobody drew before: new textures, which hold whatever their memory held. */
static enum aob_fuzz_fault draw_once(const struct aob_frame_desc *desc, struct aob_screen *screen,
                                     struct aob_reading *drawn, struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    bool ok = aob_frame_init_desc(frame, screen, desc, error);
    bool unfit = !ok && frame->unfit;
    ok = ok && aob_frame_run(frame, 1, NULL, error);
    for (int which = 0; ok && which < AOB_OUTPUT_COUNT; which++) {
        enum aob_output output = (enum aob_output)which;
        ok = !aob_graph_gives(&frame->graph, output) ||
             aob_frame_read(frame, output, aob_output_components(output), drawn->of[which], error);
    }
    aob_frame_finish(frame);
    free(frame);
    return ok ? AOB_FUZZ_FINE : unfit ? AOB_FUZZ_REFUSED : AOB_FUZZ_ERROR;
}

static enum aob_fuzz_fault draw_twice(const struct aob_frame_desc *desc, struct aob_screen *screen,
                                      struct aob_fuzz_sight *sight, struct aob_error *error)
{
    enum aob_fuzz_fault fault = draw_once(desc, screen, &sight->drawn[0], error);
    return fault == AOB_FUZZ_FINE ? draw_once(desc, screen, &sight->drawn[1], error) : fault;
}

static enum aob_fuzz_fault draw(struct aob_fuzz_artist *artist, const struct aob_fuzz_frame *frame,
                                struct aob_fuzz_sight *sight, struct aob_error *error)
{
    struct aob_subject *subject = &artist->subject;
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_screen screen;
    struct aob_geometry geometry = {0};
    const char *why = NULL;
    aob_fuzz_frame_pack(frame, values, &options);
    if (subject->technique->check && !subject->technique->check(values, &why))
        return AOB_FUZZ_REFUSED;
    if (!aob_screen_init(&screen, subject->gpu, &frame->gbuffer, &options, error))
        return screen.unfit ? AOB_FUZZ_REFUSED : AOB_FUZZ_ERROR;
    const struct aob_frame_desc desc = {.technique = subject->technique,
                                        .values = values,
                                        .fetch = (enum aob_fetch)options.fetch,
                                        .wanted = aob_options_wanted(&options),
                                        .programs = &subject->programs};
    enum aob_fuzz_fault fault = AOB_FUZZ_ERROR;
    screen.light = frame->light; /* the view is the world */
    if (artist->triangles) {
        make_geometry(frame, &geometry);
        screen.geometry = &geometry;
    }
    if (!artist->triangles || aob_geometry_upload(&geometry, subject->gpu, error))
        fault = draw_twice(&desc, &screen, sight, error);
    aob_geometry_finish(&geometry);
    aob_screen_finish(&screen);
    return fault;
}

/* What a surface's values of an output may not be. */
static bool is_in_range(enum aob_output output, const float *values)
{
    const float depth = 1;
    const struct aob_score_desc desc = {.width = 1, .height = 1, .depth = &depth, .sky_depth = 2};
    const struct aob_effect effect = {
        .output = output, .components = aob_output_components(output), .image = values};
    if (output == AOB_OUT_VISIBILITY)
        return values[0] >= 0 && values[0] <= 1;
    return output == AOB_OUT_BENT_NORMAL ? aob_bent_is_sound(values) : aob_effect_judge(&desc, &effect, NULL);
}

static enum aob_fuzz_fault judge_pixel(const struct aob_fuzz_frame *frame, const struct aob_fuzz_sight *sight,
                                       enum aob_output output, size_t i)
{
    enum aob_fuzz_pixel kind = (enum aob_fuzz_pixel)frame->pixels[aob_fuzz_frame_place(frame, i)];
    size_t stride = (size_t)aob_output_components(output);
    const float *values = sight->drawn[0].of[output] + stride * i,
                *again = sight->drawn[1].of[output] + stride * i;
    for (size_t c = 0; c < stride; c++)
        if (!isfinite(values[c]))
            return AOB_FUZZ_NOT_FINITE;
    if (kind == AOB_FUZZ_SKY && output == AOB_OUT_VISIBILITY && values[0] != 1)
        return AOB_FUZZ_NOT_OPEN;
    if (kind == AOB_FUZZ_SURFACE && !is_in_range(output, values))
        return AOB_FUZZ_RANGE;
    return memcmp(values, again, stride * sizeof *values) == 0 ? AOB_FUZZ_FINE : AOB_FUZZ_AGAIN;
}

static void tell(const struct aob_fuzz_frame *frame, struct aob_fuzz_sight *sight, enum aob_output output,
                 size_t i)
{
    static const char *const kinds[] = {"a surface", "sky", "hostile"};
    int width = aob_fuzz_frame_width(frame), height = aob_fuzz_frame_height(frame);
    size_t stride = (size_t)aob_output_components(output);
    const float *values = sight->drawn[0].of[output] + stride * i;
    struct aob_text text = {0};
    for (size_t c = 0; c < stride; c++)
        aob_text_add(&text, "%s%.9g", c ? ", " : "", (double)values[c]);
    aob_line_print(sight->sentence, sizeof sight->sentence, "pixel (%d, %d) of %dx%d, %s, has the %s %s%s",
                   (int)(i % (size_t)width), (int)(i / (size_t)width), width, height,
                   kinds[frame->pixels[aob_fuzz_frame_place(frame, i)]], aob_output_name(output), text.data,
                   sight->fault == AOB_FUZZ_AGAIN ? ", and another in a second drawing" : "");
    aob_text_finish(&text);
}

static void judge(const struct aob_fuzz_frame *frame, struct aob_fuzz_sight *sight)
{
    size_t count = (size_t)aob_fuzz_frame_width(frame) * (size_t)aob_fuzz_frame_height(frame);
    for (size_t i = 0; i < count; i++)
        for (int which = 0; which < AOB_OUTPUT_COUNT && sight->fault == AOB_FUZZ_FINE; which++) {
            sight->fault = judge_pixel(frame, sight, (enum aob_output)which, i);
            if (sight->fault != AOB_FUZZ_FINE)
                tell(frame, sight, (enum aob_output)which, i);
        }
}

void aob_fuzz_draw(struct aob_fuzz_artist *artist, const struct aob_fuzz_frame *frame,
                   struct aob_fuzz_sight *sight)
{
    struct aob_error error = {{0}};
    size_t count = (size_t)aob_fuzz_frame_width(frame) * (size_t)aob_fuzz_frame_height(frame);
    *sight = (struct aob_fuzz_sight){.fault = AOB_FUZZ_FINE};
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        for (int time = 0; time < 2; time++)
            sight->drawn[time].of[which] =
                AOB_NEW_ARRAY(float, (size_t)aob_output_components((enum aob_output)which) * count);
    sight->fault = draw(artist, frame, sight, &error);
    if (sight->fault == AOB_FUZZ_FINE)
        judge(frame, sight);
    else
        aob_line_print(sight->sentence, sizeof sight->sentence, "%s", error.text);
}

void aob_fuzz_sight_finish(struct aob_fuzz_sight *sight)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        for (int time = 0; time < 2; time++)
            free(sight->drawn[time].of[which]);
    *sight = (struct aob_fuzz_sight){.fault = AOB_FUZZ_FINE};
}
