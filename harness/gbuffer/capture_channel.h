/* Which channels of another renderer's EXR file are depth and normal, by their names, without regard to case, spaces
 * and punctuation within a part of a name. Parts lie between dots: "left.Fg.Depth.Z" has four.
 *
 * Depth, the first of these that is there:
 *   1. Z                                   (Arnold, RenderMan, OpenEXR's own name)
 *   2. DEPTH.Z                             (Blender: ViewLayer.Depth.Z)
 *   3. DEPTH.ANY.Z                         (a view of several: Depth.left.Z)
 *   4. ANY.Z that is no part of a vector   (a part of a file, a layer or a view, with a Z of its own)
 *   5. DEPTH.V, DEPTH.R                    (Blender's compositor; Unreal: FinalImageSceneDepth.R)
 *   6. DEPTH.Y, DEPTH.X
 *   7. DEPTH                               (VRayZDepth, Image.Depth)
 *   8. 5 and 6 with other parts between DEPTH and the last one (depth.left.V)
 * where DEPTH is "z" or ends with "depth". A name is no depth if any part of it holds "mist", "inv", "recip", "dispar" or
 * "denois": a mist, an inverse depth, or a pass that is smoothed for a denoiser.
 *
 * Normals: NORMAL.X .Y .Z or .R .G .B, where NORMAL is N, Nn, Normal or Normals, else ends with one of the last two and
 * does not hold "denois", else has other parts behind it.
 *
 * A channel's layer is its name without those words: that of "left.Fg.Depth.Z" and of "Fg.left.N.X" is Fg of left. Of
 * several depths that stand equally high, one is taken whose layer has a normal, else the first of the file. Normals
 * of the depth's layer go before all others. */
#ifndef AOB_GBUFFER_CAPTURE_CHANNEL_H
#define AOB_GBUFFER_CAPTURE_CHANNEL_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "config/convention.h"

enum { AOB_CHANNEL_NONE = -1, AOB_CHANNEL_LAYER = 64 };
struct aob_capture_channels {
    int depth;        /* index among the names */
    int normal[3];    /* AOB_CHANNEL_NONE thrice: there are none, or they are not wanted */
    int other_depth;  /* another that would do as well; else AOB_CHANNEL_NONE */
    int other_normal; /* another of the same layer that would do as well, by its X; else AOB_CHANNEL_NONE */
    char layer[AOB_CHANNEL_LAYER]; /* of the depth (capture_name.h) */
    bool mixed; /* depth and normals are of different layers, and the convention does not name both */
};

/* False after one line if there is no depth (the line lists the channels), or if the convention names channels that
 * are not there. */
bool aob_capture_channels_choose(struct aob_capture_channels *channels, const char *const *names,
                                 size_t count, const struct aob_convention *convention,
                                 struct aob_error *error);

/* Writes a name that came from a file as printable ASCII, at most `size` - 1 letters. */
void aob_capture_channel_print(const char *name, char *text, size_t size);
#endif
