/* What a block of cases and its references are of: a scene seen by a camera. And the job `view`: cast the G-buffer of
 * one and trace visibilities. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_VIEW_JOB_H
#define AOB_JOB_VIEW_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "term.h"

struct aob_job_view {
    const char *mesh;  /* a flat mesh file of the cache; NULL: */
    const char *scene; /* a procedural scene's name */
    bool captured;     /* it is a capture: the G-buffer is all there is */
    struct aob_camera camera;
    int frame;     /* of a scene in which something moves; else 0. Behind 0 a G-buffer has velocities */
    unsigned seed; /* of the rays that trace its truths */
    int width, height, guard; /* pixels; the guard band lies around width x height */
    const char *gbuffer;      /* file in the cache */
    struct aob_light light;   /* world space */
};
/* Puts the view's members into a job's object, and takes them from there. */
void aob_job_view_to_json(const struct aob_job_view *view, json_t *job);
bool aob_job_view_from_json(const json_t *job, struct aob_job_view *view, struct aob_error *error);

struct aob_view_term {
    struct aob_term term;
    const char *out; /* file for channels AO and SE */
};
struct aob_view_job {
    struct aob_job_view view;
    int spp;                     /* rays a pixel; even */
    bool cast;                   /* the G-buffer is to be made */
    struct aob_view_term *terms; /* term_count */
    size_t term_count;
};
/* `terms`: an array of terms, each with the file to write as the member "out"; the reference is taken. */
json_t *aob_view_job_to_json(const struct aob_job_view *view, int spp, bool cast, json_t *terms);

/* Allocates; aob_view_job_finish frees. */
bool aob_view_job_from_json(const json_t *object, struct aob_view_job *job, struct aob_error *error);
void aob_view_job_finish(struct aob_view_job *job);
#endif
