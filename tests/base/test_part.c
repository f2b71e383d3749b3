/* Files while they are written. The test gives the program its random numbers and its locks, so that the names are known
 * and a cleaner can come at any time. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "base/part.h"
#include "check.h"

static char folder[64];
static uint64_t numbers[4] = {1, 2, 3, 4};
static size_t number_at;
static char *lost_before_lock; /* a part that a cleaner removes before its writer has the lock; NULL: none */

ssize_t getrandom(void *into, size_t size, unsigned flags)
{
    (void)flags;
    memcpy(into, &numbers[number_at], size);
    number_at += number_at < 3;
    return (ssize_t)size;
}

int flock(int file, int operation)
{
    if (lost_before_lock)
        unlink(lost_before_lock);
    lost_before_lock = NULL;
    return (int)syscall(SYS_flock, file, operation);
}

static char *path_of(const char *name)
{
    static char paths[8][128];
    static int next;
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

static char *part_of(int number)
{
    char name[64];
    snprintf(name, sizeof name, ".aobudget-%016x.part", (unsigned)number);
    return path_of(name);
}

static int count_files(void)
{
    int count = -2; /* . and .. */
    DIR *directory = opendir(folder);
    while (readdir(directory))
        count++;
    closedir(directory);
    return count;
}

static void assert_holds(const char *path, const char *text)
{
    size_t size;
    char *bytes = aob_file_read(path, 4096, &size, NULL);
    assert_non_null(bytes);
    assert_string_equal(bytes, text);
    free(bytes);
}

static int start(void **state)
{
    (void)state;
    number_at = 0;
    snprintf(folder, sizeof folder, "/tmp/aob-test-part-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int end(void **state)
{
    (void)state;
    DIR *directory = opendir(folder);
    for (struct dirent *entry; (entry = readdir(directory));)
        if (entry->d_name[0] != '.' || strlen(entry->d_name) > 2)
            remove(path_of(entry->d_name));
    closedir(directory);
    return rmdir(folder);
}

static void test_a_file_is_whole_and_alone(void **state)
{
    (void)state;
    struct stat info;
    mode_t mask = umask(027);
    assert_true(aob_file_write(path_of("a"), "whole", 5, NULL));
    umask(mask);
    assert_holds(path_of("a"), "whole");
    assert_int_equal(count_files(), 1);
    assert_int_equal(stat(path_of("a"), &info), 0);
    assert_int_equal(info.st_mode & 0777, 0640);
}

/* Whoever plants a link under the temporary name gets nothing written through it, whether it leads anywhere or not. */
static void test_a_planted_link_is_not_followed(void **state)
{
    (void)state;
    struct stat info;
    char old[64];
    assert_true(aob_file_write(path_of("victim"), "mine", 4, NULL));
    number_at = 0;
    snprintf(old, sizeof old, "a.%ld.part", (long)getpid()); /* what the name once was */
    assert_int_equal(symlink("victim", path_of(old)), 0);
    assert_int_equal(symlink("victim", part_of(1)), 0);
    assert_int_equal(symlink("nowhere", part_of(2)), 0);
    assert_true(aob_file_write(path_of("a"), "whole", 5, NULL));
    assert_holds(path_of("a"), "whole");
    assert_holds(path_of("victim"), "mine");
    assert_false(aob_file_exists(path_of("nowhere")));
    assert_true(lstat(path_of("a"), &info) == 0 && S_ISREG(info.st_mode));
    assert_true(lstat(part_of(1), &info) == 0 && S_ISLNK(info.st_mode));
    /* Nor is one removed or followed by the cleaner. */
    aob_part_clean(folder);
    assert_true(lstat(part_of(1), &info) == 0 && lstat(part_of(2), &info) == 0);
    assert_holds(path_of("victim"), "mine");
}

static void test_no_free_name_is_one_line(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    for (int i = 1; i <= 4; i++)
        assert_int_equal(symlink("x", part_of(i)), 0);
    assert_false(aob_file_write(path_of("a"), "x", 1, &error));
    assert_contains(error.text, path_of("a: cannot write: File exists"));
    assert_false(aob_file_write(path_of("none/a"), "x", 1, &error));
    assert_contains(error.text, "none/a: cannot write: No such file");
}

static void test_a_dead_writer_leaves_the_old_file_and_a_part(void **state)
{
    (void)state;
    assert_true(aob_file_write(path_of("a"), "old", 3, NULL));
    pid_t child = fork();
    if (child == 0) {
        struct aob_part part;
        if (aob_part_create(&part, path_of("a"), NULL) && aob_part_write(&part, "ne", 2, NULL))
            kill(getpid(), SIGKILL);
        _exit(1);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_holds(path_of("a"), "old");
    assert_int_equal(count_files(), 2);
    aob_part_clean(folder);
    assert_int_equal(count_files(), 1);
    assert_holds(path_of("a"), "old");
}

/* Another program may be at it at this moment. */
static void test_a_living_writer_keeps_its_part(void **state)
{
    (void)state;
    struct aob_part part;
    assert_true(aob_part_create(&part, path_of("a"), NULL));
    assert_true(aob_part_write(&part, "half", 4, NULL));
    aob_part_clean(folder);
    assert_true(aob_part_write(&part, "done", 4, NULL));
    assert_true(aob_part_keep(&part, NULL));
    assert_holds(path_of("a"), "halfdone");
    assert_int_equal(count_files(), 1);
}

static void test_a_cleaner_between_the_file_and_its_lock(void **state)
{
    (void)state;
    lost_before_lock = part_of(1);
    assert_true(aob_file_write(path_of("a"), "whole", 5, NULL));
    assert_null(lost_before_lock);
    assert_holds(path_of("a"), "whole");
    assert_int_equal(count_files(), 1);
}

static void test_only_parts_are_cleaned(void **state)
{
    (void)state;
    static const char *const kept[] = {"a.part",
                                       ".aobudget-1.part",
                                       ".aobudget-00000000000000AB.part",
                                       ".aobudget-0000000000000001.part~",
                                       ".aobudgetX0000000000000001.part",
                                       "x.aobudget-0000000000000001.part"};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        assert_int_equal(close(open(path_of(kept[i]), O_CREAT | O_WRONLY, 0600)), 0);
    assert_int_equal(close(open(part_of(7), O_CREAT | O_WRONLY, 0600)), 0);
    assert_int_equal(mkdir(part_of(8), 0700), 0);
    aob_part_clean(folder);
    assert_int_equal(count_files(), 7);
    assert_false(aob_file_exists(part_of(7)));
    aob_part_clean("/nonexistent");
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, start, end)
    const struct CMUnitTest tests[] = {
        TEST(test_a_file_is_whole_and_alone),      TEST(test_a_planted_link_is_not_followed),
        TEST(test_no_free_name_is_one_line),       TEST(test_a_dead_writer_leaves_the_old_file_and_a_part),
        TEST(test_a_living_writer_keeps_its_part), TEST(test_a_cleaner_between_the_file_and_its_lock),
        TEST(test_only_parts_are_cleaned),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
