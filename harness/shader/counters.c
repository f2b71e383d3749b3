#include "counters.h"
#include "base/memory.h"

enum {
    SCOPE_DEVICE = 1,
    VERSION_STORAGE_BUFFER = 0x00010300, /* has that class */
    VERSION_INTERFACE = 0x00010400,      /* its entry point names all variables of the module */
};

/* The words as they grow, and the ids that are new in them. */
struct writer {
    const struct aob_spirv *spirv;
    uint32_t *words;
    size_t count, capacity;
    uint32_t bound, storage;
    uint32_t uint, array, block, pointer_block, pointer_uint, pointer_private, buffer, zero, one, top_bit;
    uint32_t first_index, first_counter; /* of constants 0, 1, ...; of variables, a block each */
    uint32_t blocks;
    bool has_uint;
};

static void put(struct writer *writer, uint32_t word)
{
    *AOB_PUSH(writer->words, writer->count, writer->capacity) = word;
}

static void put_op(struct writer *writer, uint32_t op, size_t count, const uint32_t *operands)
{
    put(writer, (uint32_t)(count + 1) << 16 | op);
    for (size_t i = 0; i < count; i++)
        put(writer, operands[i]);
}
#define PUT(writer, op, ...)                                                                                 \
    put_op(writer, op, sizeof((uint32_t[]){__VA_ARGS__}) / sizeof(uint32_t), (uint32_t[]){__VA_ARGS__})

static void copy(struct writer *writer, size_t place)
{
    for (uint32_t i = 0; i < aob_spirv_length(writer->spirv, place); i++)
        put(writer, writer->spirv->words[place + i]);
}

/* The module's own type of unsigned numbers: a second one would not be valid. */
static uint32_t find_uint(const struct aob_spirv *spirv)
{
    for (size_t at = AOB_SPIRV_HEAD; at < spirv->body; at += aob_spirv_length(spirv, at)) {
        const uint32_t *words = spirv->words + at;
        if (aob_spirv_op(spirv, at) == AOB_SPIRV_TYPE_INT && words[2] == 32 && !words[3])
            return words[1];
    }
    return 0;
}

static uint32_t count_blocks(const struct aob_spirv *spirv)
{
    uint32_t count = 0;
    for (size_t at = spirv->body; at < spirv->count; at += aob_spirv_length(spirv, at))
        count += aob_spirv_op(spirv, at) == AOB_SPIRV_LABEL;
    return count;
}

static uint32_t indices(const struct writer *writer)
{
    return AOB_COUNTERS_BLOCKS + writer->blocks;
}

static void choose_ids(struct writer *writer)
{
    uint32_t *const ids[] = {&writer->array,           &writer->block,  &writer->pointer_block,
                             &writer->pointer_uint,    &writer->buffer, &writer->zero,
                             &writer->pointer_private, &writer->one,    &writer->top_bit};
    writer->bound = writer->spirv->bound;
    writer->blocks = count_blocks(writer->spirv);
    writer->uint = find_uint(writer->spirv);
    writer->has_uint = writer->uint;
    if (!writer->uint)
        writer->uint = writer->bound++;
    for (size_t i = 0; i < AOB_COUNT(ids); i++)
        *ids[i] = writer->bound++;
    writer->first_index = writer->bound;
    writer->first_counter = writer->first_index + indices(writer);
    writer->bound = writer->first_counter + writer->blocks;
}

/* From SPIR-V 1.4 on it lists every variable of the module. */
static void put_entry_point(struct writer *writer, size_t place)
{
    const struct aob_spirv *spirv = writer->spirv;
    size_t start = writer->count;
    copy(writer, place);
    if (spirv->version < VERSION_INTERFACE)
        return;
    put(writer, writer->buffer);
    for (uint32_t i = 0; i < writer->blocks; i++)
        put(writer, writer->first_counter + i);
    writer->words[start] = (uint32_t)(writer->count - start) << 16 | AOB_SPIRV_ENTRY_POINT;
}

static bool has_buffer_class(const struct writer *writer)
{
    return writer->spirv->version >= VERSION_STORAGE_BUFFER;
}

