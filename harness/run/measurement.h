/* The measuring of planned cases, from the main process: lay out (does the module accept the case?), prepare
 * the view (mesh, G-buffer, references, all cached on disk), measure in blocks, and one record a case. */
#ifndef AOB_RUN_MEASUREMENT_H
#define AOB_RUN_MEASUREMENT_H
#include <jansson.h>
#include "base/error.h"
#include "dispatch.h"
#include "plan/plan.h"

struct aob_state { /* of one planned case; same index */
    enum { AOB_PENDING, AOB_DONE, AOB_REFUSED } stage;
    char status[16], reason[640]; /* where refused: unsupported, invalid or failed */
    char graph[AOB_KEY_SIZE];     /* digest of its pass graph, once it is laid out */
    bool triangles;               /* a pass of it draws the scene's */
    json_t *definition;           /* {radius, uniform, falloff, of_triangle} or NULL */
    bool mapped;                  /* the definition's value is mapped */
};
struct aob_shares { /* seconds of wall time */
    double reference, measured, warmup, images, total;
};
struct aob_measurement {
    const struct aob_dispatch *dispatch;
    struct aob_plan *plan; /* framed cameras are filled in when their mesh is loaded */
    struct aob_state *states;
    char *cache;        /* folder */
    const char *folder; /* of the run: images go to its images/; NULL: none are kept */
    const char *image;  /* in place of that: the file for the image of a plan's only case */
    struct aob_shares shares;
    void (*on_record)(void *user, size_t index, json_t *record); /* one case done; the record is borrowed */
    void *user;
};

bool aob_measurement_init(struct aob_measurement *m, const struct aob_dispatch *dispatch,
                          struct aob_plan *plan, struct aob_error *error);
void aob_measurement_finish(struct aob_measurement *m);

/* Calls each technique's check() and build() on its pending cases, in workers; refused ones get their reason.
 */
void aob_measurement_layout(struct aob_measurement *m);

/* Measures the pending cases `indices` of one block (aob_case_same_block, at most AOB_BLOCK_MAX). A block
 * whose worker dies is tried again case by case, so that it costs only the case at fault. Every case gets its
 * record. */
void aob_measurement_block(struct aob_measurement *m, const size_t *indices, size_t count);

/* The record of a case: identity first, then what the worker answered (NULL: status and reason). */
json_t *aob_record_create(const struct aob_measurement *m, size_t index, const char *status,
                          const char *reason, const json_t *answer);

/* For aob_measurement_block: the files of a view. Loads, casts and traces what the cache lacks. */
struct aob_view_files {
    char *gbuffer;
    char *mesh;                     /* of a loaded scene; NULL where it is procedural */
    char **reference, **definition; /* one a case of the block; definition NULL where there is none */
    char **
        screen; /* the definition within the screen-space bound; NULL where there is no definition. The definition's
                      file again where nothing is missing: of a capture, whose only reference is that bound, and of a
                      technique that draws the scene's triangles */
    size_t count;
};
bool aob_view_prepare(struct aob_measurement *m, const size_t *indices, size_t count,
                      struct aob_view_files *files, struct aob_error *error);
void aob_view_files_finish(struct aob_view_files *files);
json_t *aob_camera_to_json(const struct aob_camera *camera);
#endif
