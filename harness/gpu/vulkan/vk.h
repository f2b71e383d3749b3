/* The Vulkan backend's own types. Vulkan 1.3 with dynamic rendering and synchronization2; one queue, one
 * thread; images stay in the GENERAL layout; every submit is waited for, so no object is ever in use between
 * calls. */
#ifndef AOB_GPU_VULKAN_VK_H
#define AOB_GPU_VULKAN_VK_H
#include <vulkan/vulkan.h>
#include "gpu/gpu.h"

struct vk {
    struct aob_gpu base;
    VkInstance instance;
    VkDebugUtilsMessengerEXT messenger;
    VkPhysicalDevice physical;
    VkPhysicalDeviceProperties properties;
    VkPhysicalDeviceMemoryProperties memory;
    uint32_t family;
    VkDevice device;
    VkQueue queue;
    VkCommandPool pool;
    VkCommandBuffer scratch; /* for copies */
    VkFence fence;
    VkSampler samplers[2]; /* by enum aob_filter */
    VkShaderModule triangle;
    unsigned destroyed_passes;
    char driver[VK_MAX_DRIVER_NAME_SIZE + VK_MAX_DRIVER_INFO_SIZE + 32];
    char complaint[512]; /* of the validation layer, since the last aob_vk_ok; empty: none */
};

struct vk_buffer { /* mapped as long as it lives */
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *map;
};

struct vk_texture {
    struct aob_gpu_texture base;
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
};

struct vk_program {
    struct aob_gpu_program base;
    VkShaderModule vertex, fragment; /* vertex: NULL for the screen triangle */
};

/* True if `result` is success and the validation layer kept quiet; else one line: "vulkan: cannot WHAT: why".
 */
bool aob_vk_ok(struct vk *vk, VkResult result, const char *what, struct aob_error *error);

/* instance.c: instance, messenger, choice of the physical device. */
bool aob_vk_instance_create(struct vk *vk, bool validate, struct aob_error *error);
void aob_vk_instance_destroy(struct vk *vk);
bool aob_vk_choose_device(struct vk *vk, struct aob_error *error);

/* device.c */
struct aob_gpu *aob_vk_open(const struct aob_gpu_desc *desc, struct aob_error *error);
void aob_vk_close(struct aob_gpu *gpu);
VkFormat aob_vk_format(enum aob_format format);

/* commands.c: begin, record, end, then submit and wait, with a time if wanted. */
bool aob_vk_begin(struct vk *vk, VkCommandBuffer commands, struct aob_error *error);
bool aob_vk_end(struct vk *vk, VkCommandBuffer commands, struct aob_error *error);
bool aob_vk_submit(struct vk *vk, VkCommandBuffer commands, struct aob_gpu_time *time,
                   struct aob_error *error);
void aob_vk_barrier(VkCommandBuffer commands); /* all earlier writes before all later reads and writes */

/* memory.c */
bool aob_vk_buffer_init(struct vk *vk, size_t size, VkBufferUsageFlags usage, struct vk_buffer *buffer,
                        struct aob_error *error);
void aob_vk_buffer_finish(struct vk *vk, struct vk_buffer *buffer);
bool aob_vk_allocate(struct vk *vk, const VkMemoryRequirements *needs, VkMemoryPropertyFlags wanted,
                     VkDeviceMemory *memory, struct aob_error *error);

/* shader.c */
VkShaderModule aob_vk_shader_create(struct vk *vk, const uint32_t *words, size_t word_count,
                                    struct aob_error *error);

/* depth.c: the depth of a pass, float, GENERAL layout after aob_vk_depth_record. */
struct vk_depth {
    VkImage image;
    VkDeviceMemory memory;
    VkImageView view;
};
#define AOB_VK_DEPTH_FORMAT VK_FORMAT_D32_SFLOAT
bool aob_vk_depth_init(struct vk *vk, int width, int height, struct vk_depth *depth, struct aob_error *error);
void aob_vk_depth_finish(struct vk *vk, struct vk_depth *depth);
void aob_vk_depth_record(const struct vk_depth *depth, VkCommandBuffer commands);

/* The table's slots, texture.c, shader.c and pass.c. */
bool aob_vk_texture_create(struct aob_gpu *gpu, enum aob_format format, int width, int height,
                           const void *texels, struct aob_gpu_texture **texture, struct aob_error *error);
void aob_vk_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture);
bool aob_vk_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                         struct aob_error *error);
bool aob_vk_program_create(struct aob_gpu *gpu, const char *vertex, const char *fragment,
                           struct aob_gpu_program **program, struct aob_error *error);
void aob_vk_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program);
bool aob_vk_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error);
void aob_vk_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass);
bool aob_vk_pass_run(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                     struct aob_error *error);
#endif
