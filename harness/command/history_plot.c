#include <jansson.h>
#include "base/file.h"
#include "base/json.h"
#include "history.h"
#include "history/line.h"
#include "history/night.h"
#include "reports/trend/trend.h"

static bool check(const struct aob_history_options *options, struct aob_error *error)
{
    return options->out ||
           aob_fail(error, "history plot: say where to, as --out DIR; DIR/index.html is the page");
}

static bool tell(struct aob_history_options *options, const struct aob_trend_desc *trend,
                 struct aob_error *error)
{
    if (aob_common_speaks(&options->common))
        aob_text_add_line(&options->common.out, "%zu lines of %zu nights: %s/index.html", trend->lines->count,
                          trend->nights->count, options->out);
    if (!options->common.json)
        return true;
    json_t *document = json_pack("{s:o, s:I, s:I}", "folder", aob_json_path(options->out), "lines",
                                 (json_int_t)trend->lines->count, "nights", (json_int_t)trend->nights->count);
    bool ok = aob_json_write(document, options->common.json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit plot(struct aob_history_options *options, struct aob_history *history,
                          struct aob_error *error)
{
    struct aob_nights nights = {0};
    struct aob_lines lines = {0};
    const struct aob_lines_ask ask = {.config = options->config};
    const struct aob_trend_desc trend = {&lines, &nights, options->out, options->config};
    bool ok = aob_nights_read(history, options->config, &nights, error) &&
              aob_lines_read(history, &ask, &lines, error) && aob_folder_create(options->out, error) &&
              aob_trend_write(&trend, error) && tell(options, &trend, error);
    aob_lines_finish(&lines);
    aob_nights_finish(&nights);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_history_action aob_history_plot = {
    .name = "plot", .takes = "config out", .use = AOB_HISTORY_READ, .check = check, .run = plot};
