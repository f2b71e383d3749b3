#include "journal.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/json.h"
#include "base/json_keep.h"
#include "base/memory.h"

/* A journal while it is read. */
struct reading {
    json_t *records, *by_key; /* by_key: the key's place in the records */
    const char *const *paths; /* of the members that are kept; NULL: all are */
    size_t lines, damaged, first_damaged;
    struct aob_journal_lines *kept; /* the bytes of the records; NULL: nobody wants them */
    char *scratch;                  /* where a line is cut that has to stay whole; as long as the file */
};

/* A case that was tried again has several lines. The last one counts, in the place of the first, so that the order
 * stays. */
static size_t keep_last(struct reading *reading, const char *key, json_t *record)
{
    json_t *place = json_object_get(reading->by_key, key);
    size_t at = place ? (size_t)json_integer_value(place) : json_array_size(reading->records);
    if (place) {
        json_array_set(reading->records, at, record);
        return at;
    }
    json_object_set_new(reading->by_key, key, json_integer((json_int_t)at));
    json_array_append(reading->records, record);
    return at;
}

static void keep_line(struct aob_journal_lines *lines, size_t at, const char *text, size_t size)
{
    if (at >= lines->capacity)
        lines->items = aob_grow(lines->items, at, &lines->capacity, sizeof *lines->items);
    lines->items[at] = (struct aob_piece){text, size};
}

static bool take_record(struct reading *reading, char *text, size_t size)
{
    char *cut = reading->kept ? reading->scratch : text;
    size_t cut_size = reading->paths ? aob_json_keep(text, size, reading->paths, cut) : size;
    json_t *record = json_loadb(reading->paths ? cut : text, cut_size, JSON_REJECT_DUPLICATES, NULL);
    const char *key = json_string_value(json_object_get(record, "key"));
    size_t at = key ? keep_last(reading, key, record) : 0;
    if (key && reading->kept)
        keep_line(reading->kept, at, text, size);
    json_decref(record);
    return key != NULL;
}

/* Zeros part records as a line break does, but they do not belong there. */
static void take_line(struct reading *reading, char *line, size_t size)
{
    bool whole = !memchr(line, '\0', size);
    for (char *part = line, *end = line + size; part < end;) {
        size_t length = strnlen(part, (size_t)(end - part));
        whole = (!length || take_record(reading, part, length)) && whole;
        part += length + 1;
    }
    reading->lines++;
    if (!whole && !reading->damaged++)
        reading->first_damaged = reading->lines;
}

static void tell(const struct reading *reading, const char *path, struct aob_error *damage)
{
    if (reading->damaged == 1)
        aob_fail(damage, "%s: line %zu of %zu is damaged and passed over", path, reading->first_damaged,
                 reading->lines);
    else if (reading->damaged)
        aob_fail(damage, "%s: %zu of %zu lines are damaged and passed over, the first of them line %zu", path,
                 reading->damaged, reading->lines, reading->first_damaged);
}

json_t *aob_journal_read(const char *path, struct aob_error *damage, struct aob_error *error)
{
    return aob_journal_read_only(path, NULL, damage, error);
}

json_t *aob_journal_read_only(const char *path, const char *const *paths, struct aob_error *damage,
                              struct aob_error *error)
{
    return aob_journal_read_lines(path, paths, NULL, damage, error);
}

json_t *aob_journal_read_lines(const char *path, const char *const *paths, struct aob_journal_lines *lines,
                               struct aob_error *damage, struct aob_error *error)
{
    size_t size = 0;
    char *text = aob_file_exists(path) ? aob_file_read(path, (size_t)1 << 32, &size, error) : aob_strdup("");
    if (!text)
        return NULL;
    struct reading reading = {
        .records = json_array(), .by_key = json_object(), .paths = paths, .kept = lines};
    reading.scratch = lines ? aob_alloc(size + 1, 1) : NULL;
    char *end = text + size;
    for (char *line = text, *newline; (newline = memchr(line, '\n', (size_t)(end - line)));
         line = newline + 1)
        take_line(&reading, line, (size_t)(newline - line));
    free(reading.scratch);
    if (lines)
        lines->text = text;
    else
        free(text);
    json_decref(reading.by_key);
    tell(&reading, path, damage);
    return reading.records;
}

