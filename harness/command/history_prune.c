#include <jansson.h>
#include <math.h>
#include "base/file.h"
#include "base/json.h"
#include "history.h"
#include "history/night.h"

static bool read_keep(const struct aob_history_options *options, double *keep, struct aob_error *error)
{
    if (!options->keep)
        return aob_fail(error, "history prune: say how many nights of each config stay, as --keep 30");
    return (aob_parse_double(options->keep, keep) && *keep == floor(*keep) && *keep >= 1 && *keep <= 1e9) ||
           aob_fail(error, "--keep: '%s' is not a whole number from 1 to 1000000000", options->keep);
}

/* Who writes makes what is not there; but then there is nothing to remove. */
static bool check(const struct aob_history_options *options, struct aob_error *error)
{
    double keep;
    struct aob_history *history =
        read_keep(options, &keep, error)
            ? aob_history_open(options->common.words.items[0], AOB_HISTORY_READ, error)
            : NULL;
    aob_history_close(history);
    return history != NULL;
}

static void print(const struct aob_history_options *options, const struct aob_prune *pruned,
                  struct aob_text *out)
{
    const char *plural = pruned->nights == 1 ? "" : "s";
    double mb = (double)aob_file_size(options->common.words.items[0]) * 1e-6;
    if (options->rounds)
        aob_text_add_line(
            out, "removed the journal%s and raw rounds of %zu night%s; the file has %.1f MB, %.1f less",
            plural, pruned->nights, plural, mb, (double)pruned->bytes * 1e-6);
    else
        aob_text_add_line(out, "removed %zu night%s with %zu point%s; the file has %.1f MB, %.1f less",
                          pruned->nights, plural, pruned->points, pruned->points == 1 ? "" : "s", mb,
                          (double)pruned->bytes * 1e-6);
}

static bool write_document(const struct aob_history_options *options, const struct aob_prune *pruned,
                           struct aob_error *error)
{
    json_t *document =
        json_pack("{s:o, s:b, s:I, s:I, s:I}", "history", aob_json_path(options->common.words.items[0]),
                  "rounds_only", options->rounds, "nights", (json_int_t)pruned->nights, "points",
                  (json_int_t)pruned->points, "bytes", (json_int_t)pruned->bytes);
    bool ok = aob_json_write(document, options->common.json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit prune(struct aob_history_options *options, struct aob_history *history,
                           struct aob_error *error)
{
    struct aob_prune pruned;
    double keep;
    if (!read_keep(options, &keep, error) ||
        !aob_nights_prune(history, (size_t)keep, options->rounds, &pruned, error))
        return AOB_EXIT_USAGE;
    if (aob_common_speaks(&options->common))
        print(options, &pruned, &options->common.out);
    return !options->common.json || write_document(options, &pruned, error) ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_history_action aob_history_prune = {
    .name = "prune", .takes = "keep rounds", .use = AOB_HISTORY_WRITE, .check = check, .run = prune};
