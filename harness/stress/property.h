/* A property: one way in which renderers were wrong, put as a question with a number for an answer. Each is a row of a table
 * in the file of its group (projection.c, numbers.c, ...), with one small function that asks it. How large the answer may be
 * is in bounds.c, for all of them. */
#ifndef AOB_STRESS_PROPERTY_H
#define AOB_STRESS_PROPERTY_H
#include "trial.h"

enum aob_property_group {
    AOB_GROUP_PROJECTION,
    AOB_GROUP_NUMBERS,
    AOB_GROUP_NEAR,
    AOB_GROUP_NORMALS,
    AOB_GROUP_RESOLUTION,
    AOB_GROUP_EDGES,
    AOB_GROUP_RELATIONS,
    AOB_GROUP_DIRECTIONS,  /* of bent normals */
    AOB_GROUP_LIGHT,       /* of bounces, lobes and irradiance */
    AOB_GROUP_TIME,        /* of what is kept from frame to frame */
    AOB_GROUP_INSTRUMENTS, /* of the tracer, the caches, the model and the statistics; they have no subject */
    AOB_GROUP_COUNT,
};
const char *aob_property_group_name(enum aob_property_group group); /* "projection" */

struct aob_property {
    const char *name;     /* lower_snake; unique in the program */
    const char *sentence; /* what must hold, one sentence */
    const char *measure;  /* what the number is: "largest difference of a pixel" */
    const char *source;   /* where somebody got it wrong, or a text proves it */
    enum aob_property_group group;
    bool quick; /* it needs few programs: stress --quick asks it too */
    /* Why it is not asked of this subject, one sentence; NULL: it is. May be missing. */
    const char *(*excuse)(const struct aob_subject *subject);
    void (*ask)(struct aob_trial *trial);
};

/* Arrays of them, each ended by a row without a name; ended by NULL. */
extern const struct aob_property *const aob_property_tables[];
const struct aob_property *aob_property_find(const char *name); /* NULL if unknown */
size_t aob_property_count(void);

/* The largest answer that passes. A driver in software does what IEEE 754 and our texts say, to the bit where the arithmetic
 * is the same; a GPU may round otherwise. */
struct aob_bound {
    const char *property;
    double software, gpu;
    const char *reason; /* why it is as large as it is: one sentence */
};
extern const struct aob_bound aob_bounds[];                   /* ended by a NULL property */
const struct aob_bound *aob_bound_find(const char *property); /* NULL: none, which a test finds */

enum aob_outcome { AOB_PASSES, AOB_FAILS, AOB_BY_DEFINITION, AOB_NOT_APPLICABLE };
const char *aob_outcome_word(enum aob_outcome outcome); /* "pass", "fail", "by definition", "n/a" */

/* What came of asking. */
struct aob_answer {
    enum aob_outcome outcome;
    double worst, bound; /* NAN where it is not applicable */
    bool declared;       /* the technique says that it fails by definition */
    char where[200];     /* where it is worst; empty where no answer was taken */
    char reason[320];    /* the same, or what went wrong, why it is not applicable, or the text's sentence */
};
/* Asks, and judges by the bound of the subject's device. The trial keeps the images of the worst place until it is finished. */
void aob_property_ask(const struct aob_property *property, struct aob_trial *trial,
                      struct aob_answer *answer);
#endif
