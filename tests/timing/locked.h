/* A lock of measuring in a folder of its own, for tests of the lock. Both functions are the group's set-up and tear-down. */
#ifndef AOB_TESTS_TIMING_LOCKED_H
#define AOB_TESTS_TIMING_LOCKED_H
#include "check.h"
#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <unistd.h>
#include "base/file.h"
#include "timing/measure_lock.h"

static char folder[] = "/tmp/aobudget-lock-XXXXXX", *path, *turn; /* path: of the lock; turn: of its queue */

static int set_up(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    path = aob_path_join(folder, "lock");
    turn = aob_path_join(folder, "lock.turn");
    return setenv("AOBUDGET_LOCK", path, 1);
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    unlink(turn);
    free(path);
    free(turn);
    return rmdir(folder); /* which holds nothing else */
}

static struct aob_measure_lock take_lock(void)
{
    struct aob_measure_lock lock = {0};
    struct aob_error error = {{0}};
    if (!aob_measure_lock_take(&lock, &error))
        fail_msg("%s", error.text);
    return lock;
}

/* Whether somebody has what lies at the path. */
static bool is_locked(void)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    bool locked = file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0;
    if (file >= 0)
        close(file);
    return locked;
}
#endif
