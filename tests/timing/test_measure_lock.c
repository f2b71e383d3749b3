#include "locked.h"
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>

/* A second process waits for the first, says so in one line, and has the lock when it is given back. */

struct
    other { /* process that takes the lock so many times and keeps it: its standard error, and a byte for each time that it has it */
    pid_t pid;
    int said, got;
};

static void be_other(int takes, int said, int got)
{
    struct aob_measure_lock lock = {0};
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* of a test that failed nothing is left over */
    dup2(said, STDERR_FILENO);
    for (int i = 1; i <= takes; i++) {
        if (!aob_measure_lock_take(&lock, NULL) || !aob_file_send(got, "x", 1))
            _exit(1);
        if (i < takes)
            aob_measure_lock_release(&lock);
    }
    pause(); /* it holds the lock until it is killed */
}

static struct other start_other(int takes)
{
    int said[2], got[2];
    assert_true(pipe2(said, O_CLOEXEC) == 0 && pipe2(got, O_CLOEXEC) == 0);
    struct other other = {fork(), said[0], got[0]};
    if (other.pid == 0)
        be_other(takes, said[1], got[1]);
    close(said[1]);
    close(got[1]);
    return other;
}

static void end_other(struct other *other)
{
    kill(other->pid, SIGKILL);
    waitpid(other->pid, NULL, 0);
    close(other->said);
    close(other->got);
}

static bool comes(int file, int ms)
{
    struct pollfd poll_file = {.fd = file, .events = POLLIN};
    return poll(&poll_file, 1, ms) == 1;
}

static void read_line(int file, char line[256])
{
    size_t used = 0;
    while (used < 255 && comes(file, 60000) && read(file, line + used, 1) == 1 && line[used] != '\n')
        used++;
    line[used] = '\0';
}

static void test_waits_and_tells(void **state)
{
    (void)state;
    char line[256], expected[64], byte;
    struct aob_measure_lock lock = take_lock();
    struct other other = start_other(2);
    snprintf(expected, sizeof expected, "waiting for process %d, which has measured since ", (int)getpid());
    read_line(other.said, line);
    assert_contains(line, expected);
    assert_contains(line, path);
    assert_false(comes(other.got, 200)); /* it waits for as long as this takes */
    aob_measure_lock_release(&lock);
    assert_int_equal(read(other.got, &byte, 1), 1);
    assert_int_equal(read(other.got, &byte, 1), 1);
    assert_true(is_locked());
    assert_false(comes(other.said, 0));
    end_other(&other);
    lock = take_lock(); /* who is dead holds nothing */
    aob_measure_lock_release(&lock);
    assert_false(is_locked());
}

/* How many have a place in the queue. */
static int waiting(void)
{
    int file = open(turn, O_RDONLY | O_CLOEXEC), count = 0;
    struct flock place = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    while (file >= 0 && fcntl(file, F_OFD_GETLK, &place) == 0 && place.l_type != F_UNLCK) {
        count++;
        place = (struct flock){.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = place.l_start + 1};
    }
    if (file >= 0)
        close(file);
    return count;
}

/* Takes the lock again and again, writes its letter each time, and gives it back as soon as all others wait. */
static void take_for_ever(char letter, int order, int others)
{
    struct aob_measure_lock lock = {.told = true};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (;;) {
        if (!aob_measure_lock_take(&lock, NULL) || write(order, &letter, 1) != 1)
            _exit(1);
        while (waiting() < others)
            usleep(1000);
        aob_measure_lock_release(&lock);
    }
}

/* Who has measured, and waits for the next: it reads whom it waits for, and not its own number. */
static void be_former(int said, int got)
{
    struct aob_measure_lock lock = {0};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(said, STDERR_FILENO);
    if (!aob_measure_lock_take(&lock, NULL) || !aob_file_send(got, "x", 1))
        _exit(1);
    while (waiting() == 0)
        usleep(1000);
    aob_measure_lock_release(&lock);
    aob_measure_lock_take(&lock, NULL);
    _exit(0);
}

