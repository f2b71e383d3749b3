/* The first bytes of a file that may be a history, judged before SQLite sees it: what SQLite opens it may change. */
#ifndef AOB_HISTORY_HEADER_H
#define AOB_HISTORY_HEADER_H
#include <stdbool.h>
#include "base/error.h"

enum aob_header {
    AOB_HEADER_BAD,   /* a line says why */
    AOB_HEADER_NONE,  /* there is no such file */
    AOB_HEADER_EMPTY, /* of 0 bytes */
    AOB_HEADER_GOOD,  /* a history of whatever version, as long as its header says */
    AOB_HEADER_SHORT, /* shorter, and the log beside it has every page of what lacks */
};

/* Bad are: what is no regular file or cannot be read, no SQLite file, one of another application, and one that
 * is shorter than its header says while the write-ahead log beside it does not have every page that lacks. */
enum aob_header aob_header_judge(const char *path, struct aob_error *error);

/* Whether the write-ahead log beside a history holds anything: changes that were not worked in yet. */
bool aob_header_has_log(const char *path);
#endif
