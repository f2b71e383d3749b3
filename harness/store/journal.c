#include "journal.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"

/* A case that was tried again has several lines. The last one counts, in the place of the first, so that the order
 * stays. */
static void keep_last(json_t *records, json_t *by_key, json_t *record)
{
    const char *key = json_string_value(json_object_get(record, "key"));
    if (!key) {
        json_decref(record);
        return;
    }
    json_t *place = json_object_get(by_key, key);
    if (place)
        json_array_set_new(records, (size_t)json_integer_value(place), record);
    else {
        json_object_set_new(by_key, key, json_integer((json_int_t)json_array_size(records)));
        json_array_append_new(records, record);
    }
}

json_t *aob_journal_read(const char *path, struct aob_error *error)
{
    size_t size;
    json_t *records = json_array(), *by_key = json_object();
    char *text = aob_file_exists(path) ? aob_file_read(path, (size_t)1 << 32, &size, error) : aob_strdup("");
    if (!text) {
        json_decref(records);
        json_decref(by_key);
        return NULL;
    }
    for (char *line = text, *end; (end = strchr(line, '\n')); line = end + 1) {
        json_t *record = json_loadb(line, (size_t)(end - line), JSON_REJECT_DUPLICATES, NULL);
        if (record)
            keep_last(records, by_key, record);
    }
    free(text);
    json_decref(by_key);
    return records;
}

/* Cuts what a killed run left of its last line, which lies behind the last newline. */
static bool cut_torn_line(int file)
{
    off_t whole = lseek(file, 0, SEEK_END), size = whole;
    char byte;
    while (size > 0 && pread(file, &byte, 1, size - 1) == 1 && byte != '\n')
        size--;
    return size == whole ||
           ftruncate(file, size) == 0; /* a whole journal keeps its time: a page may be as new */
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
    if (!cut_torn_line(journal->file)) {
        close(journal->file);
        return aob_fail(error, "%s: cannot write: %s", path, strerror(errno));
    }
    journal->path = aob_strdup(path);
    return true;
}

bool aob_journal_append(struct aob_journal *journal, const json_t *record, struct aob_error *error)
{
    char *line = aob_json_line(record, 9);
    size_t size = strlen(line);
    line[size] = '\n';
    ssize_t written = write(journal->file, line, size + 1);
    free(line);
    if (written != (ssize_t)size + 1 || fsync(journal->file) != 0)
        return aob_fail(error, "%s: cannot write: %s", journal->path, strerror(errno));
    return true;
}

void aob_journal_close(struct aob_journal *journal)
{
    if (journal->path)
        close(journal->file);
    free(journal->path);
    *journal = (struct aob_journal){0};
}
