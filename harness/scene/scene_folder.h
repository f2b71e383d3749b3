/* Meshes that have names without being listed: the user's own, in the folder $AOBUDGET_SCENES; and public ones that
 * many papers use, of which only the source is known here. */
#ifndef AOB_SCENE_SCENE_FOLDER_H
#define AOB_SCENE_SCENE_FOLDER_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_scene_file {
    char *name, *path; /* "hall", "/home/me/scenes/hall.ply" */
};
struct aob_scene_folder {
    struct aob_scene_file *files; /* sorted by file name: hall.obj comes before hall.ply, and has the name */
    size_t count, capacity;
};

/* Finds the files in $AOBUDGET_SCENES that end like a mesh (.3ds .dae .fbx .glb .gltf .obj .off .ply .stl, in either
 * case) and whose name neither a listed scene nor an earlier file has. There are none if the variable is unset or
 * empty. False after a line if it names no readable folder. */
bool aob_scene_folder_read(struct aob_scene_folder *folder, struct aob_error *error);
void aob_scene_folder_finish(struct aob_scene_folder *folder);

const char *aob_scene_folder_find(const struct aob_scene_folder *folder,
                                  const char *name); /* path, or NULL */

struct aob_known_scene {
    const char *name, *title, *source, *licence;
};
extern const struct aob_known_scene aob_known_scenes[]; /* ends with a NULL name */
#endif
