/* A contest: one table, from its two sides to what is said of them. */
#ifndef AOB_COMPARE_CONTEST_H
#define AOB_COMPARE_CONTEST_H
#include "base/table.h"
#include "compared.h"
#include "couple.h"

struct aob_contest {        /* the caller sets the first part, zeroes the rest, and keeps what it points at */
    const char *names[2];   /* of its sides */
    const char *folders[2]; /* the runs that these are in: one and NULL, or two */
    const char *modules[2]; /* whose cases of those runs they are; NULL: all */
    const struct aob_table *keys; /* of the cases of B; NULL: all */
    const char *maps;             /* the folder that the maps of what moved go to */
    double precision;             /* the difference that counts, a share; 0: AOB_COMPARE_PRECISION */

    struct aob_rows rows;
    const struct aob_row **sides[2];
    size_t counts[2];
    bool partial; /* a run lacks cases that it was asked for, or some cannot be measured again */
    struct aob_couples couples;
    struct aob_compared_table table;
};

/* Reads both sides and fills in the rest, with what each couple costs; what a run lacks is told in a warning. False with a
 * line if no case has a partner, or a folder cannot be read. aob_contest_finish frees in any case. */
bool aob_contest_read(struct aob_contest *contest, struct aob_error *error);

/* What is said of each (aob_compared_judge). */
bool aob_contest_judge(struct aob_contest *contest, double alpha, struct aob_error *error);
void aob_contest_finish(struct aob_contest *contest); /* of a zeroed one too */
#endif
