#include "start.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/member.h"
#include "base/memory.h"
#include "config/config.h"

/* What a night is of. */
struct subject {
    char name[256], config_hash[AOB_KEY_SIZE], modules[AOB_KEY_SIZE];
};

static bool add_file(struct aob_hash *hash, const char *path, struct aob_error *error)
{
    char digest[AOB_KEY_SIZE];
    bool ok = aob_hash_file(path, digest, error);
    if (ok)
        aob_hash_add(hash, digest, sizeof digest);
    return ok;
}

/* Program and modules: a night that was stopped is gone on with only by the same ones. */
static bool hash_modules(const struct aob_nightly_desc *desc, const struct aob_config *config, char *digest,
                         struct aob_error *error)
{
    struct aob_hash hash;
    aob_hash_begin(&hash);
    bool ok = add_file(&hash, desc->dispatch.program, error);
    for (size_t i = 0; ok && i < desc->dispatch.modules.count; i++)
        ok = add_file(&hash, desc->dispatch.modules.paths[i], error);
    for (size_t i = 0; ok && i < config->technique_count; i++)
        ok = !config->techniques[i].file || add_file(&hash, config->techniques[i].file, error);
    aob_hash_end(&hash, digest);
    return ok;
}

static bool subject_of_config(const struct aob_nightly_desc *desc, struct subject *subject,
                              struct aob_error *error)
{
    struct aob_config config = {0};
    bool ok =
        aob_config_read(&config, desc->config, error) && hash_modules(desc, &config, subject->modules, error);
    if (ok) {
        snprintf(subject->name, sizeof subject->name, "%s", config.name);
        snprintf(subject->config_hash, sizeof subject->config_hash, "%s", config.hash);
    }
    aob_config_finish(&config);
    return ok;
}

static bool subject_of_run(const char *run, struct subject *subject, struct aob_error *error)
{
    json_error_t json;
    char *path = aob_path_join(run, "run.json");
    json_t *info = json_load_file(path, 0, &json);
    if (info) {
        snprintf(subject->name, sizeof subject->name, "%s", aob_member_text(info, "name"));
        snprintf(subject->config_hash, sizeof subject->config_hash, "%s",
                 aob_member_text(info, "config_hash"));
        aob_hash_text(aob_member_text(info, "build"), subject->modules);
    } else
        aob_fail(error, "%s: %s; is it the folder of a run?", path, json.text);
    bool ok = info && (*subject->name || aob_fail(error, "%s: it has no name", path));
    json_decref(info);
    free(path);
    return ok;
}

static bool is_folder(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* OUT/2026-11-30, and OUT/2026-11-30-2 for a second one of that day. */
static char *new_folder(const char *out, const char *date)
{
    for (int i = 1;; i++) {
        struct aob_text name = {0};
        aob_text_add(&name, i > 1 ? "%.10s-%d" : "%.10s", date, i);
        char *path = aob_path_join(out, name.data);
        aob_text_finish(&name);
        if (!aob_file_exists(path))
            return path;
        free(path);
    }
}

static void print_date(time_t at, char date[32])
{
    struct tm tm;
    gmtime_r(&at, &tm);
    strftime(date, 32, "%Y-%m-%dT%H:%M:%SZ", &tm);
}

/* What was measured of a night that nobody goes on with stays known. */
static bool end_stopped(struct aob_history *history, const struct aob_night *night, struct aob_error *error)
{
    struct aob_error cause = {{0}};
    aob_warn("the night of %s was stopped, and this one is of another config, program or module: it ends "
             "with what it has",
             night->date);
    if (is_folder(night->folder) && !aob_night_take(history, night->id, NULL, &cause))
        aob_warn("%s", cause.text);
    return aob_night_end(history, night->id, "{\"line\": \"stopped\"}", error);
}

static bool is_same(const struct aob_night *night, const struct subject *subject)
{
    return strcmp(night->config_hash, subject->config_hash) == 0 &&
           strcmp(night->modules, subject->modules) == 0 && is_folder(night->folder);
}

/* Of a run that was made elsewhere the night is that of its folder. */
static bool find_stopped(struct aob_history *history, const struct subject *subject,
                         struct aob_night_start *start, struct aob_error *error)
{
    struct aob_nights nights = {0};
    char *run = start->measured ? aob_path_absolute(start->run) : NULL;
    bool ok = aob_nights_read(history, subject->name, &nights, error);
    for (size_t i = 0; ok && i < nights.count; i++) {
        const struct aob_night *night = &nights.items[i];
        bool own = !run || strcmp(run, night->folder) == 0;
        if (run && own && night->whole)
            ok = aob_fail(error, "%s is the night of %s already (%lld in the history)", start->run,
                          night->date, (long long)night->id);
        else if (!night->whole && own && is_same(night, subject)) {
            free(start->run);
            free(start->date);
            *start = (struct aob_night_start){.id = night->id,
                                              .date = aob_strdup(night->date),
                                              .name = start->name,
                                              .run = aob_strdup(night->folder),
                                              .out = start->out,
                                              .measured = start->measured};
        } else if (!night->whole)
            ok = end_stopped(history, night, error);
    }
    aob_nights_finish(&nights);
    free(run);
    return ok;
}

static bool begin(struct aob_history *history, const struct subject *subject, struct aob_night_start *start,
                  struct aob_error *error)
{
    time_t now = time(NULL);
    char date[32];
    print_date(now, date);
    start->date = aob_strdup(date);
    start->run = start->measured ? start->run : new_folder(start->out, date);
    start->id = aob_night_begin(history,
                                &(struct aob_night_desc){.name = subject->name,
                                                         .config_hash = subject->config_hash,
                                                         .folder = start->run,
                                                         .modules = subject->modules,
                                                         .date = now},
                                error);
    return start->id;
}

bool aob_night_start(struct aob_history *history, const struct aob_nightly_desc *desc,
                     struct aob_night_start *start, struct aob_error *error)
{
    struct subject subject = {"", "", ""};
    start->measured = is_folder(desc->config);
    if (!(start->measured ? subject_of_run(desc->config, &subject, error)
                          : subject_of_config(desc, &subject, error)))
        return false;
    char *nights = aob_path_join("results/nightly", subject.name);
    start->name = aob_strdup(subject.name);
    start->out = aob_strdup(desc->out ? desc->out : nights);
    start->run = start->measured ? aob_strdup(desc->config) : NULL;
    free(nights);
    if (!aob_folder_create(start->out, error) || !find_stopped(history, &subject, start, error) ||
        (!start->id && !begin(history, &subject, start, error)))
        return false;
    start->folder = start->measured ? new_folder(start->out, start->date) : aob_strdup(start->run);
    return aob_folder_create(start->folder, error);
}

void aob_night_start_finish(struct aob_night_start *start)
{
    free(start->date);
    free(start->name);
    free(start->run);
    free(start->folder);
    free(start->out);
    *start = (struct aob_night_start){0};
}
