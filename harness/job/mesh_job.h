/* The job `mesh`: parse a mesh file into a flat one. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_MESH_JOB_H
#define AOB_JOB_MESH_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "base/vec.h"

struct aob_mesh_job {
    const char *file, *out; /* the user's mesh; the flat one, in the cache */
    bool cached;            /* the flat one is there to be used; else it is made */
};
json_t *aob_mesh_job_to_json(const struct aob_mesh_job *job);
bool aob_mesh_job_from_json(const json_t *object, struct aob_mesh_job *job, struct aob_error *error);

struct aob_mesh_answer {
    struct aob_vec3 low, high; /* bounding box, scene units */
    size_t vertices, triangles;
    const json_t *warnings; /* an array of texts; NULL: none */
};
json_t *aob_mesh_answer_to_json(const struct aob_mesh_answer *answer);
bool aob_mesh_answer_from_json(const json_t *object,
                               struct aob_mesh_answer *answer); /* false: of another form */
#endif
