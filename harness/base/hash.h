/* Content keys: XXH3, 128 bits, as 32 lower-case hexadecimal digits. */
#ifndef AOB_BASE_HASH_H
#define AOB_BASE_HASH_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

enum { AOB_KEY_SIZE = 33 }; /* with the NUL */

void aob_hash_bytes(const void *bytes, size_t size, char key[AOB_KEY_SIZE]);
void aob_hash_text(const char *text, char key[AOB_KEY_SIZE]);

/* Hashes a file's bytes, which it reads as a stream. */
bool aob_hash_file(const char *path, char key[AOB_KEY_SIZE], struct aob_error *error);

/* The same in pieces. aob_hash_end gives the key and frees. */
struct aob_hash {
    void *state;
};
void aob_hash_begin(struct aob_hash *hash);
void aob_hash_add(struct aob_hash *hash, const void *bytes, size_t size);
void aob_hash_end(struct aob_hash *hash, char key[AOB_KEY_SIZE]);
#endif
