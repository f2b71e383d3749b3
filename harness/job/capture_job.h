/* The job `capture`: read a frame of another renderer into the form of a G-buffer. Texts are borrowed from the JSON that
 * they were read from. */
#ifndef AOB_JOB_CAPTURE_JOB_H
#define AOB_JOB_CAPTURE_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "config/convention.h"

struct aob_capture_job {
    const char *file, *out; /* the user's EXR; the G-buffer, in the cache */
    struct aob_convention convention;
    double fov_deg, ortho_height; /* 0: the file says it */
    bool has_camera;              /* eye and target are given */
    double eye[3], target[3];     /* scene units */
};
json_t *aob_capture_job_to_json(const struct aob_capture_job *job);
bool aob_capture_job_from_json(const json_t *object, struct aob_capture_job *job, struct aob_error *error);

struct aob_capture_answer {
    int width, height;
    size_t surface, derived;      /* pixels that are no sky; of these, with a derived normal */
    double fov_deg, ortho_height; /* the camera's, as the file or the job has it */
    double eye[3], target[3];
    unsigned materials;     /* bits AOB_MATERIAL_BIT of what the file has */
    const json_t *warnings; /* an array of texts; NULL: none */
};
json_t *aob_capture_answer_to_json(const struct aob_capture_answer *answer);
bool aob_capture_answer_from_json(const json_t *object,
                                  struct aob_capture_answer *answer); /* false: of another form */
#endif