void aob_journal_lines_finish(struct aob_journal_lines *lines)
{
    free(lines->text);
    free(lines->items);
    *lines = (struct aob_journal_lines){0};
}

/* Cuts what a killed run left of its last line, which lies behind the last newline. */
static bool cut_torn_line(struct aob_journal *journal)
{
    off_t whole = lseek(journal->file, 0, SEEK_END);
    char byte;
    journal->size = whole;
    while (journal->size > 0 && pread(journal->file, &byte, 1, journal->size - 1) == 1 && byte != '\n')
        journal->size--;
    return journal->size == whole || /* a whole journal keeps its time: a page may be as new */
           ftruncate(journal->file, journal->size) == 0;
}

bool aob_journal_open(struct aob_journal *journal, const char *path, struct aob_error *error)
{
    *journal = (struct aob_journal){.file = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)};
    if (journal->file < 0)
        return aob_fail(error, "%s: cannot open: %s", path, strerror(errno));
    if (flock(journal->file, LOCK_EX | LOCK_NB) != 0) {
        close(journal->file);
        return aob_fail(error, "%s: another run is writing here; wait for it or choose another --out", path);
    }
    if (!cut_torn_line(journal)) {
        close(journal->file);
        return aob_fail(error, "%s: cannot write: %s", path, strerror(errno));
    }
    journal->path = aob_strdup(path);
    return true;
}

bool aob_journal_hold(struct aob_journal *journal, const char *path, struct aob_error *error)
{
    *journal = (struct aob_journal){.file = open(path, O_RDONLY | O_CLOEXEC)};
    if (journal->file < 0)
        return aob_fail(error, "%s: cannot open: %s", path, strerror(errno));
    if (flock(journal->file, LOCK_SH | LOCK_NB) != 0) {
        int cause = errno;
        close(journal->file);
        return cause == EWOULDBLOCK ? aob_fail(error, "%s: a run is writing here; wait for it", path)
                                    : aob_fail(error, "%s: cannot lock: %s", path, strerror(cause));
    }
    journal->path = aob_strdup(path);
    return true;
}

bool aob_journal_check(const struct aob_journal *journal, struct aob_error *error)
{
    struct stat own, named;
    if (fstat(journal->file, &own) != 0)
        return aob_fail(error, "%s: cannot look at it: %s", journal->path, strerror(errno));
    if (!own.st_nlink)
        return aob_fail(error,
                        "%s: it was deleted or replaced during the run, and its cases with it: run again",
                        journal->path);
    if (stat(journal->path, &named) != 0 || named.st_dev != own.st_dev || named.st_ino != own.st_ino)
        return aob_fail(error, "%s: it or its folder was moved during the run: put it back and run again",
                        journal->path);
    return own.st_size >= journal->size ||
           aob_fail(error, "%s: somebody cut it from %lld to %lld bytes during the run: run again",
                    journal->path, (long long)journal->size, (long long)own.st_size);
}

/* What was written of a line that does not fit is taken back, so that the next line begins one. */
static bool write_line(struct aob_journal *journal, const char *line, size_t size, struct aob_error *error)
{
    off_t before = lseek(journal->file, 0, SEEK_END);
    if (before >= 0 && aob_file_send(journal->file, line, size) && fsync(journal->file) == 0) {
        journal->size = before + (off_t)size;
        return true;
    }
    aob_fail(error, "%s: cannot write: %s", journal->path, strerror(errno));
    if (before >= 0 && ftruncate(journal->file, before) != 0)
        aob_warn("%s: the next start will cut off what was written of the last line", journal->path);
    return false;
}

bool aob_journal_append(struct aob_journal *journal, const json_t *record, struct aob_error *error)
{
    if (!aob_journal_check(journal, error))
        return false;
    char *line = aob_json_line(record, 9);
    size_t size = strlen(line);
    line[size] = '\n';
    bool ok = write_line(journal, line, size + 1, error);
    free(line);
    return ok;
}

bool aob_journal_clear(struct aob_journal *journal, struct aob_error *error)
{
    if (ftruncate(journal->file, 0) != 0 || fsync(journal->file) != 0)
        return aob_fail(error, "%s: cannot empty the journal: %s", journal->path, strerror(errno));
    journal->size = 0;
    return true;
}

void aob_journal_close(struct aob_journal *journal)
{
    if (journal->path)
        close(journal->file);
    free(journal->path);
    *journal = (struct aob_journal){0};
}
