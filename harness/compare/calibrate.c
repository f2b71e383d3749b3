#include "calibrate.h"
#include <stdlib.h>
#include <stdint.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "config/config.h"
#include "resolution.h"
#include "run/run.h"
#include "store/journal.h"
#include "timing/measure_lock.h"

/* One calibration, from its run to its table. */
struct calibration {
    const struct aob_calibrate_desc *desc;
    const char *folder, *backend, *technique;
    json_t *records; /* of the run's journal: one */
    json_t *timer;   /* of aob_dispatch_timer; NULL: it could not be tested, for this reason: */
    struct aob_error untested;
    struct aob_resolution resolution;
};

/* A scene without sky, small enough for many rounds in a process. */
static char *write_config(const struct calibration *c, struct aob_error *error)
{
    struct aob_text text = {0};
    char *path = aob_path_join(c->folder, "calibrate.yaml");
    aob_text_add(&text,
                 "name: calibrate\nscenes: [{name: atrium}]\nresolutions: [320x180]\nbackends: [\"%s\"]\n"
                 "techniques: [{name: \"%s\"}]\nmeasure: {error: false, images: false}\n",
                 c->backend, c->technique);
    bool ok = aob_folder_create(c->folder, error) && aob_file_write(path, text.data, text.size, error);
    aob_text_finish(&text);
    if (ok)
        return path;
    free(path);
    return NULL;
}

/* No interval is narrow enough to end it early: all of the seconds are wanted. */
static bool measure(struct calibration *c, struct aob_error *error)
{
    const struct aob_calibrate_desc *desc = c->desc;
    char *config = write_config(c, error);
    if (!config)
        return false;
    if (!desc->quiet)
        aob_note("calibrate: timing %s on %s", c->technique, c->backend);
    enum aob_exit code =
        aob_run(&(struct aob_run_desc){.dispatch = desc->dispatch,
                                       .config = config,
                                       .out = c->folder,
                                       .fresh = true,
                                       .quiet = true,
                                       .no_page = true,
                                       .seconds = desc->seconds > 0 ? desc->seconds : AOB_CALIBRATE_SECONDS,
                                       .precision = AOB_CONFIG_MIN_PRECISION},
                error);
    free(config);
    return code == AOB_EXIT_OK;
}

static bool read_rounds(struct calibration *c, struct aob_error *error)
{
    struct aob_round_list rounds = {0};
    struct aob_config usual;
    char *journal = aob_path_join(c->folder, "journal.jsonl");
    c->records = aob_journal_read(journal, NULL, error);
    free(journal);
    const json_t *time = json_object_get(json_array_get(c->records, 0), "time");
    const char *name = json_string_value(json_object_get(time, "rounds_file"));
    if (!name)
        return aob_fail(error, "%s: the run kept no rounds", c->folder);
    char *path = aob_path_join(c->folder, name);
    bool ok = aob_rounds_read(path, &rounds, error);
    free(path);
    if (!ok)
        return false;
    aob_config_init(&usual);
    c->resolution = aob_resolution_of(&rounds, usual.seconds);
    aob_config_finish(&usual);
    aob_rounds_finish(&rounds);
    return true;
}

/* The test measures too, so nobody else may meanwhile. */
static bool test_timer(struct calibration *c, struct aob_error *error)
{
    struct aob_measure_lock lock = {0};
    if (!aob_measure_lock_take(&lock, error))
        return false;
    c->timer = aob_dispatch_timer(&c->desc->dispatch, c->backend, &c->untested);
    aob_measure_lock_release(&lock);
    return true;
}

static const json_t *fingerprint(const struct calibration *c)
{
    return json_object_get(json_array_get(c->records, 0), "fingerprint");
}

static void print_timer(const struct calibration *c, struct aob_text *out)
{
    const json_t *check;
    size_t at;
    if (!c->timer)
        aob_text_add_line(out, "device clock: not tested: %s", c->untested.text);
    else if (json_is_true(json_object_get(c->timer, "trusted")))
        aob_text_add_line(out, "device clock: it passes its test");
    else
        aob_text_add_line(out, "device clock: it fails its test: %s",
                          json_string_value(json_object_get(c->timer, "why_not")));
    json_array_foreach(json_object_get(c->timer, "checks"), at, check)
    {
        aob_text_add_line(out, "  %-44s %8.3f, expected %.3g (%.3g .. %.3g)",
                          json_string_value(json_object_get(check, "what")),
                          aob_json_to_number(json_object_get(check, "measured")),
                          json_number_value(json_object_get(check, "expected")),
                          json_number_value(json_object_get(check, "low")),
                          json_number_value(json_object_get(check, "high")));
    }
}

static void print(const struct calibration *c, struct aob_text *out)
{
    const json_t *f = fingerprint(c);
    const json_t *time = json_object_get(json_array_get(c->records, 0), "time");
    aob_text_add_line(
        out, "%s: %s, %s; %s, %d cores; clock %s", c->backend,
        json_string_value(json_object_get(f, "device")), json_string_value(json_object_get(f, "driver")),
        json_string_value(json_object_get(f, "cpu")), (int)json_integer_value(json_object_get(f, "cores")),
        json_string_value(json_object_get(time, "clock")));
    print_timer(c, out);
    aob_resolution_print(&c->resolution, out);
}

static bool write_out(const struct calibration *c, struct aob_text *out, struct aob_error *error)
{
    print(c, out);
    if (!c->desc->json)
        return true;
    json_t *document = aob_resolution_to_json(&c->resolution);
    json_object_set_new(document, "backend", json_string(c->backend));
    json_object_set_new(document, "technique", json_string(c->technique));
    json_object_set(document, "fingerprint", (json_t *)(uintptr_t)fingerprint(c));
    json_object_set(document, "timer", c->timer ? c->timer : json_null());
    bool ok = aob_json_write(document, c->desc->json, error);
    json_decref(document);
    return ok;
}

enum aob_exit aob_calibrate(const struct aob_calibrate_desc *desc, struct aob_text *out,
                            struct aob_error *error)
{
    struct calibration c = {.desc = desc,
                            .folder = desc->folder ? desc->folder : "results/calibrate",
                            .backend = desc->backend ? desc->backend : "vulkan",
                            .technique = desc->technique ? desc->technique : "gtao"};
    bool ok = aob_json_check(desc->json, error) && measure(&c, error) && read_rounds(&c, error) &&
              test_timer(&c, error) && write_out(&c, out, error);
    json_decref(c.records);
    json_decref(c.timer);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
