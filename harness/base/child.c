#define _GNU_SOURCE 1 /* memfd_create, pipe2, sigdescr_np, strcasestr */
#include "child.h"
#include "deadline.h"
#include "file.h"
#include "memory.h"
#include "stream.h"
#include "text.h"
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* AddressSanitizer reserves terabytes of address space, so it cannot run under a limit of address space. It watches
 * resident memory instead. */
#ifdef __SANITIZE_ADDRESS__
static const bool limits_memory = false;
#else
static const bool limits_memory = true;
#endif

/* More than any job answers, and so little that this process does not feel it. */
enum { LINE_LIMIT = 16 << 20, OUTPUT_LIMIT = 64 << 20 };

struct complaint {
    char *text; /* the result's */
    bool says_error;
};

struct child {
    pid_t pid;
    int input, start_pipe[2], out_pipe[2], err_pipe[2];
    char **env;
    char *sanitizer; /* "ASAN_OPTIONS=..." with the memory limit; NULL where the kernel holds it */
};

/* One blank for each stretch of blanks and control characters; none at the begin. */
static void collapse_blanks(char *text)
{
    char *to = text;
    for (const char *from = text; *from; from++) {
        bool blank = *from == ' ' || iscntrl((unsigned char)*from);
        if (!blank)
            *to++ = *from;
        else if (to > text && to[-1] != ' ')
            *to++ = ' ';
    }
    *to = '\0';
}

static void take_complaint(void *user, const char *line)
{
    struct complaint *complaint = user;
    bool says_error = strcasestr(line, "error") != NULL;
    if (!line[strspn(line, " \t\r")] || (complaint->says_error && !says_error))
        return;
    complaint->says_error = says_error;
    aob_line_print(complaint->text, sizeof((struct aob_child_result *)0)->complaint, "%s", line);
    collapse_blanks(complaint->text);
}

static bool same_name(const char *a, const char *b)
{
    size_t size = strcspn(a, "=");
    return size == strcspn(b, "=") && !strncmp(a, b, size);
}

static bool is_replaced(const char *variable, const char *const *extra)
{
    for (; extra && *extra; extra++)
        if (same_name(variable, *extra))
            return true;
    return false;
}

static char **merge_environment(const char *const *extra)
{
    char **merged = NULL;
    size_t count = 0, capacity = 0;
    for (char **variable = environ; variable && *variable; variable++)
        if (!is_replaced(*variable, extra))
            *AOB_PUSH(merged, count, capacity) = *variable;
    for (; extra && *extra; extra++)
        *AOB_PUSH(merged, count, capacity) = (char *)*extra;
    *AOB_PUSH(merged, count, capacity) = NULL;
    return merged;
}

/* The input is a file in memory and not a pipe, so nothing has to be fed while the child runs, and no SIGPIPE comes
 * if the child does not read. */
