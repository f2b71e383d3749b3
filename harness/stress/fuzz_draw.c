#include "fuzz_draw.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "frame/frame.h"
#include "score/bent.h"

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
                                     float *pixels, float (*bent)[3], struct aob_error *error)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    bool ok = aob_frame_init_desc(frame, screen, desc, error);
    bool unfit = !ok && frame->unfit;
    ok = ok && aob_frame_run(frame, 1, NULL, error) &&
         aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, pixels, error) &&
         (!aob_graph_gives(&frame->graph, AOB_OUT_BENT_NORMAL) ||
          aob_frame_read(frame, AOB_OUT_BENT_NORMAL, 3, bent[0], error));
    aob_frame_finish(frame);
    free(frame);
    return ok ? AOB_FUZZ_FINE : unfit ? AOB_FUZZ_REFUSED : AOB_FUZZ_ERROR;
}

static enum aob_fuzz_fault draw_twice(const struct aob_frame_desc *desc, struct aob_screen *screen,
                                      struct aob_fuzz_sight *sight, struct aob_error *error)
{
    enum aob_fuzz_fault fault = draw_once(desc, screen, sight->image, sight->bent, error);
    return fault == AOB_FUZZ_FINE ? draw_once(desc, screen, sight->again, sight->bent_again, error) : fault;
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

/* What pixel i of an image may not be. */
static enum aob_fuzz_fault judge_pixel(const struct aob_fuzz_frame *frame, size_t i, float value)
{
    enum aob_fuzz_pixel kind = (enum aob_fuzz_pixel)frame->pixels[aob_fuzz_frame_place(frame, i)];
    if (!isfinite(value))
        return AOB_FUZZ_NOT_FINITE;
    if (kind == AOB_FUZZ_SKY && value != 1)
        return AOB_FUZZ_NOT_OPEN;
    if (kind == AOB_FUZZ_SURFACE && !(value >= 0 && value <= 1))
        return AOB_FUZZ_RANGE;
    return AOB_FUZZ_FINE;
}

static enum aob_fuzz_fault judge_bent(const struct aob_fuzz_frame *frame, size_t i, const float bent[3])
{
    if (!isfinite(bent[0]) || !isfinite(bent[1]) || !isfinite(bent[2]))
        return AOB_FUZZ_NOT_FINITE;
    bool surface = frame->pixels[aob_fuzz_frame_place(frame, i)] == AOB_FUZZ_SURFACE;
    return surface && !aob_bent_is_sound(bent) ? AOB_FUZZ_RANGE : AOB_FUZZ_FINE;
}

static bool is_same(const struct aob_fuzz_sight *sight, size_t i)
{
    return memcmp(&sight->image[i], &sight->again[i], sizeof(float)) == 0 &&
           memcmp(sight->bent[i], sight->bent_again[i], sizeof sight->bent[i]) == 0;
}

static void judge(const struct aob_fuzz_frame *frame, struct aob_fuzz_sight *sight)
{
    static const char *const kinds[] = {"a surface", "sky", "hostile"};
    int width = aob_fuzz_frame_width(frame), height = aob_fuzz_frame_height(frame);
    size_t count = (size_t)width * (size_t)height;
    for (size_t i = 0; i < count && sight->fault == AOB_FUZZ_FINE; i++) {
        const float *bent = sight->bent[i];
        sight->fault = judge_pixel(frame, i, sight->image[i]);
        if (sight->fault == AOB_FUZZ_FINE)
            sight->fault = judge_bent(frame, i, bent);
        if (sight->fault == AOB_FUZZ_FINE && !is_same(sight, i))
            sight->fault = AOB_FUZZ_AGAIN;
        if (sight->fault != AOB_FUZZ_FINE)
            aob_line_print(sight->sentence, sizeof sight->sentence,
                           "pixel (%d, %d) of %dx%d, %s, is %.9g, its bent normal (%.9g, %.9g, %.9g)%s",
                           (int)(i % (size_t)width), (int)(i / (size_t)width), width, height,
                           kinds[frame->pixels[aob_fuzz_frame_place(frame, i)]], (double)sight->image[i],
                           (double)bent[0], (double)bent[1], (double)bent[2],
                           sight->fault == AOB_FUZZ_AGAIN ? ", and another in a second drawing" : "");
    }
}

void aob_fuzz_draw(struct aob_fuzz_artist *artist, const struct aob_fuzz_frame *frame,
                   struct aob_fuzz_sight *sight)
{
    struct aob_error error = {{0}};
    size_t count = (size_t)aob_fuzz_frame_width(frame) * (size_t)aob_fuzz_frame_height(frame);
    *sight = (struct aob_fuzz_sight){.image = AOB_NEW_ARRAY(float, count),
                                     .again = AOB_NEW_ARRAY(float, count),
                                     .bent = aob_alloc(count, sizeof *sight->bent),
                                     .bent_again = aob_alloc(count, sizeof *sight->bent)};
    sight->fault = draw(artist, frame, sight, &error);
    if (sight->fault == AOB_FUZZ_FINE)
        judge(frame, sight);
    else
        aob_line_print(sight->sentence, sizeof sight->sentence, "%s", error.text);
}

void aob_fuzz_sight_finish(struct aob_fuzz_sight *sight)
{
    free(sight->image);
    free(sight->again);
    free(sight->bent);
    free(sight->bent_again);
    *sight = (struct aob_fuzz_sight){.image = NULL};
}
