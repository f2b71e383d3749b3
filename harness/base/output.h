/* Standard output. All that the program says there passes here, so that a failure to write is never missed, and no
 * control character of an input reaches a terminal. */
#ifndef AOB_BASE_OUTPUT_H
#define AOB_BASE_OUTPUT_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

/* Writes a text of lines or a JSON document, shown as aob_text_add_shown does, and flushes it. False: "standard output:
 * cannot write: CAUSE". */
bool aob_output_write(const char *text, size_t size, struct aob_error *error);

/* Closes it, at the end of the program: some file systems refuse only then what they took before. It is no error if
 * nothing was written and it was never open. */
bool aob_output_close(struct aob_error *error);
#endif
