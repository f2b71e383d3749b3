#include "blocks.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "operation.h"
#include "uniform.h"

/* Who uses a value, by its id. */
struct uses {
    uint32_t count;
    size_t place; /* of the last one */
};

struct counting {
    const struct aob_spirv *spirv;
    struct uses *uses;
    bool *joined;  /* by the id of a sum: a product is part of it already */
    bool *uniform; /* by the id of a value: it is not computed in each invocation */
};

/* The rows of an instruction; its slots are those of the extended one where it is of GLSL.std.450. */
struct rows {
    const struct aob_operation *form, *slots;
};

/* Words before the operands. */
static uint32_t operands_at(const struct aob_operation *form)
{
    return form->no_result ? 1 : 3;
}

static uint32_t leading_ids(const struct aob_operation *form)
{
    return form->ids == AOB_NO_IDS ? 0 : form->ids;
}

/* The other sets of instructions have the same numbers for other things. */
static bool check_set(const struct aob_spirv *spirv, const uint32_t *instruction, struct aob_error *error)
{
    static const char known[] = "GLSL.std.450";
    size_t place = instruction[3] < spirv->bound ? spirv->place[instruction[3]] : 0;
    bool import = place && aob_spirv_op(spirv, place) == AOB_SPIRV_EXT_INST_IMPORT;
    size_t size = import ? 4 * (aob_spirv_length(spirv, place) - 2) : 0;
    const char *name = (const char *)(spirv->words + place + 2);
    return (size >= sizeof known && memcmp(name, known, sizeof known) == 0) ||
           aob_fail(error,
                    "instruction %u of %.*s cannot be counted: of the sets of instructions only %s has a "
                    "table",
                    instruction[4], import ? (int)size : 15, import ? name : "an unknown set", known);
}

static bool find_extended(const struct aob_spirv *spirv, const uint32_t *instruction, struct rows *rows,
                          struct aob_error *error)
{
    if (!check_set(spirv, instruction, error))
        return false;
    rows->slots = aob_operation_find_extended(instruction[4]);
    return rows->slots || aob_fail(error,
                                   "instruction %u of GLSL.std.450 cannot be counted: it has no row in "
                                   "shader/operation.c",
                                   instruction[4]);
}

static bool find_rows(const struct aob_spirv *spirv, size_t place, struct rows *rows, struct aob_error *error)
{
    uint32_t op = aob_spirv_op(spirv, place), length = aob_spirv_length(spirv, place);
    rows->form = rows->slots = aob_operation_find(op);
    if (!rows->form)
        return aob_fail(
            error, "instruction %u of SPIR-V cannot be counted: it has no row in shader/operation.c", op);
    if (length < operands_at(rows->form) + leading_ids(rows->form))
        return aob_fail(error, "SPIR-V: %s at word %zu has %u words", rows->form->name, place, length);
    if (op != AOB_SPIRV_EXT_INST)
        return true;
    if (length < 5)
        return aob_fail(error, "SPIR-V: OpExtInst at word %zu has %u words", place, length);
    return find_extended(spirv, spirv->words + place, rows, error);
}

static void add_use(struct counting *counting, size_t place, uint32_t id)
{
    if (id >= counting->spirv->bound)
        return;
    counting->uses[id].count++;
    counting->uses[id].place = place;
}

static void add_uses(struct counting *counting, size_t place, const struct aob_operation *form)
{
    uint32_t length = aob_spirv_length(counting->spirv, place), word;
    for (uint32_t i = 0; (word = aob_operation_value(form, length, i)); i++)
        add_use(counting, place, counting->spirv->words[place + word]);
}

static bool read_body(struct counting *counting, struct aob_blocks *blocks, struct aob_error *error)
{
    const struct aob_spirv *spirv = counting->spirv;
    struct rows rows;
    bool entered = false;
    for (size_t at = spirv->body; at < spirv->count; at += aob_spirv_length(spirv, at)) {
        if (!find_rows(spirv, at, &rows, error))
            return false;
        if (aob_spirv_op(spirv, at) == AOB_SPIRV_FUNCTION && spirv->words[at + 2] == spirv->entry) {
            blocks->first = blocks->count;
            entered = true;
        }
        blocks->count += aob_spirv_op(spirv, at) == AOB_SPIRV_LABEL;
        add_uses(counting, at, rows.form);
    }
    return (entered && blocks->first < blocks->count) ||
           aob_fail(error, "SPIR-V: the entry point has no blocks");
}

/* Through signs, which cost nothing: the sum that is the only user of the product. */
static bool joins_a_sum(struct counting *counting, uint32_t product)
{
    const struct aob_spirv *spirv = counting->spirv;
    const struct uses *uses = &counting->uses[product];
    while (uses->count == 1 && aob_spirv_op(spirv, uses->place) == AOB_SPIRV_FNEGATE)
        uses = &counting->uses[spirv->words[uses->place + 2]];
    if (uses->count != 1)
        return false;
    uint32_t op = aob_spirv_op(spirv, uses->place), sum = spirv->words[uses->place + 2];
    if ((op != AOB_SPIRV_FADD && op != AOB_SPIRV_FSUB) || counting->joined[sum])
        return false;
    counting->joined[sum] = true;
    return true;
}

