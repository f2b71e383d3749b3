/* Journals of a run. */
#include "store/journal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "fuzz.h"

/* A real is written with nine digits. */
static bool same_value(const json_t *a, const json_t *b)
{
    if (!json_is_real(a) || !json_is_real(b))
        return false;
    double x = json_real_value(a), y = json_real_value(b);
    return fabs(x - y) <= 0.5001e-8 * fabs(x) + 0x1p-1074;
}

static bool same(json_t *a, json_t *b)
{
    json_t *member;
    const char *name;
    size_t i;
    if (json_typeof(a) != json_typeof(b))
        return false;
    if (json_is_array(a)) {
        json_array_foreach(a, i, member) if (!same(member, json_array_get(b, i))) return false;
        return json_array_size(a) == json_array_size(b);
    }
    if (!json_is_object(a))
        return json_equal(a, b) || same_value(a, b);
    json_object_foreach(a, name, member) if (!same(member, json_object_get(b, name))) return false;
    return json_object_size(a) == json_object_size(b);
}

static const char *key_of(const json_t *record)
{
    return json_string_value(json_object_get(record, "key"));
}

static void check_keys(const json_t *records)
{
    json_t *seen = json_object(), *record;
    size_t i;
    json_array_foreach(records, i, record)
    {
        fuzz_require(key_of(record) != NULL, "a record has a key");
        fuzz_require(json_object_set_new(seen, key_of(record), json_true()) == 0, "a key is a text");
    }
    fuzz_require(json_object_size(seen) == json_array_size(records), "a key has one record");
    json_decref(seen);
}

static json_t *read_whole(const char *path)
{
    struct aob_error damage = {{0}}, error = {{0}};
    json_t *records = aob_journal_read(path, &damage, &error);
    fuzz_require(records && !*damage.text, "what was written is read without damage");
    return records;
}

static void append(const char *path, json_t *records)
{
    struct aob_journal journal;
    struct aob_error error = {{0}};
    json_t *record;
    size_t i;
    fuzz_require(aob_journal_open(&journal, path, &error), "a journal can be opened");
    json_array_foreach(records, i, record)
        fuzz_require(aob_journal_append(&journal, record, &error), "a record can be written");
    aob_journal_close(&journal);
}

/* Records that are written are read again, with reals of nine digits; written once more they do not change. */
static void check_again(json_t *records)
{
    char *path = fuzz_file("again", "", 0);
    append(path, records);
    json_t *second = read_whole(path);
    fuzz_require(same(records, second), "a journal that is read again is the same");
    free(fuzz_file("again", "", 0));
    append(path, second);
    json_t *third = read_whole(path);
    fuzz_require(json_equal(second, third), "a journal that was read is written as it is");
    json_decref(second);
    json_decref(third);
    free(path);
}

/* The rests of the paths that go on below a member; true if one ends with it. */
static bool lead_below(const char *const *paths, const char *name, const char **below)
{
    size_t count = 0, size = strlen(name);
    bool ends = false;
    for (; *paths; paths++) {
        size_t step = strcspn(*paths, ".");
        if (strncmp(*paths, "*", step) != 0 && (step != size || strncmp(*paths, name, size) != 0))
            continue;
        ends |= !(*paths)[step];
        if ((*paths)[step])
            below[count++] = *paths + step + 1;
    }
    below[count] = NULL;
    return ends;
}

/* What the paths leave of a parsed value, as json_keep.h states it of a text. */
static void prune(json_t *value, const char *const *paths)
{
    json_t *member;
    const char *name, *below[4];
    void *next;
    size_t i;
    json_array_foreach(value, i, member) prune(member, paths);
    json_object_foreach_safe(value, next, name, member)
    {
        if (lead_below(paths, name, below))
            continue;
        if (*below)
            prune(member, below);
        else
            json_object_del(value, name);
    }
}

/* No path names a member whose name is written with an escape. */
static bool has_escape(const uint8_t *bytes, size_t size)
{
    return memmem(bytes, size, "\\u", 2) != NULL;
}

/* What is read in part is a part of what is read whole. A fault in what is left out is not seen. */
static void check_part(const char *path, json_t *records, const uint8_t *bytes, size_t size)
{
    static const char *const paths[] = {"key", "a.*.b", "e.c", NULL};
    struct aob_error damage = {{0}}, error = {{0}};
    json_t *part = aob_journal_read_only(path, paths, &damage, &error), *copy = json_deep_copy(records);
    size_t i;
    json_t *record;
    fuzz_require(part && !*damage.text, "a part of what is whole is whole");
    check_keys(part);
    json_array_foreach(copy, i, record) prune(record, paths);
    fuzz_require(has_escape(bytes, size) || json_equal(part, copy), "a part is of the whole");
    json_decref(part);
    json_decref(copy);
}

/* What a crash left of the last line is cut off, and the next record stands behind the others or in its place. */
static void check_next(const char *path, json_t *records, bool damaged)
{
    struct aob_error damage = {{0}}, error = {{0}};
    json_t *next = json_pack("[{s:s}]", "key", "next"), *record, *copy = json_copy(records);
    size_t i, at = json_array_size(records);
    append(path, next);
    json_t *after = aob_journal_read(path, &damage, &error);
    json_array_foreach(records, i, record) if (strcmp(key_of(record), "next") == 0) at = i;
    if (at == json_array_size(records))
        json_array_append(copy, json_array_get(next, 0));
    else
        json_array_set(copy, at, json_array_get(next, 0));
    fuzz_require(after && json_equal(after, copy), "a record that is appended is there, and all others");
    fuzz_require(!*damage.text == !damaged, "no line is damaged by the next");
    json_decref(after);
    json_decref(copy);
    json_decref(next);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct aob_error damage = {{0}}, error = {{0}};
    char *path = fuzz_file("input", bytes, size);
    json_t *records = aob_journal_read(path, &damage, &error);
    if (fuzz_answer(records != NULL, &error, path)) {
        if (*damage.text)
            fuzz_require_line(&damage, path);
        else
            check_part(path, records, bytes, size);
        check_keys(records);
        check_again(records);
        check_next(path, records, *damage.text);
        json_decref(records);
    }
    free(path);
    return 0;
}
