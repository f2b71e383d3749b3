/* The flags of the commands that time two builds beside each other, compare and nightly: --precision and --seconds. */
#ifndef AOB_COMMAND_BESIDE_H
#define AOB_COMMAND_BESIDE_H
#include <stdbool.h>
#include "base/error.h"

/* Reads "2%" as a share and "6" as seconds above 0, up to 1e6. A text that is NULL leaves its value alone. False with a line
 * that names the flag. */
bool aob_beside_read(const char *precision, const char *seconds, double *share, double *value,
                     struct aob_error *error);
#endif
