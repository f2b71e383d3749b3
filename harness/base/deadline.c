#include "deadline.h"
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "clock.h"

static const double look_s = 0.05; /* from one look to the next */
static const double quiet_s = 10;  /* at most; what sleeps so long waits for something that does not come */
static const double wall_factor =
    20; /* a load of 40 on two cores; nothing but threads that come and go gets there */

/* What naps a millisecond at a time uses 1 to 2 % of a processor. */
static const double nap_limits = 3, nap_share = 0.05;

/* What the threads of a process have done by now. */
struct effort {
    double busiest_s, all_s; /* processor time: of the thread that has most, of all of them */
    bool awake;              /* one of them runs, waits for a processor or waits for a disk */
};

/* The fields of /proc/PID/task/TID/stat behind the name, which may hold blanks and brackets: state is the first, utime
 * and stime are the 12th and the 13th (proc(5)). */
static void add_thread(struct effort *effort, const char *stat)
{
    unsigned long user, system;
    char state;
    const char *fields = strrchr(stat, ')');
    if (!fields || sscanf(fields + 1, " %c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &state, &user,
                          &system) != 3)
        return;
    double seconds = (double)(user + system) / (double)sysconf(_SC_CLK_TCK);
    effort->busiest_s = seconds > effort->busiest_s ? seconds : effort->busiest_s;
    effort->all_s += seconds;
    effort->awake = effort->awake || state == 'R' || state == 'D';
}

static void read_effort(pid_t pid, struct effort *effort)
{
    char path[64], stat[1024];
    *effort = (struct effort){0};
    snprintf(path, sizeof path, "/proc/%ld/task", (long)pid);
    DIR *threads = opendir(path);
    for (struct dirent *thread; threads && (thread = readdir(threads));) {
        snprintf(path, sizeof path, "/proc/%ld/task/%.20s/stat", (long)pid, thread->d_name);
        FILE *file = *thread->d_name == '.' ? NULL : fopen(path, "re");
        if (file && fgets(stat, sizeof stat, file))
            add_thread(effort, stat);
        if (file)
            fclose(file);
    }
    if (threads)
        closedir(threads);
}

static double seconds_between(int64_t from, int64_t to)
{
    return (double)(to - from) * 1e-9;
}

static bool meet(struct aob_deadline *deadline, const char *format, double seconds)
{
    snprintf(deadline->text, sizeof deadline->text, format, seconds);
    return true;
}

/* The first look only begins to wait: while this process was stopped, the other one may have slept because nobody read
 * what it wrote. */
static bool sleeps(struct aob_deadline *deadline, const struct effort *effort, int64_t now)
{
    double patience = deadline->limit_s < quiet_s ? deadline->limit_s : quiet_s;
    if (!deadline->looked_ns || effort->awake || effort->all_s > deadline->worked_s) {
        deadline->moved_ns = now;
        deadline->worked_s = effort->all_s;
    }
    return seconds_between(deadline->moved_ns, now) >= patience &&
           meet(deadline, "did nothing for %g s", patience);
}

/* What waits for a processor or a disk is awake at most looks, however little it gets. */
static bool naps(struct aob_deadline *deadline, const struct effort *effort, int64_t now)
{
    double stretch = deadline->looked_ns ? seconds_between(deadline->since_ns, now) : 0;
    deadline->looks++;
    deadline->awake_looks += effort->awake;
    if (deadline->looked_ns && stretch < nap_limits * deadline->limit_s)
        return false;
    bool idle = deadline->looked_ns && effort->all_s - deadline->since_work_s < nap_share * stretch &&
                2 * deadline->awake_looks < deadline->looks;
    deadline->since_ns = now;
    deadline->since_work_s = effort->all_s;
    deadline->looks = deadline->awake_looks = 0;
    return idle && meet(deadline, "did next to nothing for %g s", nap_limits * deadline->limit_s);
}

static bool look(struct aob_deadline *deadline, int64_t now)
{
    struct effort effort;
    read_effort(deadline->pid, &effort);
    bool idle = sleeps(deadline, &effort, now) || naps(deadline, &effort, now);
    deadline->looked_ns = now;
    return idle || (effort.busiest_s >= deadline->limit_s &&
                    meet(deadline, "took longer than %g s of work", deadline->limit_s));
}

void aob_deadline_init(struct aob_deadline *deadline, pid_t pid, double limit_s)
{
    *deadline = (struct aob_deadline){.pid = pid, .limit_s = limit_s, .start_ns = aob_clock_wall_ns()};
}

bool aob_deadline_passed(struct aob_deadline *deadline)
{
    int64_t now = aob_clock_wall_ns();
    double wall = seconds_between(deadline->start_ns, now), most = wall_factor * deadline->limit_s;
    if (deadline->passed || !(deadline->limit_s > 0) || wall < deadline->limit_s)
        return deadline->passed;
    if (seconds_between(deadline->looked_ns, now) >= look_s)
        deadline->passed = look(deadline, now);
    if (!deadline->passed && wall >= most)
        deadline->passed = meet(deadline, "took longer than %g s in all", most);
    return deadline->passed;
}
