/* The header of a PLY file, and what assimp 5.2.5 gets wrong about it. */
#ifndef AOB_SCENE_PLY_HEAD_H
#define AOB_SCENE_PLY_HEAD_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

/* False after one line if the file is PLY, by its ending or its first line, and its header has no end, where assimp
 * reads on for ever, or gives its vertices no x, y or z, which assimp takes for 0, or if its data are not what its header
 * says (ply_body.h). */
bool aob_ply_check(const char *path, struct aob_error *error);

/* assimp drops a line end that follows the header of a binary file, though it may be the first byte of the data (the
 * float -0.01 begins with one), and then misreads the rest (its issue 5341). It drops one only, so a copy with one more
 * is read right. Returns such a copy of such a file; free() it. NULL if the file is no such PLY, or cannot be read. */
char *aob_ply_pad(const char *path, size_t *size);
#endif
