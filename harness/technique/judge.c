#include "registry.h"
#include <string.h>
#include "param.h"

static bool is_name(const char *name)
{
    if (!name || !(*name >= 'a' && *name <= 'z') || strlen(name) > 40)
        return false;
    return strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(name);
}

static bool judge_param(const struct aob_technique *technique, const struct aob_param *param,
                        struct aob_error *error)
{
    if (!is_name(param->name))
        return aob_fail(error, "technique '%s': a parameter's name is missing or not lower_snake",
                        technique->name);
    if (!param->doc || !*param->doc)
        return aob_fail(error, "technique '%s': parameter '%s' has no sentence", technique->name,
                        param->name);
    if ((param->type != AOB_FLOAT && param->type != AOB_INT) || (unsigned)param->stage > AOB_HOST ||
        (unsigned)param->unit > AOB_UNIT_COUNT || (unsigned)param->scale > AOB_LOG2 ||
        (unsigned)param->rule > AOB_POWER_OF_TWO || param->offset % 4 ||
        param->offset + 4 > technique->values_size)
        return aob_fail(error, "technique '%s': parameter '%s' has a bad type, stage, unit, rule or offset",
                        technique->name, param->name);
    if (param->choices)
        return (param->type == AOB_INT && !param->rule) ||
               aob_fail(error, "technique '%s': choice '%s' is not an int32_t, or has a rule",
                        technique->name, param->name);
    if (!(param->min <= param->initial && param->initial <= param->max))
        return aob_fail(error, "technique '%s': parameter '%s': the default is outside its bounds",
                        technique->name, param->name);
    if (param->rule && (param->type != AOB_INT || !aob_param_obeys(param, param->initial)))
        return aob_fail(error,
                        "technique '%s': parameter '%s' has a rule that is for no whole number, or that its "
                        "default breaks",
                        technique->name, param->name);
    return true;
}

static bool judge_sampling(const struct aob_technique *technique, struct aob_error *error)
{
    const struct aob_sampling *sampling = &technique->sampling;
    const struct aob_param *param =
        sampling->param ? aob_param_find(technique->params, technique->param_count, sampling->param) : NULL;
    if ((unsigned)sampling->sequence > AOB_SEQUENCE_INDEPENDENT ||
        (sampling->param ? !param || param->type != AOB_INT || !sampling->sequence : sampling->sequence != 0))
        return aob_fail(error, "technique '%s': its sampling names no whole-number parameter, or no sequence",
                        technique->name);
    return true;
}

bool aob_technique_judge(const struct aob_technique *technique, struct aob_error *error)
{
    if (technique->abi != AOB_ABI || technique->size != sizeof *technique)
        return aob_fail(
            error,
            "a technique made for module interface %u (%u bytes), this program has %u (%zu bytes): "
            "build it again",
            technique->abi, technique->size, AOB_ABI, sizeof *technique);
    if (!is_name(technique->name))
        return aob_fail(error, "a technique's name is missing or not lower_snake");
    if (!technique->title || !technique->citation || !technique->build || !technique->shaders)
        return aob_fail(error, "technique '%s' lacks a title, citation, build() or shaders", technique->name);
    if (technique->param_count > AOB_MAX_PARAM || technique->values_size > 4 * AOB_MAX_PARAM)
        return aob_fail(error, "technique '%s' has more than %d parameters", technique->name, AOB_MAX_PARAM);
    for (uint32_t i = 0; i < technique->param_count; i++)
        if (!judge_param(technique, &technique->params[i], error))
            return false;
    for (const struct aob_shader *s = technique->shaders; s->name; s++)
        if (!s->text)
            return aob_fail(error, "technique '%s': shader '%s' has no text", technique->name, s->name);
    return judge_sampling(technique, error);
}
