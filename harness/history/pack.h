/* Bytes that a history keeps compressed (zstd), and their way back. */
#ifndef AOB_HISTORY_PACK_H
#define AOB_HISTORY_PACK_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

/* free() what it returns; *size becomes that of the packed bytes. NULL after a line that begins with `what`. */
char *aob_pack(const char *what, const void *bytes, size_t *size, struct aob_error *error);

/* `whole`: how many bytes it were. NULL after a line that begins with `what` where they are not these. */
char *aob_unpack(const char *what, const void *packed, size_t size, size_t whole, struct aob_error *error);
#endif
