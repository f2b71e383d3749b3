#include "uniform.h"
#include "base/memory.h"
#include "operation.h"

static bool is_block(const struct aob_spirv *spirv, uint32_t type)
{
    for (size_t at = AOB_SPIRV_HEAD; at < spirv->body; at += aob_spirv_length(spirv, at)) {
        const uint32_t *words = spirv->words + at;
        if (aob_spirv_op(spirv, at) == AOB_SPIRV_DECORATE && words[1] == type &&
            words[2] == AOB_SPIRV_DECORATION_BLOCK)
            return true;
    }
    return false;
}

static uint32_t pointed_to(const struct aob_spirv *spirv, uint32_t pointer)
{
    size_t place = pointer < spirv->bound ? spirv->place[pointer] : 0;
    bool known =
        place && aob_spirv_op(spirv, place) == AOB_SPIRV_TYPE_POINTER && aob_spirv_length(spirv, place) == 4;
    return known ? spirv->words[place + 3] : 0;
}

/* A uniform block, which is decorated as one, or an image, whose size is in its descriptor. The class alone does not tell:
 * before SPIR-V 1.3 a storage buffer, which invocations may write, is of the uniform class too. */
static bool is_uniform_variable(const struct aob_spirv *spirv, size_t place)
{
    const uint32_t *words = spirv->words + place;
    if (aob_spirv_length(spirv, place) < 4)
        return false;
    if (words[3] == AOB_SPIRV_CLASS_UNIFORM)
        return is_block(spirv, pointed_to(spirv, words[1]));
    return words[3] == AOB_SPIRV_CLASS_UNIFORM_CONSTANT;
}

static bool is_uniform_in_head(const struct aob_spirv *spirv, size_t place, uint32_t id)
{
    uint32_t op = aob_spirv_op(spirv, place);
    if (op == AOB_SPIRV_VARIABLE)
        return is_uniform_variable(spirv, place);
    return op == AOB_SPIRV_EXT_INST_IMPORT || aob_spirv_is_constant(spirv, id);
}

/* Of an instruction whose operands are known already. One that has none, such as a variable of the invocation, makes
 * something of its own. */
static bool is_uniform_result(const struct aob_spirv *spirv, size_t place, const bool *uniform)
{
    const struct aob_operation *row = aob_operation_find(aob_spirv_op(spirv, place));
    uint32_t length = aob_spirv_length(spirv, place), count = 0, word;
    if (!row || row->image || aob_spirv_op(spirv, place) == AOB_SPIRV_PHI)
        return false;
    for (; (word = aob_operation_value(row, length, count)); count++) {
        uint32_t id = spirv->words[place + word];
        if (id >= spirv->bound || !uniform[id])
            return false;
    }
    return count > 0;
}

/* One way suffices: but for a phi's, all operands stand before what uses them. */
bool *aob_uniform_values(const struct aob_spirv *spirv)
{
    bool *uniform = AOB_NEW_ARRAY(bool, spirv->bound);
    for (size_t at = AOB_SPIRV_HEAD; at < spirv->count; at += aob_spirv_length(spirv, at)) {
        uint32_t id = aob_spirv_result(spirv, at);
        if (id && at < spirv->body)
            uniform[id] = is_uniform_in_head(spirv, at, id);
        else if (id)
            uniform[id] = is_uniform_result(spirv, at, uniform);
    }
    return uniform;
}
