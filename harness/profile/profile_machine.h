/* For profile_read.c: this machine's processor as a profile, of a software driver that runs on it. */
#ifndef AOB_PROFILE_PROFILE_MACHINE_H
#define AOB_PROFILE_PROFILE_MACHINE_H
#include "profile.h"

#define AOB_PROFILE_SYSFS "/sys/devices/system/cpu/cpu0/cache"

/* Reads the data caches of a processor from a folder as AOB_PROFILE_SYSFS: levels with their facts, the first cold at each
 * pass. A cache that shares its lines with other processors becomes one for as many units. False with a line if the folder
 * does not tell, as in some virtual machines, or if what it tells is no level that can be simulated (profile_level.h). */
bool aob_profile_machine(struct aob_profile *profile, const char *folder, struct aob_error *error);

/* First caches of data that so many processors have together: processors by those that share one, at least 1. */
int aob_profile_machine_units(const char *folder, int processors);

/* Adds a fact; the texts are copied. */
void aob_profile_note(struct aob_profile *profile, const char *key, const char *value, const char *source,
                      bool confirmed);
#endif
