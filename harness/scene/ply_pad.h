/* assimp 5.2.5 takes a line end that follows the header of a binary PLY file for a part of it, though it may be the first
 * byte of the data (as of -0.01 as a float), and then misreads the rest (its issue 5341). It takes one only. */
#ifndef AOB_SCENE_PLY_PAD_H
#define AOB_SCENE_PLY_PAD_H
#include <stddef.h>

/* A copy of such a file with a line end to lose; free() it. NULL where the file is no such PLY, or cannot be read. */
char *aob_ply_pad(const char *path, size_t *size);
#endif
