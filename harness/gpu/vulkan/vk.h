/* The Vulkan backend's own types. Vulkan 1.3 with dynamic rendering and synchronization2; one queue, one
 * thread; between calls all levels of a texture lie in its rest layout, and no object is ever in use, because
 * every submit is waited for. */
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
    bool fragment_stores;  /* fragment programs can write storage buffers */
    bool extended_storage; /* storage images of every format that the device has, not of GLSL ES's only */
    VkDevice device;
    VkQueue queue;
    VkCommandPool pool;
    VkCommandBuffer commands; /* of the one submit that is being recorded or waited for */
    VkFence fence;
    VkQueryPool stamps;    /* AOB_VK_STAMPS timestamps; NULL: the queue has no timer */
    uint32_t stamp_bits;   /* valid bits of a timestamp; 0: the queue has no timer */
    VkSampler samplers[2]; /* by enum aob_filter */
    VkShaderModule triangle;
    unsigned destroyed; /* passes and programs */
    struct aob_gpu_device chosen;
    char complaint[512]; /* of the validation layer, since the last aob_vk_ok; empty: none */
};

struct vk_buffer { /* mapped as long as it lives */
    VkBuffer buffer;
    VkDeviceMemory memory;
    void *map;
};

struct vk_storage { /* a storage buffer */
    struct aob_gpu_buffer base;
    struct vk_buffer buffer;
};

struct vk_image {
    VkImage image;
    VkDeviceMemory memory;
};

/* How an image is used at some point of a list of commands: its layout, and what touches it there. */
struct vk_state {
    VkImageLayout layout;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access;
};

struct vk_texture {
    struct aob_gpu_texture base;
    struct vk_image image;
    struct vk_state rest; /* between passes, and while it is read */
};

/* What a program is compiled to for passes of one kind. Drivers compile when a pipeline is made or first drawn with, so it
 * stays with the program, and a pass that is like an earlier one costs no compiling. */
struct vk_pipeline {
    struct vk_pipeline_kind { /* all that a pipeline depends on besides its program; compared as bytes */
        VkFormat formats[AOB_MAX_OUT];
        uint32_t sampled, stored; /* bit n: binding n is such an image */
        uint32_t target_count, uniforms, storage, depth_test, blend;
    } kind;
    VkPipeline pipeline;
};

struct vk_program {
    struct aob_gpu_program base;
    VkShaderModule vertex, fragment; /* vertex: NULL for the screen triangle */
    struct vk_pipeline *pipelines;   /* pipeline_count; made as passes want them */
    size_t pipeline_count;
};

/* call.c */
/* True if `result` is success and the validation layer kept quiet; else one line: "vulkan: cannot WHAT: why".
 */
bool aob_vk_ok(struct vk *vk, VkResult result, const char *what, struct aob_error *error);
bool aob_vk_fail_no_driver(struct aob_error *error);
VkFormat aob_vk_format(enum aob_format format);

/* instance.c: instance and messenger. */
bool aob_vk_instance_create(struct vk *vk, bool validate, struct aob_error *error);
void aob_vk_instance_destroy(struct vk *vk);

/* physical.c: the devices that the instance sees, and the choice of one: by what desc->device says, or the default. */
bool aob_vk_devices(struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error);
bool aob_vk_choose_device(struct vk *vk, const char *wanted, struct aob_error *error);

/* device.c */
struct aob_gpu *aob_vk_open(const struct aob_gpu_fns *fns, const struct aob_gpu_desc *desc,
                            struct aob_error *error);
void aob_vk_close(struct aob_gpu *gpu);

/* commands.c: begin (after all that was submitted earlier), record into vk->commands, then end, submit and wait; the
 * host's times of the last are added to `time` if that is wanted. aob_vk_flush submits nothing and waits for it. */
bool aob_vk_begin(struct vk *vk, struct aob_error *error);
bool aob_vk_finish(struct vk *vk, struct aob_gpu_time *time, struct aob_error *error);
bool aob_vk_flush(struct vk *vk, struct aob_error *error);

/* Counts a pass or a program that was destroyed: lavapipe frees it at the next submit only, and a sweep may destroy much in
 * a row. So every few of them there is one. */
void aob_vk_destroyed(struct vk *vk);

/* What is recorded behind it begins when all that was recorded before has ended. */
void aob_vk_record_wait(VkCommandBuffer commands);

/* memory.c. Of the types that the driver allows, the first that suits best what the memory is for; false: none will do. */
enum vk_memory_use {
    VK_MEMORY_IMAGE, /* the device's own, and not of the part that the host sees, which may be small */
    VK_MEMORY_UNIFORMS, /* written by the host between runs: the device's own where the host sees it, else the host's */
    VK_MEMORY_UPLOAD, /* written once by the host: the host's, so that what it sees of the device's stays free */
    VK_MEMORY_DOWNLOAD, /* read by the host: the host's, cached if there is such */
    VK_MEMORY_STORAGE,  /* written by programs and read by the host: as DOWNLOAD */
};
bool aob_vk_memory_choose(const VkPhysicalDeviceMemoryProperties *memory, uint32_t allowed,
                          enum vk_memory_use use, uint32_t *type);

bool aob_vk_buffer_init(struct vk *vk, size_t size, enum vk_memory_use use, struct vk_buffer *buffer,
                        struct aob_error *error);
void aob_vk_buffer_finish(struct vk *vk, struct vk_buffer *buffer);
/* The table's slots for storage buffers. */
bool aob_vk_storage_create(struct aob_gpu *gpu, size_t size, struct aob_gpu_buffer **buffer,
                           struct aob_error *error);
