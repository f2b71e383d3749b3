#include "shelf.h"
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "file.h"
#include "memory.h"
#include "text.h"

static const char ending[] = ".yaml";

static bool ends_in_yaml(const char *name)
{
    size_t size = strlen(name), end = sizeof ending - 1;
    return size > end && strcmp(name + size - end, ending) == 0;
}

/* Seen from the program's folder. */
static char *place(const char *folder, const char *shelf)
{
    char *program = aob_path_program_folder(), *all = aob_path_join(program, folder),
         *path = aob_path_join(all, shelf);
    free(program);
    free(all);
    return path;
}

char *aob_shelf_folder(const char *shelf)
{
    char *path = place("../share/aobudget", shelf);
    if (aob_file_exists(path))
        return path;
    free(path);
    return place("../../configs", shelf);
}

bool aob_shelf_is_path(const char *text)
{
    return strchr(text, '/') || ends_in_yaml(text);
}

char *aob_shelf_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    char *name = aob_strdup(slash ? slash + 1 : path), *dot = strrchr(name, '.');
    if (dot && dot != name)
        *dot = '\0';
    return name;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

bool aob_shelf_list(const char *shelf, struct aob_shelf_names *names, struct aob_error *error)
{
    *names = (struct aob_shelf_names){0};
    char *path = aob_shelf_folder(shelf);
    DIR *folder = opendir(path);
    if (!folder)
        aob_fail(error, "%s: cannot open: %s; the %s lie beside the program", path, strerror(errno), shelf);
    for (struct dirent *entry; folder && (entry = readdir(folder));)
        if (ends_in_yaml(entry->d_name))
            *AOB_PUSH(names->items, names->count, names->capacity) = aob_shelf_name(entry->d_name);
    if (names->count)
        qsort(names->items, names->count, sizeof *names->items, compare_names);
    bool ok = folder != NULL;
    if (folder)
        closedir(folder);
    free(path);
    return ok;
}

void aob_shelf_names_finish(struct aob_shelf_names *names)
{
    for (size_t i = 0; i < names->count; i++)
        free(names->items[i]);
    free(names->items);
    *names = (struct aob_shelf_names){0};
}

static void fail_unknown(const char *shelf, const char *noun, const char *name, struct aob_error *error)
{
    struct aob_shelf_names names;
    struct aob_text known = {0};
    bool listed = aob_shelf_list(shelf, &names, error);
    for (size_t i = 0; i < names.count; i++)
        aob_text_add(&known, "%s%s", i ? ", " : "", names.items[i]);
    if (listed)
        aob_fail(error, "there is no %s '%s': choose one of %s, or the path of a file (./%s.yaml)", noun,
                 name, known.data ? known.data : "none", name);
    aob_text_finish(&known);
    aob_shelf_names_finish(&names);
}

char *aob_shelf_find(const char *shelf, const char *noun, const char *text, struct aob_error *error)
{
    if (aob_shelf_is_path(text))
        return aob_strdup(text);
    struct aob_text name = {0};
    aob_text_add(&name, "%s%s", text, ending);
    char *folder = aob_shelf_folder(shelf), *file = aob_path_join(folder, name.data);
    if (!aob_file_exists(file)) {
        fail_unknown(shelf, noun, text, error);
        free(file);
        file = NULL;
    }
    aob_text_finish(&name);
    free(folder);
    return file;
}