static void put_decorations(struct writer *writer)
{
    PUT(writer, AOB_SPIRV_DECORATE, writer->array, AOB_SPIRV_DECORATION_ARRAY_STRIDE, 4);
    PUT(writer, AOB_SPIRV_MEMBER_DECORATE, writer->block, 0, AOB_SPIRV_DECORATION_OFFSET, 0);
    PUT(writer, AOB_SPIRV_DECORATE, writer->block,
        has_buffer_class(writer) ? AOB_SPIRV_DECORATION_BLOCK : AOB_SPIRV_DECORATION_BUFFER_BLOCK);
    PUT(writer, AOB_SPIRV_DECORATE, writer->buffer, AOB_SPIRV_DECORATION_DESCRIPTOR_SET, 0);
    PUT(writer, AOB_SPIRV_DECORATE, writer->buffer, AOB_SPIRV_DECORATION_BINDING, writer->storage);
}

static void put_variables(struct writer *writer)
{
    uint32_t class = has_buffer_class(writer) ? AOB_SPIRV_CLASS_STORAGE_BUFFER : AOB_SPIRV_CLASS_UNIFORM;
    if (!writer->has_uint)
        PUT(writer, AOB_SPIRV_TYPE_INT, writer->uint, 32, 0);
    PUT(writer, AOB_SPIRV_TYPE_RUNTIME_ARRAY, writer->array, writer->uint);
    PUT(writer, AOB_SPIRV_TYPE_STRUCT, writer->block, writer->array);
    PUT(writer, AOB_SPIRV_TYPE_POINTER, writer->pointer_block, class, writer->block);
    PUT(writer, AOB_SPIRV_TYPE_POINTER, writer->pointer_uint, class, writer->uint);
    PUT(writer, AOB_SPIRV_TYPE_POINTER, writer->pointer_private, AOB_SPIRV_CLASS_PRIVATE, writer->uint);
    PUT(writer, AOB_SPIRV_CONSTANT, writer->uint, writer->zero, 0);
    PUT(writer, AOB_SPIRV_CONSTANT, writer->uint, writer->one, 1);
    PUT(writer, AOB_SPIRV_CONSTANT, writer->uint, writer->top_bit, 31);
    for (uint32_t i = 0; i < indices(writer); i++)
        PUT(writer, AOB_SPIRV_CONSTANT, writer->uint, writer->first_index + i, i);
    PUT(writer, AOB_SPIRV_VARIABLE, writer->pointer_block, writer->buffer, class);
    for (uint32_t i = 0; i < writer->blocks; i++)
        PUT(writer, AOB_SPIRV_VARIABLE, writer->pointer_private, writer->first_counter + i,
            AOB_SPIRV_CLASS_PRIVATE, writer->zero);
}

static void put_increment(struct writer *writer, uint32_t block)
{
    uint32_t counter = writer->first_counter + block, old = writer->bound++, sum = writer->bound++;
    PUT(writer, AOB_SPIRV_LOAD, writer->uint, old, counter);
    PUT(writer, AOB_SPIRV_IADD, writer->uint, sum, old, writer->one);
    PUT(writer, AOB_SPIRV_STORE, counter, sum);
}

/* An atomic operation on a word of the buffer; what it held before. */
static uint32_t put_atomic(struct writer *writer, uint32_t op, uint32_t word, uint32_t value)
{
    uint32_t pointer = writer->bound++, old = writer->bound++;
    PUT(writer, AOB_SPIRV_ACCESS_CHAIN, writer->pointer_uint, pointer, writer->buffer, writer->zero,
        writer->first_index + word);
    PUT(writer, op, writer->uint, old, pointer, writer->first_index + SCOPE_DEVICE, writer->zero, value);
    return old;
}

