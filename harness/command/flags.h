/* Command-line flags from a table: the table is parser and help text at once. */
#ifndef AOB_COMMAND_FLAGS_H
#define AOB_COMMAND_FLAGS_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_words { /* what a flag that may be repeated was given */
    const char **items;
    size_t count, capacity;
};
struct aob_flag {
    const char *name;  /* "out" for --out; "p" for -p */
    const char *value; /* what the help calls its value; NULL: a switch */
    const char *help;
    bool *on;               /* one of the three: a switch, */
    const char **text;      /* a value, */
    struct aob_words *many; /* or a value each time it is given */
};
struct aob_flags {
    const char *command, *usage; /* "run", "CONFIG" */
    const char *summary;         /* one sentence */
    const struct aob_flag
        *flags;         /* ended by a NULL name; --quiet, --json and --help included by the caller's table */
    size_t least, most; /* positional words */
};

/* False: one line (help: --help names the command's flags). `words` gets the positional ones; finish it with
 * aob_words_finish. */
bool aob_flags_parse(const struct aob_flags *flags, int argc, char **argv, struct aob_words *words,
                     struct aob_error *error);
void aob_flags_help(const struct aob_flags *flags); /* on standard output */
void aob_words_finish(struct aob_words *words);
#endif
