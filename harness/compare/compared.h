/* A table of verdicts: the couples of two sides, what each costs and shows, and what is said of it. */
#ifndef AOB_COMPARE_COMPARED_H
#define AOB_COMPARE_COMPARED_H
#include <jansson.h>
#include "blame.h"
#include "cost.h"
#include "couple.h"
#include "image_change.h"
#include "verdict.h"

struct aob_compared {
    const struct aob_couple *couple;
    struct aob_cost cost;
    struct aob_ratio wide;         /* cost.cost at the table's level */
    struct aob_error unfit;        /* why its times cannot be compared; empty: they can */
    struct aob_image_change image; /* zeros where the images were not read */
    bool image_read;
    char *
        map; /* "maps/0001-corner-front-gtao" below the table's folder, without its ending; NULL: there is none */
    struct aob_error_pair errors; /* against A's own target */
    struct aob_judgement judgement;
    struct aob_blame blame;
};
struct aob_compared_table {
    const struct aob_rows *rows;       /* of both sides */
    const struct aob_couples *couples; /* `count` items below, in their order */
    const char *names[2];              /* what A and B are: folders or modules */
    const char *folder;                /* maps of what moved go to its maps/ */
    double precision;                  /* the difference that is asked for, a share */
    bool same_program;                 /* that measured A and B */
    struct aob_compared *items;
    double alpha; /* of each interval (aob_compared_judge) */
};

/* Makes the items, each with its couple and what that costs; aob_compared_finish frees them. */
void aob_compared_cost(struct aob_compared_table *table);

/* What is said of each item. An interval misses the truth with the probability `alpha`; 0: with that of a table in which one
 * of all does so with AOB_COMPARE_ALPHA (quotient.h). Writes the maps of what moved as EXR files, in place of those of an
 * earlier comparison. False with a line if one of these cannot be written. */
bool aob_compared_judge(struct aob_compared_table *table, double alpha, struct aob_error *error);
void aob_compared_finish(struct aob_compared_table *table);

/* Draws the maps: a picture (.png) and a file for ParaView (.vti) each, by aobudget-plot, which is beside `program`. What
 * could not be drawn is told in one warning. */
void aob_compared_draw(const struct aob_compared_table *table, const char *program);

/* The table for people, a line a case. */
void aob_compared_print(const struct aob_compared_table *table, struct aob_text *out);
json_t *
aob_compared_to_json(const struct aob_compared_table *table); /* docs/design.md, Comparisons; a new object */

/* WORSE if one case is worse, else OPEN if one is undecided, else GOOD. */
enum aob_outcome aob_compared_outcome(const struct aob_compared_table *table);
#endif
