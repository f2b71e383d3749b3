#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/member.h"
#include "base/sealed.h"
#include "pack.h"
#include "take.h"

enum { MODULE_MAX = 256 << 20 }; /* bytes */

/* The file as it lies there, with its seal, so that it is good again under its name. */
static bool add_rounds(struct aob_query *query, const struct aob_taking *taking, const char *path,
                       const char *name, struct aob_error *error)
{
    size_t size;
    char *bytes = aob_file_read(path, (size_t)1 << 30, &size, error);
    if (!bytes)
        return false;
    aob_query_whole(query, taking->night);
    aob_query_text(query, name);
    aob_query_bytes(query, bytes, size);
    aob_query_run(query);
    free(bytes);
    return true;
}

/* A file that is lost or damaged is no reason to lose the night: it is left out, and told of. */
static bool take_file(struct aob_query *query, const struct aob_taking *taking, const char *name,
                      struct aob_error *error)
{
    char *path = aob_path_join(taking->folder, name);
    struct aob_error why = {{0}};
    bool good = aob_sealed_judge(path, &why) == AOB_SEALED_GOOD;
    bool ok = !good || add_rounds(query, taking, path, name, error);
    if (!good)
        aob_warn("%s; the history keeps no raw rounds of it", why.text);
    free(path);
    return ok;
}

bool aob_take_rounds(struct aob_taking *taking, struct aob_error *error)
{
    struct aob_query query;
    json_t *met = json_object(), *record;
    bool ok = true;
    size_t i;
    aob_query_begin(&query, taking->history, "INSERT INTO rounds VALUES(?, ?, ?)", error);
    json_array_foreach(taking->records, i, record)
    {
        const char *name = aob_member_text(json_object_get(record, "time"), "rounds_file");
        if (!*name || json_object_get(met, name))
            continue;
        json_object_set_new(met, name, json_true());
        ok = ok && take_file(&query, taking, name, error);
    }
    json_decref(met);
    return aob_query_end(&query) && ok;
}

/* The module's file where it still is what was measured: a path of a config is seen from the config's folder, one of the
 * command line from the working folder. free() it; NULL: it is neither. */
static char *find_module(const struct aob_taking *taking, const json_t *technique)
{
    const char *module = aob_member_text(technique, "module"),
               *config = aob_member_text(taking->info, "config");
    char *paths[] = {aob_path_beside(config, module), aob_path_absolute(module)}, *found = NULL;
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        char now[AOB_KEY_SIZE];
        if (!found && aob_hash_file(paths[i], now, NULL) &&
            strcmp(now, aob_member_text(technique, "digest")) == 0)
            found = paths[i];
        else
            free(paths[i]);
    }
    return found;
}

static bool keep_module(const struct aob_taking *taking, const json_t *technique, const char *path,
                        struct aob_error *error)
{
    struct aob_query query;
    size_t size, packed_size;
    char *bytes = aob_file_read(path, MODULE_MAX, &size, error);
    char *packed = bytes ? aob_pack(path, bytes, (packed_size = size, &packed_size), error) : NULL;
    free(bytes);
    if (!packed)
        return false;
    aob_query_begin(&query, taking->history, "INSERT INTO module VALUES(?, ?, ?)", error);
    aob_query_text(&query, aob_member_text(technique, "digest"));
    aob_query_whole(&query, (int64_t)size);
    aob_query_bytes(&query, packed, packed_size);
    aob_query_run(&query);
    free(packed);
    return aob_query_end(&query);
}

static bool has_module(const struct aob_taking *taking, const char *digest, bool *has,
                       struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, taking->history, "SELECT 1 FROM module WHERE digest = ?", error);
    aob_query_text(&query, digest);
    *has = aob_query_step(&query);
    return aob_query_end(&query);
}

static bool take_module(const struct aob_taking *taking, const json_t *technique, struct aob_error *error)
{
    bool has, ok = has_module(taking, aob_member_text(technique, "digest"), &has, error);
    char *path = ok && !has ? find_module(taking, technique) : NULL;
    if (path)
        ok = keep_module(taking, technique, path, error);
    else if (ok && !has)
        aob_warn(
            "%s: is not there any more as it was measured; the history keeps no file of this build, so it "
            "cannot be measured again",
            aob_member_text(technique, "module"));
    free(path);
    return ok;
}

static void add_measured(struct aob_query *query, const struct aob_taking *taking, const json_t *technique)
{
    aob_query_whole(query, taking->night);
    aob_query_text(query, aob_member_text(technique, "name"));
    aob_query_text(query, aob_member_text(technique, "module"));
    aob_query_text(query, aob_member_text(technique, "digest"));
    aob_query_run(query);
}

/* A built-in technique has no file: its builds are told apart, and cannot be measured again. */
bool aob_take_modules(struct aob_taking *taking, struct aob_error *error)
{
    struct aob_query query;
    json_t *technique;
    bool ok = true;
    size_t i;
    aob_query_begin(&query, taking->history, "INSERT OR REPLACE INTO measured VALUES(?, ?, ?, ?)", error);
    json_array_foreach(json_object_get(taking->info, "techniques"), i, technique)
    {
        add_measured(&query, taking, technique);
        if (ok && *aob_member_text(technique, "module"))
            ok = take_module(taking, technique, error);
    }
    return aob_query_end(&query) && ok;
}

bool aob_night_module_write(struct aob_history *history, const char *digest, const char *path,
                            struct aob_error *error)
{
    struct aob_query query;
    char *bytes = NULL;
    aob_query_begin(&query, history, "SELECT size, zstd FROM module WHERE digest = ?", error);
    aob_query_text(&query, digest);
    size_t size = 0;
    bool there = aob_query_step(&query);
    if (there) {
        size = (size_t)aob_query_get_whole(&query, 0);
        bytes = aob_unpack(digest, sqlite3_column_blob(query.statement, 1),
                           (size_t)sqlite3_column_bytes(query.statement, 1), size, error);
    }
    bool ok = aob_query_end(&query) &&
              (there || aob_fail(error, "%s: keeps no module of the build %s", history->path, digest)) &&
              bytes && aob_file_write(path, bytes, size, error);
    free(bytes);
    return ok;
}
