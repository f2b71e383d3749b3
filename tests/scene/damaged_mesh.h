/* Mesh files of several formats, to be damaged: some are written here, some packaged. */
#ifndef AOB_TESTS_SCENE_DAMAGED_MESH_H
#define AOB_TESTS_SCENE_DAMAGED_MESH_H
#include "damaged.h"

/* Damages `files` meshes in all, the same in every run, and adds up what became of them. */
void damaged_meshes(int files, struct damaged_counts *counts);
#endif
