/* Milliseconds of a pass on a profile's device, modelled from what the pass executes, fetches, misses and writes: one time
 * for each resource of the device, as if the pass had it alone (docs/model.md has the formulas and how far to trust them).
 * Resources overlap in part, so the point is the root of the sum of squares, and the band reaches from the largest, which
 * is perfect overlap, to the sum, which is none. Nothing is fitted. */
#ifndef AOB_PROFILE_MODEL_H
#define AOB_PROFILE_MODEL_H
#include "issue.h"
#include "operations.h"
#include "profile.h"
#include "result.h"

struct aob_model_input { /* of a pass: sums over its invocations */
    struct aob_operations operations;
    struct aob_issue issue;
    double filled[AOB_PROFILE_MAX_LEVEL]
                 [AOB_FLIGHT_COUNT]; /* bytes that each level brought, the last from memory */
    double written;                  /* bytes, to its targets */
    double pixels;                   /* of its targets, each target counted */
};

enum aob_resource {
    AOB_RESOURCE_ALU, /* lanes, and the unit of special functions */
    AOB_RESOURCE_TEXTURE,
    AOB_RESOURCE_FILL, /* of the first level; then the others' but the last one's, whose is memory's */
    AOB_RESOURCE_MEMORY = AOB_RESOURCE_FILL + AOB_PROFILE_MAX_LEVEL - 1,
    AOB_RESOURCE_TARGETS,
    AOB_RESOURCE_COUNT
};

struct aob_model_time {
    double ms, low_ms, high_ms;           /* launch_ms is in each */
    double launch_ms;                     /* serial, whatever else overlaps */
    double resources[AOB_RESOURCE_COUNT]; /* ms; those that the profile has not are 0 */
};

/* The profile has rates. Of what is a band itself (misses by warps in flight, lines that a quad finds at once), `resources`
 * and the point take the middle, `low_ms` the lower ends and `high_ms` the upper ones. */
struct aob_model_time aob_model_pass(const struct aob_profile *profile, const struct aob_model_input *input);

/* Passes run one after the other. */
void aob_model_add(struct aob_model_time *frame, const struct aob_model_time *pass);

/* The resource that takes longest; of equal ones the first. */
enum aob_resource aob_model_limit(const struct aob_model_time *modelled);

/* "alu", "texture", the name of a level, "memory", "targets"; NULL where the profile has no such level. */
const char *aob_model_resource_name(const struct aob_profile *profile, enum aob_resource resource);
#endif
