#include "files.h"
#include <stdlib.h>
#include <string.h>
#include "base/hash.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "base/table.h"
#include "base/text.h"
#include "named.h"

/* A file of one name, as one of the sources has it. */
struct origin {
    const struct aob_merge_source *source;
    char seal[AOB_SEAL_SIZE + 1]; /* the same where the bytes are the same; empty: there is none */
    const char *becomes;          /* its name in the merged folder; NULL: it was not copied */
    bool spare; /* of a record that agrees with one that stands: taken where no other is whole */
};
struct file {
    char *name; /* below a run's folder */
    struct origin *origins;
    size_t count, capacity;
};
struct copying {
    struct aob_merge_files *files;
    const struct aob_merge_union *all;
    const char *out;
    struct file *items;
    size_t count, capacity;
    struct aob_table places, met; /* of a name; of a folder with a name */
    char **names;                 /* of what is kept apart */
    size_t name_count, name_capacity;
};

static void meet(struct copying *copying, const struct aob_merge_source *source, const char *name, bool spare)
{
    char *text = aob_path_join(source->path, name);
    size_t next = copying->met.count;
    bool is_new = aob_table_put(&copying->met, text, next) == next;
    free(text);
    if (!is_new)
        return;
    size_t at = aob_table_put(&copying->places, name, copying->count);
    if (at == copying->count)
        AOB_PUSH(copying->items, copying->count, copying->capacity)->name = aob_strdup(name);
    struct file *file = &copying->items[at];
    *AOB_PUSH(file->origins, file->count, file->capacity) = (struct origin){.source = source, .spare = spare};
}

static void gather(struct copying *copying)
{
    for (size_t i = 0; i < copying->all->count; i++) {
        const struct aob_merge_case *c = &copying->all->cases[i];
        json_t *names = c->source ? aob_merge_named(c->line) : NULL, *name;
        size_t at;
        json_array_foreach(names, at, name)
        {
            meet(copying, c->source, json_string_value(name), false);
        }
        json_decref(names);
    }
}

/* What else such a record names, as its own raw rounds, no record names that stands. */
static void gather_spare(struct copying *copying)
{
    for (size_t i = 0; i < copying->all->other_count; i++) {
        const struct aob_merge_other *other = &copying->all->others[i];
        json_t *wanted = other->differs ? NULL : aob_merge_named(copying->all->cases[other->at].line),
               *names = other->differs ? NULL : aob_merge_named(other->line), *name;
        size_t at;
        json_array_foreach(names, at, name)
        {
            if (aob_merge_named_has(wanted, name))
                meet(copying, other->source, json_string_value(name), true);
        }
        json_decref(wanted);
        json_decref(names);
    }
}

/* The folder that was given first comes first; all sources lie in one array. Spare ones come last. */
static int compare_origins(const void *a, const void *b)
{
    const struct origin *first = a, *second = b;
    if (first->spare != second->spare)
        return first->spare - second->spare;
    return (first->source > second->source) - (first->source < second->source);
}

/* A graph's name is a digest of the passes, and it has no seal. */
static void take_seal(struct origin *origin, const char *path, bool graph)
{
    if (graph && !aob_hash_file(path, origin->seal, NULL))
        *origin->seal = '\0';
    if (!graph && !aob_sealed_peek(path, origin->seal))
        *origin->seal = '\0';
}

static bool copy_plain(const char *from, const char *to, struct aob_error *error)
{
    size_t size;
    char *bytes = aob_file_read(from, (size_t)1 << 30, &size, error);
    bool ok = bytes && aob_file_write_pieces_unflushed(to, &(struct aob_piece){bytes, size}, 1, error);
    free(bytes);
    return ok;
}

/* Whether the fault was in what was read. */
static bool is_bad(const char *path, bool graph)
{
    return graph ? !aob_file_exists(path) : aob_sealed_judge(path, NULL) != AOB_SEALED_GOOD;
}

/* True also where the file is bad, with the line in `reason`. */
static bool copy_one(struct copying *copying, struct origin *origin, const char *name, const char *becomes,
                     struct aob_error *reason, struct aob_error *error)
{
    char *from = aob_path_join(origin->source->path, name), *to = aob_path_join(copying->out, becomes);
    bool graph = aob_merge_named_is_graph(name), ok = true;
    struct aob_error failed = {{0}};
    if ((graph ? copy_plain : aob_sealed_copy_unflushed)(from, to, &failed)) {
        origin->becomes = becomes;
        copying->files->copied++;
    } else if (is_bad(from, graph)) {
        if (!*reason->text)
            *reason = failed;
    } else {
        ok = aob_fail(error, "%s", failed.text);
    }
    free(from);
    free(to);
    return ok;
}

