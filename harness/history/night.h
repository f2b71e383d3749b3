/* A night: one run of a config, as a history keeps it: who measured what and when, the journal whole, the raw rounds, and
 * the modules that were measured, so that a later night can measure them again. */
#ifndef AOB_HISTORY_NIGHT_H
#define AOB_HISTORY_NIGHT_H
#include <stdint.h>
#include "history.h"

struct aob_night {
    int64_t id;        /* from 1, in the order in which the nights began */
    char *date;        /* when it began, "2026-11-30T02:00:00Z" */
    char *name;        /* the config's */
    char *config_hash; /* 32 digits */
    char *build;       /* hash of the program; "" before the first case was taken */
    char *folder;      /* of its run, absolute; it may be gone */
    char *modules;     /* hash of what the caller says the night is of (aob_night_begin) */
    bool whole;        /* ended; else it was stopped, or is under way */
    size_t cases, ok;  /* taken so far */
    char *summary;     /* JSON text that aob_night_end was given; "" before */
};
struct aob_nights { /* zero it first */
    struct aob_night *items;
    size_t count;
};

/* All nights in their order; with a config's name (not NULL) those of that name. */
bool aob_nights_read(struct aob_history *history, const char *name, struct aob_nights *nights,
                     struct aob_error *error);
void aob_nights_finish(struct aob_nights *nights);

struct aob_night_desc {
    const char *name, *config_hash, *folder; /* folder: as given; an absolute path is kept */
    const char *
        modules; /* a hash of program and modules: a night that was stopped is gone on with only if it is equal */
    int64_t date; /* seconds since 1970, UTC; 0: now */
};
/* Begins a night and returns its id; 0 after a line. */
int64_t aob_night_begin(struct aob_history *history, const struct aob_night_desc *desc,
                        struct aob_error *error);

/* Takes what the night's run folder holds now (journal.jsonl, run.json, rounds/): points, journal, rounds, and the bytes of
 * its modules' files where they still have the digest that run.json names. In one transaction: all of it or nothing. Taking
 * the same folder again replaces what the night held, verdicts included; an ended night is refused. Of the journal those
 * records count that are of the run's plan. A record without a time is on its series' line as the run's other cases of that
 * backend were timed, else on a line of the series. One without a `series` (its case reached no device) is on a
 * line whose case has the same names, settings and size, so that what breaks is seen on its own line; if there is
 * none, on a line under its key. Of several such lines it is one of the machine and clock that the run's other cases of that
 * backend name, else, and among these, the one with the latest point. Of two cases on one line the first is kept. That, a file
 * of rounds that is missing or damaged, and a module whose file is no longer what was measured, are told by a warning. A
 * run.json that is there and cannot be read is refused. *taken: points (NULL: nobody asks). */
bool aob_night_take(struct aob_history *history, int64_t night, size_t *taken, struct aob_error *error);

/* Ends the night: nothing is added to it any more. `summary`: a JSON text that `history list` and pages show. */
bool aob_night_end(struct aob_history *history, int64_t night, const char *summary, struct aob_error *error);

/* Writes the file of the module with this digest to `path`. False with a line: it is not kept, or cannot be written. */
bool aob_night_module_write(struct aob_history *history, const char *digest, const char *path,
                            struct aob_error *error);

/* Removes what is older than the `keep` latest nights of each config that ended with a case: with `rounds_only` the raw rounds
 * and journals of those older nights, else the nights; and modules that no night names any more. A night that has not ended
 * stays. Then the file is made smaller. */
struct aob_prune {
    size_t nights, points;
    long long bytes; /* that the file is smaller by */
};
bool aob_nights_prune(struct aob_history *history, size_t keep, bool rounds_only, struct aob_prune *pruned,
                      struct aob_error *error);
#endif
