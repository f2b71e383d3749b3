#include "subject.h"
#include <stdio.h>
#include <stdlib.h>
#include "base/file.h"
#include "base/member.h"
#include "config/config.h"

static bool add_file(struct aob_hash *hash, const char *path, struct aob_error *error)
{
    char digest[AOB_KEY_SIZE];
    bool ok = aob_hash_file(path, digest, error);
    if (ok)
        aob_hash_add(hash, digest, sizeof digest);
    return ok;
}

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

static bool read_config(struct aob_subject *subject, const struct aob_nightly_desc *desc,
                        struct aob_error *error)
{
    struct aob_config config = {0};
    bool ok =
        aob_config_read(&config, desc->config, error) && hash_modules(desc, &config, subject->modules, error);
    if (ok) {
        snprintf(subject->name, sizeof subject->name, "%s", config.name);
        snprintf(subject->config_hash, sizeof subject->config_hash, "%s", config.hash);
        subject->date = time(NULL);
    }
    aob_config_finish(&config);
    return ok;
}

/* A run of an older program may have another form of date, or none: then the night is of now. */
static time_t date_of(const json_t *info)
{
    struct tm tm = {0};
    const char *end = strptime(aob_member_text(info, "date"), "%Y-%m-%dT%H:%M:%SZ", &tm);
    return end && !*end ? timegm(&tm) : time(NULL);
}

static bool read_run(struct aob_subject *subject, const char *run, struct aob_error *error)
{
    json_error_t json;
    char *path = aob_path_join(run, "run.json");
    json_t *info = json_load_file(path, 0, &json);
    if (info) {
        snprintf(subject->name, sizeof subject->name, "%s", aob_member_text(info, "name"));
        snprintf(subject->config_hash, sizeof subject->config_hash, "%s",
                 aob_member_text(info, "config_hash"));
        aob_hash_text(aob_member_text(info, "build"), subject->modules);
        subject->date = date_of(info);
    } else
        aob_fail(error, "%s: %s; is it the folder of a run?", path, json.text);
    bool ok = info && (*subject->name || aob_fail(error, "%s: it has no name", path));
    json_decref(info);
    free(path);
    return ok;
}

bool aob_subject_read(struct aob_subject *subject, const struct aob_nightly_desc *desc, bool measured,
                      struct aob_error *error)
{
    return measured ? read_run(subject, desc->config, error) : read_config(subject, desc, error);
}
