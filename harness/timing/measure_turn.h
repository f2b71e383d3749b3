/* The queue for the lock of measuring (measure_lock.h): an open file of which each process that waits has locked one byte,
 * its place. It joins behind the last place that is taken, so nobody who comes later is ever before it. The kernel gives a
 * place back with its process; nothing is written. Whoever is first asks for the lock itself. */
#ifndef AOB_TIMING_MEASURE_TURN_H
#define AOB_TIMING_MEASURE_TURN_H
#include <stdbool.h>
#include <sys/types.h>

struct aob_measure_turn {
    int file;    /* -1: none */
    off_t place; /* -1: the file gives none; then it is anybody's turn */
};

/* Takes the file over, which must be open for writing; without one, or where it cannot be locked, there is no queue. */
void aob_measure_turn_join(struct aob_measure_turn *turn, int file);

/* Whether somebody has a place before this one. */
bool aob_measure_turn_is_behind(const struct aob_measure_turn *turn);

/* Gives the place back and closes the file. */
void aob_measure_turn_leave(struct aob_measure_turn *turn);
#endif
