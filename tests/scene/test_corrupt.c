/* Damaged mesh files, through the worker that loads them. */
#include "damaged.h"
#include "job/mesh_job.h"
#include "random.h"

static const char *const files[] = {
    "/usr/share/doc/embree3/models/cornell_box.obj", "/usr/share/glmark2/models/horse.3ds",
    "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb"};

static const char ply[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

static uint32_t seed = 1;

/* A third are cut off, a third have a bit turned anywhere, a third one within the first 400 bytes. */
static size_t damage(char *bytes, size_t size, int variant)
{
    if (variant % 3 == 0)
        return random_below(&seed, size);
    size_t reach = variant % 3 == 1 || size < 400 ? size : 400;
    bytes[random_below(&seed, reach)] ^= (char)(1 << random_below(&seed, 8));
    return size;
}

static json_t *job(const struct damaged *d)
{
    return aob_mesh_job_to_json(&(struct aob_mesh_job){.file = d->file, .out = d->out});
}

static void check_file(const char *bytes, size_t size, const char *ending)
{
    char file[64], out[64];
    snprintf(file, sizeof file, "/tmp/aobudget-corrupt-%ld%s", (long)getpid(), ending);
    snprintf(out, sizeof out, "/tmp/aobudget-corrupt-%ld.mesh", (long)getpid());
    damaged_check(&(struct damaged){.what = ending,
                                    .file = file,
                                    .out = out,
                                    .job = job,
                                    .answer = "triangles",
                                    .timeout_s = 1,
                                    .memory_limit = (size_t)1 << 29,
                                    .damage = damage,
                                    .variants = 75,
                                    .may_crash = true}, /* assimp is not ours */
                  bytes, size);
}

static void test_damaged_meshes(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(files); i++) {
        size_t size;
        char *bytes = aob_file_read(files[i], 1 << 26, &size, NULL);
        assert_non_null(bytes); /* ./dev installs these */
        check_file(bytes, size, strrchr(files[i], '.'));
        free(bytes);
    }
    check_file(ply, sizeof ply - 1, ".ply");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_damaged_meshes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
