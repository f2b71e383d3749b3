#include "hash.h"
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <xxhash.h>

static void write_key(XXH128_hash_t hash, char key[AOB_KEY_SIZE])
{
    snprintf(key, AOB_KEY_SIZE, "%016llx%016llx", (unsigned long long)hash.high64,
             (unsigned long long)hash.low64);
}

void aob_hash_bytes(const void *bytes, size_t size, char key[AOB_KEY_SIZE])
{
    write_key(XXH3_128bits(bytes, size), key);
}

void aob_hash_text(const char *text, char key[AOB_KEY_SIZE])
{
    aob_hash_bytes(text, strlen(text), key);
}

void aob_hash_begin(struct aob_hash *hash)
{
    hash->state = XXH3_createState();
    XXH3_128bits_reset(hash->state);
}

void aob_hash_add(struct aob_hash *hash, const void *bytes, size_t size)
{
    if (size)
        XXH3_128bits_update(hash->state, bytes, size);
}

void aob_hash_end(struct aob_hash *hash, char key[AOB_KEY_SIZE])
{
    write_key(XXH3_128bits_digest(hash->state), key);
    XXH3_freeState(hash->state);
    hash->state = NULL;
}

bool aob_hash_file(const char *path, char key[AOB_KEY_SIZE], struct aob_error *error)
{
    struct stat info; /* before it is opened: a pipe would wait for its writer, a device would never end */
    if (stat(path, &info) != 0)
        return aob_fail(error, "%s: cannot open: %s", path, strerror(errno));
    if (!S_ISREG(info.st_mode))
        return aob_fail(error, "%s: cannot read: is it a file?", path);
    FILE *file = fopen(path, "rb");
    if (!file)
        return aob_fail(error, "%s: cannot open: %s", path, strerror(errno));
    struct aob_hash hash;
    aob_hash_begin(&hash);
    char block[65536];
    size_t got;
    while ((got = fread(block, 1, sizeof block, file)) > 0)
        aob_hash_add(&hash, block, got);
    bool ok = !ferror(file);
    fclose(file);
    aob_hash_end(&hash, key);
    return ok || aob_fail(error, "%s: cannot read: is it a file?", path);
}
