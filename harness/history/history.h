/* A history: one SQLite file (write-ahead log) that keeps the figures of every night, of every series, by the class of
 * the machine and device that measured it. Nights are added and pruned; what a night holds does not change. One thread a
 * history; several processes may read it while one writes. */
#ifndef AOB_HISTORY_HISTORY_H
#define AOB_HISTORY_HISTORY_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_history;

enum aob_history_use {
    AOB_HISTORY_READ,  /* the file must be there; neither it nor a log that lies beside it is changed */
    AOB_HISTORY_WRITE, /* made if it is not there; its folder must be */
};

/* Opens and judges the file: one that is no history, is damaged or cut short, was made by a newer program, cannot be
 * written although it shall be, or is held by another writer for more than `AOB_HISTORY_WAIT_S` is refused with one line
 * that says which, and is left as it is. NULL then. */
struct aob_history *aob_history_open(const char *path, enum aob_history_use use, struct aob_error *error);
void aob_history_close(struct aob_history *history); /* NULL too */

#define AOB_HISTORY_WAIT_S 10.0
#endif
