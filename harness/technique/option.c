#include "option.h"
#include "graph.h"

static const char *const fetch_names[] = {"sampled", "storage", NULL};

static const char *const depth_names[] = {"r32f",
                                          "r16f",
                                          "unorm16",
                                          "packed16",
                                          "device24",
                                          "device24_reversed",
                                          "device24_infinite",
                                          "device32",
                                          "device32_reversed",
                                          "device32_infinite",
                                          NULL};
static const char *const normal_names[] = {"rgba32f", "oct_rg16f", "rgba8",        "packed8", "rgba16f",
                                           "oct_rg8", "rgb10",     "sphere_rg16f", NULL};
static const char *const normals_names[] = {"geometric", "shading", "from_depth", NULL};
static const char *const switch_names[] = {"off", "on", NULL};
static const char *const gbuffer_names[] = {"canonical", "raster", NULL};

const struct aob_param aob_option_params[AOB_OPTION_COUNT] = {
    AOB_PARAM(
        struct aob_options, guard_band, .unit = AOB_UNIT_PIXEL, .min = 0, .max = 1024, .initial = 0,
        .doc =
            "Pixels rendered around the view and cropped before scoring; more removes the border's error."),
    AOB_PARAM(struct aob_options, fetch, .choices = fetch_names,
              .doc = "How shaders read textures: through a sampler, or as a storage image."),
    AOB_PARAM(struct aob_options, gbuffer, .choices = gbuffer_names,
              .doc =
                  "What techniques read: the ray-cast G-buffer, or one that the backend's rasteriser draws."),
    AOB_PARAM(struct aob_options, threads, .unit = AOB_UNIT_COUNT, .min = 0, .max = 64, .initial = 0,
              .doc = "Threads of a software driver; 0 leaves the driver's default."),
    AOB_PARAM(struct aob_options, depth_encoding, .choices = depth_names,
              .doc = "How the G-buffer holds depth: linear, or as a device's depth buffer does."),
    AOB_PARAM(struct aob_options, normal_encoding, .choices = normal_names,
              .doc = "How the G-buffer holds normals."),
    AOB_PARAM(struct aob_options, normals, .choices = normals_names,
              .doc =
                  "Which normals: of the triangles, interpolated, or derived from the depth by each reader."),
    AOB_PARAM(struct aob_options, near, .unit = AOB_UNIT_LENGTH, .min = 0, .max = 1e9,
              .doc = "Near plane of the device encodings; 0 is half the view's nearest depth."),
    AOB_PARAM(struct aob_options, far, .unit = AOB_UNIT_LENGTH, .min = 0, .max = 1e9,
              .doc = "Far plane of the device and 16-bit encodings; 0 is 1.01 of the view's farthest depth."),
    AOB_PARAM(struct aob_options, thrift, .choices = switch_names,
              .doc = "Whether sky and what nothing can occlude are left out, which some passes find."),
    AOB_PARAM(struct aob_options, bent_normal, .choices = switch_names,
              .doc =
                  "Whether the mean open direction is wanted too; off lays no pass and no texture for it."),
    AOB_PARAM(struct aob_options, visibility_rgb, .choices = switch_names,
              .doc =
                  "Whether visibility after bounces between the surfaces is wanted too, for each channel."),
    AOB_PARAM(struct aob_options, specular, .choices = switch_names,
              .doc = "Whether the open share of the GGX lobe is wanted too."),
    AOB_PARAM(struct aob_options, irradiance, .choices = switch_names,
              .doc = "Whether the occluded irradiance of the scene's light is wanted too."),
    AOB_PARAM(struct aob_options, lit, .choices = switch_names,
              .doc = "Whether the lit image is wanted too, composed of the outputs that are wanted."),
};

uint32_t aob_options_wanted(const struct aob_options *options)
{
    return (options->thrift ? AOB_WANT_THRIFT : 0) | (options->bent_normal ? 1u << AOB_OUT_BENT_NORMAL : 0) |
           (options->visibility_rgb ? 1u << AOB_OUT_VISIBILITY_RGB : 0) |
           (options->specular ? 1u << AOB_OUT_SPECULAR : 0) |
           (options->irradiance ? 1u << AOB_OUT_IRRADIANCE : 0) | (options->lit ? 1u << AOB_OUT_LIT : 0);
}
