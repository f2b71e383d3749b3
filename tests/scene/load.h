/* A mesh file loaded as its header demands: by a child process, through the flat file. */
#ifndef AOB_TESTS_SCENE_LOAD_H
#define AOB_TESTS_SCENE_LOAD_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "scene/mesh.h"

enum { LOADED = 0, REFUSED = 1, SILENT = 2 }; /* SILENT: refused without exactly one line */

struct paths {
    char source[64], flat[64];
};

static inline void make_paths(struct paths *paths, const char *extension)
{
    snprintf(paths->source, sizeof paths->source, "/tmp/aob_test_import_%ld.%s", (long)getpid(), extension);
    snprintf(paths->flat, sizeof paths->flat, "/tmp/aob_test_import_%ld.flat", (long)getpid());
}

static inline int child(const char *source, const char *flat)
{
    struct aob_error error = {""};
    struct aob_mesh mesh;
    alarm(20);
    if (!aob_mesh_import(&mesh, source, &error))
        return strstr(error.text, source) && !strchr(error.text, '\n') ? REFUSED : SILENT;
    bool ok = aob_mesh_save(&mesh, flat, &error);
    aob_mesh_finish(&mesh);
    return ok ? LOADED : SILENT;
}

/* How the child ended: one of the above, or 128 + the signal. */
static inline int load(const char *source, const char *flat)
{
    fflush(NULL);
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0)
        _exit(child(source, flat));
    int status = 0;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/* Loads what must be refused in one line that begins with the file's path, and gives what follows it. */
static inline void refuse_file(const char *source, struct aob_error *error)
{
    int ends[2];
    *error = (struct aob_error){""};
    assert_int_equal(pipe(ends), 0);
    fflush(NULL);
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        struct aob_error line = {""};
        struct aob_mesh mesh;
        alarm(20);
        bool ok = aob_mesh_import(&mesh, source, &line);
        _exit(!ok && write(ends[1], line.text, strlen(line.text)) > 0 ? REFUSED : LOADED);
    }
    close(ends[1]);
    struct aob_error line = {""};
    assert_true(read(ends[0], line.text, sizeof line.text - 1) >= 0);
    close(ends[0]);
    int status = 0;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), REFUSED);
    assert_null(strchr(line.text, '\n'));
    assert_memory_equal(line.text, source, strlen(source));
    strcpy(error->text, line.text + strlen(source));
}

static inline void refuse_text(const char *extension, const char *text, struct aob_error *error)
{
    struct paths paths;
    make_paths(&paths, extension);
    assert_true(aob_file_write(paths.source, text, strlen(text), NULL));
    refuse_file(paths.source, error);
    unlink(paths.source);
}

static inline void load_text(struct aob_mesh *mesh, const char *extension, const char *text)
{
    struct paths paths;
    struct aob_error error = {""};
    make_paths(&paths, extension);
    assert_true(aob_file_write(paths.source, text, strlen(text), &error));
    assert_int_equal(load(paths.source, paths.flat), LOADED);
    assert_true(aob_mesh_restore(mesh, paths.flat, &error));
    unlink(paths.source);
    unlink(paths.flat);
}
#endif
