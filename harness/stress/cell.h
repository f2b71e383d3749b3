/* The cells of a run of `stress`: subject by property, and the document that holds them (docs/design.md, Stress figures). */
#ifndef AOB_STRESS_CELL_H
#define AOB_STRESS_CELL_H
#include <jansson.h>
#include "job/stress_job.h"
#include "property.h"
#include "technique/registry.h"

/* A technique on a backend, or the instruments (technique NULL). */
struct aob_stress_row {
    const struct aob_technique_info *technique; /* borrowed */
    const char *backend;                        /* borrowed; NULL of the instruments */
    const char *choice;    /* its device as the user named it, borrowed; NULL: the default */
    char *device, *driver; /* once it was opened */
    char *missing;         /* why the backend cannot be had; NULL: it can */
    struct aob_stress_cell {
        const struct aob_property *property;
        bool asked; /* an answer has come */
        enum aob_outcome outcome;
        double worst, bound;
        bool declared, compared;
        char *where, *reason, *image;
    } * cells; /* cell_count, in the order of the properties */
    size_t cell_count;
};
void aob_stress_row_init(struct aob_stress_row *row, const struct aob_technique_info *technique,
                         const char *backend);
struct aob_stress_cell *aob_stress_row_add(struct aob_stress_row *row, const struct aob_property *property);
void aob_stress_row_finish(struct aob_stress_row *row);

/* Fills the cell of the answer's property; false if it has none. */
bool aob_stress_row_take(struct aob_stress_row *row, const struct aob_stress_answer *answer);

struct aob_stress_counts {
    size_t by[4]; /* by enum aob_outcome */
};
struct aob_stress_counts aob_stress_count(const struct aob_stress_row *rows, size_t count);

/* The document, a new object. `quick` as it was asked. */
json_t *aob_stress_to_json(const struct aob_stress_row *rows, size_t count, bool quick);

/* For people: what fails, a line each with the command that shows it again; the worst value of each property; the counts. */
void aob_stress_print(const struct aob_stress_row *rows, size_t count, struct aob_text *out);

/* "aobudget stress --technique gtao --property sky_is_open --backend vulkan". */
void aob_stress_command(const struct aob_stress_row *row, const struct aob_stress_cell *cell,
                        struct aob_text *text);
#endif
