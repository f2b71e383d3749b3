#include "start.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>
#include "base/file.h"
#include "base/member.h"
#include "base/memory.h"
#include "subject.h"

static const char stopped[] = "{\"line\": \"stopped\"}";

bool aob_night_is_stopped(const struct aob_night *night)
{
    return !night->whole || strcmp(night->summary, stopped) == 0;
}

/* OUT/2026-11-30, and OUT/2026-11-30-2 for a second one of that day. */
static char *new_folder(const char *out, const char *date)
{
    for (int i = 1;; i++) {
        struct aob_text name = {0};
        aob_text_add(&name, i > 1 ? "%.10s-%d" : "%.10s", date, i);
        char *path = aob_path_join(out, name.data);
        aob_text_finish(&name);
        if (!aob_file_exists(path))
            return path;
        free(path);
    }
}

/* A night that nobody has is not locked, whatever became of the program that had it. */
static bool lock(struct aob_night_start *start, const char *folder, struct aob_error *error)
{
    int file = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (file < 0)
        return aob_fail(error, "%s: %s", folder, strerror(errno));
    if (flock(file, LOCK_EX | LOCK_NB) != 0) {
        bool busy = errno == EWOULDBLOCK;
        aob_fail(error, "%s: %s", folder,
                 busy ? "another call of nightly has this night; wait until it has ended" : strerror(errno));
        close(file);
        return false;
    }
    if (start->lock)
        close(start->lock);
    start->lock = file;
    return true;
}

/* What was measured of a night that nobody goes on with stays known. */
static bool end_stopped(struct aob_history *history, const struct aob_night *night, struct aob_error *error)
{
    struct aob_error cause = {{0}};
    struct aob_night_start other = {0};
    if (aob_folder_exists(night->folder) && !lock(&other, night->folder, error))
        return false;
    aob_warn(
        "the night of %s was stopped, and this is none to go on with it: it ends unjudged, with what it has",
        night->date);
    if (other.lock && !aob_night_take(history, night->id, NULL, &cause))
        aob_warn("%s", cause.text);
    bool ok = aob_night_end(history, night->id, stopped, error);
    aob_night_start_finish(&other);
    return ok;
}

static bool is_same(const struct aob_night *night, const struct aob_subject *subject)
{
    return strcmp(night->config_hash, subject->config_hash) == 0 &&
           strcmp(night->modules, subject->modules) == 0 && aob_folder_exists(night->folder);
}

static bool go_on(const struct aob_night *night, struct aob_night_start *start, struct aob_error *error)
{
    free(start->run);
    free(start->date);
    start->id = night->id;
    start->date = aob_strdup(night->date);
    start->run = aob_strdup(night->folder);
    return lock(start, start->run, error);
}

/* A run that was made elsewhere is the night of its folder, and of no other. */
static bool find_stopped(struct aob_history *history, const struct aob_subject *subject,
                         struct aob_night_start *start, struct aob_error *error)
{
    struct aob_nights nights = {0};
    bool ok = aob_nights_read(history, subject->name, &nights, error);
    for (size_t i = 0; ok && i < nights.count; i++) {
        const struct aob_night *night = &nights.items[i];
        bool own = !start->measured || strcmp(start->run, night->folder) == 0;
        if (start->measured && own && night->whole)
            ok = aob_fail(error, "%s is the night of %s already, number %lld", start->run, night->date,
                          (long long)night->id);
        else if (!night->whole)
            ok = own && is_same(night, subject) ? go_on(night, start, error)
                                                : end_stopped(history, night, error);
    }
    aob_nights_finish(&nights);
    return ok;
}

static bool begin(struct aob_history *history, const struct aob_subject *subject,
                  struct aob_night_start *start, struct aob_error *error)
{
    char date[32];
    struct tm tm;
    gmtime_r(&subject->date, &tm);
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &tm);
    start->date = aob_strdup(date);
    start->run = start->measured ? start->run : new_folder(start->out, date);
    if (!aob_folder_create(start->run, error) || !lock(start, start->run, error))
        return false;
    start->id = aob_night_begin(history,
                                &(struct aob_night_desc){.name = subject->name,
                                                         .config_hash = subject->config_hash,
                                                         .folder = start->run,
                                                         .modules = subject->modules,
                                                         .date = subject->date},
                                error);
    return start->id;
}

bool aob_night_start(struct aob_history *history, const struct aob_nightly_desc *desc,
                     struct aob_night_start *start, struct aob_error *error)
{
    struct aob_subject subject;
    start->measured = aob_folder_exists(desc->config);
    if (!aob_subject_read(&subject, desc, start->measured, error))
        return false;
    char *nights = aob_path_join("results/nightly", subject.name);
    start->name = aob_strdup(subject.name);
    start->modules = aob_strdup(subject.modules);
    start->out = aob_strdup(desc->out ? desc->out : nights);
    start->run = start->measured ? realpath(desc->config, NULL) : NULL;
    free(nights);
    if (start->measured && !start->run)
        return aob_fail(error, "%s: %s", desc->config, strerror(errno));
    if (!aob_folder_create(start->out, error) || !find_stopped(history, &subject, start, error) ||
        (!start->id && !begin(history, &subject, start, error)))
        return false;
    start->folder = start->measured ? new_folder(start->out, start->date) : aob_strdup(start->run);
    return aob_folder_create(start->folder, error);
}

bool aob_night_start_stands(const struct aob_night_start *start, const struct aob_nightly_desc *desc,
                            struct aob_error *error)
{
    struct aob_subject now;
    return aob_subject_read(&now, desc, start->measured, error) &&
           (strcmp(now.modules, start->modules) == 0 ||
            aob_fail(
                error,
                "a module or the program was built again while the night of %s was measured, so its cases "
                "are of two builds: start the night again",
                start->date));
}

void aob_night_start_finish(struct aob_night_start *start)
{
    if (start->lock)
        close(start->lock);
    free(start->date);
    free(start->name);
    free(start->run);
    free(start->folder);
    free(start->out);
    free(start->modules);
    *start = (struct aob_night_start){0};
}