void aob_vk_storage_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer);
bool aob_vk_storage_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                          const void *bytes, struct aob_error *error);
bool aob_vk_storage_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         void *bytes, struct aob_error *error);

bool aob_vk_allocate(struct vk *vk, const VkMemoryRequirements *needs, enum vk_memory_use use,
                     VkDeviceMemory *memory, struct aob_error *error);

/* shader.c */
VkShaderModule aob_vk_shader_create(struct vk *vk, const uint32_t *words, size_t word_count,
                                    struct aob_error *error);

/* image.c: an image and its memory; finish also after an init that failed. */
struct vk_image_desc {
    VkFormat format;
    int width, height, levels;
    VkImageUsageFlags usage;
};
bool aob_vk_image_init(struct vk *vk, const struct vk_image_desc *desc, struct vk_image *image,
                       struct aob_error *error);
void aob_vk_image_finish(struct vk *vk, struct vk_image *image);
bool aob_vk_view_create(struct vk *vk, VkImage image, VkFormat format, const VkImageSubresourceRange *range,
                        VkImageView *view, struct aob_error *error);
VkImageSubresourceRange aob_vk_levels(int first, int count); /* of a colour image */

/* A move from what an image was used for to what it is used for next: it waits for the stages of the one and lets those of
 * the other wait, and no others. */
VkImageMemoryBarrier2 aob_vk_move(VkImage image, VkImageSubresourceRange range, struct vk_state from,
                                  struct vk_state to);
void aob_vk_record_moves(VkCommandBuffer commands, const VkImageMemoryBarrier2 *moves, uint32_t count);

/* limits.c: lacks_depth stays false, as these do not tell it. */
struct aob_gpu_limits aob_vk_limits(const VkPhysicalDeviceLimits *device);

/* states.c. aob_vk_rest: between passes, of a texture with those uses (bits of enum aob_gpu_use), whatever pass comes next.
 * The others: in a pass, or a copy. */
struct vk_state aob_vk_rest(uint32_t uses);
struct vk_state aob_vk_drawn(enum aob_gpu_blend blend);
extern const struct vk_state aob_vk_depth_state, aob_vk_copied_to, aob_vk_copied_from;

/* The same place with undefined content, which is not kept. */
struct vk_state aob_vk_undefined(struct vk_state state);

/* uses.c: what a texture's uses (bits of enum aob_gpu_use; `filled`: it is made with texels) need of a device. `needs`: those bits and those of enum aob_gpu_need; `has`: what the device has for the format;
 * `extended`: struct vk's extended_storage. The word for the first need that is missing ("storage image"); NULL: none is. */
VkImageUsageFlags aob_vk_usage(uint32_t uses, bool filled);
const char *aob_vk_format_lacks(enum aob_format format, uint32_t needs, VkFormatFeatureFlags has,
                                bool extended);

/* depth.c: the depth of a pass, float. aob_vk_depth_move makes it an attachment of undefined content. */
struct vk_depth {
    struct vk_image image;
    VkImageView view;
};
#define AOB_VK_DEPTH_FORMAT VK_FORMAT_D32_SFLOAT
bool aob_vk_depth_init(struct vk *vk, int width, int height, struct vk_depth *depth, struct aob_error *error);
void aob_vk_depth_finish(struct vk *vk, struct vk_depth *depth);
VkImageMemoryBarrier2 aob_vk_depth_move(const struct vk_depth *depth);

/* binds.c: what a pass reads. */
struct vk_binds {
    struct vk_buffer uniforms;
    VkImageView views[AOB_GPU_MAX_BINDING];
    VkDescriptorSetLayout set_layout;
    VkDescriptorPool pool;
    VkDescriptorSet set; /* NULL: the pass reads nothing */
    VkPipelineLayout layout;
};
bool aob_vk_binds_init(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct vk_binds *binds,
                       struct aob_error *error);
void aob_vk_binds_finish(struct vk *vk, struct vk_binds *binds);

/* pipeline.c: how a pass draws. The pipeline is the program's, which lends it to all passes of that kind; `layout` may go,
 * since that of another such pass is compatible with it. */
bool aob_vk_pipeline_lend(struct vk *vk, const struct aob_gpu_pass_desc *desc, VkPipelineLayout layout,
                          VkPipeline *pipeline, struct aob_error *error);

/* The table's slots, texture.c, shader.c and pass.c. */
const char *aob_vk_lacks(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs);
bool aob_vk_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                           struct aob_gpu_texture **texture, struct aob_error *error);
void aob_vk_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture);
bool aob_vk_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                         struct aob_error *error);
bool aob_vk_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                          struct aob_error *error);
bool aob_vk_program_create(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                           struct aob_gpu_program **program, struct aob_error *error);
void aob_vk_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program);
bool aob_vk_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error);
void aob_vk_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass);
bool aob_vk_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block,
                              struct aob_error *error);
void aob_vk_pass_set_part(struct aob_gpu_pass *pass, const struct aob_gpu_part *part);
void aob_vk_pass_record(const struct aob_gpu_pass *pass, VkCommandBuffer commands);

/* run.c: the slot, and what it needs of a device. */
enum { AOB_VK_STAMPS = 2 * AOB_GPU_SUBMIT_MAX + 2 }; /* before and behind each pass, and the whole */
bool aob_vk_stamps_create(struct vk *vk, struct aob_error *error);
bool aob_vk_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                struct aob_gpu_time *whole, struct aob_error *error);
#endif
