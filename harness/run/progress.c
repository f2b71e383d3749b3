#include "progress.h"
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include "base/clock.h"
#include "base/text.h"

void aob_progress_init(struct aob_progress *progress, size_t total, bool quiet)
{
    *progress = (struct aob_progress){
        .shown = !quiet && isatty(STDERR_FILENO), .total = total, .start_ns = aob_clock_wall_ns()};
}

/* No time is told before the first case is done: nothing is known of it then. */
static void add_time_left(const struct aob_progress *progress, struct aob_text *line)
{
    if (!progress->done)
        return;
    double elapsed = (double)(aob_clock_wall_ns() - progress->start_ns) * 1e-9;
    long left = (long)(elapsed / (double)progress->done * (double)(progress->total - progress->done) + 0.5);
    aob_text_add(line, "%ld:%02ld left  ", left / 60, left % 60);
}

/* The cursor goes back to the end of the line above, so that a message begins where it does without them. */
static void say_below(const struct aob_progress *progress, int width, int column)
{
    int lines = 0;
    for (size_t i = 0; i < progress->below_count; i++) {
        struct aob_text shown = {0};
        if (!progress->below[i].size)
            continue;
        aob_text_add_shown(&shown, progress->below[i].data, progress->below[i].size, false);
        fprintf(stderr, "\n%.*s", width, shown.data);
        aob_text_finish(&shown);
        lines++;
    }
    if (lines)
        fprintf(stderr, "\033[%dA\r\033[%dC", lines, column < width ? column : width);
}

void aob_progress_say(const struct aob_progress *progress, const char *what)
{
    if (!progress->shown)
        return;
    struct winsize window = {.ws_col = 80};
    struct aob_text line = {0};
    ioctl(STDERR_FILENO, TIOCGWINSZ, &window);
    aob_text_add(&line, "[%zu/%zu] ", progress->done, progress->total);
    add_time_left(progress, &line);
    aob_text_add_shown(&line, what, strlen(what), false);
    int width = window.ws_col > 1 ? window.ws_col - 1 : 79;
    fprintf(stderr, "\r%s%.*s", progress->below_count ? "\033[J" : "\033[K", width, line.data);
    say_below(progress, width, (int)line.size);
    fflush(stderr);
    aob_text_finish(&line);
}

void aob_progress_step(struct aob_progress *progress, const char *what)
{
    progress->done++;
    aob_progress_say(progress, what);
}

void aob_progress_finish(struct aob_progress *progress)
{
    if (progress->shown)
        fprintf(stderr, "\r%s", progress->below_count ? "\033[J" : "\033[K");
}
