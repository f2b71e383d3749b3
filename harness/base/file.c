#include "file.h"
#include "memory.h"
#include "part.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *aob_file_read(const char *path, size_t limit, size_t *size, struct aob_error *error)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        aob_fail(error, "%s: cannot open: %s", path, strerror(errno));
        return NULL;
    }
    char *bytes = NULL;
    size_t used = 0, room = 0, got;
    do {
        room = room ? room * 2 : 65536;
        bytes = aob_realloc(bytes, room + 1, 1);
        got = fread(bytes + used, 1, room - used, file);
        used += got;
    } while (used == room && used <= limit);
    bool bad = ferror(file);
    fclose(file);
    if (bad || used > limit) {
        aob_fail(error, bad ? "%s: cannot read: is it a file?" : "%s: the file is larger than %zu bytes",
                 path, limit);
        free(bytes);
        return NULL;
    }
    bytes[used] = '\0';
    if (size)
        *size = used;
    return bytes;
}

/* A disk that fills up takes a part first, and says why it takes no more when it is asked again. */
bool aob_file_send(int file, const void *bytes, size_t size)
{
    for (size_t sent = 0; sent < size;) {
        ssize_t count = write(file, (const char *)bytes + sent, size - sent);
        if (count < 0 && errno != EINTR)
            return false;
        sent += count > 0 ? (size_t)count : 0;
    }
    return true;
}

bool aob_file_is_special(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && !S_ISREG(info.st_mode);
}

bool aob_folder_exists(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

char *aob_file_target(const char *path, struct aob_error *error)
{
    char *real = realpath(path, NULL);
    if (!real)
        return aob_strdup(path);
    if (!aob_file_is_special(real))
        return real;
    aob_fail(error, "%s: cannot write: it is no regular file", path);
    free(real);
    return NULL;
}

static bool write_into(const char *path, const struct aob_piece *pieces, size_t count,
                       struct aob_error *error)
{
    FILE *file = fopen(path, "wb");
    bool ok = file != NULL;
    for (size_t i = 0; i < count && ok; i++)
        ok = fwrite(pieces[i].bytes, 1, pieces[i].size, file) == pieces[i].size;
    if (file)
        ok = fclose(file) == 0 && ok;
    return ok || aob_fail(error, "%s: cannot write: %s", path, strerror(errno));
}

/* A pipe is not opened here, because its reader would see the end of its input. */
bool aob_file_check(const char *path, struct aob_error *error)
{
    if (aob_file_is_special(path))
        return (access(path, W_OK) == 0 && !aob_folder_exists(path)) ||
               aob_fail(error, "%s: cannot write: %s", path,
                        aob_folder_exists(path) ? "it is a folder" : strerror(errno));
    char *target = aob_file_target(path, error);
    if (!target)
        return false;
    struct aob_part part;
    bool ok = aob_part_create(&part, target, error);
    if (ok)
        aob_part_drop(&part);
    free(target);
    return ok;
}

static bool replace(const char *target, const struct aob_piece *pieces, size_t count,
                    bool (*keep)(struct aob_part *, struct aob_error *), struct aob_error *error)
{
    struct aob_part part;
    if (!aob_part_create(&part, target, error))
        return false;
    for (size_t i = 0; i < count; i++)
        if (!aob_part_write(&part, pieces[i].bytes, pieces[i].size, error)) {
            aob_part_drop(&part);
            return false;
        }
    return keep(&part, error);
}

bool aob_file_write_pieces(const char *path, const struct aob_piece *pieces, size_t count,
                           struct aob_error *error)
{
    if (aob_file_is_special(path))
        return write_into(path, pieces, count, error);
    char *target = aob_file_target(path, error);
    bool ok = target && replace(target, pieces, count, aob_part_keep, error);
    free(target);
    return ok;
}

bool aob_file_write_pieces_unflushed(const char *path, const struct aob_piece *pieces, size_t count,
                                     struct aob_error *error)
{
    char *target = aob_file_target(path, error);
    bool ok = target && replace(target, pieces, count, aob_part_name, error);
    free(target);
    return ok;
}

bool aob_file_write(const char *path, const void *bytes, size_t size, struct aob_error *error)
{
    return aob_file_write_pieces(path, &(struct aob_piece){bytes, size}, 1, error);
}

bool aob_file_fail(const char *path, const char *words, struct aob_error *error)
{
    return aob_fail(error,
                    "%s: cannot load: the file is damaged, or of a form or size that is not read: save it "
                    "again, or in another format (%s)",
                    path, words);
}

bool aob_file_exists(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0;
}

size_t aob_file_size(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 ? (size_t)info.st_size : 0;
}

bool aob_folder_create(const char *path, struct aob_error *error)
{
    if (!*path)
        return aob_fail(error, "a folder's name is empty: give one, such as results/new");
    char *part = aob_strdup(path);
    for (char *c = part + 1; *c; c++) {
        if (*c != '/')
            continue;
        *c = '\0';
        mkdir(part, 0777);
        *c = '/';
    }
    free(part);
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        return aob_fail(error, "%s: cannot create the folder: %s", path, strerror(errno));
    if (!aob_folder_exists(path))
        return aob_fail(error, "%s: it is not a folder", path);
    return access(path, W_OK) == 0 || aob_fail(error, "%s: the folder is not writable", path);
}

bool aob_folder_flush(const char *path, struct aob_error *error)
{
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    bool ok = (folder >= 0 && syncfs(folder) == 0) ||
              aob_fail(error, "%s: cannot write: %s", path, strerror(errno));
    if (folder >= 0)
        close(folder);
    return ok;
}

char *aob_path_join(const char *folder, const char *name)
{
    char *path = aob_alloc(strlen(folder) + strlen(name) + 2, 1);
    sprintf(path, "%s/%s", folder, name);
    return path;
}

char *aob_path_beside(const char *file, const char *path)
{
    const char *slash = strrchr(file, '/');
    if (*path == '/' || !slash)
        return aob_strdup(path);
    size_t folder = (size_t)(slash - file) + 1;
    char *joined = aob_alloc(folder + strlen(path) + 1, 1);
    memcpy(joined, file, folder);
    strcpy(joined + folder, path);
    return joined;
}

char *aob_path_absolute(const char *path)
{
    char *folder = *path == '/' ? NULL : getcwd(NULL, 0);
    char *absolute = folder ? aob_path_join(folder, path) : aob_strdup(path);
    free(folder);
    return absolute;
}

char *aob_path_program(void)
{
    char path[4096];
    ssize_t size = readlink("/proc/self/exe", path, sizeof path - 1);
    path[size > 0 ? size : 0] = '\0';
    return aob_strdup(path);
}

char *aob_path_program_folder(void)
{
    char *path = aob_path_program();
    char *slash = strrchr(path, '/');
    if (slash)
        *slash = '\0';
    return path;
}
