#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/sealed.h"
#include "check.h"
#include "store/cache.h"

static char folder[64];

static char *below(const char *name)
{
    static char paths[8][128];
    static int next;
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", folder, name);
    return path;
}

static int setup(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/aob-test-cache-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

/* Opens the cache in this folder; `line`: what the refusal says, NULL if it is none. */
static void assert_opens(const char *path, const char *line)
{
    struct aob_cache cache = {0};
    struct aob_error error = {{0}};
    setenv("AOBUDGET_CACHE", path, 1);
    bool ok = aob_cache_open(&cache, &error);
    if (ok == (line != NULL))
        fail_msg("%s: %s", path, ok ? "opened" : error.text);
    if (line) {
        assert_contains(error.text, line);
        assert_contains(error.text, "cache (set AOBUDGET_CACHE to move it): ");
    }
    aob_cache_close(&cache);
}

static void test_a_new_folder_is_the_users_alone(void **state)
{
    (void)state;
    struct stat info;
    mode_t mask = umask(0);
    assert_opens(below("new/deep/cache//"), NULL);
    umask(mask);
    assert_int_equal(stat(below("new/deep/cache"), &info), 0);
    assert_int_equal(info.st_mode & 07777, 0700);
    assert_opens(below("new/deep/cache"), NULL); /* again */
}

static void test_a_folder_that_others_may_write_in_is_refused(void **state)
{
    (void)state;
    static const mode_t good[] = {0700, 0755, 0750}, bad[] = {0777, 0770, 01777, 0702};
    mkdir(below("open"), 0700);
    for (size_t i = 0; i < 3; i++) {
        chmod(below("open"), good[i]);
        assert_opens(below("open"), NULL);
    }
    for (size_t i = 0; i < 4; i++) {
        chmod(below("open"), bad[i]);
        assert_opens(below("open"), "others may write");
    }
}

static void test_what_is_no_folder_is_refused(void **state)
{
    (void)state;
    mkdir(below("real"), 0700);
    assert_int_equal(symlink("real", below("link")), 0);
    assert_opens(below("link"), "it is a link");
    assert_opens(below("link/"), "it is a link");
    assert_int_equal(symlink("nowhere", below("dangling")), 0);
    assert_opens(below("dangling"), "it is a link");
    assert_false(aob_file_exists(below("nowhere")));
    assert_true(aob_file_write(below("file"), "x", 1, NULL));
    assert_opens(below("file"), "not a folder");
    assert_opens(below("file/below"), "folder");
}

/* As root a folder is given away; any other user finds one that is root's. */
static void test_a_folder_of_another_user_is_refused(void **state)
{
    (void)state;
    mkdir(below("theirs"), 0700);
    bool root = geteuid() == 0;
    if (root)
        assert_int_equal(chown(below("theirs"), 65534, 65534), 0);
    assert_opens(root ? below("theirs") : "/usr", root ? "belongs to user 65534" : "belongs to user 0");
}

static void assert_chosen(const char *own, const char *xdg, const char *home, const char *folder_wanted)
{
    struct aob_cache cache = {0};
    struct aob_error error = {{0}};
    setenv("AOBUDGET_CACHE", own, 1);
    setenv("XDG_CACHE_HOME", xdg, 1);
    setenv("HOME", home, 1);
    if (!aob_cache_open(&cache, &error))
        fail_msg("%s", error.text);
    assert_string_equal(cache.folder, folder_wanted);
    aob_cache_close(&cache);
}

static void test_where_it_lies(void **state)
{
    (void)state;
    assert_chosen(below("own"), below("xdg"), below("home"), below("own"));
    assert_chosen("", below("xdg"), below("home"), below("xdg/aobudget"));
    assert_chosen("", "", below("home"), below("home/.cache/aobudget"));
}

/* Without any of the three it is /tmp/aobudget-UID, which anybody may have made before. As root the test is a user that
 * nobody is. */
static int open_fallback(uid_t user)
{
    struct aob_cache cache = {0};
    struct aob_error error = {{0}};
    int status = 0;
    pid_t child = fork();
    if (child == 0) {
        unsetenv("AOBUDGET_CACHE");
        unsetenv("XDG_CACHE_HOME");
        unsetenv("HOME");
        if (geteuid() != user && seteuid(user) != 0)
            _exit(99);
        bool ok = aob_cache_open(&cache, &error);
        bool refused = strstr(error.text, "/tmp/aobudget-") && !strchr(error.text, '\n');
        aob_cache_close(&cache);
        _exit(ok ? 0 : refused ? 2 : 98);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void test_a_planted_fallback_is_refused(void **state)
{
    (void)state;
    char path[64];
    struct stat info;
    uid_t user = geteuid() == 0 ? 100000 + (uid_t)getpid() : geteuid();
    snprintf(path, sizeof path, "/tmp/aobudget-%ld", (long)user);
    if (user == geteuid() && lstat(path, &info) == 0) /* this user's own, in use */
        return assert_int_equal(open_fallback(user), info.st_mode & 022 ? 2 : 0);
    rmdir(path);
    assert_int_equal(symlink(folder, path), 0);
    assert_int_equal(open_fallback(user), 2);
    unlink(path);
    assert_int_equal(mkdir(path, 0777), 0);
    assert_int_equal(chmod(path, user == geteuid() ? 0777 : 0755),
                     0); /* as root: another's, however closed */
    assert_int_equal(open_fallback(user), 2);
    rmdir(path);
    assert_int_equal(open_fallback(user), 0);
    assert_true(lstat(path, &info) == 0 && info.st_uid == user && (info.st_mode & 0777) == 0700);
    rmdir(path);
}

/* What an older version wrote has no seal. It lies under names that are never asked for, and stays. */
static void test_names(void **state)
{
    (void)state;
    struct aob_cache cache = {(char *)"/c"};
    char key[AOB_KEY_SIZE], old[96];
    char *a = aob_cache_path(&cache, "mesh", "x", ".mesh"), *b = aob_cache_path(&cache, "mesh", "y", ".mesh"),
         *c = aob_cache_path(&cache, "gbuffer", "x", ".exr");
    assert_int_equal(strlen(a), strlen("/c/mesh-.mesh") + 32);
    assert_true(strcmp(a, b) != 0 && strncmp(c, "/c/gbuffer-", 11) == 0 && strcmp(c + 43, ".exr") == 0);
    aob_hash_text("x", key);
    snprintf(old, sizeof old, "/c/mesh-%s.mesh", key);
    assert_string_not_equal(a, old);
    free(a);
    free(b);
    free(c);
}

static void test_what_is_there_to_be_used(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    bool has = true;
    char *path = below("visibility-1.exr");
    assert_true(aob_cache_has(path, &has, &error) && !has);
    assert_true(aob_sealed_write(path, &(struct aob_piece){"truth", 5}, 1, NULL));
    assert_true(aob_cache_has(path, &has, &error) && has);
    assert_int_equal(truncate(path, 7), 0);
    assert_true(aob_cache_has(path, &has, &error) && !has);
    assert_int_equal(aob_file_size(path), 7); /* it is replaced when it is made again, not removed */
    assert_string_equal(error.text, "");
    unlink(path);
    mkdir(path, 0700);
    assert_false(aob_cache_has(path, &has, &error));
    assert_contains(error.text, "stays as it is");
    assert_ptr_equal(strstr(error.text, path), error.text);
}

static void test_old_parts_go_when_it_is_opened(void **state)
{
    (void)state;
    mkdir(below("parts"), 0700);
    assert_true(aob_file_write(below("parts/.aobudget-0123456789abcdef.part"), "x", 1, NULL));
    assert_true(aob_file_write(below("parts/visibility-1.exr.77.part"), "x", 1, NULL));
    assert_opens(below("parts"), NULL);
    assert_false(aob_file_exists(below("parts/.aobudget-0123456789abcdef.part")));
    assert_true(aob_file_exists(below("parts/visibility-1.exr.77.part"))); /* an older program may be at it */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_new_folder_is_the_users_alone),
        cmocka_unit_test(test_a_folder_that_others_may_write_in_is_refused),
        cmocka_unit_test(test_what_is_no_folder_is_refused),
        cmocka_unit_test(test_a_folder_of_another_user_is_refused),
        cmocka_unit_test(test_where_it_lies),
        cmocka_unit_test(test_a_planted_fallback_is_refused),
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_what_is_there_to_be_used),
        cmocka_unit_test(test_old_parts_go_when_it_is_opened),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
