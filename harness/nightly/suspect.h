/* What stands out in a night: each line's case of it, against the nights before. */
#ifndef AOB_NIGHTLY_SUSPECT_H
#define AOB_NIGHTLY_SUSPECT_H
#include "compare/verdict.h"
#include "history/night.h"
#include "history/watch.h"

/* What is said of a case: of its cost, of its image, or in the end of both. */
struct aob_finding {
    enum aob_night_verdict verdict;
    enum aob_outcome outcome;
    char said[600]; /* one sentence; "": nothing */
};
void aob_finding_say(struct aob_finding *finding, enum aob_night_verdict verdict, enum aob_outcome outcome,
                     const char *format, ...) __attribute__((format(printf, 4, 5)));

struct aob_suspect {
    const struct aob_line *line;
    const struct aob_point *now;
    const struct aob_point *before; /* the latest good one of a night that was judged; NULL: there is none */
    const struct aob_point
        *old; /* whose build of the module the new one is set against; NULL: nothing stands out */
    struct aob_watch watch; /* of its cost */
    bool moved;             /* its image is another than that of `before` */

    struct aob_finding cost;           /* of what stands out; of other cases what is said of them */
    struct aob_finding image, counted; /* counted: memory and cache figures */
    char cause[200];                   /* of the image's change, where it is known; "": it is not */
    struct aob_finding told;           /* all of it (aob_suspect_join) */
    double beside, low,
        high;  /* cost of the new module over the old one's, and its 95 % interval; NAN: not measured */
    char *map; /* below the night's folder, without its ending; NULL: none */
};
struct aob_suspects { /* zero it first; an item for each line that has a case of the night, in their order */
    struct aob_suspect *items;
    size_t count;
    size_t watched; /* those with a good case before */
};

/* Of the lines' last points, which are the night's. What needs no second measurement is decided: first cases, such as do not
 * run (any more), and memory or cache figures that changed. `nights`: those of the config. `precision`: the share that counts. */
void aob_suspects_choose(struct aob_suspects *suspects, const struct aob_lines *lines,
                         const struct aob_nights *nights, double precision);
void aob_suspects_finish(struct aob_suspects *suspects);

/* Whether it is to be measured again, or its images to be compared. */
bool aob_suspect_stands_out(const struct aob_suspect *suspect);

/* The night in which its new level of cost began; 0: its cost does not stand out. */
int64_t aob_suspect_since(const struct aob_suspect *suspect);

/* The night that the history keeps with what was told: from there later nights count, if the cost is decided, or are asked again, if
 * the whole is open. 0: neither. */
int64_t aob_suspect_restart(const struct aob_suspect *suspect);

/* Joins what is said: the verdict is that of the worst finding, of two alike that of the image, then of the cost. */
void aob_suspect_join(struct aob_suspect *suspect);
#endif
