/* The folder of a run: journal.jsonl, run.json (what run it is), images/, report/. */
#ifndef AOB_STORE_RUN_FOLDER_H
#define AOB_STORE_RUN_FOLDER_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "journal.h"

struct aob_run_folder {
    char *path, *info, *journal_path; /* info: path of run.json */
    struct aob_journal journal;       /* open for appending; one run a folder */
};

/* Creates or reopens. What an earlier run left is kept if its run.json names the same config_hash and build as
 * `info`, discarded if `fresh`, else refused: figures would be lost, or figures of two programs mixed. */
bool aob_run_folder_open(struct aob_run_folder *folder, const char *path, const json_t *info, bool fresh,
                         struct aob_error *error);
bool aob_run_folder_describe(const struct aob_run_folder *folder, const json_t *info,
                             struct aob_error *error);
void aob_run_folder_close(struct aob_run_folder *folder);
#endif
