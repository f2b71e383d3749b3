#include "stream.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "memory.h"

enum { READ_SIZE = 1 << 16, DRAIN_READS = 16 };

static void pass_lines(struct aob_stream *stream, size_t searched)
{
    char *line = stream->data, *end = stream->data + stream->size, *newline;
    char *search = stream->data + searched;
    while (search < end && (newline = memchr(search, '\n', (size_t)(end - search)))) {
        *newline = '\0';
        if (stream->take)
            stream->take(stream->user, line);
        line = search = newline + 1;
    }
    stream->size = (size_t)(end - line);
    memmove(stream->data, line, stream->size);
}

static void close_stream(struct aob_stream *stream)
{
    if (stream->fd >= 0)
        close(stream->fd);
    stream->fd = -1;
}

bool aob_stream_read(struct aob_stream *stream)
{
    if (stream->fd < 0)
        return false;
    if (stream->capacity - stream->size < READ_SIZE) {
        stream->capacity = stream->capacity * 2 + READ_SIZE;
        stream->data = aob_realloc(stream->data, stream->capacity, 1);
    }
    ssize_t count = read(stream->fd, stream->data + stream->size, READ_SIZE);
    if (count < 0 && (errno == EAGAIN || errno == EINTR))
        return false;
    if (count <= 0) {
        close_stream(stream);
        return false;
    }
    size_t searched = stream->size;
    stream->size += (size_t)count;
    stream->total += (size_t)count;
    pass_lines(stream, searched);
    return !aob_stream_is_broken(stream, NULL, 0);
}

bool aob_stream_is_broken(const struct aob_stream *stream, char *text, size_t size)
{
    bool line = stream->size > stream->line_limit;
    if (!line && stream->total <= stream->limit)
        return false;
    if (text)
        snprintf(text, size, "%smore than %zu MiB", line ? "a line of " : "",
                 (line ? stream->line_limit : stream->limit) >> 20);
    return true;
}

/* The writer is gone, so a pipe's content is all that is left. The number of reads is limited because a stray
 * grandchild could write for ever. */
void aob_stream_finish(struct aob_stream *stream, bool keep_unfinished_line)
{
    for (int i = 0; i < DRAIN_READS && aob_stream_read(stream); i++)
        continue;
    if (stream->size && keep_unfinished_line && stream->take) {
        stream->data = aob_realloc(stream->data, stream->size + 1, 1);
        stream->data[stream->size] = '\0';
        stream->take(stream->user, stream->data);
    }
    free(stream->data);
    stream->data = NULL;
    close_stream(stream);
}
