#include "part.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include "file.h"
#include "memory.h"

enum { RANDOM_DIGITS = 16, NAME_SIZE = 40, MOST_TRIES = 100 };
static const char prefix[] = ".aobudget-", suffix[] = ".part";

static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    if (!slash)
        return aob_strdup(".");
    char *folder = aob_strdup(path);
    folder[slash == path ? 1 : slash - path] = '\0';
    return folder;
}

static bool fail(const struct aob_part *part, struct aob_error *error)
{
    return aob_fail(error, "%s: cannot write: %s", part->target, strerror(errno));
}

/* The lock says that the writer lives, whatever process numbers mean in a folder that several machines or containers
 * share. A cleaner may come between the two calls; the part has no name then. */
static bool create_and_lock(struct aob_part *part)
{
    struct stat info;
    part->file = open(part->path, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (part->file < 0)
        return false;
    while (flock(part->file, LOCK_EX) != 0 && errno == EINTR)
        continue;
    if (fstat(part->file, &info) == 0 && info.st_nlink > 0)
        return true;
    close(part->file);
    errno = EEXIST;
    return false;
}

static bool create_in(struct aob_part *part, const char *folder)
{
    for (int i = 0; i < MOST_TRIES; i++) {
        uint64_t number;
        char name[NAME_SIZE];
        if (getrandom(&number, sizeof number, 0) != sizeof number)
            return false;
        snprintf(name, sizeof name, "%s%0*llx%s", prefix, RANDOM_DIGITS, (unsigned long long)number, suffix);
        part->path = aob_path_join(folder, name);
        if (create_and_lock(part))
            return true;
        free(part->path);
        part->path = NULL;
        if (errno != EEXIST)
            return false;
    }
    return false;
}

bool aob_part_create(struct aob_part *part, const char *target, struct aob_error *error)
{
    *part = (struct aob_part){.file = -1, .target = target};
    char *folder = folder_of(target);
    bool ok = create_in(part, folder) || fail(part, error);
    free(folder);
    return ok;
}

bool aob_part_write(struct aob_part *part, const void *bytes, size_t size, struct aob_error *error)
{
    return aob_file_send(part->file, bytes, size) || fail(part, error);
}

/* A new name is on disk when its folder is. Some file systems cannot say that of a folder, and one that may not be read
 * cannot be asked. */
static bool sync_folder(const char *target)
{
    char *path = folder_of(target);
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    bool ok = folder < 0 || fsync(folder) == 0 || errno == EINVAL || errno == ENOTSUP;
    if (folder >= 0)
        close(folder);
    free(path);
    return ok;
}

static void finish(struct aob_part *part)
{
    close(part->file);
    free(part->path);
    *part = (struct aob_part){.file = -1};
}

static bool give_name(struct aob_part *part, bool flush, struct aob_error *error)
{
    if ((!flush || fsync(part->file) == 0) && rename(part->path, part->target) == 0)
        return true;
    fail(part, error);
    aob_part_drop(part);
    return false;
}

bool aob_part_name(struct aob_part *part, struct aob_error *error)
{
    bool ok = give_name(part, false, error);
    if (ok)
        finish(part);
    return ok;
}

bool aob_part_keep(struct aob_part *part, struct aob_error *error)
{
    if (!give_name(part, true, error))
        return false;
    bool ok = sync_folder(part->target) || fail(part, error);
    finish(part);
    return ok;
}

void aob_part_drop(struct aob_part *part)
{
    unlink(part->path);
    finish(part);
}

static bool is_part(const char *name)
{
    size_t head = sizeof prefix - 1;
    return strncmp(name, prefix, head) == 0 && strspn(name + head, "0123456789abcdef") == RANDOM_DIGITS &&
           strcmp(name + head + RANDOM_DIGITS, suffix) == 0;
}

static void clean_one(int folder, const char *name)
{
    int file = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return;
    if (flock(file, LOCK_EX | LOCK_NB) == 0)
        unlinkat(folder, name, 0);
    close(file);
}

void aob_part_clean(const char *folder)
{
    DIR *directory = opendir(folder);
    for (struct dirent *entry; directory && (entry = readdir(directory));)
        if (is_part(entry->d_name))
            clean_one(dirfd(directory), entry->d_name);
    if (directory)
        closedir(directory);
}
