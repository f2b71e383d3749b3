/* The data of a PLY file, held to what its header says of them. */
#ifndef AOB_SCENE_PLY_BODY_H
#define AOB_SCENE_PLY_BODY_H
#include <stdbool.h>
#include "base/error.h"

/* assimp takes what it finds: a text that is cut off loses its last faces without a word, a line that lacks a number
 * shifts those behind it, a face without corners ends the process, and a wrong count asks for all memory. So this goes
 * through the file before assimp does. False after one line unless every element is there with all of its numbers (a
 * text: on a line of its own), every face has a corner, and names vertices that there are. `path` is a PLY file whose
 * header has an end. What cannot be read, and a header without vertices and faces, is left to the importer. */
bool aob_ply_body_check(const char *path, struct aob_error *error);
#endif
