#include "layout.h"

int aob_layout_texel_bytes(enum aob_format format)
{
    static const int bytes[AOB_FORMAT_COUNT] = {
        [AOB_R8] = 1,    [AOB_R16] = 2,   [AOB_R16F] = 2,  [AOB_R32F] = 4,    [AOB_RG8] = 2,
        [AOB_RG16F] = 4, [AOB_RG32F] = 8, [AOB_RGBA8] = 4, [AOB_RGBA16F] = 8, [AOB_RGBA32F] = 16};
    return bytes[format];
}

static uint32_t round_up(uint32_t value, uint32_t to)
{
    return (value + to - 1) / to * to;
}

/* Blocks are no higher than the plane: a driver halves them while half of one would hold it. */
static uint32_t block_shift(int block_height, uint32_t height)
{
    uint32_t shift = (uint32_t)__builtin_ctz((unsigned)block_height);
    while (shift && height <= 8u << (shift - 1))
        shift--;
    return shift;
}

struct aob_placed aob_layout_level(const struct aob_profile *profile, int bytes, int width, int height,
                                   uint64_t base)
{
    uint32_t w = (uint32_t)width, h = (uint32_t)height, row = w * (uint32_t)bytes, rows = h;
    struct aob_placed placed = {
        .layout = profile->layout, .base = base, .texel_shift = (uint32_t)__builtin_ctz((unsigned)bytes)};
    if (placed.layout == AOB_LAYOUT_LINEAR) {
        row = placed.pitch = round_up(row, AOB_LAYOUT_ROW);
    } else if (placed.layout == AOB_LAYOUT_MORTON) {
        placed.pitch = round_up(w, 8) / 8;
        row = round_up(w, 8) * (uint32_t)bytes;
        rows = round_up(h, 8);
    } else {
        placed.block_shift = block_shift(profile->block_height, h);
        row = round_up(row, 64);
        placed.pitch = row / 64;
        rows = round_up(h, 8u << placed.block_shift);
    }
    placed.size = (uint64_t)row * rows;
    return placed;
}

static int texel_bytes(const struct aob_profile *profile, const struct aob_trace_texture *texture)
{
    if (profile->depth_bytes && texture->role == AOB_TRACE_ROLE_DEPTH)
        return profile->depth_bytes;
    if (profile->normal_bytes && texture->role == AOB_TRACE_ROLE_NORMAL)
        return profile->normal_bytes;
    return aob_layout_texel_bytes(texture->format);
}

static int level_side(int side, int level)
{
    return side >> level ? side >> level : 1;
}

bool aob_layout_place(const struct aob_profile *profile, const struct aob_trace_frame *frame,
                      struct aob_placed_frame *placed, struct aob_error *error)
{
    uint64_t at = 0;
    for (int t = 0; t < frame->texture_count; t++) {
        const struct aob_trace_texture *texture = &frame->textures[t];
        if (texture->levels > AOB_LAYOUT_MAX_LEVEL)
            return aob_fail(error, "texture '%s' has %d levels: a simulation takes %d at most", texture->name,
                            texture->levels, AOB_LAYOUT_MAX_LEVEL);
        placed->bytes[t] = texel_bytes(profile, texture);
        at = (at + AOB_LAYOUT_TEXTURE - 1) / AOB_LAYOUT_TEXTURE * AOB_LAYOUT_TEXTURE;
        for (int l = 0; l < texture->levels; l++) {
            placed->levels[t][l] = aob_layout_level(profile, placed->bytes[t], level_side(texture->width, l),
                                                    level_side(texture->height, l), at);
            at += (placed->levels[t][l].size + AOB_LAYOUT_GOB - 1) / AOB_LAYOUT_GOB * AOB_LAYOUT_GOB;
        }
    }
    placed->size = at;
    return true;
}

static bool has_level(const struct aob_trace_frame *frame, int texture, int level)
{
    return texture >= 0 && texture < frame->texture_count && level >= 0 &&
           level < frame->textures[texture].levels;
}

bool aob_layout_judge(const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                      struct aob_error *error)
{
    for (int p = 0; p < pass->plane_count; p++) {
        const struct aob_trace_plane *plane = &pass->planes[p];
        if (!has_level(frame, plane->texture, plane->level) ||
            plane->width != level_side(frame->textures[plane->texture].width, plane->level) ||
            plane->height != level_side(frame->textures[plane->texture].height, plane->level))
            return aob_fail(error, "pass '%s': plane %d of its trace is no level of a texture of the frame",
                            pass->name, p);
    }
    for (int w = 0; w < pass->write_count; w++)
        if (!has_level(frame, pass->writes[w].texture, pass->writes[w].level))
            return aob_fail(error, "pass '%s': target %d of its trace is no level of a texture of the frame",
                            pass->name, w);
    return true;
}
