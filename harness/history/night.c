#include "night.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "base/file.h"
#include "base/memory.h"
#include "database.h"

static struct aob_night take_row(const struct aob_query *query)
{
    return (struct aob_night){.id = aob_query_get_whole(query, 0),
                              .date = aob_query_copy(query, 1),
                              .name = aob_query_copy(query, 2),
                              .config_hash = aob_query_copy(query, 3),
                              .build = aob_query_copy(query, 4),
                              .folder = aob_query_copy(query, 5),
                              .modules = aob_query_copy(query, 6),
                              .whole = aob_query_get_whole(query, 7) != 0,
                              .cases = (size_t)aob_query_get_whole(query, 8),
                              .ok = (size_t)aob_query_get_whole(query, 9),
                              .summary = aob_query_copy(query, 10)};
}

bool aob_nights_read(struct aob_history *history, const char *name, struct aob_nights *nights,
                     struct aob_error *error)
{
    static const char sql[] = "SELECT id, date, name, config_hash, build, folder, modules, whole, cases, ok,"
                              " summary FROM night WHERE ?1 IS NULL OR name = ?1 ORDER BY id";
    struct aob_query query;
    size_t room = 0;
    *nights = (struct aob_nights){0};
    aob_query_begin(&query, history, sql, error);
    aob_query_text(&query, name);
    while (aob_query_step(&query))
        *AOB_PUSH(nights->items, nights->count, room) = take_row(&query);
    if (aob_query_end(&query))
        return true;
    aob_nights_finish(nights);
    return false;
}

void aob_nights_finish(struct aob_nights *nights)
{
    for (size_t i = 0; i < nights->count; i++) {
        struct aob_night *n = &nights->items[i];
        free(n->date);
        free(n->name);
        free(n->config_hash);
        free(n->build);
        free(n->folder);
        free(n->modules);
        free(n->summary);
    }
    free(nights->items);
    *nights = (struct aob_nights){0};
}

static void add_night(struct aob_query *query, const struct aob_night_desc *desc)
{
    char date[32], *folder = aob_path_absolute(desc->folder);
    time_t when = desc->date ? (time_t)desc->date : time(NULL);
    struct tm parts;
    gmtime_r(&when, &parts);
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &parts);
    aob_query_text(query, date);
    aob_query_text(query, desc->name);
    aob_query_text(query, desc->config_hash ? desc->config_hash : "");
    aob_query_text(query, folder);
    aob_query_text(query, desc->modules ? desc->modules : "");
    aob_query_run(query);
    free(folder);
}

int64_t aob_night_begin(struct aob_history *history, const struct aob_night_desc *desc,
                        struct aob_error *error)
{
    struct aob_query query;
    if (!aob_database_begin(history, error))
        return 0;
    aob_query_begin(&query, history,
                    "INSERT INTO night(date, name, config_hash, folder, modules) VALUES(?, ?, ?, ?, ?)",
                    error);
    add_night(&query, desc);
    int64_t id = sqlite3_last_insert_rowid(history->db);
    bool ok = aob_query_end(&query);
    return aob_database_end(history, ok, error) ? id : 0;
}

bool aob_night_end(struct aob_history *history, int64_t night, const char *summary, struct aob_error *error)
{
    struct aob_query query;
    if (!aob_database_begin(history, error))
        return false;
    aob_query_begin(&query, history, "UPDATE night SET whole = 1, summary = ? WHERE id = ?", error);
    aob_query_text(&query, summary ? summary : "");
    aob_query_whole(&query, night);
    aob_query_run(&query);
    bool ok =
        aob_query_end(&query) && (sqlite3_changes(history->db) == 1 ||
                                  aob_fail(error, "%s: has no night %lld", history->path, (long long)night));
    return aob_database_end(history, ok, error);
}
