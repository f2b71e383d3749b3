#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "base/sealed.h"
#include "check.h"
#include "random.h"

/* A folder of the test's own; paths are below it. */
struct place {
    char folder[64], path[96], other[96];
};

static int setup(void **state)
{
    static struct place place;
    snprintf(place.folder, sizeof place.folder, "/tmp/aob-test-sealed-XXXXXX");
    *state = &place;
    if (!mkdtemp(place.folder))
        return -1;
    snprintf(place.path, sizeof place.path, "%s/a.exr", place.folder);
    snprintf(place.other, sizeof place.other, "%s/b.exr", place.folder);
    return 0;
}

static int teardown(void **state)
{
    const struct place *place = *state;
    unlink(place->path);
    unlink(place->other);
    return rmdir(place->folder);
}

static void seal(const char *path, const char *bytes, size_t size)
{
    struct aob_error error = {{0}};
    if (!aob_sealed_write(path, &(struct aob_piece){bytes, size}, 1, &error))
        fail_msg("%s", error.text);
}

/* As it may happen to a file: without a flush to disk for each of thousands. */
static void put(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* Both readers say the same, and anything that is not good has a line that begins with the path. */
static void assert_state(const char *path, enum aob_sealed state)
{
    struct aob_error judged = {{0}}, read = {{0}};
    size_t size = 0;
    assert_int_equal(aob_sealed_judge(path, &judged), state);
    char *bytes = aob_sealed_read(path, &size, &read);
    assert_int_equal(bytes != NULL, state == AOB_SEALED_GOOD);
    assert_string_equal(judged.text, read.text);
    if (state != AOB_SEALED_GOOD)
        assert_ptr_equal(strstr(judged.text, path), judged.text);
    free(bytes);
}

static void test_what_is_read_is_what_was_written(void **state)
{
    const struct place *place = *state;
    static const size_t sizes[] = {0, 1, 511, 65536, 65537, 200000};
    uint32_t seed = 1;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        char *bytes = malloc(sizes[s] + 1);
        for (size_t i = 0; i < sizes[s]; i++)
            bytes[i] = (char)(random_next(&seed) >> 24);
        size_t half = sizes[s] / 2, size = 7;
        const struct aob_piece pieces[] = {{bytes, half}, {NULL, 0}, {bytes + half, sizes[s] - half}};
        assert_true(aob_sealed_write(place->path, pieces, 3, NULL));
        assert_state(place->path, AOB_SEALED_GOOD);
        char *back = aob_sealed_read(place->path, &size, NULL);
        assert_int_equal(size, sizes[s]);
        assert_memory_equal(back, bytes, size);
        /* The bytes come first, as they are. */
        assert_true(aob_file_size(place->path) > size && aob_file_size(place->path) <= size + 64);
        free(back);
        free(bytes);
    }
}

static void test_every_changed_bit_is_wrong(void **state)
{
    const struct place *place = *state;
    size_t size;
    seal(place->path, "some hundred bytes of truth", 27);
    char *bytes = aob_file_read(place->path, 4096, &size, NULL);
    for (size_t bit = 0; bit < 8 * size; bit++) {
        bytes[bit / 8] = (char)(bytes[bit / 8] ^ (1 << bit % 8));
        put(place->path, bytes, size);
        assert_state(place->path, AOB_SEALED_WRONG);
        bytes[bit / 8] = (char)(bytes[bit / 8] ^ (1 << bit % 8));
    }
    for (size_t cut = 0; cut < size; cut++) {
        put(place->path, bytes, cut);
        assert_state(place->path, AOB_SEALED_WRONG);
    }
    bytes[size] = 0; /* its NUL: one byte more */
    put(place->path, bytes, size + 1);
    assert_state(place->path, AOB_SEALED_WRONG);
    put(place->path, bytes, size);
    assert_state(place->path, AOB_SEALED_GOOD);
    free(bytes);
}

static void test_every_zeroed_sector_is_wrong(void **state)
{
    enum { SECTOR = 512 };
    const struct place *place = *state;
    static char content[20 * SECTOR], zero[SECTOR];
    size_t size;
    memset(content, 'x', sizeof content);
    seal(place->path, content, sizeof content);
    char *bytes = aob_file_read(place->path, 1 << 20, &size, NULL);
    for (size_t at = 0; at < size; at += SECTOR) {
        size_t count = size - at < SECTOR ? size - at : SECTOR;
        int file = open(place->path, O_WRONLY);
        assert_int_equal(pwrite(file, zero, count, (off_t)at), (int)count);
        close(file);
        assert_state(place->path, AOB_SEALED_WRONG);
        put(place->path, bytes, size);
    }
    free(bytes);
}

