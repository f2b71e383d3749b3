#include "option.h"

static const char *const fetch_names[] = {"sampled", "storage", NULL};

const struct aob_param aob_option_params[AOB_OPTION_COUNT] = {
    AOB_PARAM(
        struct aob_options, guard_band, .unit = AOB_UNIT_PIXEL, .min = 0, .max = 1024, .initial = 0,
        .doc =
            "Pixels rendered around the view and cropped before scoring; more removes the border's error."),
    AOB_PARAM(struct aob_options, fetch, .choices = fetch_names,
              .doc = "How shaders read textures: through a sampler, or as a storage image."),
    AOB_PARAM(struct aob_options, threads, .unit = AOB_UNIT_COUNT, .min = 0, .max = 64, .initial = 0,
              .doc = "Threads of a software driver; 0 leaves the driver's default."),
};
