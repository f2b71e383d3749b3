/* The actions of `aobudget history F.db ACTION`: each is a file and a row of the table in history.c. */
#ifndef AOB_COMMAND_HISTORY_H
#define AOB_COMMAND_HISTORY_H
#include "command.h"
#include "history/history.h"

struct aob_history_options {
    struct aob_common common; /* its words are the file and the action */
    const char *config, *from, *out, *keep;
    bool rounds;
};

struct aob_history_action {
    const char *name, *takes; /* the flags that it takes besides every command's: "config from out" */
    enum aob_history_use use; /* how it opens the file */
    bool (*check)(const struct aob_history_options *options, struct aob_error *error); /* before that; NULL */
    enum aob_exit (*run)(struct aob_history_options *options, struct aob_history *history,
                         struct aob_error *error);
};
extern const struct aob_history_action aob_history_list, aob_history_prune, aob_history_export_table;
#endif
