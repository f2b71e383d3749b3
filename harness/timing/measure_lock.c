#include "measure_lock.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#include "base/file.h"
#include "base/text.h"
#include "measure_turn.h"

static const char *const places[] = {"/run/lock/aobudget-measure.lock", "/tmp/aobudget-measure.lock", NULL};

/* Everybody shall be able to lock it, whatever the umask, from the moment that it has its name. One call does that; it needs
 * neither modes nor hard links, which some file systems do not have, and leaves nothing half made. False with errno, which
 * is EEXIST if somebody was faster. */
static bool create_file(const char *path)
{
    mode_t mask = umask(0);
    int file = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    int cause = errno;
    umask(mask);
    if (file >= 0)
        close(file);
    errno = cause;
    return file >= 0;
}

/* Without O_CREAT: in a folder that anybody may write to, Linux refuses to open another user's file with it
 * (fs.protected_regular). A file that may only be read can be locked as well. */
static int open_existing(const char *path)
{
    const int flags = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    int file = open(path, O_RDWR | flags);
    return file < 0 && errno == EACCES ? open(path, O_RDONLY | flags) : file;
}

static int open_file(const char *path)
{
    int file = open_existing(path);
    if (file < 0 && errno == ENOENT && (create_file(path) || errno == EEXIST))
        file = open_existing(path);
    return file;
}

static bool refuse(const char *path, const char *why, struct aob_error *error)
{
    return aob_fail(error,
                    "%s: cannot be used as the lock of measuring: %s; AOBUDGET_LOCK may name another file",
                    path, why);
}

static int open_regular(const char *path, struct aob_error *error)
{
    struct stat info;
    int file = open_file(path);
    if (file >= 0 && fstat(file, &info) == 0 && S_ISREG(info.st_mode))
        return file;
    refuse(path, file >= 0 ? "it is no regular file" : strerror(errno), error);
    if (file >= 0)
        close(file);
    return -1;
}

int aob_measure_lock_open(const char *const *files, const char **path, struct aob_error *error)
{
    struct stat there;
    for (const char *const *p = files; *p; p++) {
        int file = open_regular(*p, error);
        *path = *p;
        if (file >= 0 && error)
            *error->text = '\0'; /* of the first place */
        if (file >= 0 || lstat(*p, &there) == 0)
            return file;
    }
    return -1;
}

static int open_lock(const char **path, struct aob_error *error)
{
    const char *own[] = {getenv("AOBUDGET_LOCK"), NULL};
    return aob_measure_lock_open(own[0] ? own : places, path, error);
}

/* 0 if nobody has it, EWOULDBLOCK if somebody has, else why it cannot be locked. It is locked for a moment. */
static int probe(int file)
{
    if (flock(file, LOCK_SH | LOCK_NB) != 0)
        return errno;
    flock(file, LOCK_UN);
    return 0;
}

bool aob_measure_lock_check(struct aob_error *error)
{
    const char *path;
    int file = open_lock(&path, error);
    if (file < 0)
        return false;
    int cause = probe(file);
    close(file);
    return cause == 0 || cause == EWOULDBLOCK || refuse(path, strerror(cause), error);
}

/* What the holder wrote is shown if it is another process' number; anybody may write there. */
static void tell(struct aob_measure_lock *lock, const char *path)
{
    char number[16] = {0}, since[16] = "?", holder[48] = "another process", own[16];
    struct stat info;
    struct tm local;
    snprintf(own, sizeof own, "%d\n", (int)getpid());
    if (pread(lock->file, number, sizeof number - 1, 0) > 0 && strcmp(number, own) != 0) {
        size_t digits = strspn(number, "0123456789");
        if (digits > 0 && digits <= 10 && number[digits] == '\n')
            snprintf(holder, sizeof holder, "process %.*s", (int)digits, number);
    }
    if (fstat(lock->file, &info) == 0 && localtime_r(&info.st_mtime, &local))
        strftime(since, sizeof since, "%H:%M:%S", &local);
    if (!lock->told)
        aob_note("waiting for %s, which has measured since %s: one at a time on a machine (%s)", holder,
                 since, path);
    lock->told = true;
}

