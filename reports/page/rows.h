/* The cases of one or more run folders, read from journal.jsonl and run.json.
 * Whatever is absent, null or of another type is "" or NaN, so that a partial or foreign journal still makes
 * a page. All strings belong to the rows. */
#ifndef AOB_REPORTS_PAGE_ROWS_H
#define AOB_REPORTS_PAGE_ROWS_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/member.h"
#include "store/metric.h"
#include "target.h"

struct aob_run {
    const char *folder;
    json_t *info;     /* run.json, or NULL */
    json_t *lines;    /* the journal's objects */
    const char *name; /* run.json's, else the folder's path */
    size_t planned;   /* cases; 0: not known */
    size_t cases;     /* found in the journal */
    size_t asked,
        missing; /* of those planned: what the run's filters let through, and what the journal lacks of it */
    struct aob_error damage; /* of the journal, one line; empty if there is none */
};

/* A case's image against one target. */
struct aob_score {
    size_t target;      /* its place among the rows' targets */
    const json_t *json; /* the entry of `errors`; an older record's `error` */
    const char *truth;  /* path of the target's truth below the run's folder; "": none is kept */
    bool own;           /* the record's `error` is this one: the case's image holds its truth */
    struct aob_metrics metrics;
};

struct aob_row {
    size_t run, section, technique_place; /* places in the lists below */
    const json_t *json;
    const char *key, *series, *scene, *view, *backend, *status, *reason, *image;
    const char
        *technique; /* what it is called: its name; "gtao (new.so)" where the rows have two builds of it */
    const char *name, *module; /* of the technique, as in the journal; module "": built in */
    int width, height;
    double cost_ms;                /* of a frame: processor time, or wall time if that is the case's clock */
    double ratio, ci_low, ci_high; /* the 95 % interval is the ratio's */
    double memory_bytes;
    struct aob_score *scores; /* one a target, in the order of the targets */
    size_t score_count;
    char *label; /* what sets the case apart (label.h) */
    char *build; /* the technique's text where it is more than its name; else NULL */
};

/* One scene seen in one view, in one run. */
struct aob_section {
    size_t run;
    const char *scene, *view;
    const char *backend; /* of its first good case; "" */
    size_t *rows;        /* places of its cases */
    size_t count, capacity;
};

struct aob_rows {
    struct aob_run *runs;
    size_t run_count;
    struct aob_row *list;
    size_t count, capacity;
    struct aob_target *targets; /* sorted, each once */
    size_t target_count, target_capacity;
    struct aob_section *sections; /* in the order of the journals */
    size_t section_count, section_capacity;
    const char *
        *techniques; /* what they are called, in the same order; the place is the technique's colour */
    size_t technique_count, technique_capacity;
};

/* False if a folder is given twice or has neither a journal nor run.json, or the journal cannot be read; damaged lines
 * are left out. */
bool aob_rows_read(struct aob_rows *rows, const char *const *folders, size_t folder_count,
                   struct aob_error *error);
void aob_rows_finish(struct aob_rows *rows);

/* The same of one folder, with no other members of its records than those that `paths` name (base/json_keep.h). */
bool aob_rows_read_only(struct aob_rows *rows, const char *folder, const char *const *paths,
                        struct aob_error *error);

/* The line on the first journal with damaged lines; "" if there is none. */
const char *aob_rows_damage(const struct aob_rows *rows);

bool aob_row_is_ok(const struct aob_row *row);

/* Whether an entry of run.json's techniques is the row's. Of an older record, which names no module, the first of the
 * name is. */
bool aob_row_is_of(const struct aob_row *row, const json_t *technique);

/* The case's score against the target of that place; against its own, which `error` holds. NULL: there is none. */
const struct aob_score *aob_row_score(const struct aob_row *row, size_t target);
const struct aob_score *aob_row_own_score(const struct aob_row *row);

/* Does the score hold all three parts of its error? Without a definition, and in old journals, it does not. */
bool aob_score_is_split(const struct aob_score *score);
#endif
