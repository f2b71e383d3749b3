#include "check.h"
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "job/mesh_job.h"
#include "run/dispatch.h"

/* Damaged mesh files, through the worker that loads them: the harness stays up, and every refusal is one line. */

static const char *const files[] = {
    "/usr/share/doc/embree3/models/cornell_box.obj", "/usr/share/glmark2/models/horse.3ds",
    "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb"};

static const char ply[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

static unsigned seed = 1;

static size_t below(size_t n)
{
    seed = seed * 1664525u + 1013904223u;
    return (size_t)(((uint64_t)seed * n) >> 32);
}

/* A third are cut off, a third have a bit turned anywhere, a third one within the first 400 bytes. */
static size_t damage(char *bytes, size_t size, int variant)
{
    if (variant % 3 == 0)
        return below(size);
    size_t reach = variant % 3 == 1 || size < 400 ? size : 400;
    bytes[below(reach)] ^= (char)(1 << below(8));
    return size;
}

static void count_answer(void *user, const json_t *answer)
{
    *(int *)user += json_is_integer(json_object_get(answer, "triangles"));
}

/* 1: loaded; 0: refused in one line. */
static int load(const struct aob_dispatch *dispatch, const char *file, const char *out)
{
    struct aob_error error = {{0}};
    int answers = 0;
    unlink(out);
    struct aob_job_desc desc = {.job = aob_mesh_job_to_json(&(struct aob_mesh_job){file, out}),
                                .timeout_s = 1,
                                .memory_limit = (size_t)1 << 29,
                                .on_answer = count_answer,
                                .user = &answers};
    bool ok = aob_dispatch_job(dispatch, &desc, &error);
    assert_int_equal(answers, ok);
    assert_true(ok || *error.text);
    assert_null(strchr(error.text, '\n'));
    assert_true(ok || !aob_file_exists(out));
    return ok;
}

static void check_file(const char *bytes, size_t size, const char *ending, int variants)
{
    char *program = aob_path_join(getenv("AOBUDGET_BUILD"), "aobudget"), file[64], out[64];
    struct aob_dispatch dispatch = {.program = program};
    char *copy = aob_alloc(size, 1);
    int loaded = 0;
    snprintf(file, sizeof file, "/tmp/aobudget-corrupt-%ld%s", (long)getpid(), ending);
    snprintf(out, sizeof out, "/tmp/aobudget-corrupt-%ld.mesh", (long)getpid());
    assert_true(aob_file_write(file, bytes, size, NULL));
    assert_int_equal(load(&dispatch, file, out), 1); /* undamaged */
    for (int v = 0; v < variants; v++) {
        memcpy(copy, bytes, size);
        size_t left = damage(copy, size, v);
        assert_true(aob_file_write(file, copy, left, NULL));
        loaded += load(&dispatch, file, out);
    }
    printf("%s: of %d damaged files %d load, %d are refused in one line\n", ending, variants, loaded,
           variants - loaded);
    unlink(file);
    unlink(out);
    free(copy);
    free(program);
}

static void test_damaged_meshes(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        size_t size;
        char *bytes = aob_file_read(files[i], 1 << 26, &size, NULL);
        assert_non_null(bytes); /* ./dev installs these */
        check_file(bytes, size, strrchr(files[i], '.'), 75);
        free(bytes);
    }
    check_file(ply, sizeof ply - 1, ".ply", 75);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_damaged_meshes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
