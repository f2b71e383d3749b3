/* assimp 5.2.5 drops a line end that follows the header of a binary PLY file, though it may be the first byte of the
 * data (the float -0.01 begins with one), and then misreads the rest (its issue 5341). It drops one only, so a copy
 * with one more is read right. */
#ifndef AOB_SCENE_PLY_PAD_H
#define AOB_SCENE_PLY_PAD_H
#include <stddef.h>

/* Returns a copy of such a file with one more line end; free() it. NULL if the file is no such PLY, or cannot be
 * read. */
char *aob_ply_pad(const char *path, size_t *size);
#endif
