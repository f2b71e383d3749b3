/* The measuring of planned cases, from the main process: lay out (does the module accept the case?), prepare
 * the view (mesh, G-buffer, references, all cached on disk), measure in blocks, and one record a case. */
#ifndef AOB_RUN_MEASUREMENT_H
#define AOB_RUN_MEASUREMENT_H
#include <jansson.h>
#include <stdint.h>
#include "base/error.h"
#include "dispatch.h"
#include "plan/plan.h"
#include "run_clock.h"
#include "state.h"
#include "store/cache.h"
#include "timing/measure_lock.h"

struct aob_shares { /* seconds of wall time */
    double reference, measured, warmup, images;
};
struct aob_measurement {
    const struct aob_dispatch *dispatch;
    struct aob_plan *plan;    /* framed cameras are filled in when their mesh is loaded */
    struct aob_state *states; /* one a case; same index */
    size_t *
        by_view; /* the cases' indices, those of one view (scene, size, guard band) together, in the plan's order */
    size_t *place;        /* where a case stands in by_view */
    json_t *failed_views; /* what could not be cast or traced: its first place in by_view -> why */
    struct aob_cache cache;
    const char *folder; /* of the run: images go to its images/; NULL: none are kept */
    const char *
        shaders; /* folder that drivers may keep compiled shaders in, of this run alone; NULL: they keep none */
    const char *image; /* in place of that: the file for the image of a plan's only case */
    const char *map;   /* the file for the map of misses of a plan's only case; NULL: none */
    struct aob_shares shares;
    struct aob_measure_lock lock;
    struct aob_run_clocks clocks;
    uint32_t seed; /* of the orders of its timing, drawn anew for each measurement; records tell it */
    void (*on_work)(void *user, size_t index,
                    const char *work); /* "tracing", of the case's view; NULL: nobody asks */
    void (*on_foretold)(
        void *user, const char *work,
        double seconds); /* once a case's fetches are counted: what follows; NULL: nobody asks */
    void (*on_record)(void *user, size_t index, json_t *record); /* one case done; the record is borrowed */
    void *user;
};

bool aob_measurement_init(struct aob_measurement *m, const struct aob_dispatch *dispatch,
                          struct aob_plan *plan, struct aob_error *error);
void aob_measurement_finish(struct aob_measurement *m); /* of a zeroed one too */

/* Calls each technique's check() and build() on its pending cases, in workers; refused ones get their reason. */
void aob_measurement_layout(struct aob_measurement *m);

/* Measures the pending cases `indices` of one block (aob_case_same_block, at most AOB_BLOCK_MAX): scores in one worker,
 * times in several (timing/processes.h). A case that fails in a shared worker, or whose worker dies, is tried once more
 * in workers of its own, so that a fault costs only the case that has it; a worker that dies while it only times costs
 * its rounds, as long as enough others are good. Every case gets its record, after its last round. */
void aob_measurement_block(struct aob_measurement *m, const size_t *indices, size_t count);

struct aob_view_pose { /* a frame of a sequence before its last */
    struct aob_camera camera;
    int frame;     /* as of a job's view; */
    unsigned seed; /* likewise */
    char *gbuffer;
    char **truth; /* of each of the scene's targets: of the visibility alone */
};

/* For aob_measurement_block: the files of a view. Loads, casts and traces what the cache lacks. */
struct aob_view_files {
    char *mesh; /* a flat mesh; NULL where the scene is procedural or captured */
    char *gbuffer;
    /* Of each of the scene's targets the truth of each output; NULL where no case of the block gives that, and for the
     * bent normal, which lies in the visibility's file. */
    char *(*truth)[AOB_OUTPUT_COUNT];
    size_t target_count;
    unsigned outputs; /* that the block's cases give; bits 1 << enum aob_output */
    bool bent;        /* the truths hold their mean open directions too, because a case gives a bent normal */
    char **
        definition; /* what a case claims; this and the next have `count` entries, NULL where a case has none */
    char **screen; /* the claim within the screen-space bound. The definition's file again where nothing is
                          missing: of a capture, whose only reference is that bound, and of a technique that draws the
                          scene's triangles */
    size_t count;
    struct aob_view_pose *poses; /* pose_count, in order; none: one picture */
    size_t pose_count;
};
bool aob_view_prepare(struct aob_measurement *m, const size_t *indices, size_t count,
                      struct aob_view_files *files, struct aob_error *error);
void aob_view_files_finish(struct aob_view_files *files);

/* A number of the case's view (scene, camera, size and guard band), below the number of the plan's cases. */
size_t aob_view_number(const struct aob_measurement *m, size_t index);

/* Bytes that a job which casts rays may take; 0: no limit. */
size_t aob_view_memory_limit(void);

/* The case's view as a job has it; its texts belong to the plan and to `files`. */
struct aob_job_view;
struct aob_job_view aob_job_view_of(const struct aob_case *c, const struct aob_view_files *files);
#endif