static void test_former_holder_waits(void **state)
{
    (void)state;
    int said[2], got[2];
    char line[256], expected[64], byte;
    assert_true(pipe2(said, O_CLOEXEC) == 0 && pipe2(got, O_CLOEXEC) == 0);
    struct other former = {fork(), said[0], got[0]};
    if (former.pid == 0)
        be_former(said[1], got[1]);
    close(said[1]);
    close(got[1]);
    assert_int_equal(read(former.got, &byte, 1), 1);
    struct other next = start_other(1);
    read_line(former.said, line);
    snprintf(expected, sizeof expected, "waiting for process %d, which", (int)next.pid);
    end_other(&next);
    end_other(&former);
    assert_contains(line, expected);
}

/* Whose turn it is may be stopped: the others measure all the same. */
static void test_stopped_waiter(void **state)
{
    (void)state;
    char line[256];
    int status;
    struct aob_measure_lock lock = take_lock();
    struct other stopped = start_other(1);
    read_line(stopped.said, line);
    assert_int_equal(kill(stopped.pid, SIGSTOP), 0);
    assert_true(waitpid(stopped.pid, &status, WUNTRACED) == stopped.pid && WIFSTOPPED(status));
    aob_measure_lock_release(&lock);
    assert_int_equal(waiting(), 1);
    struct other next = start_other(1);
    bool came = comes(next.got, 60000);
    bool locked = is_locked();
    end_other(&next); /* before anything is asserted: who is left over would hold the turn in the next test */
    end_other(&stopped);
    assert_true(came && locked);
}

/* Four that want it without end: they have it in turn, so who returns at once is behind all that wait. */
static void test_in_turn(void **state)
{
    (void)state;
    enum { COUNT = 4, TAKES = 40 };
    pid_t pids[COUNT];
    int order[2], taken = 0;
    char letters[TAKES];
    assert_int_equal(pipe2(order, O_CLOEXEC), 0);
    for (int i = 0; i < COUNT; i++)
        if ((pids[i] = fork()) == 0)
            take_for_ever((char)('a' + i), order[1], COUNT - 1);
    close(order[1]);
    while (taken < TAKES && comes(order[0], 60000) && read(order[0], &letters[taken], 1) == 1)
        taken++;
    for (int i = 0; i < COUNT; i++) { /* before anything is asserted */
        kill(pids[i], SIGKILL);
        waitpid(pids[i], NULL, 0);
    }
    close(order[0]);
    assert_int_equal(taken, TAKES);
    for (int i = 0; i < COUNT; i++)
        assert_non_null(memchr(letters, 'a' + i, COUNT));
    for (int t = COUNT; t < TAKES; t++)
        assert_int_equal(letters[t], letters[t - COUNT]);
}

/* A file that is removed meanwhile: the next one locks what lies there then, and so must who has waited. */
static void test_removed_while_waiting(void **state)
{
    (void)state;
    char line[256], byte;
    struct aob_measure_lock lock = take_lock();
    struct other other = start_other(1);
    read_line(other.said, line);
    unlink(path);
    aob_measure_lock_release(&lock);
    assert_int_equal(read(other.got, &byte, 1), 1);
    assert_true(is_locked());
    end_other(&other);
}

/* What stands in the file is anybody's. */
static void test_content_is_not_trusted(void **state)
{
    (void)state;
    static const char *const texts[] = {"\033[2J1\n", "12 34\n", "999999999999999999999\n", "", "\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct aob_measure_lock lock = take_lock();
        char line[256];
        int file = open(path, O_WRONLY | O_TRUNC | O_CLOEXEC);
        assert_true(file >= 0 && aob_file_send(file, texts[i], strlen(texts[i])));
        close(file);
        struct other other = start_other(2);
        read_line(other.said, line);
        assert_contains(line, "waiting for another process, which has measured since ");
        aob_measure_lock_release(&lock);
        end_other(&other);
    }
}

/* Without a second file there are no turns, but there is the lock. */
static void test_without_turns(void **state)
{
    (void)state;
    unlink(turn);
    assert_int_equal(symlink("/dev/null", turn), 0);
    struct aob_measure_lock lock = take_lock();
    assert_true(is_locked());
    aob_measure_lock_release(&lock);
    unlink(turn);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_waits_and_tells),        cmocka_unit_test(test_removed_while_waiting),
        cmocka_unit_test(test_content_is_not_trusted), cmocka_unit_test(test_in_turn),
        cmocka_unit_test(test_former_holder_waits),    cmocka_unit_test(test_stopped_waiter),
        cmocka_unit_test(test_without_turns)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
