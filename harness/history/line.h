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
    int verdict;                                       /* enum aob_night_verdict below */
    int64_t since; /* the night in which the level that it tells of began; 0: none */
    char *said;    /* the sentence of that; "" */
    json_t *
        figures; /* {"flip": 0.01, "cache.ps4.l2.most.miss_ratio": 0.2}: every metric of the own target and every cache
                        figure, named as the columns of cases.csv; NULL unless they were asked for */
};
struct aob_line {
    int64_t id;
    char series[AOB_KEY_SIZE];
    char *
        class_name; /* of machine, device, driver, threads, clock and fixed pass: "cpu, 2 x AMD EPYC ..., llvmpipe ..." */
    char *config;                                    /* name of the config whose nights it is in */
    char *scene, *view, *technique, *backend, *size; /* size: "480x270" */
    char *
        text; /* "corner/front gtao radius=0.5 vulkan 480x270": as tables call it; what is at default is left out if run.json tells */
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
    bool figures;
};
bool aob_lines_read(struct aob_history *history, const struct aob_lines_ask *ask, struct aob_lines *lines,
                    struct aob_error *error);
void aob_lines_finish(struct aob_lines *lines);

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
    AOB_NIGHT_VERDICTS
};
extern const char *const aob_night_verdict_names[]; /* lower-case words: "none", "first", "slower", ... */

/* Keeps the verdict on a line's point of a night, with one sentence. `since`: the night in which the new level began; 0 where
 * there is none. */
bool aob_line_judge(struct aob_history *history, int64_t line, int64_t night, enum aob_night_verdict verdict,
                    int64_t since, const char *said, struct aob_error *error);
#endif
