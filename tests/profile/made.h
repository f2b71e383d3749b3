/* Profiles and captures that tests make by hand. */
#ifndef AOB_TESTS_PROFILE_MADE_H
#define AOB_TESTS_PROFILE_MADE_H
#include <jansson.h>
#include <stdio.h>
#include <string.h>
#include "check.h"
#include "profile/simulate.h"

/* Two units, tiles of 8 x 8, warps of 8 x 4, linear; one level of 4 ways of 64-byte lines, hashed. */
static inline struct aob_profile made_profile(void)
{
    return (struct aob_profile){.name = (char *)(uintptr_t) "made",
                                .units = 2,
                                .in_flight = 3,
                                .tile = {8, 8},
                                .block = {8, 8},
                                .warp = {8, 4},
                                .layout = AOB_LAYOUT_LINEAR,
                                .block_height = 16,
                                .levels = {{.name = "L1",
                                            .size = 1024,
                                            .line = 64,
                                            .sector = 64,
                                            .ways = 4,
                                            .sets = 4,
                                            .index = AOB_INDEX_XOR,
                                            .units = 1,
                                            .cold_at_pass = true}},
                                .level_count = 1};
}

static inline void made_texture(struct aob_trace_frame *frame, const char *name, enum aob_format format,
                                int width, int height, int levels)
{
    struct aob_trace_texture *texture = &frame->textures[frame->texture_count++];
    *texture =
        (struct aob_trace_texture){.format = format, .width = width, .height = height, .levels = levels};
    snprintf(texture->name, sizeof texture->name, "%s", name);
}

/* The same, of the screen. */
static inline void made_screen(struct aob_trace_frame *frame, enum aob_trace_role role,
                               enum aob_format format, int width, int height, int levels)
{
    made_texture(frame, role == AOB_TRACE_ROLE_DEPTH ? "depth" : "normal", format, width, height, levels);
    frame->textures[frame->texture_count - 1].role = role;
}

/* A pass of that area that reads level 0 of texture 0. */
static inline struct aob_trace_pass made_pass(const struct aob_trace_frame *frame, int width, int height)
{
    struct aob_trace_pass pass = {.name = "made", .width = width, .height = height, .plane_count = 1};
    pass.planes[0] =
        (struct aob_trace_plane){.width = frame->textures[0].width, .height = frame->textures[0].height};
    return pass;
}

/* Gives the words of a pass without fragments to a sink in bands. */
static inline bool made_send(const struct aob_trace_sink *sink, const struct aob_trace_frame *frame,
                             const struct aob_trace_pass *pass, const uint32_t *words, int slots,
                             struct aob_error *error)
{
    bool ok = sink->begin(sink->self, frame, pass, error);
    for (int row = 0; ok && row < pass->height; row += AOB_TRACE_BAND_ROWS) {
        int rows = pass->height - row < AOB_TRACE_BAND_ROWS ? pass->height - row : AOB_TRACE_BAND_ROWS;
        struct aob_trace_band band = {.row = row,
                                      .rows = rows,
                                      .count = (size_t)rows * (size_t)pass->width,
                                      .slots = slots,
                                      .words = words + (size_t)row * (size_t)pass->width * (size_t)slots};
        ok = sink->band(sink->self, &band, error);
    }
    return ok && sink->end(sink->self, error);
}

/* The number at a path of a document: "passes.0.levels.1.one.misses". */
static inline double made_real_at(const json_t *object, const char *path)
{
    char copy[128], *rest = copy, *name;
    snprintf(copy, sizeof copy, "%s", path);
    while (object && (name = strsep(&rest, ".")))
        object = *name >= '0' && *name <= '9' ? json_array_get(object, (size_t)(*name - '0'))
                                              : json_object_get(object, name);
    if (!json_is_number(object))
        fail_msg("there is no number at %s", path);
    return json_number_value(object);
}
#endif
