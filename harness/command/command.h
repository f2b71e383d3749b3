/* A command of the program: its flags, its help and its story. One file a command; main.c lists them. */
#ifndef AOB_COMMAND_COMMAND_H
#define AOB_COMMAND_COMMAND_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/flags.h"
#include "run/dispatch.h"

/* What every command has; the first member of each one's options. Filled in before the command runs. */
struct aob_common {
    const char *json; /* --json: a file, or "-": standard output; NULL: no document */
    bool quiet, help;
    struct aob_words modules, words;
    struct aob_dispatch dispatch;
    struct aob_text out; /* for standard output: written when the command is done, whatever its code */
};

struct aob_command {
    const char *name, *help;      /* its row of `aobudget --help` */
    const char *usage, *summary;  /* "CONFIG [--out DIR]"; one sentence */
    const struct aob_flag *flags; /* its own, ended by a NULL name; NULL: none */
    bool modules;                 /* it takes --module */
    bool devices;                 /* it takes --device */
    size_t least, most;           /* words besides flags */
    size_t size;                  /* of its options, whose first member is a struct aob_common */
    enum aob_exit (*run)(void *options, struct aob_error *error);
};

/* Reads the flags, prints the help if that is asked for, else runs the command. A line in `error` if the code is not
 * AOB_EXIT_OK, where there is one to say. */
enum aob_exit aob_command_run(const struct aob_command *command, int argc, char **argv,
                              struct aob_error *error);

/* Whether a summary for people may be printed on standard output: not if --quiet or if the document goes there. */
bool aob_common_speaks(const struct aob_common *common);

extern const struct aob_command aob_command_list, aob_command_plan, aob_command_run_config, aob_command_shot,
    aob_command_report, aob_command_papers, aob_command_compare, aob_command_calibrate, aob_command_cache,
    aob_command_budget, aob_command_effects, aob_command_stress, aob_command_doctor, aob_command_nightly,
    aob_command_history, aob_command_merge, aob_command_tune;
#endif
