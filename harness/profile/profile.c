#include "profile.h"
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

static const char ending[] = ".yaml";

static bool ends_in_yaml(const char *name)
{
    size_t size = strlen(name), end = sizeof ending - 1;
    return size > end && strcmp(name + size - end, ending) == 0;
}

void aob_profile_fact_finish(struct aob_profile_fact *fact)
{
    free(fact->key);
    free(fact->value);
    free(fact->source);
}

void aob_profile_finish(struct aob_profile *profile)
{
    for (size_t i = 0; i < profile->fact_count; i++)
        aob_profile_fact_finish(&profile->facts[i]);
    free(profile->name);
    free(profile->path);
    free(profile->title);
    *profile = (struct aob_profile){0};
}

/* Installed they lie in share/, in the tree in configs/. */
static char *find_folder(void)
{
    char *program = aob_path_program_folder();
    char *folder = aob_path_join(program, "../share/aobudget/profiles");
    if (!aob_file_exists(folder)) {
        free(folder);
        folder = aob_path_join(program, "../../configs/profiles");
    }
    free(program);
    return folder;
}

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

bool aob_profile_names(struct aob_profile_names *names, struct aob_error *error)
{
    *names = (struct aob_profile_names){0};
    char *path = find_folder();
    DIR *folder = opendir(path);
    if (!folder)
        aob_fail(error, "%s: cannot open: %s; the profiles lie beside the program", path, strerror(errno));
    for (struct dirent *entry; folder && (entry = readdir(folder));)
        if (ends_in_yaml(entry->d_name)) {
            char *name = aob_strdup(entry->d_name);
            name[strlen(name) - strlen(ending)] = '\0';
            *AOB_PUSH(names->items, names->count, names->capacity) = name;
        }
    if (names->count)
        qsort(names->items, names->count, sizeof *names->items, compare_names);
    bool ok = folder != NULL;
    if (folder)
        closedir(folder);
    free(path);
    return ok;
}

void aob_profile_names_finish(struct aob_profile_names *names)
{
    for (size_t i = 0; i < names->count; i++)
        free(names->items[i]);
    free(names->items);
    *names = (struct aob_profile_names){0};
}

static bool fail_unknown(const char *name, struct aob_error *error)
{
    struct aob_profile_names names;
    struct aob_text known = {0};
    bool listed = aob_profile_names(&names, error);
    for (size_t i = 0; i < names.count; i++)
        aob_text_add(&known, "%s%s", i ? ", " : "", names.items[i]);
    if (listed)
        aob_fail(error, "there is no profile '%s': choose one of %s, or the path of a file (./%s.yaml)", name,
                 known.data ? known.data : "none", name);
    aob_text_finish(&known);
    aob_profile_names_finish(&names);
    return false;
}

bool aob_profile_is_file(const char *name)
{
    return strchr(name, '/') || ends_in_yaml(name);
}

bool aob_profile_find(struct aob_profile *profile, const char *name, struct aob_error *error)
{
    if (aob_profile_is_file(name))
        return aob_profile_read(profile, name, error);
    char *folder = find_folder(), *file = NULL;
    struct aob_text text = {0};
    aob_text_add(&text, "%s%s", name, ending);
    file = aob_path_join(folder, text.data);
    bool ok = aob_file_exists(file) ? aob_profile_read(profile, file, error) : fail_unknown(name, error);
    aob_text_finish(&text);
    free(file);
    free(folder);
    return ok;
}

const char *aob_layout_name(enum aob_layout layout)
{
    static const char *const names[AOB_LAYOUT_COUNT] = {"linear", "morton", "block_linear"};
    return names[layout];
}
