/* A target: the truth that cases are compared with. Errors against two targets answer two questions, so no chart, front
 * or table holds both. */
#ifndef AOB_REPORTS_PAGE_TARGET_H
#define AOB_REPORTS_PAGE_TARGET_H
#include <jansson.h>
#include <stdbool.h>

struct aob_target {
    double radius; /* farthest occluder, scene units; HUGE_VAL: any distance; NAN: the record does not say */
    bool uniform;  /* directions are weighted evenly, not by the cosine */
    bool screen;   /* a capture's: the screen-space bound stands for the truth; false: rays were traced */
};

/* The target of an entry of `errors`, or of `error`. What an older record has no `target` for is the cosine-weighted
 * truth within its `reference_radius`. */
struct aob_target aob_target_of(const json_t *entry, const json_t *record);

/* By radius, the unknown one last; then cosine before uniform; then what was traced before a capture's. */
int aob_target_compare(const struct aob_target *a, const struct aob_target *b);

/* "the truth within 0.5 scene units"; "the screen-space bound ..." of a capture. Targets that differ have names and
 * slugs that differ. free() it. */
char *aob_target_say(const struct aob_target *target);

/* "0.5-cosine", "0.5-cosine-screen": fit for an address, the same in every run. free() it. */
char *aob_target_slug(const struct aob_target *target);
#endif
