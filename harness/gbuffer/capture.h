/* A captured frame: depth and normals from another renderer's EXR file, brought to the form of the canonical
 * G-buffer. The file comes from a stranger, so this runs in a worker, on one thread.
 *
 * A pixel is sky if its depth is not finite, not above 0, 5e8 or more, 65504 (the largest half, where Blender puts
 * the sky), at `far` or beyond, or at a depth buffer's far value, or if the file has no pixel there. Normals are
 * turned to the camera and normalised. If a pixel has none, it is derived from depth: on each axis the neighbour
 * nearer in depth is taken, and the cross product of the two gives the normal. */
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
    struct aob_error warnings[AOB_CAPTURE_WARNINGS]; /* one where another channel would do as well */
    size_t warning_count;
};

/* False with one line that names the file. Allocates; aob_capture_finish frees. */
bool aob_capture_read(struct aob_capture *capture, const struct aob_capture_desc *desc,
                      struct aob_error *error);
void aob_capture_finish(struct aob_capture *capture);

/* Fills normal and shading from `planes`, which are three of the file's or NULL three times. It serves
 * aob_capture_read. */
bool aob_capture_normals(struct aob_capture *capture, const struct aob_capture_desc *desc,
                         const float *const planes[3], bool camera_known, struct aob_error *error);

/* The version is raised when a file could be read as something else. It is part of the file's digest. */
extern const char aob_capture_version[];
#endif
