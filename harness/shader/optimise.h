/* SPIR-V by SPIRV-Tools as a driver's compiler would make it; C in front of its C++. Functions are inlined, constants folded
 * and equal expressions merged: what glslang writes is full of variables and functions, and no GPU would run that. */
#ifndef AOB_SHADER_OPTIMISE_H
#define AOB_SHADER_OPTIMISE_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* The passes of `spirv-opt -O`, which keep all bindings. Allocated words (free()) and their count, or NULL and a reason in
 * `why`. Results may be rounded elsewhere, because a product and a sum become one instruction and factors are gathered: an
 * image that the words draw may differ by last bits. */
uint32_t *aob_shader_optimise(const uint32_t *words, size_t count, size_t *new_count, char *why,
                              size_t why_size);

#ifdef __cplusplus
}
#endif
#endif