static int open_input(const char *input, size_t size)
{
    if (!input)
        return open("/dev/null", O_RDONLY | O_CLOEXEC);
    int fd = memfd_create("aobudget-input", MFD_CLOEXEC);
    if (fd >= 0 && aob_file_send(fd, input, size) && lseek(fd, 0, SEEK_SET) == 0)
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

static void close_fd(int *fd)
{
    if (*fd >= 0)
        close(*fd);
    *fd = -1;
}

static void child_finish(struct child *child)
{
    int *fds[] = {&child->input,       &child->start_pipe[0], &child->start_pipe[1], &child->out_pipe[0],
                  &child->out_pipe[1], &child->err_pipe[0],   &child->err_pipe[1]};
    for (size_t i = 0; i < AOB_COUNT(fds); i++)
        close_fd(fds[i]);
    free(child->env);
    free(child->sanitizer);
    child->env = NULL;
    child->sanitizer = NULL;
}

static char *sanitizer_limit(size_t bytes)
{
    struct aob_text text = {0};
    const char *set = getenv("ASAN_OPTIONS");
    aob_text_add(&text, "ASAN_OPTIONS=%s%shard_rss_limit_mb=%zu", set ? set : "", set ? ":" : "",
                 bytes >> 20);
    return text.data;
}

static char **child_environment(struct child *child, const struct aob_child_desc *desc)
{
    size_t count = 0;
    const char **extra = NULL;
    if (limits_memory || !desc->memory_limit)
        return merge_environment(desc->env);
    while (desc->env && desc->env[count])
        count++;
    extra = AOB_NEW_ARRAY(const char *, count + 2);
    for (size_t i = 0; i < count; i++)
        extra[i] = desc->env[i];
    extra[count] = child->sanitizer = sanitizer_limit(desc->memory_limit);
    char **merged = merge_environment(extra);
    free(extra);
    return merged;
}

static bool child_prepare(struct child *child, const struct aob_child_desc *desc)
{
    *child = (struct child){.input = -1, .start_pipe = {-1, -1}, .out_pipe = {-1, -1}, .err_pipe = {-1, -1}};
    child->env = child_environment(child, desc);
    child->input = open_input(desc->input, desc->input_size);
    return child->input >= 0 && !pipe2(child->start_pipe, O_CLOEXEC) && !pipe2(child->out_pipe, O_CLOEXEC) &&
           !pipe2(child->err_pipe, O_CLOEXEC) && !fcntl(child->out_pipe[0], F_SETFL, O_NONBLOCK) &&
           !fcntl(child->err_pipe[0], F_SETFL, O_NONBLOCK);
}

/* The user's own limits stand where they are narrower: the soft one was meant, and the hard one cannot be raised. */
static bool narrow_limit(int resource, rlim_t wanted)
{
    struct rlimit limit;
    if (getrlimit(resource, &limit) != 0)
        return false;
    limit.rlim_cur = wanted < limit.rlim_cur ? wanted : limit.rlim_cur;
    limit.rlim_max = wanted < limit.rlim_max ? wanted : limit.rlim_max;
    return setrlimit(resource, &limit) == 0;
}

/* This runs between fork and exec, so nothing here may allocate or lock. */
static void __attribute__((noreturn)) become(const struct child *child, const struct aob_child_desc *desc)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    bool ready = narrow_limit(RLIMIT_CORE, 0) && dup2(child->input, 0) >= 0 &&
                 dup2(child->out_pipe[1], 1) >= 0 && dup2(child->err_pipe[1], 2) >= 0;
    if (ready && limits_memory && desc->memory_limit)
        ready = narrow_limit(RLIMIT_AS, desc->memory_limit);
    if (ready)
        execve(desc->argv[0], (char *const *)desc->argv, child->env);
    int cause = errno;
    while (write(child->start_pipe[1], &cause, sizeof cause) < 0 && errno == EINTR)
        continue;
    _exit(127);
}

/* The start pipe closes by itself when exec succeeds, and carries errno when it does not. */
static int start_error(struct child *child)
{
    int cause = 0;
    ssize_t count;
    do
        count = read(child->start_pipe[0], &cause, sizeof cause);
    while (count < 0 && errno == EINTR);
    return count == sizeof cause ? cause : 0;
}

static bool child_start(struct child *child, const struct aob_child_desc *desc, struct aob_error *error)
{
    if (!child_prepare(child, desc) || (child->pid = fork()) < 0) {
        aob_fail(error, "%s: cannot start a process: %s", desc->argv[0], strerror(errno));
        child_finish(child);
        return false;
    }
    if (!child->pid)
        become(child, desc);
    setpgid(child->pid, child->pid);
    close_fd(&child->input);
    close_fd(&child->start_pipe[1]);
    close_fd(&child->out_pipe[1]);
    close_fd(&child->err_pipe[1]);
    int cause = start_error(child);
    if (!cause)
        return true;
    aob_fail(error, "%s: cannot start this program: %s", desc->argv[0], strerror(cause));
    waitpid(child->pid, NULL, 0);
    child_finish(child);
    return false;
}

