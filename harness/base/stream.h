/* Lines from a pipe. Bytes come in and whole lines go out. Who writes may be hostile or broken, so both a line and the
 * whole have a ceiling, and no more than a line is held. */
#ifndef AOB_BASE_STREAM_H
#define AOB_BASE_STREAM_H
#include <stdbool.h>
#include <stddef.h>

struct aob_stream {
    int fd;                                     /* does not block; -1 after its end */
    size_t line_limit, limit;                   /* bytes of a line; of all that comes */
    void (*take)(void *user, const char *line); /* without its newline; may be NULL */
    void *user;
    /* Zeroed at the start. */
    char *data; /* of the line that has begun */
    size_t size, capacity, total;
};

/* Reads what is there, a part at a time. True if there may be more to read at once. */
bool aob_stream_read(struct aob_stream *stream);

/* Whether a ceiling is broken, and then the line for it: "a line of more than 16 MiB", "more than 64 MiB". `text` may be
 * NULL. */
bool aob_stream_is_broken(const struct aob_stream *stream, char *text, size_t size);

/* Reads what is left after the writer's end, and frees. A last line without a newline is passed on only if
 * `keep_unfinished_line`: the end may have cut it. */
void aob_stream_finish(struct aob_stream *stream, bool keep_unfinished_line);
#endif