/* A good file of another name is not the one that is asked for; a copy is. */
static void test_the_name_is_sealed_too(void **state)
{
    const struct place *place = *state;
    struct aob_error error = {{0}};
    seal(place->path, "of a", 4);
    assert_int_equal(rename(place->path, place->other), 0);
    assert_state(place->other, AOB_SEALED_WRONG);
    assert_false(aob_sealed_copy(place->other, place->path, &error));
    assert_state(place->path, AOB_SEALED_NONE);
    seal(place->path, "of a", 4);
    assert_true(aob_sealed_copy(place->path, place->other, &error));
    assert_state(place->other, AOB_SEALED_GOOD);
    put(place->path, "what an older version left", 26);
    assert_state(place->path, AOB_SEALED_WRONG);
}

/* None of these says anything of the content. */
static void test_no_access_is_not_wrong(void **state)
{
    const struct place *place = *state;
    unlink(place->path);
    assert_state(place->path, AOB_SEALED_NONE);
    assert_int_equal(symlink(place->path, place->path), 0); /* a link to itself */
    assert_state(place->path, AOB_SEALED_SHUT);
    unlink(place->path);
    assert_int_equal(mkdir(place->path, 0700), 0);
    assert_state(place->path, AOB_SEALED_SHUT);
    rmdir(place->path);
    assert_int_equal(mkfifo(place->path, 0600), 0); /* nobody writes, and it is not waited for */
    assert_state(place->path, AOB_SEALED_SHUT);
    unlink(place->path);
    seal(place->path, "good", 4);
    struct rlimit limit, none;
    getrlimit(RLIMIT_NOFILE, &limit);
    none = limit;
    none.rlim_cur = 3;
    setrlimit(RLIMIT_NOFILE, &none);
    enum aob_sealed full = aob_sealed_judge(place->path, NULL);
    setrlimit(RLIMIT_NOFILE, &limit);
    assert_int_equal(full, AOB_SEALED_SHUT);
    assert_state(place->path, AOB_SEALED_GOOD);
}

/* Root may read all, so the reader is somebody else. */
static void test_no_permission_is_not_wrong(void **state)
{
    const struct place *place = *state;
    int status = 0;
    seal(place->path, "good", 4);
    assert_int_equal(chmod(place->folder, 0755) | chmod(place->path, 0), 0);
    pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && seteuid(65534) != 0)
            _exit(99);
        _exit((int)aob_sealed_judge(place->path, NULL));
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), AOB_SEALED_SHUT);
    assert_int_equal(chmod(place->path, 0600), 0);
    assert_state(place->path, AOB_SEALED_GOOD);
}

static void test_what_is_no_file_is_not_written(void **state)
{
    const struct place *place = *state;
    struct aob_error error = {{0}};
    assert_false(aob_sealed_write(place->folder, &(struct aob_piece){"x", 1}, 1, &error));
    assert_contains(error.text, "no regular file");
    assert_false(aob_sealed_write("/dev/null", &(struct aob_piece){"x", 1}, 1, &error));
    assert_contains(error.text, "/dev/null");
}

/* A copy is sealed under its own name, with the same seal under the same name; what is damaged is not copied. */
static void test_copies(void **state)
{
    const struct place *place = *state;
    struct aob_error error = {{0}};
    char first[AOB_SEAL_SIZE + 1], second[AOB_SEAL_SIZE + 1], again[AOB_SEAL_SIZE + 1];
    seal(place->path, "content", 7);
    assert_true(aob_sealed_copy_unflushed(place->path, place->other, &error));
    assert_true(aob_folder_flush(place->folder, &error));
    assert_state(place->other, AOB_SEALED_GOOD);
    assert_true(aob_sealed_peek(place->path, first));
    assert_true(aob_sealed_peek(place->other, second));
    assert_string_not_equal(first, second);
    assert_ptr_equal(strstr(first, aob_sealed_version), first);
    assert_true(aob_sealed_copy_unflushed(place->other, place->path, &error));
    assert_true(aob_sealed_peek(place->path, again));
    assert_string_equal(first, again);
    put(place->path, "changed", 7);
    assert_false(aob_sealed_peek(place->path, again));
    assert_false(aob_sealed_copy_unflushed(place->path, place->other, &error));
    assert_contains(error.text, "a.exr");
    assert_state(place->other, AOB_SEALED_GOOD); /* nothing has replaced it */
    assert_false(aob_sealed_copy_unflushed(place->other, "/nowhere/c.exr", &error));
    assert_contains(error.text, "/nowhere/c.exr: cannot write");
    assert_false(aob_folder_flush("/nowhere", &error));
    assert_contains(error.text, "/nowhere: cannot write");
    unlink(place->path);
    assert_false(aob_sealed_peek(place->path, again));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_what_is_read_is_what_was_written),
        cmocka_unit_test(test_every_changed_bit_is_wrong),
        cmocka_unit_test(test_every_zeroed_sector_is_wrong),
        cmocka_unit_test(test_the_name_is_sealed_too),
        cmocka_unit_test(test_no_access_is_not_wrong),
        cmocka_unit_test(test_no_permission_is_not_wrong),
        cmocka_unit_test(test_what_is_no_file_is_not_written),
        cmocka_unit_test(test_copies),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
