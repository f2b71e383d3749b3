#include "locked.h"
#include <errno.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>

/* The file of the lock of measuring: where it is made, for whom, and what is refused in its place. */

/* Every user of the machine can lock what one of them has made, and one that may only be read is locked as well. */
static void test_is_for_everybody(void **state)
{
    (void)state;
    struct stat info;
    mode_t mask = umask(077);
    unlink(path);
    struct aob_measure_lock lock = take_lock();
    umask(mask);
    assert_int_equal(stat(path, &info), 0);
    assert_int_equal(info.st_mode & 0777, 0666);
    aob_measure_lock_release(&lock);
    chmod(path, 0444);
    lock = take_lock();
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
    int created = 0, watch = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    unlink(path);
    assert_true(inotify_add_watch(watch, folder, IN_CREATE | IN_ATTRIB) >= 0);
    struct aob_measure_lock lock = take_lock();
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

struct refusal {           /* of a call of the kernel */
    unsigned call, second; /* second: its argument; ANY: whatever that is */
};
#define ANY (~0u)

/* From now on the kernel refuses this process such calls. */
static bool go_without(const struct refusal *refusals, size_t count, unsigned cause)
{
    struct sock_filter code[64];
    unsigned short used = 0;
    for (size_t i = 0; i < count; i++) {
        const struct refusal *r = &refusals[i];
        const unsigned short test = r->second == ANY ? BPF_JGE : BPF_JEQ;
        const struct sock_filter rule[] = {
            BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
            BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, r->call, 0, 3),
            BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, args[1])),
            BPF_JUMP(BPF_JMP | test | BPF_K, r->second == ANY ? 0 : r->second, 0, 1),
            BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | cause),
        };
        memcpy(code + used, rule, sizeof rule);
        used += sizeof rule / sizeof *rule;
    }
    code[used++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    const struct sock_fprog program = {used, code};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/* As on vfat. */
static bool go_without_links_and_modes(void)
{
    static const struct refusal refused[] = {
        {SYS_linkat, ANY}, {SYS_fchmod, ANY}, {SYS_fchmodat, ANY},
#ifdef SYS_link /* newer processors have only those */
        {SYS_link, ANY},   {SYS_chmod, ANY},
#endif
    };
    return go_without(refused, sizeof refused / sizeof *refused, EPERM) && link(folder, path) != 0 &&
           errno == EPERM && chmod(folder, 0700) != 0 && errno == EPERM;
}

/* As on a network's file system that has no locks. */
static bool go_without_locks(void)
{
    static const struct refusal refused[] = {{SYS_flock, ANY}};
    return go_without(refused, 1, ENOLCK) && flock(STDIN_FILENO, LOCK_UN) != 0 && errno == ENOLCK;
}

static bool go_without_places(void)
{
    static const struct refusal refused[] = {{SYS_fcntl, F_OFD_SETLK}};
    struct flock none = {.l_type = F_UNLCK, .l_whence = SEEK_SET};
    return go_without(refused, 1, ENOLCK) && fcntl(STDIN_FILENO, F_OFD_SETLK, &none) != 0 && errno == ENOLCK;
}

/* The exit code of what a child does; -1: it hangs. */
static int in_child(int (*act)(void))
{
    int status = 0;
    pid_t pid = fork(), ended = 0;
    if (pid == 0)
        _exit(act());
    for (int i = 0; i < 6000 && (ended = waitpid(pid, &status, WNOHANG)) == 0; i++)
        usleep(10000);
    if (ended == 0) {
        kill(pid, SIGKILL);
        waitpid(pid, NULL, 0);
    }
    return ended == pid && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static int take_without_links_and_modes(void)
{
    struct aob_measure_lock lock = {0};
    if (!go_without_links_and_modes())
        return 2;
    return aob_measure_lock_take(&lock, NULL) && is_locked() ? 0 : 1;
}

static void test_needs_no_links_and_modes(void **state)
{
    (void)state;
    unlink(path);
    assert_int_equal(in_child(take_without_links_and_modes), 0);
}

static bool is_told(const struct aob_error *error)
{
    return strstr(error->text, path) && strstr(error->text, strerror(ENOLCK)) &&
           strstr(error->text, "AOBUDGET_LOCK");
}

static int check_without_locks(void)
{
    struct aob_error error = {{0}};
    if (!go_without_locks())
        return 2;
    return !aob_measure_lock_check(&error) && is_told(&error) ? 0 : 1;
}

static int take_without_locks(void)
{
    struct aob_measure_lock lock = {0};
    struct aob_error error = {{0}};
    if (!go_without_locks())
        return 2;
    return !aob_measure_lock_take(&lock, &error) && is_told(&error) ? 0 : 1;
}

static int take_without_places(void)
{
    struct aob_measure_lock lock = {0};
    if (!go_without_places())
        return 2;
    return aob_measure_lock_take(&lock, NULL) && is_locked() ? 0 : 1;
}

/* What the system refuses to lock ends with a line, also behind another one that never comes to its turn. */
static void test_cannot_be_locked(void **state)
{
    (void)state;
    assert_int_equal(in_child(check_without_locks), 0);
    assert_int_equal(in_child(take_without_locks), 0);
    int file = open(turn, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    struct flock first = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_len = 1};
    assert_int_equal(fcntl(file, F_OFD_SETLK, &first), 0);
    int code = in_child(take_without_locks);
    close(file);
    assert_int_equal(code, 0);
}

/* Where no place in the queue can be had, or somebody has all of them, there is the lock all the same. */
static void test_without_places(void **state)
{
    (void)state;
    struct aob_measure_lock lock = {0};
    assert_int_equal(in_child(take_without_places), 0);
    int file = open(turn, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    struct flock all = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    assert_int_equal(fcntl(file, F_OFD_SETLK, &all), 0);
    bool got = aob_measure_lock_take(&lock, NULL) && is_locked();
    aob_measure_lock_release(&lock);
    close(file);
    assert_true(got);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_is_for_everybody),         cmocka_unit_test(test_is_for_everybody_at_once),
        cmocka_unit_test(test_only_a_regular_file),      cmocka_unit_test(test_second_place),
        cmocka_unit_test(test_needs_no_links_and_modes), cmocka_unit_test(test_cannot_be_locked),
        cmocka_unit_test(test_without_places),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
