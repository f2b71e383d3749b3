/* Files: whole reads, writes that appear whole or not at all, folders, and where this program lies. */
#ifndef AOB_BASE_FILE_H
#define AOB_BASE_FILE_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

/* Returns the file's bytes with a NUL behind them; free() them. A file of more than `limit` bytes is an error. */
char *aob_file_read(const char *path, size_t limit, size_t *size, struct aob_error *error);

/* Writes a file beside `path`, flushes it to disk and renames it (part.h), so a reader sees the old file or the new
 * one. A link stays a link. What is no regular file (a device, a pipe) is written into and not replaced. */
bool aob_file_write(const char *path, const void *bytes, size_t size, struct aob_error *error);

struct aob_piece { /* a stretch of bytes; borrowed */
    const void *bytes;
    size_t size;
};
bool aob_file_write_pieces(const char *path, const struct aob_piece *pieces, size_t count,
                           struct aob_error *error); /* one after the other */

/* The same of many files: none waits for the disk, which each does for some milliseconds. aob_folder_flush then waits for all of them; a loss
 * of power before that may leave a file of any length. What is no regular file is refused. */
bool aob_file_write_pieces_unflushed(const char *path, const struct aob_piece *pieces, size_t count,
                                     struct aob_error *error);

/* Writes all of it to an open file, however many calls that takes. False with errno, of which nothing else tells. */
bool aob_file_send(int file, const void *bytes, size_t size);

/* Checks that `path` can be written, so that a long job fails at its start and not at its end. It leaves nothing
 * behind. */
bool aob_file_check(const char *path, struct aob_error *error);

/* Returns the path that a finished file for `path` is renamed to, with links followed; free() it. NULL after a line
 * if that is no regular file. */
char *aob_file_target(const char *path, struct aob_error *error);

/* Writes the line of a file that its reader could not make sense of, or died of: what to do, and in brackets the
 * reader's own words, which may be those of a library. Always false. */
bool aob_file_fail(const char *path, const char *words, struct aob_error *error);

bool aob_file_exists(const char *path);

/* Whether a path names something that is no regular file: a folder, a pipe, a device. */
bool aob_file_is_special(const char *path);
size_t aob_file_size(const char *path); /* bytes; 0 if there is none */

bool aob_folder_exists(const char *path); /* false of what is no folder, too */

/* Creates a folder and its parents. The folder may exist already; it must be writable. */
bool aob_folder_create(const char *path, struct aob_error *error);

/* Waits until all that was written to the file system of this folder is on disk. */
bool aob_folder_flush(const char *path, struct aob_error *error);

/* Returns "folder/name"; free() it. */
char *aob_path_join(const char *folder, const char *name);

/* Returns the path that `path` means in a text of `file`: relative ones are seen from the file's folder; free() it. */
char *aob_path_beside(const char *file, const char *path);

/* Returns the path from the root, seen from the working folder; free() it. Nothing in it is resolved, so a text that
 * names it holds `path` as well. */
char *aob_path_absolute(const char *path);

/* The folder of the running program, without a trailing slash; free() it. */
char *aob_path_program_folder(void);

/* The file of the running program; free() it. */
char *aob_path_program(void);
#endif
