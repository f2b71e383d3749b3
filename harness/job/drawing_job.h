/* What the jobs that draw frames have in common: a view on a device, and a technique with the values that it is drawn
 * with. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_DRAWING_JOB_H
#define AOB_JOB_DRAWING_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "address.h"
#include "base/error.h"
#include "technique/option.h"
#include "view_job.h"

struct aob_job_drawing {
    struct aob_job_view view;
    const char *backend;
    const char *device;     /* of the backend (gpu/gpu.h); NULL: its default */
    bool validate;          /* Vulkan runs under its validation layer */
    bool raster, triangles; /* the device draws the G-buffer; a pass draws the scene's triangles */
};
/* Puts its members into a job's object, and takes them from there. */
void aob_job_drawing_to_json(const struct aob_job_drawing *drawing, json_t *job);
bool aob_job_drawing_from_json(const json_t *job, struct aob_job_drawing *drawing, struct aob_error *error);

struct aob_job_frame {
    struct aob_address technique;
    double params[AOB_MAX_PARAM]; /* param_count, in the order of the technique's table */
    size_t param_count;
    double options[AOB_OPTION_COUNT];
};
/* The same, into the object of a case. */
void aob_job_frame_to_json(const struct aob_job_frame *frame, json_t *object);
bool aob_job_frame_from_json(const json_t *object, struct aob_job_frame *frame, struct aob_error *error);
#endif
