/* Readers of mesh files that owe nothing to the program's: small strict ones of OBJ, PLY and STL, and assimp for
 * glTF. */
#ifndef AOB_TESTS_SCENE_SECOND_READER_H
#define AOB_TESTS_SCENE_SECOND_READER_H
#include <stdbool.h>
#include "mesh_sums.h"

/* False where the reader does not understand the file, or finds anything in it that is not plainly right. */
bool second_reader(const char *file, struct mesh_sums *sums);
#endif
