#include "map_list.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

enum { MOST_BYTES = 16 << 20 };

static char *list_path(const char *folder)
{
    return aob_path_join(folder, "maps/files.txt");
}

/* A name of the folder's own only, whatever somebody wrote there. */
static void remove_files(const char *folder, const char *name)
{
    static const char *const endings[] = {".exr", ".png", ".vti", ".svg"};
    if (strncmp(name, "maps/", 5) != 0 || strchr(name + 5, '/'))
        return;
    for (size_t i = 0; i < AOB_COUNT(endings); i++) {
        struct aob_text file = {0};
        aob_text_add(&file, "%s/%s%s", folder, name, endings[i]);
        unlink(file.data);
        aob_text_finish(&file);
    }
}

void aob_map_list_discard(const char *folder)
{
    char *path = list_path(folder), *names = aob_file_read(path, MOST_BYTES, NULL, NULL), *rest = names;
    for (char *name; (name = strsep(&rest, "\n"));)
        remove_files(folder, name);
    if (names)
        unlink(path);
    free(names);
    free(path);
}

bool aob_map_list_add(const char *folder, const char *name, struct aob_error *error)
{
    char *maps = aob_path_join(folder, "maps"), *path = list_path(folder);
    bool ok = aob_folder_create(maps, error);
    FILE *file = ok ? fopen(path, "ae") : NULL;
    if (ok && (!file || fprintf(file, "%s\n", name) < 0 || fflush(file) != 0))
        ok = aob_fail(error, "%s: cannot be written: %s", path, strerror(errno));
    if (file)
        fclose(file);
    free(path);
    free(maps);
    return ok;
}
