/* Which channels of another renderer's EXR file are depth and normal, by their names. Only the last two parts of a
 * name count ("ViewLayer.Depth.Z" is Depth.Z), without regard to case, spaces and punctuation within a part.
 *
 * Depth, the first of these that is there:
 *   1. Z                                   (Arnold, RenderMan, OpenEXR's own name)
 *   2. DEPTH.Z                             (Blender: ViewLayer.Depth.Z)
 *   3. ANY.Z that is no part of a vector   (a part of a file, or a layer, with a Z of its own)
 *   4. DEPTH.V, DEPTH.R                    (Blender's compositor; Unreal: FinalImageSceneDepth.R)
 *   5. DEPTH.Y, DEPTH.X
 *   6. DEPTH                               (VRayZDepth, Image.Depth)
 * where DEPTH is "z" or ends with "depth". Normals: NORMAL.X .Y .Z or .R .G .B, where NORMAL is N, Nn, Normal or
 * Normals, else ends with one of the last two. Blender's "Denoising ..." passes are not taken. */
#ifndef AOB_GBUFFER_CAPTURE_CHANNEL_H
#define AOB_GBUFFER_CAPTURE_CHANNEL_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "config/convention.h"

enum { AOB_CHANNEL_NONE = -1 };
struct aob_capture_channels {
    int depth;     /* index among the names */
    int normal[3]; /* AOB_CHANNEL_NONE thrice: there are none, or they are not wanted */
    int other_depth,
        other_normal; /* another that would do as well (a normal by its X); else AOB_CHANNEL_NONE */
};

/* False after one line if there is no depth (the line lists the channels), or if the convention names channels that
 * are not there. */
bool aob_capture_channels_choose(struct aob_capture_channels *channels, const char *const *names,
                                 size_t count, const struct aob_convention *convention,
                                 struct aob_error *error);

/* Writes a name that came from a file as printable ASCII, at most `size` - 1 letters. */
void aob_capture_channel_print(const char *name, char *text, size_t size);
#endif
