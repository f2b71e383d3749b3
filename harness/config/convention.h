/* What the numbers of a captured frame mean: how its depth is stored, which way its normals point. Stated by the
 * user, as keys of a scene or as flags of `shot`; the zero value is planar depth with normals in view space.
 *
 *   depth      planar: along the view axis; distance: along the pixel's ray; device: a depth buffer, 0 at `near`, 1 at
 *              `far`; device_reversed: 1 at near, 0 at far
 *   near, far  of a depth buffer, scene units; far may be inf. With planar and distance, what lies at `far` or beyond
 *              is sky
 *   normals    view; world (needs eye and target); derived: those of the file are not used
 *   handed     right: view space looks along -Z; left: along +Z, and the world is left-handed too
 *   up         the world's up, for normals in world space
 *   depth_channel, normal_channel   names within the file, where they are not found by themselves; of the normal
 *              without its last part: "ViewLayer.Normal"
 *   materials  file: those that the file has; none: they are not read
 *   albedo_channel, roughness_channel, metalness_channel   likewise; of the albedo without its last part */
#ifndef AOB_CONFIG_CONVENTION_H
#define AOB_CONFIG_CONVENTION_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"

enum aob_convention_key {
    AOB_CONVENTION_DEPTH,
    AOB_CONVENTION_NEAR,
    AOB_CONVENTION_FAR,
    AOB_CONVENTION_NORMALS,
    AOB_CONVENTION_HANDED,
    AOB_CONVENTION_UP,
    AOB_CONVENTION_DEPTH_CHANNEL,
    AOB_CONVENTION_NORMAL_CHANNEL,
    AOB_CONVENTION_MATERIALS,
    AOB_CONVENTION_ALBEDO_CHANNEL,
    AOB_CONVENTION_ROUGHNESS_CHANNEL,
    AOB_CONVENTION_METALNESS_CHANNEL,
    AOB_CONVENTION_COUNT
};
/* "depth", "depth_channel"; as a flag with - for _. NULL-ended. */
extern const char *const aob_convention_keys[AOB_CONVENTION_COUNT + 1];

/* What a capture may say of a surface's material. */
enum aob_material_channel {
    AOB_MATERIAL_ALBEDO, /* three: the base colour */
    AOB_MATERIAL_ROUGHNESS,
    AOB_MATERIAL_METALNESS,
    AOB_MATERIAL_CHANNELS
};
#define AOB_MATERIAL_BIT(channel) (1u << (channel))
extern const char *const aob_material_channel_names[AOB_MATERIAL_CHANNELS]; /* "albedo" */

struct aob_convention {
    bool depth_stated; /* else planar is assumed, and doubted where the values look like no lengths */
    enum { AOB_DEPTH_PLANAR, AOB_DEPTH_DISTANCE, AOB_DEPTH_DEVICE, AOB_DEPTH_DEVICE_REVERSED } depth;
    enum { AOB_NORMALS_VIEW, AOB_NORMALS_WORLD, AOB_NORMALS_DERIVED } normals;
    double near, far; /* 0: not stated */
    bool left_handed;
    double up[3]; /* 0 0 0: not stated, +Y */
    char depth_channel[64], normal_channel[64];
    bool no_materials;
    char material_channels[AOB_MATERIAL_CHANNELS][64]; /* by enum aob_material_channel */
};

/* What follows "capture:" in a scene's name; NULL: it is no capture. */
const char *aob_capture_file(const char *scene);

/* One key from its text ("device", "0.1", "0,0,1"). False with a line that names what is allowed. */
bool aob_convention_set(struct aob_convention *convention, enum aob_convention_key key, const char *text,
                        struct aob_error *error);

/* Do the keys go together? False with one line. */
bool aob_convention_check(const struct aob_convention *convention, struct aob_error *error);

/* "depth=device near=0.1 ...": every key, exactly; part of a digest. */
void aob_convention_print(const struct aob_convention *convention, struct aob_text *text);
#endif
