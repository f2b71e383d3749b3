#include "scene_folder.h"
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "scene.h"

const struct aob_known_scene aob_known_scenes[] = {
    {"sponza-crytek",
     "Atrium of the Sponza palace, 279,163 triangles; plants and chains are solid quads here",
     "McGuire Computer Graphics Archive, https://casual-effects.com/data", "CC BY 3.0, Frank Meinl, Crytek"},
    {"sterngarten", "Park with bushes, railings and steps, 71,673 triangles; leaves are solid quads here",
     "Debian package stellarium-data, a 3D scenery", "CC BY-SA 4.0, Georg Zotti"},
    {NULL, NULL, NULL, NULL},
};

static int is_mesh(const struct dirent *entry)
{
    static const char *const endings[] = {".3ds", ".dae", ".fbx", ".glb", ".gltf",
                                          ".obj", ".off", ".ply", ".stl"};
    const char *dot = strrchr(entry->d_name, '.');
    if (!dot || dot == entry->d_name)
        return false;
    for (size_t i = 0; i < AOB_COUNT(endings); i++)
        if (strcasecmp(dot, endings[i]) == 0)
            return true;
    return false;
}

/* Compares bytes, because the order must not depend on the user's locale. */
static int compare_entries(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

static void add_file(struct aob_scene_folder *folder, const char *path, const char *file)
{
    char *name = aob_strdup(file);
    *strrchr(name, '.') = '\0';
    if (aob_scene_find(name) || aob_scene_folder_find(folder, name)) {
        free(name);
        return;
    }
    struct aob_scene_file *entry = AOB_PUSH(folder->files, folder->count, folder->capacity);
    entry->name = name;
    entry->path = aob_path_join(path, file);
}

bool aob_scene_folder_read(struct aob_scene_folder *folder, struct aob_error *error)
{
    const char *path = getenv("AOBUDGET_SCENES");
    struct dirent **entries = NULL;
    *folder = (struct aob_scene_folder){0};
    if (!path || !*path)
        return true;
    int count = scandir(path, &entries, is_mesh, compare_entries);
    if (count < 0)
        return aob_fail(error, "AOBUDGET_SCENES: cannot read the folder %s: %s", path, strerror(errno));
    for (int i = 0; i < count; i++) {
        add_file(folder, path, entries[i]->d_name);
        free(entries[i]);
    }
    free(entries);
    return true;
}

void aob_scene_folder_finish(struct aob_scene_folder *folder)
{
    for (size_t i = 0; i < folder->count; i++) {
        free(folder->files[i].name);
        free(folder->files[i].path);
    }
    free(folder->files);
    *folder = (struct aob_scene_folder){0};
}

const char *aob_scene_folder_find(const struct aob_scene_folder *folder, const char *name)
{
    for (size_t i = 0; i < folder->count; i++)
        if (strcmp(folder->files[i].name, name) == 0)
            return folder->files[i].path;
    return NULL;
}
