/* The folder of a run: journal.jsonl, run.json (which run it is), run.config.yaml (a copy of its config), images/, truths/, rounds/,
 * report/. */
#ifndef AOB_STORE_RUN_FOLDER_H
#define AOB_STORE_RUN_FOLDER_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "journal.h"

#define AOB_RUN_FOLDER_CONFLICTS                                                                             \
    "conflicts.jsonl" /* what a merge left out (merge/union.h); gone with what is discarded */

struct aob_run_folder {
    char *path, *info, *journal_path; /* info: path of run.json */
    char *
        shaders; /* empty when the run begins, removed when it ends: for what a driver keeps between processes */
    bool open;                  /* this program has it, and no other */
    struct aob_journal journal; /* open for appending; one run a folder */
};

/* Creates or reopens. What an earlier run left is kept if its run.json names the same config_hash, build and devices as
 * `info`, and discarded if `fresh`, records before files; else it is refused, because figures would be lost, or figures of two programs or
 * two devices mixed. A folder whose journal is empty or missing holds no run. `info` takes over the earlier device of a
 * backend that could not be opened now, and adds the earlier `asked` to its own; one of them without that list asks for all
 * of `keys`, and so does the whole then. */
bool aob_run_folder_open(struct aob_run_folder *folder, const char *path, json_t *info, bool fresh,
                         struct aob_error *error);

/* Whether aob_run_folder_open would keep what an earlier run left in this folder; it changes nothing. False after a line. */
bool aob_run_folder_judge(const char *path, const json_t *info, struct aob_error *error);

/* The first backend that has one device in `then` and another in `now`, which are `devices` of two run.json; NULL: there is
 * none. A backend that could not be opened in one of them has measured nothing there, and is no other device. */
const char *aob_run_folder_other_device(const json_t *then, const json_t *now);

/* Adds "llvmpipe, Mesa 22.3.6, AMD EPYC": all that run.json says of a device. */
void aob_run_folder_add_device(struct aob_text *text, const json_t *device);

bool aob_run_folder_describe(const struct aob_run_folder *folder, const json_t *info,
                             struct aob_error *error);
bool aob_run_folder_keep_config(const struct aob_run_folder *folder, const char *text, size_t size,
                                struct aob_error *error);
void aob_run_folder_close(struct aob_run_folder *folder);
#endif
