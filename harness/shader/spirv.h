/* The words of a SPIR-V module as a list of instructions, and where each id comes from. Numbers are those of the SPIR-V
 * specification; only what a fragment program of a technique holds has a name here. */
#ifndef AOB_SHADER_SPIRV_H
#define AOB_SHADER_SPIRV_H
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"

enum aob_spirv_op {
    AOB_SPIRV_LINE = 8,
    AOB_SPIRV_EXT_INST_IMPORT = 11,
    AOB_SPIRV_EXT_INST = 12,
    AOB_SPIRV_ENTRY_POINT = 15,
    AOB_SPIRV_TYPE_VOID = 19, /* the first of the types */
    AOB_SPIRV_TYPE_INT = 21,
    AOB_SPIRV_TYPE_VECTOR = 23,
    AOB_SPIRV_TYPE_MATRIX = 24,
    AOB_SPIRV_TYPE_RUNTIME_ARRAY = 29,
    AOB_SPIRV_TYPE_STRUCT = 30,
    AOB_SPIRV_TYPE_POINTER = 32,
    AOB_SPIRV_TYPE_FUNCTION = 33, /* the last of those with a result */
    AOB_SPIRV_CONSTANT_TRUE = 41, /* the first of the constants */
    AOB_SPIRV_CONSTANT = 43,
    AOB_SPIRV_CONSTANT_COMPOSITE = 44,
    AOB_SPIRV_SPEC_CONSTANT_OP = 52, /* the last of the constants */
    AOB_SPIRV_FUNCTION = 54,
    AOB_SPIRV_VARIABLE = 59,
    AOB_SPIRV_LOAD = 61,
    AOB_SPIRV_STORE = 62,
    AOB_SPIRV_ACCESS_CHAIN = 65,
    AOB_SPIRV_DECORATE = 71,
    AOB_SPIRV_MEMBER_DECORATE = 72,
    AOB_SPIRV_FNEGATE = 127,
    AOB_SPIRV_IADD = 128,
    AOB_SPIRV_FADD = 129,
    AOB_SPIRV_FSUB = 131,
    AOB_SPIRV_FMUL = 133,
    AOB_SPIRV_VECTOR_TIMES_SCALAR = 142,
    AOB_SPIRV_SHIFT_RIGHT_LOGICAL = 194,
    AOB_SPIRV_BITWISE_AND = 199,
    AOB_SPIRV_NOT = 200,
    AOB_SPIRV_ATOMIC_IADD = 234,
    AOB_SPIRV_ATOMIC_UMAX = 239,
    AOB_SPIRV_PHI = 245,
    AOB_SPIRV_LABEL = 248,
    AOB_SPIRV_KILL = 252,
    AOB_SPIRV_RETURN = 253,
    AOB_SPIRV_NO_LINE = 317,
    AOB_SPIRV_TERMINATE_INVOCATION = 4416,
};
enum aob_spirv_class { /* of storage */
                       AOB_SPIRV_CLASS_UNIFORM_CONSTANT = 0,
                       AOB_SPIRV_CLASS_UNIFORM = 2,
                       AOB_SPIRV_CLASS_PRIVATE = 6,
                       AOB_SPIRV_CLASS_STORAGE_BUFFER = 12,
};
enum aob_spirv_decoration {
    AOB_SPIRV_DECORATION_BLOCK = 2,
    AOB_SPIRV_DECORATION_BUFFER_BLOCK = 3, /* a storage buffer of the uniform class, before SPIR-V 1.3 */
    AOB_SPIRV_DECORATION_ARRAY_STRIDE = 6,
    AOB_SPIRV_DECORATION_BINDING = 33,
    AOB_SPIRV_DECORATION_DESCRIPTOR_SET = 34,
    AOB_SPIRV_DECORATION_OFFSET = 35,
};
enum {
    AOB_SPIRV_HEAD = 5
}; /* words before the first instruction: magic, version, generator, bound, schema */

struct aob_spirv {
    const uint32_t *words; /* must outlive it */
    size_t count;
    uint32_t version; /* as it is written: 0x00010500 is 1.5 */
    uint32_t bound;   /* all ids lie below it */
    size_t *place;    /* of the instruction that makes an id, by the id; 0: none does */
    uint32_t entry;   /* id of the function that is called first */
    size_t body;      /* place of the first function */
};

/* False after one line if the words are no module with one entry point; leaves nothing behind then. */
bool aob_spirv_init(struct aob_spirv *spirv, const uint32_t *words, size_t count, struct aob_error *error);
void aob_spirv_finish(struct aob_spirv *spirv);

/* Of the instruction at a place: its number, its words with the first one counted. The next one lies behind them. */
static inline uint32_t aob_spirv_op(const struct aob_spirv *spirv, size_t place)
{
    return spirv->words[place] & 0xffff;
}
static inline uint32_t aob_spirv_length(const struct aob_spirv *spirv, size_t place)
{
    return spirv->words[place] >> 16;
}

/* The result of the instruction at a place, or 0. */
uint32_t aob_spirv_result(const struct aob_spirv *spirv, size_t place);

/* Numbers that a value of the type has: 3 of a vec3, 9 of a mat3, 1 of anything else. */
uint32_t aob_spirv_components(const struct aob_spirv *spirv, uint32_t type);

/* The type of a value; 0: the id is no value. */
uint32_t aob_spirv_type_of(const struct aob_spirv *spirv, uint32_t value);

/* Whether the value is a constant of the module. */
bool aob_spirv_is_constant(const struct aob_spirv *spirv, uint32_t value);

/* Whether all components of a constant are the same 32 bits, which are then in `bits`. */
bool aob_spirv_constant_bits(const struct aob_spirv *spirv, uint32_t value, uint32_t *bits);
#endif
