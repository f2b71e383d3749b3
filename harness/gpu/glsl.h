/* GLSL 4.50 to SPIR-V by glslang, for one of two clients from the same text.
 * The text must not say #version: it is put in front together with
 *   BIND(n)    the binding qualifier: set=0,binding=n for Vulkan, binding=n for GL
 *   BIND_STORAGE  that of the one storage buffer that a program may declare, in place of BIND(n)
 *   VERTEX_ID  gl_VertexIndex or gl_VertexID
 *   dot, length, distance, normalize, reflect, mix
 *              as in GLSL, in sums of one fixed order: drivers that lower the built-ins differently for the
 * two APIs (Mesa 22.3 does) still give the same bits. So an array's .length() cannot be written, mix() takes
 * floats and booleans only, and vector * matrix and refract() may differ by a last bit. Threads: one at a
 * time a process (glslang's process state is initialised on first use). */
#ifndef AOB_GPU_GLSL_H
#define AOB_GPU_GLSL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"

enum aob_glsl_client { AOB_GLSL_VULKAN, AOB_GLSL_OPENGL };
enum aob_glsl_stage { AOB_GLSL_VERTEX, AOB_GLSL_FRAGMENT };

/* Allocated words (free()), or NULL after one line: glslang's first error with its line in `text`, as in
 * "fragment shader, line 12: 'x' : undeclared identifier"; after `#line 3 7` line 3 is named "7:3". */
uint32_t *aob_glsl_compile(const char *text, enum aob_glsl_stage stage, enum aob_glsl_client client,
                           size_t *word_count, struct aob_error *error);

/* Bit n: the words declare BIND(n), AOB_GLSL_STORAGE: BIND_STORAGE; a binding beyond 61 sets bit 63. The storage buffer
 * has a number of its own on Vulkan, and is number 0 on OpenGL, which counts storage buffers apart. */
enum { AOB_GLSL_STORAGE = 62, AOB_GLSL_STORAGE_BINDING = 32 /* on Vulkan */ };
uint64_t aob_glsl_bindings(const uint32_t *words, size_t word_count);

/* The vertex program of every pass without one of its own: one triangle that covers the target; the body of the text, as above. */
extern const char *const aob_glsl_screen_triangle;
#endif
