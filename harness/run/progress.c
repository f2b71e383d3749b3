#include "progress.h"
#include <stdio.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include "base/clock.h"

void aob_progress_init(struct aob_progress *progress, size_t total, bool quiet)
{
    *progress = (struct aob_progress){
        .shown = !quiet && isatty(STDERR_FILENO), .total = total, .start_ns = aob_clock_wall_ns()};
}

void aob_progress_step(struct aob_progress *progress, const char *what)
{
    progress->done++;
    if (!progress->shown)
        return;
    struct winsize window = {.ws_col = 80};
    ioctl(STDERR_FILENO, TIOCGWINSZ, &window);
    double elapsed = (double)(aob_clock_wall_ns() - progress->start_ns) * 1e-9;
    long left = (long)(elapsed / (double)progress->done * (double)(progress->total - progress->done) + 0.5);
    char line[512];
    snprintf(line, sizeof line, "[%zu/%zu] %ld:%02ld left  %s", progress->done, progress->total, left / 60,
             left % 60, what);
    fprintf(stderr, "\r\033[K%.*s", window.ws_col > 1 ? window.ws_col - 1 : 79, line);
    fflush(stderr);
}

void aob_progress_finish(struct aob_progress *progress)
{
    if (progress->shown)
        fprintf(stderr, "\r\033[K");
}
