/* Errors and exit codes.
 * A function that can fail takes a `struct aob_error *` last, returns false (or NULL) and has then written
 * exactly one line that names the object, the cause and, where it helps, what to do. The line carries no
 * newline and no "error:"; whoever ends the story prints it once, with aob_error_print. */
#ifndef AOB_BASE_ERROR_H
#define AOB_BASE_ERROR_H
#include <stdbool.h>

enum aob_exit {
    AOB_EXIT_OK = 0,    /* done and good */
    AOB_EXIT_BAD = 1,   /* the answer is bad: slower, a regression, a failed property */
    AOB_EXIT_USAGE = 2, /* usage, config, unreadable input, unwritable output, nothing could run */
    AOB_EXIT_PART = 3,  /* done in part; what was done is stored */
};

struct aob_error {
    char text[768]; /* empty while nothing failed */
};

/* Writes the line into `error` (NULL is allowed: the caller does not want it). Always returns false. */
bool aob_fail(struct aob_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Puts "prefix: " before the line that is already there. Always returns false. */
bool aob_fail_in(struct aob_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints one line on standard error: "aobudget: error: TEXT". Line breaks within the text become spaces,
 * and other control characters escapes (aob_text_add_shown): a text may quote an input. */
void aob_error_print(const struct aob_error *error);

/* Each prints one line on standard error: "aobudget: warning: TEXT" or "aobudget: TEXT". */
void aob_warn(const char *format, ...) __attribute__((format(printf, 1, 2)));
void aob_note(const char *format, ...) __attribute__((format(printf, 1, 2)));
#endif
