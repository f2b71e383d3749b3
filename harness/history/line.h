/* A line: what a history knows of one series on one class of machine and device, night by night. */
#ifndef AOB_HISTORY_LINE_H
#define AOB_HISTORY_LINE_H
#include <jansson.h>
#include <stdint.h>
#include "base/hash.h"
#include "history.h"

/* One night's case. What it does not have is NAN or "". */
struct aob_point {
    int64_t night;            /* its id */
    char key[AOB_KEY_SIZE];   /* of the case */
    char build[AOB_KEY_SIZE]; /* digest of the technique's build, from run.json */
    char image[AOB_KEY_SIZE]; /* digest of its image */
    char *status, *reason;    /* as in the journal */
    char *module;             /* as in the journal; "" of a built-in */
    double ratio, low, high;  /* in fixed passes, and its 95 % interval */
    double cost_ms;           /* by the clock of its class */
    double ref_ms;            /* of the fixed pass */
    double memory_bytes;
    double rmse, band_rmse, reference_se, band_pixels; /* against the case's own target */
    double target_radius;                              /* of that target, scene units */
    char *target_weighting;                            /* "cosine", "uniform"; "" without a target */
    char *reference;                                   /* "ray-traced", "screen"; "" without a target */
    int verdict;                                       /* enum aob_night_verdict below */
    int64_t since; /* the night in which the level that it tells of began; 0: none */
    char *said;    /* the sentence of that; "" */
    /* {"flip": 0.01, "cache.ps4.l2.most.miss_ratio": 0.2}: every metric against the own target and every cache figure, named
     * as the columns of cases.csv; infinity is "inf", and what is not known is absent. NULL unless they were asked for and are there. */
    json_t *figures;
};

/* A series in another config, and on another class, is another line: times of two clocks never mix in one. Where a night has
 * several builds of a technique, the cases of each module's file are a line. */
struct aob_line {
    int64_t id;
    char series[AOB_KEY_SIZE]; /* a key, where no night's case reached a device */
    char *class_name; /* "cpu, 2 x AMD EPYC, llvmpipe, Mesa 22.3.6, fixed pass 1, 2 threads, cpu time" */
    char *config;     /* its name */
    char *scene, *view, *technique, *backend, *size; /* size: "480x270" */
    char *params, *options;                          /* every one, as in cases.csv: "radius=0.5 slices=3" */
    char *module; /* the file, where builds had to be told apart; else "" */
    char *
        text; /* as tables call it, without what is at its default: "corner/front gtao radius=1 vulkan 480x270" */
    struct aob_point *points; /* in the order of the nights, one a night at most */
    size_t count;
};
struct aob_lines {          /* zero it first */
    struct aob_line *items; /* in the order in which they first came */
    size_t count;
};

struct aob_lines_ask {  /* zero: all lines of all nights, without figures */
    const char *config; /* NULL: all */
    int64_t night;      /* only lines that have a point in it; 0: all */
    int64_t figures;    /* with the figures of the nights from this one on; 0: without any */
};
bool aob_lines_read(struct aob_history *history, const struct aob_lines_ask *ask, struct aob_lines *lines,
                    struct aob_error *error);
void aob_lines_finish(struct aob_lines *lines);

/* How many lines and points there are of a config's name; NULL: of all. */
bool aob_lines_count(struct aob_history *history, const char *config, size_t *lines, size_t *points,
                     struct aob_error *error);

/* What a night says of a line's point. It is kept, because the judgement of later nights begins from it. */
enum aob_night_verdict {
    AOB_NIGHT_NONE,   /* nothing stood out */
    AOB_NIGHT_FIRST,  /* the line's first point */
    AOB_NIGHT_SLOWER, /* confirmed beside the old module */
    AOB_NIGHT_FASTER,
    AOB_NIGHT_MOVED,   /* another image */
    AOB_NIGHT_OUTLIER, /* it stood out, and measured again it did not */
    AOB_NIGHT_MACHINE, /* it stands out, and the module is the same, or is as fast as the old one beside it */
    AOB_NIGHT_OPEN,    /* it stood out, and could not be decided */
    AOB_NIGHT_BROKEN,  /* it ran the night before, and does not any more */
    AOB_NIGHT_CHANGED, /* cost and image are as before, and its memory or cache figures are not */
    AOB_NIGHT_FAILING, /* it failed, and did not run the night before either */
    AOB_NIGHT_VERDICTS
};
extern const char *const aob_night_verdict_names[]; /* lower-case words: "none", "first", "slower", ... */

struct aob_line_verdict {
    int64_t line; /* its id */
    enum aob_night_verdict verdict;
    int64_t since;    /* the night in which the new level began; 0: it tells of none */
    const char *said; /* one sentence; NULL is "" */
};
/* Keeps the verdicts on the points that the lines have in a night: all of them or none. */
bool aob_lines_judge(struct aob_history *history, int64_t night, const struct aob_line_verdict *verdicts,
                     size_t count, struct aob_error *error);
#endif
