/* What the fuzz targets share. A target is a file with one function, LLVMFuzzerTestOneInput, which hands the bytes to one
 * reader of files and ends the process where a rule is broken: a refusal is one line that may be shown, and what loads
 * is within what the reader's header states, is finished, and where it can be written is the same when it is read
 * again. libFuzzer calls it (./dev fuzz), and so does replay.c in every build. One thread. */
#ifndef AOB_TESTS_FUZZ_FUZZ_H
#define AOB_TESTS_FUZZ_FUZZ_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size); /* always 0 */

/* A path in a folder of this process, which is removed when it ends; free() it. */
char *fuzz_path(const char *name);

/* Puts the bytes into that file, without or with a seal (base/sealed.h) behind them, and returns its path; free() it. */
char *fuzz_file(const char *name, const void *bytes, size_t size);
char *fuzz_sealed_file(const char *name, const void *bytes, size_t size);

/* Ends the process with a line unless the rule is kept. */
void fuzz_require(bool kept, const char *rule);

/* A reader that refused: its error must be one line of UTF-8 that may be shown, and name the file. */
void fuzz_require_line(const struct aob_error *error, const char *path);

/* A reader's answer: what loaded is counted, of what was refused the line is required. Returns `ok`. */
bool fuzz_answer(bool ok, const struct aob_error *error, const char *path);
size_t fuzz_count_loaded(void);
#endif
