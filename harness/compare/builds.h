/* For compare.c: the measuring of two builds of a module. */
#ifndef AOB_COMPARE_BUILDS_H
#define AOB_COMPARE_BUILDS_H
#include "compare.h"

/* Whether the two files are the same, byte for byte. False with a line if one cannot be read. */
bool aob_builds_identical(const struct aob_compare_desc *desc, bool *identical, struct aob_error *error);

/* The module file of a stored run (sides[0]) that has a technique of the new module (sides[1]), for measuring it again; free()
 * it. NULL after a line if the run has none of a module, or its file is not there any more or is another build now. */
char *aob_builds_stored(const struct aob_compare_desc *desc, struct aob_error *error);

/* Runs every case of the config with both modules, in the same blocks, anew into the folder. False with a line if nothing
 * could be measured: the modules have no technique in common, or every case failed. */
bool aob_builds_measure(const struct aob_compare_desc *desc, const char *folder, struct aob_error *error);
#endif
