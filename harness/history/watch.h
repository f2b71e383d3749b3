/* Whether the latest night of a line stands out against the nights before it. Pure functions. */
#ifndef AOB_HISTORY_WATCH_H
#define AOB_HISTORY_WATCH_H
#include <stdbool.h>
#include <stddef.h>
#include "line.h"

struct aob_watch {
    bool suspect;  /* the cost stands out: it is to be measured again, beside the old module */
    size_t since;  /* place of the point where the new level began; the last one's if only that stands out */
    double before; /* the level that it stands out against, a ratio to the fixed pass; NAN: there is none */
    double shift;  /* the new level over that: 1.05 is 5 % dearer; NAN: none */
    double least;  /* the share by which it had to stand out: max of what was asked for, the line's noise, its interval */
};

/* Of a line whose last point is the night in question. What earlier nights decided is in the points' verdicts, and their
 * levels count from there. `least`: the smallest share that counts, such as .02. */
void aob_watch_line(const struct aob_point *points, size_t count, double least, struct aob_watch *watch);

/* Which of `count` p-values are discoveries at the false-discovery rate q (Benjamini and Hochberg 1995); a NAN is none and
 * does not count as tested. */
void aob_watch_discover(const double *p, size_t count, double q, bool *found);
#endif
