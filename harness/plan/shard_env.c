#include <stdlib.h>
#include <string.h>
#include "shard.h"

/* What an engine tells its tasks. */
struct engine {
    const char *name;
    const char *task, *count; /* variables */
    int from;                 /* the first task's number; where it says that itself, */
    const char *first, *last; /* the variables of the first and the last task's; else NULL */
};
static const struct engine engines[] = {
    {"Slurm", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", 0, "SLURM_ARRAY_TASK_MIN",
     "SLURM_ARRAY_TASK_MAX"},
    {"GitLab", "CI_NODE_INDEX", "CI_NODE_TOTAL", 1, NULL, NULL},
    {"Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", 0, NULL, NULL},
    {0},
};

/* An empty variable is none. */
static const char *find(const char *name)
{
    const char *text = getenv(name);
    return text && *text ? text : NULL;
}

static bool read_number(const char *name, long *value, struct aob_error *error)
{
    const char *text = find(name);
    if (text && strlen(text) <= 9 && strspn(text, "0123456789") == strlen(text)) {
        *value = strtol(text, NULL, 10);
        return true;
    }
    return text ? aob_fail(error, "%s is '%s', which is no number of a task", name, text)
                : aob_fail(error, "%s is not set", name);
}

/* An array of 3 and 7 says as little of the others as one that begins at 3. */
static bool is_whole(long first, long last, long count)
{
    return first <= 1 && last - first + 1 == count;
}

static bool read_bounds(const struct engine *engine, long count, long *first, struct aob_error *error)
{
    long last = engine->from + count - 1;
    *first = engine->from;
    if (engine->first &&
        (!read_number(engine->first, first, error) || !read_number(engine->last, &last, error)))
        return false;
    return (count >= 2 && is_whole(*first, last, count)) ||
           aob_fail(
               error,
               "%s says that its tasks are %ld from %ld to %ld, which may be a part that was started again: "
               "state the shard, such as 2/4",
               engine->name, count, *first, last);
}

static bool read_engine(const struct engine *engine, struct aob_shard *shard, struct aob_error *error)
{
    long task = 0, count = 0, first = 0;
    if (!read_number(engine->task, &task, error) || !read_number(engine->count, &count, error) ||
        !read_bounds(engine, count, &first, error))
        return false;
    if (task < first || task - first >= count || count > AOB_SHARD_MOST)
        return aob_fail(error, "%s=%ld is none of %s=%ld tasks from %ld, or these are more than %d",
                        engine->task, task, engine->count, count, first, AOB_SHARD_MOST);
    *shard = (struct aob_shard){(int)(task - first) + 1, (int)count};
    return true;
}

bool aob_shard_from_environment(struct aob_shard *shard, struct aob_error *error)
{
    const struct engine *from = NULL;
    *shard = (struct aob_shard){0};
    for (const struct engine *engine = engines; engine->name; engine++) {
        struct aob_shard found;
        if (!find(engine->task))
            continue;
        if (!read_engine(engine, &found, error))
            return false;
        if (from && (found.index != shard->index || found.count != shard->count))
            return aob_fail(error, "%s says shard %d/%d and %s %d/%d: state the one that is meant",
                            from->name, shard->index, shard->count, engine->name, found.index, found.count);
        from = engine;
        *shard = found;
    }
    return from || aob_fail(error, "none of SLURM_ARRAY_TASK_ID, CI_NODE_INDEX and OMPI_COMM_WORLD_RANK is "
                                   "set: state the shard, such as 2/4");
}
