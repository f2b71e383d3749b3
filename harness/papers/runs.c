#include "runs.h"
#include <math.h>
#include <stdlib.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/shelf.h"
#include "base/text.h"
#include "config/config.h"
#include "run/run.h"
#include "store/journal.h"

void aob_paper_runs_init(struct aob_paper_runs *runs, const struct aob_papers_desc *desc, const char *out)
{
    *runs = (struct aob_paper_runs){
        .desc = desc, .out = out, .configs = aob_shelf_folder("papers"), .ran = json_object()};
}

void aob_paper_runs_finish(struct aob_paper_runs *runs)
{
    json_decref(runs->ran);
    free(runs->configs);
}

static char *config_path(const struct aob_paper_runs *runs, const char *config)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s/%s.yaml", runs->configs, config);
    return text.data;
}

bool aob_paper_runs_have(const struct aob_paper_runs *runs, const char *config, const char *row,
                         struct aob_error *error)
{
    if (!config)
        return true;
    char *path = config_path(runs, config);
    bool ok = aob_file_exists(path) ||
              aob_fail(error, "%s: not found; row %s needs it: install the program whole", path, row);
    free(path);
    return ok;
}

/* What a config asks for, doubled with each run of it: twice the time, half the width of its intervals. */
static bool ask(const struct aob_paper_runs *runs, const char *path, int patience, struct aob_run_desc *desc,
                struct aob_error *error)
{
    struct aob_config config;
    if (!aob_config_read(&config, path, error))
        return false;
    desc->seconds = (runs->desc->quick ? 0.1 : config.seconds) * exp2(patience);
    desc->precision = config.precision * exp2(-patience);
    aob_config_finish(&config);
    return true;
}

/* NULL after one line. Cases that are not ok are the rows' concern. */
static json_t *run_once(struct aob_paper_runs *runs, const char *config, int patience,
                        struct aob_error *error)
{
    bool quick = runs->desc->quick;
    char *path = config_path(runs, config), *folder = aob_paper_runs_folder(runs, config),
         *journal = aob_path_join(folder, "journal.jsonl");
    struct aob_run_desc desc = {.dispatch = runs->desc->dispatch,
                                .config = path,
                                .out = folder,
                                .fresh = true,
                                .quiet = true,
                                .no_page = true,
                                .max_width = quick ? 80 : 0,
                                .max_spp = quick ? 64 : 0};
    if (!runs->desc->quiet)
        aob_note("papers: running %s%s", config, patience ? " again, for longer" : "");
    if (ask(runs, path, patience, &desc, error))
        aob_run(&desc, error);
    json_t *records = *error->text ? NULL : aob_journal_read(journal, NULL, error);
    free(journal);
    free(folder);
    free(path);
    return records;
}

const json_t *aob_paper_runs_run(struct aob_paper_runs *runs, const char *config, int patience)
{
    struct aob_error error = {{0}};
    json_t *found = run_once(runs, config, patience, &error);
    json_object_set_new(runs->ran, config, found ? found : json_string(error.text));
    return json_object_get(runs->ran, config);
}

const json_t *aob_paper_runs_get(struct aob_paper_runs *runs, const char *config)
{
    const json_t *kept = json_object_get(runs->ran, config);
    return kept ? kept : aob_paper_runs_run(runs, config, 0);
}

char *aob_paper_runs_folder(const struct aob_paper_runs *runs, const char *config)
{
    return aob_path_join(runs->out, config);
}
