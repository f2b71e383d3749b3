#include "backends.h"

static const struct {
    size_t size;
    int components;
    const char *layout;
} formats[AOB_FORMAT_COUNT] = {
    [AOB_R8] = {1, 1, "r8"},           [AOB_R16] = {2, 1, "r16"},
    [AOB_R16F] = {2, 1, "r16f"},       [AOB_R32F] = {4, 1, "r32f"},
    [AOB_RG8] = {2, 2, "rg8"},         [AOB_RG16F] = {4, 2, "rg16f"},
    [AOB_RG32F] = {8, 2, "rg32f"},     [AOB_RGBA8] = {4, 4, "rgba8"},
    [AOB_RGBA16F] = {8, 4, "rgba16f"}, [AOB_RGBA32F] = {16, 4, "rgba32f"},
};

size_t aob_gpu_texel_size(enum aob_format format)
{
    return formats[format].size;
}

int aob_gpu_texel_components(enum aob_format format)
{
    return formats[format].components;
}

const char *aob_gpu_format_layout(enum aob_format format)
{
    return formats[format].layout;
}

struct aob_gpu_texture aob_gpu_texture_base(const struct aob_gpu_texture_desc *desc)
{
    return (struct aob_gpu_texture){.format = desc->format,
                                    .width = desc->width,
                                    .height = desc->height,
                                    .levels = desc->levels ? desc->levels : 1,
                                    .uses = desc->uses,
                                    .filled = desc->texels != NULL};
}

int aob_gpu_level_side(int side, int level)
{
    return side >> level ? side >> level : 1;
}

size_t aob_gpu_level_bytes(const struct aob_gpu_texture *texture, int level)
{
    return (size_t)aob_gpu_level_side(texture->width, level) *
           (size_t)aob_gpu_level_side(texture->height, level) * aob_gpu_texel_size(texture->format);
}

int aob_gpu_bind_levels(const struct aob_gpu_bind *bind)
{
    return bind->level_count ? bind->level_count : bind->texture->levels - bind->first_level;
}
