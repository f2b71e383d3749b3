#include "check.h"
#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "timing/measure_lock.h"

/* The file of the lock of measuring: where it is made, for whom, and what is refused in its place. */

static char folder[] = "/tmp/aobudget-lock-file-XXXXXX", *path, *turn;

static int set_up(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    path = aob_path_join(folder, "lock");
    turn = aob_path_join(folder, "lock.turn");
    return setenv("AOBUDGET_LOCK", path, 1);
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    unlink(turn);
    free(path);
    free(turn);
    return rmdir(folder); /* which holds nothing else */
}

/* Whether somebody has what lies at the path. */
static bool is_locked(void)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    bool locked = file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0;
    if (file >= 0)
        close(file);
    return locked;
}

/* Every user of the machine can lock what one of them has made, and one that may only be read is locked as well. */
static void test_is_for_everybody(void **state)
{
    (void)state;
    struct aob_measure_lock lock = {0};
    struct stat info;
    mode_t mask = umask(077);
    unlink(path);
    assert_true(aob_measure_lock_take(&lock, NULL));
    umask(mask);
    assert_int_equal(stat(path, &info), 0);
    assert_int_equal(info.st_mode & 0777, 0666);
    aob_measure_lock_release(&lock);
    chmod(path, 0444);
    assert_true(aob_measure_lock_take(&lock, NULL));
    assert_true(is_locked());
    aob_measure_lock_release(&lock);
}

/* Nobody ever finds it shut: its mode does not change once it has its name. */
static void test_is_for_everybody_at_once(void **state)
{
    (void)state;
    union {
        struct inotify_event first;
        char bytes[8192];
    } events;
    struct aob_measure_lock lock = {0};
    int created = 0, watch = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    unlink(path);
    assert_true(inotify_add_watch(watch, folder, IN_CREATE | IN_ATTRIB) >= 0);
    assert_true(aob_measure_lock_take(&lock, NULL));
    aob_measure_lock_release(&lock);
    ssize_t size = read(watch, events.bytes, sizeof events.bytes);
    assert_true(size > 0);
    for (ssize_t at = 0; at < size;) {
        const struct inotify_event *event = (const void *)(events.bytes + at);
        if (strcmp(event->name, "lock") == 0) {
            assert_true(event->mask & IN_CREATE);
            created++;
        }
        at += (ssize_t)(sizeof *event + event->len);
    }
    assert_int_equal(created, 1);
    close(watch);
}

static void refuse(const char *cause)
{
    struct aob_measure_lock lock = {0};
    struct aob_error error = {{0}};
    assert_false(aob_measure_lock_check(&error));
    assert_contains(error.text, path);
    assert_contains(error.text, cause);
    assert_contains(error.text, "AOBUDGET_LOCK");
    assert_false(aob_measure_lock_take(&lock, &error));
    aob_measure_lock_release(&lock);
}

static void test_only_a_regular_file(void **state)
{
    (void)state;
    unlink(path);
    assert_int_equal(symlink("/dev/null", path), 0);
    refuse("symbolic links");
    unlink(path);
    assert_int_equal(mkfifo(path, 0666), 0);
    refuse("no regular file");
    unlink(path);
    assert_int_equal(mkdir(path, 0777), 0);
    refuse("directory");
    rmdir(path);
}

/* The second place serves where nothing lies at the first and nothing can. What is there and cannot be used may be held. */
static void test_second_place(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    char *nowhere = aob_path_join(folder, "none/lock");
    const char *const places[] = {nowhere, path, NULL}, *const twice[] = {path, nowhere, NULL}, *chosen;
    int file = aob_measure_lock_open(places, &chosen, &error);
    assert_true(file >= 0 && chosen == path && !*error.text);
    close(file);
    unlink(path);
    assert_int_equal(symlink("/dev/null", path), 0);
    assert_int_equal(aob_measure_lock_open(twice, &chosen, &error), -1);
    assert_contains(error.text, "symbolic links");
    assert_int_equal(aob_measure_lock_open(places, &chosen, NULL), -1);
    unlink(path);
    free(nowhere);
}

/* From now on this process has no calls for second names and for modes, as on vfat. */
static bool go_without_links_and_modes(void)
{
    static const unsigned refused[] = {
        SYS_linkat, SYS_fchmod, SYS_fchmodat,
#ifdef SYS_link /* newer processors have only those */
        SYS_link,   SYS_chmod,
#endif
    };
    struct sock_filter code[2 * sizeof refused / sizeof *refused + 2];
    unsigned short count = 0;
    code[count++] = (struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr));
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        code[count++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, refused[i], 0, 1);
        code[count++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
    }
    code[count++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    const struct sock_fprog program = {count, code};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0 && link(folder, path) != 0 &&
           errno == EPERM && chmod(folder, 0700) != 0 && errno == EPERM;
}

static void test_needs_no_links_and_modes(void **state)
{
    (void)state;
    int status;
    unlink(path);
    pid_t pid = fork();
    if (pid == 0) {
        struct aob_measure_lock lock = {0};
        if (!go_without_links_and_modes())
            _exit(2);
        _exit(aob_measure_lock_take(&lock, NULL) && is_locked() ? 0 : 1);
    }
    assert_int_equal(waitpid(pid, &status, 0), pid);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_is_for_everybody),         cmocka_unit_test(test_is_for_everybody_at_once),
        cmocka_unit_test(test_only_a_regular_file),      cmocka_unit_test(test_second_place),
        cmocka_unit_test(test_needs_no_links_and_modes),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
