/* Command-line flags from a const table: the table is parser and help text at once. Values go into an options struct by
 * offset, as a technique's parameters do. Threads: a struct is used by one at a time. */
#ifndef AOB_BASE_FLAGS_H
#define AOB_BASE_FLAGS_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"
#include "text.h"

struct aob_words { /* what a flag that may be repeated was given; the texts are argv's */
    const char **items;
    size_t count, capacity;
};
enum aob_flag_kind {
    AOB_FLAG_TEXT,   /* into a const char *, once */
    AOB_FLAG_MANY,   /* into a struct aob_words, each time it is given */
    AOB_FLAG_SWITCH, /* sets a bool; takes no value */
};
struct aob_flag {
    const char *name;  /* "out" for --out; "p" for -p */
    const char *value; /* what the help calls its value; NULL of a switch */
    const char *help;
    enum aob_flag_kind kind;
    size_t offset; /* of the field in the options struct */
};

struct aob_flags_desc {
    const char *command;          /* for messages */
    const struct aob_flag *table; /* ended by a NULL name */
    int argc;                     /* the words behind the command's name */
    char **argv;
};
/* Puts the flags into `options` and the other words into `words`. --name=value is --name value; a flag of one letter has
 * one dash. False: one line that names the command and the flag. */
bool aob_flags_parse(const struct aob_flags_desc *desc, void *options, struct aob_words *words,
                     struct aob_error *error);
void aob_flags_help(const struct aob_flag *table, struct aob_text *out); /* a line each */
void aob_words_finish(struct aob_words *words);
#endif
