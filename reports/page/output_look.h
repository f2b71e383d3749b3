/* How the page shows the outputs besides visibility: which case of a technique is pictured, and from which channels of its
 * image. Each that a run wants gets its figures from a row of this table. Threads: const data. */
#ifndef AOB_REPORTS_PAGE_OUTPUT_LOOK_H
#define AOB_REPORTS_PAGE_OUTPUT_LOOK_H
#include <aobudget/technique.h>
#include <stdbool.h>
#include <stddef.h>

struct aob_output_look {
    enum aob_output output;
    const char *metric;    /* what ranks the cases against their own target, the least first: "bent_band" */
    const char *error;     /* channel of the map */
    const char *amount;    /* unit of a map of amounts from 0 up; NULL: it is a difference of `quantity` */
    const char *quantity;  /* what the difference is of, in the label of its colours */
    const char *technique; /* channels of the pictures beside the map; NULL: there is a map only */
    const char *reference;
    const char *truth; /* heading of the reference's picture */
    bool colour;       /* three channels each, NAME.R to NAME.B */
    double
        exposure; /* of the colours; 0: that of the case's metric `exposed`, or the plotter's choice where it is NULL */
    const char *exposed;
    const char *end;       /* of the pictures' file names */
    const char *map_end;   /* of the map's */
    const char *title;     /* of the pictures, after the technique's name and a colon */
    const char *map_title; /* of the map */
    const char *heading;   /* of the page's part */
    const char *sentence;  /* below the heading; NULL: none */
};

/* In the order of enum aob_output, without visibility. */
enum { AOB_OUTPUT_LOOKS = AOB_OUTPUT_COUNT - 1 };
extern const struct aob_output_look aob_output_looks[AOB_OUTPUT_LOOKS];
#endif
