/* A program run in a process of its own, with limits of time, memory and output. The child leads a process group that
 * is killed whole, at its end or at a limit, so nothing is left over; it also dies with the thread that
 * runs it. Threads: any; each call has its own child. */
#ifndef AOB_BASE_CHILD_H
#define AOB_BASE_CHILD_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

struct aob_child_desc {
    const char *const *argv; /* NULL-ended; argv[0] is the program's path */
    const char *const *env;  /* NULL, or NULL-ended "NAME=value" set on top of this process's environment */
    const char *input;       /* what it reads from standard input; NULL: nothing */
    size_t input_size;
    double timeout_s; /* of work (deadline.h), for the whole run; 0: no limit */
    /* Bytes of address space (of resident memory under AddressSanitizer). 0: no limit but the one of this process, which
     * holds in any case. */
    size_t memory_limit;
    size_t output_limit; /* bytes of each of its two outputs; 0: 64 MiB. A line ends at 16 MiB */
    /* Called with each line of standard output, of any length, without its newline; may be NULL. A last line that
     * lacks its newline counts only if the child exited by itself: a crash may have cut it. */
    void (*on_line)(void *user, const char *line);
    void *user;
};
struct aob_child_result {
    int exit_code; /* -1 unless it exited by itself */
    int signal;    /* 0 unless a signal ended it */
    bool timed_out;
    char limit
        [64]; /* of time, which it met: "took longer than 20 s of work", "did nothing for 10 s" (deadline.h) */
    char excess
        [64]; /* what it wrote too much, and was killed for: "a line of more than 16 MiB on standard error" */
    char complaint[512]; /* the last line on standard error that says "error", else the last line; may be
                            empty */
};

/* False only if the child could not be started; how it ended is in *result. */
bool aob_child_run(const struct aob_child_desc *desc, struct aob_child_result *result,
                   struct aob_error *error);

/* Bytes of address space that a child of this limit has, or 0 that this process has. 0: no limit. */
size_t aob_child_memory(size_t limit);

/* "crashed (signal 11, segmentation fault): COMPLAINT", "not enough memory (its limit is 293 MiB): std::bad_alloc",
 * LIMIT, "wrote EXCESS, and was stopped", "exit code 2: COMPLAINT". */
void aob_child_explain(const struct aob_child_desc *desc, const struct aob_child_result *result, char *text,
                       size_t size);
#endif