static void sign(int file)
{
    char text[16];
    int size = snprintf(text, sizeof text, "%d\n", (int)getpid());
    if (ftruncate(file, 0) == 0 && !aob_file_send(file, text, (size_t)size))
        return; /* a full disk: the lock holds without a name */
}

static int open_turn(const char *path)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s.turn", path);
    int turn = open_regular(name.data, NULL);
    aob_text_finish(&name);
    return turn;
}

/* Whose turn it is takes a lock that is free at once. If it does not, it is stopped, which must not stop everybody else; or
 * the lock can be locked by nobody, which whoever asks for it is told. */
static void await_turn(struct aob_measure_lock *lock, const struct aob_measure_turn *turn, const char *path)
{
    const struct timespec step = {.tv_nsec = AOB_MEASURE_LOCK_STEP_MS * 1000000L};
    int held_ms = 0, idle_ms = 0;
    while (idle_ms < AOB_MEASURE_LOCK_PATIENCE_MS && aob_measure_turn_is_behind(turn)) {
        nanosleep(&step, NULL);
        bool held = probe(lock->file) == EWOULDBLOCK;
        idle_ms = held ? 0 : idle_ms + AOB_MEASURE_LOCK_STEP_MS;
        if (held && !lock->told)
            held_ms += AOB_MEASURE_LOCK_STEP_MS;
        if (held_ms >= AOB_MEASURE_LOCK_PATIENCE_MS && !lock->told)
            tell(lock, path);
    }
}

/* Who only asks whether it is held has it for a moment, which is nothing to tell of: so it is tried twice. */
static bool wait_for(struct aob_measure_lock *lock, const char *path)
{
    const struct timespec step = {.tv_nsec = AOB_MEASURE_LOCK_STEP_MS * 1000000L};
    if (flock(lock->file, LOCK_EX | LOCK_NB) == 0)
        return true;
    nanosleep(&step, NULL);
    if (flock(lock->file, LOCK_EX | LOCK_NB) == 0)
        return true;
    if (errno == EWOULDBLOCK)
        tell(lock, path);
    int got;
    while ((got = flock(lock->file, LOCK_EX)) != 0 && errno == EINTR)
        continue;
    return got == 0;
}

/* The place in the queue is given back after the lock is signed, so that whoever is first then reads there for whom it
 * waits. */
static bool lock_in_turn(struct aob_measure_lock *lock, const char *path)
{
    struct aob_measure_turn turn;
    aob_measure_turn_join(&turn, open_turn(path));
    await_turn(lock, &turn, path);
    bool ok = wait_for(lock, path);
    int cause = errno;
    if (ok)
        sign(lock->file);
    aob_measure_turn_leave(&turn);
    errno = cause;
    return ok;
}

/* The file may have been removed while it was waited for, as old files in /tmp are; who comes next locks another then. */
static bool is_current(int file, const char *path)
{
    struct stat own, named;
    return fstat(file, &own) == 0 && lstat(path, &named) == 0 && own.st_dev == named.st_dev &&
           own.st_ino == named.st_ino;
}

bool aob_measure_lock_take(struct aob_measure_lock *lock, struct aob_error *error)
{
    const char *path;
    for (;;) {
        lock->file = open_lock(&path, error);
        if (lock->file < 0)
            return false;
        if (!lock_in_turn(lock, path)) {
            refuse(path, strerror(errno), error);
            close(lock->file);
            return false;
        }
        if (is_current(lock->file, path))
            break;
        close(lock->file);
    }
    lock->held = true;
    return true;
}

void aob_measure_lock_release(struct aob_measure_lock *lock)
{
    if (lock->held) {
        flock(lock->file, LOCK_UN); /* a child that was just started may still have the file */
        close(lock->file);
    }
    lock->held = false;
}
