/* Files: whole reads, writes that appear whole or not at all, folders, and where this program lies. */
#ifndef AOB_BASE_FILE_H
#define AOB_BASE_FILE_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

/* The file's bytes with a NUL behind them; free() them. At most `limit` bytes, else an error. */
char *aob_file_read(const char *path, size_t limit, size_t *size, struct aob_error *error);

/* Write beside `path`, flush to disk, rename: a reader sees the old file or the new one. A link stays a link, and
 * what is no file at all (a device, a pipe) is written into, not replaced. */
bool aob_file_write(const char *path, const void *bytes, size_t size, struct aob_error *error);

/* The whole of one file into another, as aob_file_write writes it. */
bool aob_file_copy(const char *from, const char *to, struct aob_error *error);

/* Whether that could be written now, for those who would be long at work before they write it. Leaves nothing behind. */
bool aob_file_check(const char *path, struct aob_error *error);

/* Where a whole file for `path` may be renamed to: links followed; NULL after a line if that is no regular file.
 * free() it. */
char *aob_file_target(const char *path, struct aob_error *error);

bool aob_file_exists(const char *path);
size_t aob_file_size(const char *path); /* bytes; 0 if there is none */

/* A folder with its parents. An existing folder is fine; it must be writable. */
bool aob_folder_create(const char *path, struct aob_error *error);

/* "a/b": allocated; free() it. */
char *aob_path_join(const char *folder, const char *name);

/* The folder of the running program, without a trailing slash; free() it. */
char *aob_path_program_folder(void);

/* The file of the running program; free() it. */
char *aob_path_program(void);

/* $AOBUDGET_CACHE, else $XDG_CACHE_HOME/aobudget, else $HOME/.cache/aobudget, else /tmp/aobudget-UID; free()
 * it. */
char *aob_path_cache_folder(void);
#endif
