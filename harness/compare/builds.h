/* For compare.c: the measuring of two builds of a module. */
#ifndef AOB_COMPARE_BUILDS_H
#define AOB_COMPARE_BUILDS_H
#include "compare.h"
#include "old_module.h"

/* Whether the two files are the same, byte for byte. False with a line if one cannot be read. */
bool aob_builds_identical(const char *a, const char *b, bool *identical, struct aob_error *error);

/* Runs every case of the config with both modules, in the same blocks, anew into the folder. False with a line if nothing
 * could be measured: the modules have no technique in common, or every case failed. */
bool aob_builds_measure(const struct aob_compare_desc *desc, const char *folder, struct aob_error *error);

/* Runs the cases that the stored run has of its old module, as its own config has them, with both builds. False with a line
 * if none of them can be made again or measured; of one that cannot a warning says what is missing. */
bool aob_builds_measure_again(const struct aob_compare_desc *desc, const struct aob_old_module *stored,
                              const char *folder, struct aob_error *error);
#endif
