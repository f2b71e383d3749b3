/* A captured frame: depth and normals from another renderer's EXR file, brought to the form of the canonical G-buffer.
 * The file is a stranger's, so this runs in a worker. One thread.
 *
 * Sky is what is not finite, not above 0, 5e8 or more, 65504 (the largest half, where Blender puts the sky), at `far`
 * or beyond, or at a depth buffer's far value; and what the file has no pixels for.
 * Normals are turned to the camera and normalised. Where a pixel has none it is derived from depth: of the two
 * neighbours on each axis the one that is nearer in depth, and their cross product. */
#ifndef AOB_GBUFFER_CAPTURE_H
#define AOB_GBUFFER_CAPTURE_H
#include <stdbool.h>
#include "base/error.h"
#include "config/convention.h"
#include "reference/tracer.h"
#include "scene/camera.h"

struct aob_capture_desc {
    const char *file;
    struct aob_convention convention; /* aob_convention_check has passed it */
    double fov_deg, ortho_height;     /* 0: the file says it, as files of this program do */
    bool has_camera; /* eye and target are given; else the file's, else at 0 looking along -Z */
    struct aob_vec3 eye, target;
};
enum { AOB_CAPTURE_WARNINGS = 2 };
struct aob_capture {
    struct aob_camera camera;
    struct aob_hits
        hits; /* depth, normal, shading (the same), primitive 0; the size is the display window's */
    size_t surface, derived; /* pixels that are no sky; of these, with a derived normal */
    struct aob_error warnings[AOB_CAPTURE_WARNINGS]; /* where another channel would do as well */
    size_t warning_count;
};

/* False with one line that names the file. Allocates; aob_capture_finish frees. */
bool aob_capture_read(struct aob_capture *capture, const struct aob_capture_desc *desc,
                      struct aob_error *error);
void aob_capture_finish(struct aob_capture *capture);

/* For aob_capture_read: fills normal and shading from `planes`, three of the file's or NULL thrice. */
bool aob_capture_normals(struct aob_capture *capture, const struct aob_capture_desc *desc,
                         const float *const planes[3], bool camera_known, struct aob_error *error);

/* Raised when what a file is read as could change; part of its digest. */
extern const char aob_capture_version[];
#endif
