/* Sealed files: what this program writes and trusts when it reads it again. Behind a file's bytes stands a digest of
 * them and of the file's name (without its folder), so a changed byte anywhere, a lost end, and another file under this
 * name are noticed before any byte is used. Formats with a table of places, as OpenEXR, do not see the seal. It shows
 * damage, not malice: whoever may write a file may seal it. */
#ifndef AOB_BASE_SEALED_H
#define AOB_BASE_SEALED_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"
#include "file.h"

enum aob_sealed {
    AOB_SEALED_GOOD,
    AOB_SEALED_NONE,  /* there is no such file */
    AOB_SEALED_WRONG, /* the content is not what was written under this name */
    AOB_SEALED_SHUT,  /* it cannot be read, which says nothing of its content */
};
enum { AOB_SEAL_SIZE = 40 };            /* bytes behind those of the file */
extern const char aob_sealed_version[]; /* a part of the names in the cache */

/* Reads the whole file as a stream and says what it is. The error has a line unless it is good. */
enum aob_sealed aob_sealed_judge(const char *path, struct aob_error *error);

/* Returns the bytes of a good file without the seal; free() them. NULL after a line if it is anything else. */
char *aob_sealed_read(const char *path, size_t *size, struct aob_error *error);

/* Writes the pieces one after the other, and the seal, as aob_file_write writes. What is no regular file is refused. */
bool aob_sealed_write(const char *path, const struct aob_piece *pieces, size_t count,
                      struct aob_error *error);

/* Copies a good file, and seals it under its new name. */
bool aob_sealed_copy(const char *from, const char *to, struct aob_error *error);

/* The same as aob_file_write_pieces_unflushed writes: for many files, which aob_folder_flush flushes. */
bool aob_sealed_copy_unflushed(const char *from, const char *to, struct aob_error *error);

/* The seal that stands at the end of a file, as it is there, which is not looked at: two files of one name have the same seal
 * where they have the same bytes. False where no file ends with a seal. */
bool aob_sealed_peek(const char *path, char seal[AOB_SEAL_SIZE + 1]);
#endif
