#include "cache.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/part.h"
#include "base/sealed.h"
#include "base/text.h"

static char *choose_folder(void)
{
    const char *own = getenv("AOBUDGET_CACHE"), *xdg = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
    if (own && *own)
        return aob_strdup(own);
    if (xdg && *xdg)
        return aob_path_join(xdg, "aobudget");
    if (home && *home)
        return aob_path_join(home, ".cache/aobudget");
    char path[64];
    snprintf(path, sizeof path, "/tmp/aobudget-%ld", (long)geteuid());
    return aob_strdup(path);
}

/* With a slash at its end, a link would be taken for the folder behind it. */
static void cut_slashes(char *path)
{
    for (size_t size = strlen(path); size > 1 && path[size - 1] == '/'; size--)
        path[size - 1] = '\0';
}

static bool create_folder(const char *path, struct aob_error *error)
{
    struct stat info;
    const char *slash = strrchr(path, '/');
    if (lstat(path, &info) == 0)
        return true;
    if (slash && slash != path) {
        char *parent = aob_strdup(path);
        parent[slash - path] = '\0';
        bool ok = aob_folder_create(parent, error);
        free(parent);
        if (!ok)
            return false;
    }
    return mkdir(path, 0700) == 0 || errno == EEXIST ||
           aob_fail(error, "%s: cannot create the folder: %s", path, strerror(errno));
}

static bool judge_folder(const char *path, struct aob_error *error)
{
    struct stat info;
    if (lstat(path, &info) != 0)
        return aob_fail(error, "%s: cannot open: %s", path, strerror(errno));
    if (S_ISLNK(info.st_mode))
        return aob_fail(error, "%s: it is a link, and is not followed: name the folder itself", path);
    if (!S_ISDIR(info.st_mode))
        return aob_fail(error, "%s: it is not a folder", path);
    if (info.st_uid != geteuid())
        return aob_fail(error, "%s: the folder belongs to user %ld, not to you (user %ld)", path,
                        (long)info.st_uid, (long)geteuid());
    if (info.st_mode & (S_IWGRP | S_IWOTH))
        return aob_fail(error, "%s: others may write in the folder (mode %04o): chmod go-w", path,
                        (unsigned)info.st_mode & 07777);
    return faccessat(AT_FDCWD, path, W_OK | X_OK, AT_EACCESS) == 0 ||
           aob_fail(error, "%s: the folder is not writable", path);
}

bool aob_cache_keep(const struct aob_cache *cache, struct aob_error *error)
{
    return (create_folder(cache->folder, error) && judge_folder(cache->folder, error)) ||
           aob_fail_in(error, "cache (set AOBUDGET_CACHE to move it)");
}

bool aob_cache_open(struct aob_cache *cache, struct aob_error *error)
{
    cache->folder = choose_folder();
    cut_slashes(cache->folder);
    if (aob_cache_keep(cache, error)) {
        aob_part_clean(cache->folder);
        return true;
    }
    aob_cache_close(cache);
    return false;
}

void aob_cache_close(struct aob_cache *cache)
{
    free(cache->folder);
    cache->folder = NULL;
}

char *aob_cache_path(const struct aob_cache *cache, const char *kind, const char *what, const char *suffix)
{
    char key[AOB_KEY_SIZE];
    struct aob_text text = {0}, name = {0};
    aob_text_add(&text, "%s %s", aob_sealed_version, what);
    aob_hash_text(text.data, key);
    aob_text_add(&name, "%s/%s-%s%s", cache->folder, kind, key, suffix);
    aob_text_finish(&text);
    return name.data;
}

bool aob_cache_has(const char *path, bool *has, struct aob_error *error)
{
    struct aob_error wrong = {{0}};
    enum aob_sealed state = aob_sealed_judge(path, &wrong);
    *has = state == AOB_SEALED_GOOD;
    if (state == AOB_SEALED_WRONG)
        aob_warn("%s: it is discarded and made again", wrong.text);
    if (state != AOB_SEALED_SHUT)
        return true;
    return aob_fail(error, "%s: the cached file stays as it is: make it readable, or remove it", wrong.text);
}
