/* One frame from the command line: the flags that say which, a plan of that case alone, and its measurement. What `shot`
 * and `cache` share. */
#ifndef AOB_COMMAND_SINGLE_H
#define AOB_COMMAND_SINGLE_H
#include <jansson.h>
#include "base/flags.h"
#include "config/convention.h"
#include "run/sweep.h"

/* Texts as given; NULL: not given. */
struct aob_single_flags {
    const char *technique, *scene; /* scene: a listed one, a mesh file or capture:FILE */
    const char *light;             /* a listed one or a probe's file */
    const char *view, *eye, *target, *fov, *ortho, *shift, *metres_per_unit, *size, *backend;
    const char *frames, *last_eye, *last_target;  /* of a sequence */
    const char *convention[AOB_CONVENTION_COUNT]; /* of a capture, by enum aob_convention_key */
    struct aob_words params; /* "name=value": parameters of the technique and run options */
};

#define AOB_FLAG_OF(type, member, name, value, help)                                                         \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(type, member)                                             \
    }
/* Rows of a command's table: its options are a `type` with a struct aob_single_flags as `member`. */
#define AOB_SINGLE_FLAGS(type, member)                                                                       \
    AOB_FLAG_OF(type, member.technique, "technique", "NAME", "see: aobudget list techniques"),               \
        AOB_FLAG_OF(type, member.scene, "scene", "NAME",                                                     \
                    "a listed scene, a mesh file, or capture:FILE.exr"),                                     \
        AOB_VIEW_FLAGS(type, member)

/* Of these the rows that say which view of a scene, of which size. */
#define AOB_VIEW_FLAGS(type, member)                                                                         \
    AOB_FLAG_OF(type, member.view, "view", "NAME", "a listed view (the scene's first)"),                     \
        AOB_FLAG_OF(type, member.eye, "eye", "x,y,z", "camera position, scene units"),                       \
        AOB_FLAG_OF(type, member.target, "target", "x,y,z", "what the camera looks at"),                     \
        AOB_FLAG_OF(type, member.fov, "fov", "DEG", "vertical field of view (60)"),                          \
        AOB_FLAG_OF(type, member.ortho, "ortho", "H", "orthographic, H scene units high"),                   \
        AOB_FLAG_OF(type, member.shift, "shift", "x,y", "image moved right, up; in its heights"),            \
        AOB_FLAG_OF(type, member.frames, "frames", "N",                                                      \
                    "a sequence of N frames, of which the last is looked at"),                               \
        AOB_FLAG_OF(type, member.last_eye, "last-eye", "x,y,z",                                              \
                    "where the camera is in the last of them (it stays)"),                                   \
        AOB_FLAG_OF(type, member.last_target, "last-target", "x,y,z", "and what it looks at then"),          \
        AOB_FLAG_OF(type, member.metres_per_unit, "metres-per-unit", "M",                                    \
                    "of a mesh file or capture, for default lengths (1)"),                                   \
        AOB_FLAG_OF(type, member.light, "light", "NAME",                                                     \
                    "see: aobudget list lights; or a probe, FILE.exr (the scene's own)"),                    \
        AOB_FLAG_OF(type, member.size, "size", "WxH", "pixels (480x270)"),                                   \
        AOB_FLAG_OF(type, member.backend, "backend", "NAME", "see: aobudget list backends (vulkan)"),        \
        {"p", "name=value", "a parameter or run option; may be repeated", AOB_FLAG_MANY,                     \
         offsetof(type, member.params)},                                                                     \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_DEPTH], "depth", "KIND",                          \
                    "of a capture: planar, distance, device or device_reversed (planar)"),                   \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_NEAR], "near", "D",                               \
                    "near plane of a capture's device depth"),                                               \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_FAR], "far", "D",                                 \
                    "its far plane, inf allowed; of other depths: sky from here on"),                        \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_NORMALS], "normals", "SPACE",                     \
                    "of a capture: view, world or derived (view)"),                                          \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_HANDED], "handed", "SIDE",                        \
                    "of a capture's normals: right or left (right)"),                                        \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_UP], "up", "x,y,z",                               \
                    "the world's up, for normals world (0,1,0)"),                                            \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_DEPTH_CHANNEL], "depth-channel", "NAME",          \
                    "of a capture, where it is not found by its name"),                                      \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_NORMAL_CHANNEL], "normal-channel", "NAME",        \
                    "the same of its normals, without .X .Y .Z"),                                            \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_MATERIALS], "materials", "WHOSE",                 \
                    "of a capture: file or none (file)"),                                                    \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_ALBEDO_CHANNEL], "albedo-channel", "NAME",        \
                    "of a capture's base colour, without .R .G .B"),                                         \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_ROUGHNESS_CHANNEL], "roughness-channel", "NAME",  \
                    "the same of its roughness"),                                                            \
        AOB_FLAG_OF(type, member.convention[AOB_CONVENTION_METALNESS_CHANNEL], "metalness-channel", "NAME",  \
                    "the same of its metalness")

/* The flags as a config of one case for the command `name`. The caller chooses what is measured. False after a line; the
 * config is to be finished either way, and with it the words of the flags (aob_words_finish). */
bool aob_single_config(const char *name, const struct aob_single_flags *flags, struct aob_config *config,
                       struct aob_error *error);

/* Expands the sweep of such a config; fails as well where it is more than one case, or the device is not there. */
bool aob_single_expand(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error);

struct aob_single_desc {
    const struct aob_dispatch *dispatch;
    const char *image, *map; /* EXR files to write; NULL: none */
    void (*on_foretold)(void *user, const char *work,
                        double seconds); /* run/measurement.h; user: of no use */
};
/* The record comes back whatever the case's status is; false with its reason if that is not ok. */
bool aob_single_measure(const struct aob_single_desc *desc, struct aob_sweep *sweep, json_t **record,
                        struct aob_error *error);

/* A number within bounds, if `text` is given; else *value stays. */
bool aob_single_number(const char *flag, const char *text, double low, double high, double *value,
                       struct aob_error *error);
#endif
