#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "base/file.h"
#include "check.h"
#include "store/run_folder.h"

#define LINE "{\"key\":\"k\"}\n"
static const char *const files[] = {
    "images/0123456789abcdef0123456789abcdef.exr", "truths/0123456789abcdef0123456789abcdef.exr",
    "rounds/0123456789abcdef0123456789abcdef.jsonl.zst", AOB_RUN_FOLDER_CONFLICTS, "images/mine.exr"};
enum { FILES = sizeof files / sizeof *files, OWN = FILES - 1 /* of a user */ };

static char *make_folder(char *template)
{
    static const char *const folders[] = {"images", "truths", "rounds"};
    assert_non_null(mkdtemp(template));
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        char *path = aob_path_join(template, folders[i]);
        assert_true(aob_folder_create(path, NULL));
        free(path);
    }
    for (size_t i = 0; i < FILES; i++) {
        char *path = aob_path_join(template, files[i]);
        assert_true(aob_file_write(path, "x", 1, NULL));
        free(path);
    }
    return aob_path_join(template, "journal.jsonl");
}

static size_t count_files(const char *folder)
{
    size_t count = 0;
    for (size_t i = 0; i < FILES; i++) {
        char *path = aob_path_join(folder, files[i]);
        count += aob_file_exists(path);
        free(path);
    }
    return count;
}

static bool start_afresh(const char *path, struct aob_error *error)
{
    struct aob_run_folder folder;
    json_t *info = json_object();
    bool ok = aob_run_folder_open(&folder, path, info, true, error);
    aob_run_folder_close(&folder);
    json_decref(info);
    return ok;
}

static void remove_folder(const char *folder)
{
    char command[64];
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

static void test_fresh(void **state)
{
    (void)state;
    char folder[] = "/tmp/aobudget-folder-XXXXXX", *journal = make_folder(folder);
    assert_true(aob_file_write(journal, LINE, sizeof LINE - 1, NULL));
    assert_true(start_afresh(folder, NULL));
    assert_true(aob_file_exists(journal));
    assert_int_equal(aob_file_size(journal), 0);
    assert_int_equal(count_files(folder), 1);
    char *own = aob_path_join(folder, files[OWN]);
    assert_true(aob_file_exists(own));
    free(own);
    free(journal);
    remove_folder(folder);
}

/* Records go before their files: a journal that cannot be emptied, since it lies in memory that must not shrink, keeps all of
 * them. So a call that is killed in between leaves no records without files. */
static void test_order(void **state)
{
    (void)state;
    char folder[] = "/tmp/aobudget-folder-XXXXXX", *journal = make_folder(folder), target[32];
    int memory = memfd_create("journal", MFD_ALLOW_SEALING);
    struct aob_error error = {{0}};
    assert_int_equal(write(memory, LINE, sizeof LINE - 1), sizeof LINE - 1);
    assert_int_equal(fcntl(memory, F_ADD_SEALS, F_SEAL_SHRINK), 0);
    snprintf(target, sizeof target, "/proc/self/fd/%d", memory);
    assert_int_equal(symlink(target, journal), 0);
    assert_false(start_afresh(folder, &error));
    assert_contains(error.text, "cannot empty the journal: Operation not permitted");
    assert_int_equal(count_files(folder), FILES);
    assert_int_equal(aob_file_size(journal), sizeof LINE - 1);
    close(memory);
    free(journal);
    remove_folder(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_fresh), cmocka_unit_test(test_order)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
