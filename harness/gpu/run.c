#include "backends.h"

void aob_gpu_time_add(struct aob_gpu_time *sum, const struct aob_gpu_time *time)
{
    sum->wall_ns += time->wall_ns;
    sum->cpu_ns += time->cpu_ns;
    sum->device_ns += time->device_ns;
}

static bool submit(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                   struct aob_gpu_time *whole, struct aob_error *error)
{
    struct aob_gpu_time parts[AOB_GPU_MAX_LIST] = {{0}}, time = {0};
    if (!gpu->fns->run(gpu, desc, parts, &time, error))
        return false;
    for (size_t i = 0; i < desc->count; i++) {
        desc->passes[i]->last_ns = 1 + time.wall_ns / desc->repeats / (int64_t)desc->count;
        aob_gpu_time_add(&times[i], &parts[i]);
    }
    aob_gpu_time_add(whole, &time);
    return true;
}

static bool run_alone(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                      struct aob_gpu_time *whole, struct aob_error *error)
{
    for (int r = 0; r < desc->repeats; r++)
        for (size_t i = 0; i < desc->count; i++) {
            const struct aob_gpu_run_desc one = {&desc->passes[i], 1, 1};
            struct aob_gpu_time sum = {0}, unused = {0};
            if (!submit(gpu, &one, &unused, &sum, error))
                return false;
            aob_gpu_time_add(&times[i], &sum);
            aob_gpu_time_add(whole, &sum);
        }
    return true;
}

int aob_gpu_submit_repeats(int64_t list_ns, size_t count, int left)
{
    int64_t room = AOB_GPU_SUBMIT_MAX / (int64_t)count, wanted = list_ns ? AOB_GPU_SUBMIT_NS / list_ns : 1;
    wanted = wanted < room ? wanted : room;
    wanted = wanted < left ? wanted : left;
    return wanted < 1 ? 1 : (int)wanted;
}

/* What the list took when it last ran; 0: some pass of it never did. */
static int64_t list_ns(const struct aob_gpu_run_desc *desc)
{
    int64_t sum = 0;
    for (size_t i = 0; i < desc->count; i++) {
        if (!desc->passes[i]->last_ns)
            return 0;
        sum += desc->passes[i]->last_ns;
    }
    return sum;
}

static bool run_lists(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                      struct aob_gpu_time *whole, struct aob_error *error)
{
    struct aob_gpu_run_desc part = *desc;
    for (int left = desc->repeats; left > 0; left -= part.repeats) {
        part.repeats = aob_gpu_submit_repeats(list_ns(desc), desc->count, left);
        if (!submit(gpu, &part, times, whole, error))
            return false;
    }
    return true;
}

bool aob_gpu_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                 struct aob_gpu_time *whole, struct aob_error *error)
{
    struct aob_gpu_time sums[AOB_GPU_MAX_LIST] = {{0}}, sum = {0};
    if (desc->count < 1 || desc->count > AOB_GPU_MAX_LIST || desc->repeats < 1)
        return aob_fail(error, "%s: run of %zu passes, %d times: there must be 1..%d passes, at least once",
                        gpu->info.backend, desc->count, desc->repeats, (int)AOB_GPU_MAX_LIST);
    if (!(gpu->lists ? run_lists : run_alone)(gpu, desc, sums, &sum, error))
        return false;
    for (size_t i = 0; times && i < desc->count; i++)
        times[i] = sums[i];
    if (whole)
        *whole = sum;
    return true;
}

int64_t aob_gpu_ticks_ns(uint64_t from, uint64_t to, unsigned bits, double period_ns)
{
    uint64_t mask = bits < 64 ? ((uint64_t)1 << bits) - 1 : ~(uint64_t)0;
    return (int64_t)((double)((to - from) & mask) * period_ns);
}