/* The child stays a zombie, so that its group's number is still its own when the group is killed. */
static bool has_ended(pid_t pid)
{
    siginfo_t info = {0};
    return waitid(P_PID, (id_t)pid, &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == pid;
}

static bool is_excess(const struct aob_stream *stream, const char *name, char excess[64])
{
    char what[40];
    if (!aob_stream_is_broken(stream, what, sizeof what))
        return false;
    snprintf(excess, 64, "%s on standard %s", what, name);
    return true;
}

/* Waits until the child ends, its time is up, or it writes too much. */
static void follow(pid_t pid, double timeout_s, struct aob_stream *out, struct aob_stream *err,
                   struct aob_child_result *result)
{
    struct aob_deadline deadline;
    aob_deadline_init(&deadline, pid, timeout_s);
    while (!has_ended(pid)) {
        result->timed_out = aob_deadline_passed(&deadline);
        memcpy(result->limit, deadline.text, sizeof result->limit);
        if (result->timed_out || is_excess(out, "output", result->excess) ||
            is_excess(err, "error", result->excess))
            return;
        struct pollfd fds[] = {{.fd = out->fd, .events = POLLIN}, {.fd = err->fd, .events = POLLIN}};
        bool closed = out->fd < 0 && err->fd < 0;
        poll(fds, AOB_COUNT(fds), closed ? 1 : 20);
        if (fds[0].revents)
            aob_stream_read(out);
        if (fds[1].revents)
            aob_stream_read(err);
    }
}

static void reap(pid_t pid, struct aob_child_result *result)
{
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
        continue;
    if (WIFEXITED(status))
        result->exit_code = WEXITSTATUS(status);
    else if (WIFSIGNALED(status))
        result->signal = WTERMSIG(status);
}

bool aob_child_run(const struct aob_child_desc *desc, struct aob_child_result *result,
                   struct aob_error *error)
{
    *result = (struct aob_child_result){.exit_code = -1};
    struct child child;
    if (!child_start(&child, desc, error))
        return false;
    struct complaint complaint = {.text = result->complaint};
    size_t limit = desc->output_limit ? desc->output_limit : OUTPUT_LIMIT;
    struct aob_stream out = {child.out_pipe[0], LINE_LIMIT, limit, desc->on_line, desc->user, .size = 0};
    struct aob_stream err = {child.err_pipe[0], LINE_LIMIT, limit, take_complaint, &complaint, .size = 0};
    child.out_pipe[0] = child.err_pipe[0] = -1;

    follow(child.pid, desc->timeout_s, &out, &err, result);
    kill(-child.pid, SIGKILL);
    reap(child.pid, result);
    aob_stream_finish(&out, !result->signal && !result->timed_out);
    aob_stream_finish(&err, true);
    child_finish(&child);
    return true;
}

size_t aob_child_memory(size_t limit)
{
    struct rlimit own;
    if (getrlimit(RLIMIT_AS, &own) == 0 && own.rlim_cur != RLIM_INFINITY && (!limit || own.rlim_cur < limit))
        return (size_t)own.rlim_cur;
    return limit;
}

static void explain_signal(const struct aob_child_desc *desc, const struct aob_child_result *result,
                           char *text, size_t size)
{
    const char *colon = result->complaint[0] ? ": " : "", *known = sigdescr_np(result->signal);
    size_t allowed = aob_child_memory(desc->memory_limit);
    char name[64];
    if (strstr(result->complaint, "bad_alloc")) { /* what C++ says before it aborts */
        snprintf(name, sizeof name, allowed ? " (its limit is %zu MiB)" : "", allowed >> 20);
        snprintf(text, size, "not enough memory%s: %s", name, result->complaint);
        return;
    }
    snprintf(name, sizeof name, "%s", known ? known : "unknown");
    name[0] = (char)tolower((unsigned char)name[0]);
    snprintf(text, size, "crashed (signal %d, %s)%s%s", result->signal, name, colon, result->complaint);
}

void aob_child_explain(const struct aob_child_desc *desc, const struct aob_child_result *result, char *text,
                       size_t size)
{
    const char *colon = result->complaint[0] ? ": " : "";
    if (result->timed_out)
        snprintf(text, size, "%s", result->limit);
    else if (*result->excess)
        snprintf(text, size, "wrote %s, and was stopped", result->excess);
    else if (result->signal)
        explain_signal(desc, result, text, size);
    else
        snprintf(text, size, "exit code %d%s%s", result->exit_code, colon, result->complaint);
}
