#include <jansson.h>
#include "base/file.h"
#include "base/json.h"
#include "base/member.h"
#include "history.h"
#include "history/line.h"
#include "history/night.h"

struct listing {
    struct aob_nights nights;
    size_t lines, points;
    size_t bytes; /* of the file */
};

static void print_night(const struct aob_night *night, struct aob_text *out)
{
    json_t *summary = json_loads(night->summary, 0, NULL);
    const char *line = aob_member_text(summary, "line");
    aob_text_add_line(out, "%4lld  %s  %s  %zu of %zu ok  %s%s%s", (long long)night->id, night->date,
                      night->name, night->ok, night->cases, night->whole ? "whole" : "not ended",
                      *line ? "  " : "", line);
    json_decref(summary);
}

static void print(const struct listing *listing, struct aob_text *out)
{
    for (size_t i = 0; i < listing->nights.count; i++)
        print_night(&listing->nights.items[i], out);
    aob_text_add_line(out, "%zu night%s, %zu line%s, %zu point%s; the file has %.1f MB",
                      listing->nights.count, listing->nights.count == 1 ? "" : "s", listing->lines,
                      listing->lines == 1 ? "" : "s", listing->points, listing->points == 1 ? "" : "s",
                      (double)listing->bytes * 1e-6);
}

static json_t *night_to_json(const struct aob_night *night)
{
    json_t *summary = json_loads(night->summary, 0, NULL);
    return json_pack("{s:I, s:s, s:s, s:s, s:s, s:o, s:b, s:I, s:I, s:o}", "id", (json_int_t)night->id,
                     "date", night->date, "config", night->name, "config_hash", night->config_hash, "build",
                     night->build, "folder", aob_json_text(night->folder), "whole", night->whole, "cases",
                     (json_int_t)night->cases, "ok", (json_int_t)night->ok, "summary",
                     summary ? summary : json_null());
}

static bool write_document(const struct listing *listing, const struct aob_common *common,
                           struct aob_error *error)
{
    json_t *nights = json_array();
    for (size_t i = 0; i < listing->nights.count; i++)
        json_array_append_new(nights, night_to_json(&listing->nights.items[i]));
    json_t *document =
        json_pack("{s:o, s:o, s:I, s:I, s:I}", "history", aob_json_path(common->words.items[0]), "nights",
                  nights, "lines", (json_int_t)listing->lines, "points", (json_int_t)listing->points, "bytes",
                  (json_int_t)listing->bytes);
    bool ok = aob_json_write(document, common->json, error);
    json_decref(document);
    return ok;
}

static bool read_listing(struct aob_history *history, const struct aob_history_options *options,
                         struct listing *listing, struct aob_error *error)
{
    if (!aob_nights_read(history, options->config, &listing->nights, error) ||
        !aob_lines_count(history, options->config, &listing->lines, &listing->points, error))
        return false;
    listing->bytes = aob_file_size(options->common.words.items[0]);
    return listing->nights.count || !options->config ||
           aob_fail(error, "%s: has no night of a config '%s'", options->common.words.items[0],
                    options->config);
}

static enum aob_exit list(struct aob_history_options *options, struct aob_history *history,
                          struct aob_error *error)
{
    struct listing listing = {0};
    bool ok = read_listing(history, options, &listing, error);
    if (ok && aob_common_speaks(&options->common))
        print(&listing, &options->common.out);
    if (ok && options->common.json)
        ok = write_document(&listing, &options->common, error);
    aob_nights_finish(&listing.nights);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_history_action aob_history_list = {
    .name = "list", .takes = "config", .use = AOB_HISTORY_READ, .run = list};