/* One more; and one into the upper half where the lower one was full, which is where its top bit goes from 1 to 0. */
static void put_invocation(struct writer *writer)
{
    uint32_t old = put_atomic(writer, AOB_SPIRV_ATOMIC_IADD, AOB_COUNTERS_INVOCATIONS, writer->one);
    uint32_t next = writer->bound++, not_next = writer->bound++, left = writer->bound++,
             carry = writer->bound++;
    PUT(writer, AOB_SPIRV_IADD, writer->uint, next, old, writer->one);
    PUT(writer, AOB_SPIRV_NOT, writer->uint, not_next, next);
    PUT(writer, AOB_SPIRV_BITWISE_AND, writer->uint, left, old, not_next);
    PUT(writer, AOB_SPIRV_SHIFT_RIGHT_LOGICAL, writer->uint, carry, left, writer->top_bit);
    put_atomic(writer, AOB_SPIRV_ATOMIC_IADD, AOB_COUNTERS_INVOCATIONS_HIGH, carry);
}

/* What the invocation has counted goes into the buffer. */
static void put_end(struct writer *writer)
{
    uint32_t total = writer->zero;
    for (uint32_t i = 0; i < writer->blocks; i++) {
        uint32_t runs = writer->bound++, sum = writer->bound++;
        PUT(writer, AOB_SPIRV_LOAD, writer->uint, runs, writer->first_counter + i);
        PUT(writer, AOB_SPIRV_IADD, writer->uint, sum, total, runs);
        put_atomic(writer, AOB_SPIRV_ATOMIC_IADD, AOB_COUNTERS_BLOCKS + i, runs);
        total = sum;
    }
    put_atomic(writer, AOB_SPIRV_ATOMIC_UMAX, AOB_COUNTERS_MOST, total);
    put_invocation(writer);
}

/* Behind what must come first in a block. */
static bool is_first_in_block(uint32_t op)
{
    return op == AOB_SPIRV_LABEL || op == AOB_SPIRV_PHI || op == AOB_SPIRV_VARIABLE || op == AOB_SPIRV_LINE ||
           op == AOB_SPIRV_NO_LINE;
}

static bool ends_invocation(uint32_t op, bool entry)
{
    return op == AOB_SPIRV_KILL || op == AOB_SPIRV_TERMINATE_INVOCATION || (entry && op == AOB_SPIRV_RETURN);
}

static void put_body(struct writer *writer)
{
    const struct aob_spirv *spirv = writer->spirv;
    uint32_t block = 0;
    bool entry = false, waits = false; /* a block's label has come, and its increment has not */
    for (size_t at = spirv->body; at < spirv->count; at += aob_spirv_length(spirv, at)) {
        uint32_t op = aob_spirv_op(spirv, at);
        if (waits && !is_first_in_block(op)) {
            put_increment(writer, block++);
            waits = false;
        }
        if (op == AOB_SPIRV_FUNCTION)
            entry = spirv->words[at + 2] == spirv->entry;
        if (ends_invocation(op, entry))
            put_end(writer);
        waits = waits || op == AOB_SPIRV_LABEL;
        copy(writer, at);
    }
}

/* The parts of a module come in a fixed order: decorations before types, types and variables before functions. */
static void put_head(struct writer *writer)
{
    const struct aob_spirv *spirv = writer->spirv;
    bool decorated = false;
    for (size_t at = AOB_SPIRV_HEAD; at < spirv->body; at += aob_spirv_length(spirv, at)) {
        uint32_t op = aob_spirv_op(spirv, at);
        if (!decorated && op >= AOB_SPIRV_TYPE_VOID && op <= AOB_SPIRV_TYPE_FUNCTION) {
            put_decorations(writer);
            decorated = true;
        }
        if (op == AOB_SPIRV_ENTRY_POINT)
            put_entry_point(writer, at);
        else
            copy(writer, at);
    }
    put_variables(writer);
}

uint32_t *aob_counters_insert(const struct aob_spirv *spirv, uint32_t storage, size_t *count)
{
    struct writer writer = {.spirv = spirv, .storage = storage};
    choose_ids(&writer);
    for (size_t i = 0; i < AOB_SPIRV_HEAD; i++)
        put(&writer, spirv->words[i]);
    put_head(&writer);
    put_body(&writer);
    writer.words[3] = writer.bound;
    *count = writer.count;
    return writer.words;
}
