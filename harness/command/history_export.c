#include "history/export.h"
#include <jansson.h>
#include "base/json.h"
#include "history.h"

static struct aob_export_desc desc_of(const struct aob_history_options *options)
{
    return (struct aob_export_desc){options->config, options->from, options->out};
}

static bool check(const struct aob_history_options *options, struct aob_error *error)
{
    const struct aob_export_desc desc = desc_of(options);
    if (!options->out)
        return aob_fail(error, "history export: say where to, as --out FILE.csv or --out FILE.jsonl");
    return aob_export_check(&desc, error);
}

static bool tell(struct aob_history_options *options, size_t rows, struct aob_error *error)
{
    if (aob_common_speaks(&options->common))
        aob_text_add_line(&options->common.out, "%zu point%s in %s", rows, rows == 1 ? "" : "s",
                          options->out);
    if (!options->common.json)
        return true;
    json_t *document =
        json_pack("{s:o, s:I}", "file", aob_json_path(options->out), "points", (json_int_t)rows);
    bool ok = aob_json_write(document, options->common.json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit export_table(struct aob_history_options *options, struct aob_history *history,
                                  struct aob_error *error)
{
    const struct aob_export_desc desc = desc_of(options);
    size_t rows;
    return aob_history_export(history, &desc, &rows, error) && tell(options, rows, error) ? AOB_EXIT_OK
                                                                                          : AOB_EXIT_USAGE;
}

const struct aob_history_action aob_history_export_table = {.name = "export",
                                                            .takes = "config from out",
                                                            .use = AOB_HISTORY_READ,
                                                            .check = check,
                                                            .run = export_table};
