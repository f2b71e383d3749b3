/* The G-buffer on a device, in the encodings of some options; shared by the frames of a block that have the same. */
#ifndef AOB_FRAME_SCREEN_H
#define AOB_FRAME_SCREEN_H
#include "base/error.h"
#include "gbuffer/encoding.h"
#include "gbuffer/gbuffer.h"
#include "geometry.h"
#include "gpu/gpu.h"
#include "scene/affine.h"
#include "scene/light.h"
#include "technique/option.h"

struct aob_screen {
    struct aob_gpu *gpu;
    const struct aob_gbuffer *gbuffer; /* must outlive it */
    struct aob_options options;        /* that it was made for */
    struct aob_encoding encoding;
    struct aob_gpu_texture *depth,
        *normal; /* one texture where they are packed together; normal may be NULL */
    struct aob_gpu_texture *albedo, *shine; /* NULL until a frame reads materials */
    struct aob_gpu_texture *velocity;       /* NULL until a frame reads it (velocity_texels.h) */
    uint32_t uses;                          /* of these textures: sampled or storage */
    const struct aob_geometry
        *geometry;          /* uploaded; set by the owner; NULL: a capture, or nothing needs it */
    struct aob_light light; /* view space; uniform until the owner sets another */
    struct aob_affine
        then;   /* from view space to that of the frame before (aob_camera_then); the identity at first */
    bool unfit; /* after a refusal: the device lacks something that the encoding needs (unsupported) */
};

/* False leaves nothing behind but `unfit`. */
bool aob_screen_init(struct aob_screen *screen, struct aob_gpu *gpu, const struct aob_gbuffer *gbuffer,
                     const struct aob_options *options, struct aob_error *error);
void aob_screen_finish(struct aob_screen *screen);

/* Uploads what a frame of these reads (enum aob_read bits) needs besides depth and normal, unless it is there: nothing is
 * paid for materials that nobody reads. False after one line; `unfit` then says whose fault it is. */
bool aob_screen_provide(struct aob_screen *screen, uint32_t reads, struct aob_error *error);

/* Another frame of a sequence in the same encodings: what is uploaded of the G-buffer is written again, of a view of the same size and
 * lens. Light and motion are of that frame. What frames know of a view in their uniforms follows with aob_frame_set. False after
 * one line: the encodings do not fit the view, or the device fails; the screen is then of neither frame. */
struct aob_screen_pose {
    const struct aob_gbuffer *gbuffer; /* must outlive the screen, or the next pose */
    const struct aob_light *light;     /* view space */
    struct aob_affine then;            /* as above */
};
bool aob_screen_show(struct aob_screen *screen, const struct aob_screen_pose *pose, struct aob_error *error);
#endif
