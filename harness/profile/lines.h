/* A stream of line numbers from a file, through one cache: what `aobudget cache --lines` does. */
#ifndef AOB_PROFILE_LINES_H
#define AOB_PROFILE_LINES_H
#include "base/error.h"
#include "result.h"

struct aob_lines_desc {
    const char *path; /* of 32-bit numbers, little-endian, any of them; an empty file is a stream of none */
    uint32_t sets, ways;
    enum aob_index index;
};
bool aob_lines_simulate(const struct aob_lines_desc *desc, struct aob_misses *misses,
                        struct aob_error *error);
#endif
