#include "old_files.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/text.h"

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* In a folder the module's whole path comes before its name alone, which two modules may share. */
static char *find_given(const char *given, const char *module)
{
    if (!given)
        return NULL;
    if (!aob_folder_exists(given))
        return aob_strdup(given);
    const char *const names[] = {module, file_name(module)};
    for (size_t i = 0; i < AOB_COUNT(names); i++) {
        char *path = aob_path_join(given, names[i]);
        if (aob_file_exists(path))
            return path;
        free(path);
    }
    return NULL;
}

/* OLD/DIGEST/gtao.so: two builds of one module may be asked for. */
static char *write_kept(const struct aob_old_files *files, const struct aob_point *old,
                        struct aob_error *error)
{
    char *folder = aob_path_join(files->folder, old->build),
         *path = aob_path_join(folder, file_name(old->module));
    bool ok =
        aob_folder_create(folder, error) && aob_night_module_write(files->history, old->build, path, error);
    free(folder);
    if (ok)
        return path;
    free(path);
    return NULL;
}

char *aob_old_files_find(const struct aob_old_files *files, const struct aob_point *old,
                         const struct aob_point *now, struct aob_error *error)
{
    if (!*now->module) {
        aob_fail(error, "it is built into the program, so no old build of it can be set beside it");
        return NULL;
    }
    struct aob_error cause = {{0}};
    char *given = find_given(files->given, now->module), digest[AOB_KEY_SIZE];
    char *file = given ? given : write_kept(files, old, &cause);
    if (!file)
        aob_fail(error, "%s; give the old build with --old", cause.text);
    else if (!aob_hash_file(file, digest, error) ||
             (strcmp(digest, now->build) == 0 &&
              !aob_fail(error, "%s is the build that the night measured, and no older one", file))) {
        free(file);
        file = NULL;
    }
    return file;
}
