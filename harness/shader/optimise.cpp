#include "optimise.h"
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <spirv-tools/optimizer.hpp>
#include <string>
#include <vector>

enum { VERSION_1_0 = 0x00010000 }; /* of OpenGL */

static bool optimise(const uint32_t *words, size_t count, std::vector<uint32_t> *made, std::string *why)
{
    const bool opengl = count > 1 && words[1] == VERSION_1_0;
    spvtools::Optimizer optimizer(opengl ? SPV_ENV_OPENGL_4_5 : SPV_ENV_VULKAN_1_3);
    spvtools::OptimizerOptions options;
    optimizer.SetMessageConsumer(
        [why](spv_message_level_t level, const char *, const spv_position_t &, const char *message) {
            if (level <= SPV_MSG_ERROR)
                *why = message;
        });
    optimizer.RegisterPerformancePasses();
    options.set_run_validator(true); /* the passes rely on it */
    options.set_preserve_bindings(true);
    return optimizer.Run(words, count, made, options);
}

static uint32_t *copy(const std::vector<uint32_t> &words)
{
    auto *made = static_cast<uint32_t *>(std::malloc(words.size() * sizeof(uint32_t)));
    if (!made)
        throw std::bad_alloc();
    std::memcpy(made, words.data(), words.size() * sizeof(uint32_t));
    return made;
}

uint32_t *aob_shader_optimise(const uint32_t *words, size_t count, size_t *new_count, char *why,
                              size_t why_size)
{
    try {
        std::vector<uint32_t> made;
        std::string reason = "SPIRV-Tools gives no reason";
        if (optimise(words, count, &made, &reason)) {
            *new_count = made.size();
            return copy(made);
        }
        std::snprintf(why, why_size, "%s", reason.c_str());
    } catch (const std::bad_alloc &) {
        std::snprintf(why, why_size, "it asks for more memory than there is");
    }
    return nullptr;
}
