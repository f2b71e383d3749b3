/* The cache: what can be made again from what its name stands for, and takes long to make. Meshes, captures, G-buffers
 * and traced visibilities lie in one folder of the user's as sealed files (base/sealed.h). Several programs may share it
 * at a time: a file appears whole, and a wrong one is replaced, never removed, because by now another program may have
 * made it good. */
#ifndef AOB_STORE_CACHE_H
#define AOB_STORE_CACHE_H
#include <stdbool.h>
#include "base/error.h"

struct aob_cache {
    char *folder;
};

/* The folder is $AOBUDGET_CACHE, else $XDG_CACHE_HOME/aobudget, else $HOME/.cache/aobudget, else /tmp/aobudget-UID. It
 * is created with mode 0700 if it is not there. It is refused with a line unless it is a folder and no link, belongs to
 * the effective user, and only that user can write in it: what another may have put there decides figures. Parts of
 * writers that are gone are removed. aob_cache_close frees. */
bool aob_cache_open(struct aob_cache *cache, struct aob_error *error);
void aob_cache_close(struct aob_cache *cache); /* of a zeroed one too */

/* Creates the folder of an open cache again if it was removed meanwhile, and judges it again as above. Called before
 * files are looked for or made. */
bool aob_cache_keep(const struct aob_cache *cache, struct aob_error *error);

/* The path of the file "KIND-HASH" with this suffix, whose hash is made of `what` and of the seal's version; free()
 * it. */
char *aob_cache_path(const struct aob_cache *cache, const char *kind, const char *what, const char *suffix);

/* Whether the file is there to be used. A wrong one is not, and a warning says so. False after a line if it cannot be
 * read: that says nothing of its content, so nobody may put another in its place. */
bool aob_cache_has(const char *path, bool *has, struct aob_error *error);
#endif
