/* What each SPIR-V instruction of a fragment program costs, in slots of the units of a GPU: the one table that operations are
 * counted by. docs/operations.md explains the numbers. An instruction that is not in it cannot be counted, and is refused:
 * none is free by omission. */
#ifndef AOB_SHADER_OPERATION_H
#define AOB_SHADER_OPERATION_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum aob_operation_per {                 /* what the slots are of */
                         AOB_PER_RESULT, /* each component of the result */
                         AOB_PER_OPERAND, /* each component of the first operand, of what makes one number of it */
                         AOB_PER_ELEMENT,     /* each element of the matrix that is an operand */
                         AOB_PER_INSTRUCTION, /* the whole */
};
enum aob_operation_constant {                     /* what a constant as the second operand changes */
                              AOB_CONSTANT_ALIKE, /* nothing */
                              AOB_CONSTANT_WHOLE, /* by 1 is free, by another power of two takes by_power, else by_constant */
                              AOB_CONSTANT_FLOAT, /* it takes by_constant */
                              AOB_CONSTANT_RANGE, /* 0 and 1 as the bounds of a clamp are free: a modifier of another instruction */
};

struct aob_operation {
    uint16_t number; /* opcode; in the second table that of GLSL.std.450 */
    const char *name;
    uint8_t alu, special, image; /* slots (profile/operations.h), per: */
    enum aob_operation_per per;
    enum aob_operation_constant constant;
    uint8_t by_power, by_constant; /* slots of the full rate, and no others, per the same */
    bool no_result;                /* else its words 1 and 2 are its type and id */
    uint8_t ids;                   /* operands that are values, from the first one on; 0: all of them */
    bool more;                     /* behind those are one literal word, and then more values */
};
enum { AOB_NO_IDS = 255 };

extern const struct aob_operation aob_operations[], aob_operations_extended[];
extern const size_t aob_operations_count, aob_operations_extended_count;

/* NULL: it is not in the table. */
const struct aob_operation *aob_operation_find(uint32_t op);
const struct aob_operation *aob_operation_find_extended(uint32_t number);

/* The word, within an instruction of `length` words, of its operand number `index` of those that are values; 0: it has no
 * more of them. Literals are passed over: a component's number is no id. */
uint32_t aob_operation_value(const struct aob_operation *operation, uint32_t length, uint32_t index);
#endif
