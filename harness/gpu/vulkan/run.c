#include "vk.h"
#include "gpu/backends.h"

bool aob_vk_stamps_create(struct vk *vk, struct aob_error *error)
{
    VkQueryPoolCreateInfo create = {.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                    .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                    .queryCount = AOB_VK_STAMPS};
    return !vk->stamp_bits || aob_vk_ok(vk, vkCreateQueryPool(vk->device, &create, NULL, &vk->stamps),
                                        "create timestamps", error);
}

/* When all that was recorded before is done. What is recorded behind it waits by its own barriers only: a pass that reads
 * nothing of the one before it may begin while that one still runs, as in a renderer, and is in its time as far. */
static void stamp(struct vk *vk, uint32_t index)
{
    vkCmdWriteTimestamp2(vk->commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, vk->stamps, index);
}

/* No frame runs beside the next one, which is the same work again: a frame's time would be that of half of two. */
static void record_repeat(struct vk *vk, int repeat)
{
    if (repeat > 0)
        aob_vk_record_wait(vk->commands);
}

static void record_plain(struct vk *vk, const struct aob_gpu_run_desc *desc)
{
    for (int r = 0; r < desc->repeats; r++) {
        record_repeat(vk, r);
        for (size_t i = 0; i < desc->count; i++)
            aob_vk_pass_record(desc->passes[i], vk->commands);
    }
}

static void record_stamped(struct vk *vk, const struct aob_gpu_run_desc *desc)
{
    uint32_t used = 2 * (uint32_t)desc->count * (uint32_t)desc->repeats + 2, at = 0;
    vkCmdResetQueryPool(vk->commands, vk->stamps, 0, used);
    stamp(vk, at++);
    for (int r = 0; r < desc->repeats; r++) {
        record_repeat(vk, r);
        for (size_t i = 0; i < desc->count; i++) {
            stamp(vk, at++);
            aob_vk_pass_record(desc->passes[i], vk->commands);
            stamp(vk, at++);
        }
    }
    stamp(vk, at);
}

static int64_t between(const struct vk *vk, const uint64_t *stamps, uint32_t from, uint32_t to)
{
    return aob_gpu_ticks_ns(stamps[from], stamps[to], vk->stamp_bits, vk->properties.limits.timestampPeriod);
}

static bool read_stamps(struct vk *vk, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                        struct aob_gpu_time *whole, struct aob_error *error)
{
    uint64_t stamps[AOB_VK_STAMPS];
    uint32_t used = 2 * (uint32_t)desc->count * (uint32_t)desc->repeats + 2, at = 1;
    VkResult result =
        vkGetQueryPoolResults(vk->device, vk->stamps, 0, used, used * sizeof *stamps, stamps, sizeof *stamps,
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    if (!aob_vk_ok(vk, result, "read timestamps", error))
        return false;
    for (int r = 0; r < desc->repeats; r++)
        for (size_t i = 0; i < desc->count; i++, at += 2)
            times[i].device_ns += between(vk, stamps, at, at + 1);
    whole->device_ns += between(vk, stamps, 0, used - 1);
    return true;
}

bool aob_vk_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                struct aob_gpu_time *whole, struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    bool stamped =
        gpu->lists && vk->stamps; /* on a processor they would be in the times that it is judged by */
    if (!aob_vk_begin(vk, error))
        return false;
    (stamped ? record_stamped : record_plain)(vk, desc);
    return aob_vk_finish(vk, whole, error) && (!stamped || read_stamps(vk, desc, times, whole, error));
}
