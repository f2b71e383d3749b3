#include "spirv.h"
#include <stdlib.h>
#include "base/memory.h"
#include "operation.h"

enum { MAGIC = 0x07230203, MOST_IDS = 1 << 22 };

static bool is_type(uint32_t op)
{
    return op >= AOB_SPIRV_TYPE_VOID && op <= AOB_SPIRV_TYPE_FUNCTION;
}

static bool is_constant(uint32_t op)
{
    return op >= AOB_SPIRV_CONSTANT_TRUE && op <= AOB_SPIRV_SPEC_CONSTANT_OP;
}

uint32_t aob_spirv_result(const struct aob_spirv *spirv, size_t place)
{
    uint32_t op = aob_spirv_op(spirv, place), length = aob_spirv_length(spirv, place);
    const uint32_t *words = spirv->words + place;
    const struct aob_operation *operation = aob_operation_find(op);
    if (is_type(op) || op == AOB_SPIRV_EXT_INST_IMPORT || op == AOB_SPIRV_LABEL)
        return length > 1 ? words[1] : 0;
    bool has = is_constant(op) || (operation && !operation->no_result);
    return has && length > 2 ? words[2] : 0;
}

static bool check_length(const struct aob_spirv *spirv, size_t place, struct aob_error *error)
{
    uint32_t length = aob_spirv_length(spirv, place);
    return (length && length <= spirv->count - place) ||
           aob_fail(error, "SPIR-V: the instruction at word %zu has %u words, and %zu are left", place,
                    length, spirv->count - place);
}

static bool read_instruction(struct aob_spirv *spirv, size_t place, struct aob_error *error)
{
    uint32_t op = aob_spirv_op(spirv, place), id = aob_spirv_result(spirv, place);
    if (id >= spirv->bound)
        return aob_fail(error, "SPIR-V: the id %u at word %zu is beyond the bound of %u", id, place,
                        spirv->bound);
    spirv->place[id] = id ? place : 0;
    if (op == AOB_SPIRV_ENTRY_POINT && spirv->entry)
        return aob_fail(error, "SPIR-V: there are two entry points");
    if (op == AOB_SPIRV_ENTRY_POINT && aob_spirv_length(spirv, place) > 3)
        spirv->entry = spirv->words[place + 2];
    if (op == AOB_SPIRV_FUNCTION && !spirv->body)
        spirv->body = place;
    return true;
}

static bool read_all(struct aob_spirv *spirv, struct aob_error *error)
{
    for (size_t at = AOB_SPIRV_HEAD; at < spirv->count; at += aob_spirv_length(spirv, at))
        if (!check_length(spirv, at, error) || !read_instruction(spirv, at, error))
            return false;
    return (spirv->entry && spirv->body) || aob_fail(error, "SPIR-V: there is no entry point");
}

bool aob_spirv_init(struct aob_spirv *spirv, const uint32_t *words, size_t count, struct aob_error *error)
{
    *spirv = (struct aob_spirv){.words = words, .count = count};
    if (count < AOB_SPIRV_HEAD || words[0] != MAGIC || !words[3] || words[3] > MOST_IDS)
        return aob_fail(error, "SPIR-V: %zu words that do not begin as a module does", count);
    spirv->version = words[1];
    spirv->bound = words[3];
    spirv->place = AOB_NEW_ARRAY(size_t, spirv->bound);
    if (read_all(spirv, error))
        return true;
    aob_spirv_finish(spirv);
    return false;
}

void aob_spirv_finish(struct aob_spirv *spirv)
{
    free(spirv->place);
    *spirv = (struct aob_spirv){0};
}

/* Of the instruction that makes an id; NULL: none does. */
static const uint32_t *made_by(const struct aob_spirv *spirv, uint32_t id)
{
    size_t place = id < spirv->bound ? spirv->place[id] : 0;
    return place ? spirv->words + place : NULL;
}

uint32_t aob_spirv_components(const struct aob_spirv *spirv, uint32_t type)
{
    const uint32_t *words = made_by(spirv, type);
    uint32_t op = words ? *words & 0xffff : 0;
    if (op == AOB_SPIRV_TYPE_VECTOR)
        return words[3];
    return op == AOB_SPIRV_TYPE_MATRIX ? words[3] * aob_spirv_components(spirv, words[2]) : 1;
}

uint32_t aob_spirv_type_of(const struct aob_spirv *spirv, uint32_t value)
{
    const uint32_t *words = made_by(spirv, value);
    return words && !is_type(*words & 0xffff) && *words >> 16 > 2 ? words[1] : 0;
}

bool aob_spirv_is_constant(const struct aob_spirv *spirv, uint32_t value)
{
    const uint32_t *words = made_by(spirv, value);
    return words && is_constant(*words & 0xffff);
}

bool aob_spirv_constant_bits(const struct aob_spirv *spirv, uint32_t value, uint32_t *bits)
{
    const uint32_t *words = made_by(spirv, value);
    uint32_t op = words ? *words & 0xffff : 0, length = words ? *words >> 16 : 0, other;
    if (op == AOB_SPIRV_CONSTANT && length == 4) {
        *bits = words[3];
        return true;
    }
    if (op != AOB_SPIRV_CONSTANT_COMPOSITE || length < 4 || !aob_spirv_constant_bits(spirv, words[3], bits))
        return false;
    for (uint32_t i = 4; i < length; i++)
        if (!aob_spirv_constant_bits(spirv, words[i], &other) || other != *bits)
            return false;
    return true;
}
