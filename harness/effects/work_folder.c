#define _GNU_SOURCE 1 /* close_range */
#include "work_folder.h"
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <jansson.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"

static int remove_one(const char *path, const struct stat *what, int kind, struct FTW *place)
{
    (void)what;
    (void)kind;
    (void)place;
    return remove(path);
}

static void remove_all(const char *path)
{
    nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

/* A new folder's path; free() it. NULL: none can be made there. Paths of jobs are UTF-8. */
static char *make_in(const char *parent)
{
    json_t *text = json_string(parent);
    char *whole = text && *parent ? aob_path_absolute(parent) : NULL,
         *path = whole ? aob_path_join(whole, "aobudget-effects-XXXXXX") : NULL;
    json_decref(text);
    free(whole);
    if (path && mkdtemp(path))
        return path;
    free(path);
    return NULL;
}

/* The signals that end a program in its terminal do not end this one, and it holds nothing that others wait for. */
static void __attribute__((noreturn)) keep(const char *path, int end)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    char byte;
    setsid();
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        signal(signals[i], SIG_IGN);
    dup2(end, 0);
    close_range(1, ~0U, 0);
    while (read(0, &byte, 1) < 0 && errno == EINTR)
        continue;
    remove_all(path);
    _exit(0);
}

/* Workers get the end that is written to, and never write to it: so it closes with the last of them. An orderly end writes a byte.
 * Without a keeper only an orderly end removes the folder. */
static void start_keeper(struct aob_work_folder *folder)
{
    int ends[2];
    folder->alive = -1;
    if (pipe(ends) != 0)
        return;
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    folder->keeper = fork();
    if (!folder->keeper)
        keep(folder->path, ends[0]);
    close(ends[0]);
    if (folder->keeper > 0)
        folder->alive = ends[1];
    else
        close(ends[1]);
}

bool aob_work_folder_create(struct aob_work_folder *folder, struct aob_error *error)
{
    const char *wanted = getenv("TMPDIR");
    *folder = (struct aob_work_folder){.path = wanted ? make_in(wanted) : NULL, .alive = -1};
    if (!folder->path)
        folder->path = make_in("/tmp");
    if (!folder->path)
        return aob_fail(
            error, "/tmp: cannot create a folder for the frames: %s; set TMPDIR to one that can be written",
            strerror(errno));
    start_keeper(folder);
    return true;
}

void aob_work_folder_remove(struct aob_work_folder *folder)
{
    remove_all(folder->path);
    if (folder->alive >= 0) {
        /* A driver may have left a process behind that still holds the pipe: so the keeper is told, and does not wait for it. */
        ssize_t told = write(folder->alive, "", 1);
        (void)told;
        close(folder->alive);
        waitpid(folder->keeper, NULL, 0);
    }
    free(folder->path);
    *folder = (struct aob_work_folder){.alive = -1};
}
