#include "sealed.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "hash.h"
#include "memory.h"

const char aob_sealed_version[] = "aobseal1";
enum {
    MARK = sizeof aob_sealed_version - 1,
    DIGEST = AOB_KEY_SIZE - 1,
    SEAL = MARK + DIGEST,
    BLOCK = 1 << 16
};
_Static_assert((int)SEAL == (int)AOB_SEAL_SIZE, "a reader of another format skips this many bytes");

static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Takes the bytes' hash and makes the seal of it. */
static void make_seal(struct aob_hash *hash, const char *path, char seal[SEAL + 1])
{
    aob_hash_add(hash, name_of(path), strlen(name_of(path)));
    memcpy(seal, aob_sealed_version, MARK);
    aob_hash_end(hash, seal + MARK);
}

/* A sealed file while it is read. */
struct reader {
    const char *path;
    int file;
    size_t size; /* without the seal */
    struct aob_error *error;
};

static enum aob_sealed fail_access(const struct reader *r)
{
    int cause = errno;
    aob_fail(r->error, "%s: cannot read: %s", r->path, strerror(cause));
    return cause == ENOENT ? AOB_SEALED_NONE : AOB_SEALED_SHUT;
}

static enum aob_sealed fail_unsealed(const struct reader *r)
{
    aob_fail(r->error,
             "%s: it does not end with this program's seal: it was cut, or an older version wrote it",
             r->path);
    return AOB_SEALED_WRONG;
}

static enum aob_sealed fail_damaged(const struct reader *r)
{
    aob_fail(r->error, "%s: it is damaged: its content is not what was written under this name", r->path);
    return AOB_SEALED_WRONG;
}

/* A pipe must not be waited for. */
static enum aob_sealed open_file(struct reader *r)
{
    struct stat info;
    r->file = open(r->path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (r->file < 0 || fstat(r->file, &info) != 0)
        return fail_access(r);
    if (!S_ISREG(info.st_mode)) {
        aob_fail(r->error, "%s: cannot read: it is no regular file", r->path);
        return AOB_SEALED_SHUT;
    }
    if (info.st_size < SEAL)
        return fail_unsealed(r);
    r->size = (size_t)info.st_size - SEAL;
    return AOB_SEALED_GOOD;
}

/* The next `size` bytes. A file that ends before has been cut since it was opened. */
static enum aob_sealed read_bytes(const struct reader *r, char *into, size_t size)
{
    while (size) {
        ssize_t got = read(r->file, into, size);
        if (got == 0)
            return fail_unsealed(r);
        if (got < 0 && errno != EINTR)
            return fail_access(r);
        into += got > 0 ? got : 0;
        size -= got > 0 ? (size_t)got : 0;
    }
    return AOB_SEALED_GOOD;
}

/* `into`: where the bytes are kept; NULL: nowhere. */
static enum aob_sealed check(const struct reader *r, char *into)
{
    char block[BLOCK], seal[SEAL + 1], found[SEAL];
    struct aob_hash hash;
    enum aob_sealed state = AOB_SEALED_GOOD;
    aob_hash_begin(&hash);
    for (size_t done = 0; done < r->size && state == AOB_SEALED_GOOD;) {
        size_t count = r->size - done < BLOCK ? r->size - done : BLOCK;
        char *at = into ? into + done : block;
        state = read_bytes(r, at, count);
        aob_hash_add(&hash, at, state == AOB_SEALED_GOOD ? count : 0);
        done += count;
    }
    make_seal(&hash, r->path, seal);
    if (state == AOB_SEALED_GOOD)
        state = read_bytes(r, found, SEAL);
    if (state != AOB_SEALED_GOOD)
        return state;
    if (memcmp(found, aob_sealed_version, MARK) != 0)
        return fail_unsealed(r);
    return memcmp(found, seal, SEAL) == 0 ? AOB_SEALED_GOOD : fail_damaged(r);
}

static void close_file(struct reader *r)
{
    if (r->file >= 0)
        close(r->file);
}

enum aob_sealed aob_sealed_judge(const char *path, struct aob_error *error)
{
    struct reader r = {.path = path, .error = error};
    enum aob_sealed state = open_file(&r);
    if (state == AOB_SEALED_GOOD)
        state = check(&r, NULL);
    close_file(&r);
    return state;
}

char *aob_sealed_read(const char *path, size_t *size, struct aob_error *error)
{
    struct reader r = {.path = path, .error = error};
    char *bytes = NULL;
    if (open_file(&r) == AOB_SEALED_GOOD) {
        bytes = aob_alloc(r.size + 1, 1);
        *size = r.size;
        if (check(&r, bytes) != AOB_SEALED_GOOD) {
            free(bytes);
            bytes = NULL;
        }
    }
    close_file(&r);
    return bytes;
}

/* How the bytes get into the file. */
typedef bool writer_function(const char *path, const struct aob_piece *pieces, size_t count,
                             struct aob_error *error);

static bool write_with(writer_function *writer, const char *path, const struct aob_piece *pieces,
                       size_t count, struct aob_error *error)
{
    char seal[SEAL + 1], *target = aob_file_target(path, error);
    if (!target)
        return false;
    struct aob_piece *all = AOB_NEW_ARRAY(struct aob_piece, count + 1);
    struct aob_hash hash;
    aob_hash_begin(&hash);
    for (size_t i = 0; i < count; i++) {
        all[i] = pieces[i];
        aob_hash_add(&hash, pieces[i].bytes, pieces[i].size);
    }
    make_seal(&hash, path, seal);
    all[count] = (struct aob_piece){seal, SEAL};
    bool ok = writer(path, all, count + 1, error);
    free(all);
    free(target);
    return ok;
}

bool aob_sealed_write(const char *path, const struct aob_piece *pieces, size_t count, struct aob_error *error)
{
    return write_with(aob_file_write_pieces, path, pieces, count, error);
}

static bool copy_with(writer_function *writer, const char *from, const char *to, struct aob_error *error)
{
    size_t size;
    char *bytes = aob_sealed_read(from, &size, error);
    bool ok = bytes && write_with(writer, to, &(struct aob_piece){bytes, size}, 1, error);
    free(bytes);
    return ok;
}

bool aob_sealed_copy(const char *from, const char *to, struct aob_error *error)
{
    return copy_with(aob_file_write_pieces, from, to, error);
}

bool aob_sealed_copy_unflushed(const char *from, const char *to, struct aob_error *error)
{
    return copy_with(aob_file_write_pieces_unflushed, from, to, error);
}

bool aob_sealed_peek(const char *path, char seal[AOB_SEAL_SIZE + 1])
{
    struct reader r = {.path = path};
    bool ok = open_file(&r) == AOB_SEALED_GOOD && pread(r.file, seal, SEAL, (off_t)r.size) == SEAL &&
              memcmp(seal, aob_sealed_version, MARK) == 0;
    seal[ok ? SEAL : 0] = '\0';
    close_file(&r);
    return ok;
}
