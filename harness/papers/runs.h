/* The runs that rows are measured from: configs of configs/papers, each run anew below one folder. */
#ifndef AOB_PAPERS_RUNS_H
#define AOB_PAPERS_RUNS_H
#include <jansson.h>
#include "papers.h"

struct aob_paper_runs {
    const struct aob_papers_desc *desc; /* borrowed */
    const char *out;                    /* borrowed: the folder that the runs' folders lie in */
    char *configs;                      /* the folder of the configs */
    json_t *ran;                        /* config -> its records, or the text of why it failed */
};
void aob_paper_runs_init(struct aob_paper_runs *runs, const struct aob_papers_desc *desc, const char *out);
void aob_paper_runs_finish(struct aob_paper_runs *runs);

/* False after a line if the row's config is missing. `config` NULL: the row runs none. */
bool aob_paper_runs_have(const struct aob_paper_runs *runs, const char *config, const char *row,
                         struct aob_error *error);

/* Runs a config and keeps what its journal holds, or the text of what went wrong, which is the runs' (json_is_string).
 * `patience`: how often before; each time the cases are timed twice as long, to half the width. */
const json_t *aob_paper_runs_run(struct aob_paper_runs *runs, const char *config, int patience);

/* The kept result of a config that was run; runs it once where it was not. */
const json_t *aob_paper_runs_get(struct aob_paper_runs *runs, const char *config);

char *aob_paper_runs_folder(const struct aob_paper_runs *runs, const char *config); /* of its run; free() */
#endif
