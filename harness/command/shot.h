/* `aobudget shot`: one case, measured and scored like a case of a run. */
#ifndef AOB_COMMAND_SHOT_H
#define AOB_COMMAND_SHOT_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "config/convention.h"
#include "run/dispatch.h"

struct aob_shot_desc { /* texts as given on the command line; NULL: not given */
    struct aob_dispatch dispatch;
    const char *technique, *scene; /* scene: a listed one, a mesh file or capture:FILE */
    const char *view, *eye, *target, *fov, *ortho, *shift, *size, *backend, *reference_spp;
    const char *target_radius, *target_weighting, *reference_radius; /* the last: what the first was called */
    const char *convention[AOB_CONVENTION_COUNT]; /* of a capture, by enum aob_convention_key */
    const char *const *params; /* "name=value": parameters of the technique and run options */
    size_t param_count;
    const char *out, *json;
    bool quiet;
};
enum aob_exit aob_shot(const struct aob_shot_desc *desc, struct aob_error *error);
#endif
