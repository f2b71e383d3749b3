/* For profile_read.c and profile_machine.c: what a level of a profile must be, wherever it comes from. */
#ifndef AOB_PROFILE_PROFILE_LEVEL_H
#define AOB_PROFILE_PROFILE_LEVEL_H
#include "profile.h"

enum aob_level_part {
    AOB_LEVEL_SIZE,
    AOB_LEVEL_LINE,
    AOB_LEVEL_SECTOR,
    AOB_LEVEL_WAYS,
    AOB_LEVEL_INDEX,
    AOB_LEVEL_PART_COUNT
};

/* Completes the last level of the profile, whose size, line, ways and index are set: the sector where it is 0, and the
 * sets. False with a line if they do not go together, do not follow the level before, or are too large for this machine.
 * The line names neither the file nor the level; *part is what it is about. */
bool aob_profile_judge_level(struct aob_profile *profile, enum aob_level_part *part, struct aob_error *error);
#endif
