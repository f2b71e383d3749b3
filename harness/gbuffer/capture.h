/* A captured frame: depth, normals and materials from another renderer's EXR file, brought to the form of the canonical
 * G-buffer. The file comes from a stranger, so this runs in a worker, on one thread.
 *
 * A pixel is sky if its depth is not finite, not above 0, 5e8 or more, 65504 (the largest half, where Blender puts
 * the sky), at `far` or beyond, or at a depth buffer's far value, or if the file has no pixel there.
 *
 * The file's normals are the shading normals: normalised, turned to the side of the surface that is seen, and bent to
 * the horizon where they lean away from the camera (AOB_LEAST_FACING of reference/tracer.h). The side is that of the
 * surface that the depth shows (capture_surface.h), if it shows one for sure. The geometric normal is the file's too,
 * unless it leans away from the camera, or more than 2.5 degrees away from a surface that is sure: then it is the
 * surface's. The file's stays in our own files. If a pixel has no normal, both are the surface's.
 *
 * Of base colour, roughness and metalness the file may have each. A number beyond 0..1 is clamped; more than a quarter of
 * them, or one that is none where a surface is, refuses the file. What it lacks of the three is aob_material_default's. */
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
enum { AOB_CAPTURE_WARNINGS = 24 };

/* How fine the file's depths are: a step at depth d is flat + relative d + squared d^2 scene units. */
struct aob_capture_grain {
    double flat, relative, squared;
};
struct aob_capture {
    struct aob_camera camera;
    struct aob_hits hits; /* depth, normal, shading, primitive 0; the size is the display window's */
    float *albedo;        /* as struct aob_gbuffer has them; NULL: the file has no material at all */
    float *shine;
    unsigned materials; /* bits AOB_MATERIAL_BIT of what it has */
    bool own;           /* this program wrote the file, and its field of view is not stated otherwise */
    struct aob_capture_grain grain;
    size_t surface, derived; /* pixels that are no sky; of these, with a derived normal */
    size_t leaning;          /* pixels whose geometric normal is not the file's */
    /* What a user should know about how the file was read: a line for each of other channels that would do as well,
     * depth and others of different layers, depths that look like another kind, and normals that are missing or
     * lean; of materials, numbers that were clamped, and a metalness that is missing. */
    struct aob_error warnings[AOB_CAPTURE_WARNINGS];
    size_t warning_count;
};

/* False with one line that names the file. Allocates; aob_capture_finish frees. */
bool aob_capture_read(struct aob_capture *capture, const struct aob_capture_desc *desc,
                      struct aob_error *error);
void aob_capture_finish(struct aob_capture *capture);

/* These serve aob_capture_read. Depth: fills depth, primitive, grain and surface from the file's plane. Normals: fills
 * normal and shading from `planes`, which are three of the file's or NULL three times. Materials: fills albedo, shine and
 * materials from planes of which the first of each is NULL where the file has none; depth has been filled before. */
bool aob_capture_depth(struct aob_capture *capture, const struct aob_capture_desc *desc, const float *z,
                       struct aob_error *error);
bool aob_capture_normals(struct aob_capture *capture, const struct aob_capture_desc *desc,
                         const float *const planes[3], bool camera_known, struct aob_error *error);
bool aob_capture_materials(struct aob_capture *capture, const struct aob_capture_desc *desc,
                           const float *const planes[AOB_MATERIAL_CHANNELS][3], struct aob_error *error);
void aob_capture_warn(struct aob_capture *capture, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The version is raised when a file could be read as something else. It is part of the file's digest. */
extern const char aob_capture_version[];
#endif