static bool is_zero_to_one(const struct aob_spirv *spirv, size_t place)
{
    const uint32_t one = 0x3f800000; /* 1.0f */
    uint32_t low, high;
    const uint32_t *operands = spirv->words + place + 5;
    return aob_spirv_length(spirv, place) == 8 && aob_spirv_constant_bits(spirv, operands[1], &low) &&
           aob_spirv_constant_bits(spirv, operands[2], &high) && !low && high == one;
}

/* Whether a constant operand decides what the instruction takes. The reciprocal of a uniform divisor is uniform as well. */
static bool is_decided(const struct counting *counting, size_t place, const struct aob_operation *slots)
{
    const struct aob_spirv *spirv = counting->spirv;
    uint32_t second = aob_spirv_length(spirv, place) > 4 ? spirv->words[place + 4] : 0;
    switch (slots->constant) {
    case AOB_CONSTANT_WHOLE:
        return aob_spirv_is_constant(spirv, second);
    case AOB_CONSTANT_FLOAT:
        return second < spirv->bound && counting->uniform[second];
    case AOB_CONSTANT_RANGE:
        return is_zero_to_one(spirv, place);
    default:
        return false;
    }
}

/* Slots of the full rate, and the only ones, that it takes then. */
static double decided_slots(const struct aob_spirv *spirv, size_t place, const struct aob_operation *slots)
{
    uint32_t bits = 0;
    bool whole = slots->constant == AOB_CONSTANT_WHOLE &&
                 aob_spirv_constant_bits(spirv, spirv->words[place + 4], &bits);
    if (whole && bits == 1)
        return 0;
    return whole && bits && !(bits & (bits - 1)) ? slots->by_power : slots->by_constant;
}

static uint32_t components_of_value(const struct aob_spirv *spirv, uint32_t value)
{
    return aob_spirv_components(spirv, aob_spirv_type_of(spirv, value));
}

/* How often the row's slots are taken. */
static uint32_t times(const struct aob_spirv *spirv, size_t place, const struct aob_operation *slots)
{
    const uint32_t *words = spirv->words + place;
    uint32_t a, b;
    switch (slots->per) {
    case AOB_PER_RESULT:
        return aob_spirv_components(spirv, words[1]);
    case AOB_PER_OPERAND:
        return components_of_value(spirv, words[3]);
    case AOB_PER_ELEMENT:
        a = components_of_value(spirv, words[3]);
        b = components_of_value(spirv, words[4]);
        return a > b ? a : b;
    default:
        return 1;
    }
}

static bool is_product(uint32_t op)
{
    return op == AOB_SPIRV_FMUL || op == AOB_SPIRV_VECTOR_TIMES_SCALAR;
}

static void add_slots(struct counting *counting, size_t place, struct aob_operations *sum)
{
    const struct aob_spirv *spirv = counting->spirv;
    uint32_t op = aob_spirv_op(spirv, place);
    struct rows rows;
    find_rows(spirv, place, &rows, NULL); /* read_body has found them */
    const struct aob_operation *slots = rows.slots;
    if (!slots->alu && !slots->special && !slots->image)
        return;
    if (counting->uniform[spirv->words[place + 2]])
        return;
    if (is_product(op) && joins_a_sum(counting, spirv->words[place + 2]))
        return;
    double count = times(spirv, place, slots);
    if (is_decided(counting, place, slots)) {
        sum->alu += count * decided_slots(spirv, place, slots);
        return;
    }
    sum->alu += count * slots->alu;
    sum->special += count * slots->special;
    sum->image += count * slots->image;
}

static void add_all(struct counting *counting, struct aob_blocks *blocks)
{
    const struct aob_spirv *spirv = counting->spirv;
    struct aob_operations *block = NULL;
    for (size_t at = spirv->body; at < spirv->count; at += aob_spirv_length(spirv, at))
        if (aob_spirv_op(spirv, at) == AOB_SPIRV_LABEL)
            block = block ? block + 1 : blocks->each;
        else if (block)
            add_slots(counting, at, block);
}

bool aob_blocks_init(struct aob_blocks *blocks, const struct aob_spirv *spirv, struct aob_error *error)
{
    struct counting counting = {.spirv = spirv,
                                .uses = AOB_NEW_ARRAY(struct uses, spirv->bound),
                                .joined = AOB_NEW_ARRAY(bool, spirv->bound),
                                .uniform = aob_uniform_values(spirv)};
    *blocks = (struct aob_blocks){0};
    bool ok = read_body(&counting, blocks, error);
    if (ok) {
        blocks->each = AOB_NEW_ARRAY(struct aob_operations, blocks->count);
        add_all(&counting, blocks);
    } else
        *blocks = (struct aob_blocks){0};
    free(counting.uses);
    free(counting.joined);
    free(counting.uniform);
    return ok;
}

void aob_blocks_finish(struct aob_blocks *blocks)
{
    free(blocks->each);
    *blocks = (struct aob_blocks){0};
}