/* A name that is as long and as much a run's own, made of what it was and of the bytes; borrowed. NULL: it has no such form. */
static const char *name_apart(struct copying *copying, const struct file *file, const struct origin *origin)
{
    const char *base = strchr(file->name, '/') + 1;
    char hash[AOB_KEY_SIZE];
    struct aob_text text = {0};
    if (strspn(base, "0123456789abcdef") != AOB_KEY_SIZE - 1)
        return NULL;
    aob_text_add(&text, "%s %s", file->name, origin->seal);
    aob_hash_text(text.data, hash);
    aob_text_finish(&text);
    char *name = aob_strdup(file->name);
    memcpy(name + (base - file->name), hash, AOB_KEY_SIZE - 1);
    *AOB_PUSH(copying->names, copying->name_count, copying->name_capacity) = name;
    return name;
}

static const struct origin *find_twin(const struct file *file, const struct origin *origin)
{
    for (const struct origin *other = file->origins; other < origin; other++)
        if (other->becomes && strcmp(other->seal, origin->seal) == 0)
            return other;
    return NULL;
}

static const struct origin *find_copied(const struct file *file)
{
    for (size_t i = 0; i < file->count; i++)
        if (file->origins[i].becomes)
            return &file->origins[i];
    return NULL;
}

/* The second and later ones of other bytes. A graph keeps its name, which its records have in short. */
static bool copy_apart(struct copying *copying, struct file *file, struct origin *origin,
                       struct aob_error *reason, struct aob_error *error)
{
    const struct origin *first = find_copied(file);
    const char *name = aob_merge_named_is_graph(file->name) ? NULL : name_apart(copying, file, origin);
    if (name && !copy_one(copying, origin, file->name, name, reason, error))
        return false;
    if (name && !origin->becomes)
        return true;
    json_array_append_new(copying->files->apart,
                          json_pack("{s:s, s:[s, s], s:s?}", "file", file->name, "folders",
                                    first->source->path, origin->source->path, "becomes", name));
    return true;
}

static void lose(struct copying *copying, const struct file *file, const struct aob_error *reason)
{
    json_array_append_new(copying->files->lost,
                          json_pack("{s:s, s:s, s:s}", "file", file->name, "folder",
                                    file->origins[0].source->path, "reason", reason->text));
}

static bool copy_file(struct copying *copying, struct file *file, struct aob_error *error)
{
    struct aob_error reason = {{0}};
    if (!aob_merge_named_is_safe(file->name)) {
        aob_fail(&reason, "%s: a record names '%s', which is no file of a run", file->origins[0].source->path,
                 file->name);
        lose(copying, file, &reason);
        return true;
    }
    bool graph = aob_merge_named_is_graph(file->name), ok = true;
    qsort(file->origins, file->count, sizeof *file->origins, compare_origins);
    for (size_t i = 0; i < file->count && ok; i++) {
        struct origin *origin = &file->origins[i];
        if (origin->spare && find_copied(file))
            break;
        char *path = aob_path_join(origin->source->path, file->name);
        take_seal(origin, path, graph);
        free(path);
        const struct origin *twin = find_twin(file, origin);
        if (twin)
            origin->becomes = twin->becomes;
        else if (find_copied(file) && *origin->seal)
            ok = copy_apart(copying, file, origin, &reason, error);
        else if (!find_copied(file))
            ok = copy_one(copying, origin, file->name, file->name, &reason, error);
    }
    if (ok && !find_copied(file))
        lose(copying, file, &reason);
    return ok;
}

/* The lines of records whose files have another name now. */
static void change_lines(const struct copying *copying)
{
    for (size_t i = 0; i < copying->all->count && copying->name_count; i++) {
        const struct aob_merge_case *c = &copying->all->cases[i];
        json_t *names = c->source ? aob_merge_named(c->line) : NULL, *name;
        size_t at, place;
        json_array_foreach(names, at, name)
        {
            aob_table_find(&copying->places, json_string_value(name), &place);
            const struct file *file = &copying->items[place];
            for (size_t k = 0; k < file->count; k++)
                if (file->origins[k].source == c->source && file->origins[k].becomes &&
                    file->origins[k].becomes != file->name)
                    aob_merge_named_change(c->line, file->name, file->origins[k].becomes);
        }
        json_decref(names);
    }
}

static void finish(struct copying *copying)
{
    for (size_t i = 0; i < copying->count; i++) {
        free(copying->items[i].name);
        free(copying->items[i].origins);
    }
    for (size_t i = 0; i < copying->name_count; i++)
        free(copying->names[i]);
    free(copying->items);
    free(copying->names);
    aob_table_finish(&copying->places);
    aob_table_finish(&copying->met);
}

bool aob_merge_files_copy(struct aob_merge_files *files, const struct aob_merge_union *all, const char *out,
                          struct aob_error *error)
{
    struct copying copying = {.files = files, .all = all, .out = out};
    char *graphs = aob_path_join(out, "graphs");
    *files = (struct aob_merge_files){.lost = json_array(), .apart = json_array()};
    gather(&copying);
    gather_spare(&copying);
    bool ok = aob_folder_create(graphs, error);
    for (size_t i = 0; i < copying.count && ok; i++)
        ok = copy_file(&copying, &copying.items[i], error);
    change_lines(&copying);
    finish(&copying);
    free(graphs);
    return ok;
}

void aob_merge_files_finish(struct aob_merge_files *files)
{
    json_decref(files->lost);
    json_decref(files->apart);
    *files = (struct aob_merge_files){0};
}
