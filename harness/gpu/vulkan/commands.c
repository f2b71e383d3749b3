#include "vk.h"
#include "base/clock.h"

/* All earlier writes before all later reads and writes. Once a submit, before its first stamp: what came in an earlier submit
 * was waited for already, so nothing is held up, and its moves (states.c) need not think of more than their own list. */
static void record_barrier(VkCommandBuffer commands)
{
    VkMemoryBarrier2 all = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
    };
    vkCmdPipelineBarrier2(commands, &(VkDependencyInfo){.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                                        .memoryBarrierCount = 1,
                                                        .pMemoryBarriers = &all});
}

void aob_vk_record_wait(VkCommandBuffer commands)
{
    VkMemoryBarrier2 all = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                            .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                            .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
    vkCmdPipelineBarrier2(commands, &(VkDependencyInfo){.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                                        .memoryBarrierCount = 1,
                                                        .pMemoryBarriers = &all});
}

bool aob_vk_begin(struct vk *vk, struct aob_error *error)
{
    VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                      .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    if (!aob_vk_ok(vk, vkBeginCommandBuffer(vk->commands, &begin), "begin a command buffer", error))
        return false;
    record_barrier(vk->commands);
    return true;
}

static bool end(struct vk *vk, struct aob_error *error)
{
    VkMemoryBarrier2 for_host = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
        .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT,
    };
    vkCmdPipelineBarrier2(vk->commands, &(VkDependencyInfo){.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                                            .memoryBarrierCount = 1,
                                                            .pMemoryBarriers = &for_host});
    return aob_vk_ok(vk, vkEndCommandBuffer(vk->commands), "record commands", error);
}

static bool wait_idle(struct vk *vk, struct aob_error *error)
{
    return aob_vk_ok(vk, vkWaitForFences(vk->device, 1, &vk->fence, VK_TRUE, UINT64_MAX),
                     "wait for the device", error);
}

static bool submit(struct vk *vk, VkCommandBuffer commands, struct aob_gpu_time *time,
                   struct aob_error *error)
{
    VkCommandBufferSubmitInfo buffer = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                        .commandBuffer = commands};
    VkSubmitInfo2 submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                            .commandBufferInfoCount = commands ? 1 : 0,
                            .pCommandBufferInfos = &buffer};
    int64_t cpu = aob_clock_cpu_ns(), wall = aob_clock_wall_ns();
    if (!aob_vk_ok(vk, vkQueueSubmit2(vk->queue, 1, &submit, vk->fence), "submit", error) ||
        !wait_idle(vk, error))
        return false;
    if (time) {
        time->wall_ns += aob_clock_wall_ns() - wall;
        time->cpu_ns += aob_clock_cpu_ns() - cpu;
    }
    return aob_vk_ok(vk, vkResetFences(vk->device, 1, &vk->fence), "reset a fence", error);
}

bool aob_vk_finish(struct vk *vk, struct aob_gpu_time *time, struct aob_error *error)
{
    return end(vk, error) && submit(vk, vk->commands, time, error);
}

bool aob_vk_flush(struct vk *vk, struct aob_error *error)
{
    return submit(vk, VK_NULL_HANDLE, NULL, error);
}

enum { FLUSH_EVERY = 8 };

void aob_vk_destroyed(struct vk *vk)
{
    if (++vk->destroyed % FLUSH_EVERY == 0)
        aob_vk_flush(vk, NULL);
}
