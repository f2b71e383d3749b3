#include "registry.h"
#include <float.h>
#include <jansson.h>
#include <math.h>
#include <string.h>
#include "option.h"
#include "param.h"

static bool is_name(const char *name)
{
    if (!name || !(*name >= 'a' && *name <= 'z') || strlen(name) > 40)
        return false;
    return strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(name);
}

/* Descriptions travel as JSON, which has no other text. */
static bool is_text(const char *text)
{
    json_t *json = text ? json_string(text) : NULL;
    json_decref(json);
    return json;
}

static bool judge_choices(const struct aob_technique *technique, const struct aob_param *param,
                          struct aob_error *error)
{
    int count = 0;
    for (; param->choices[count]; count++)
        if (!is_text(param->choices[count]))
            return aob_fail(error, "technique '%s': a choice of '%s' is not UTF-8 text", technique->name,
                            param->name);
    if (param->type != AOB_INT || param->rule)
        return aob_fail(error, "technique '%s': choice '%s' is not an int32_t, or has a rule",
                        technique->name, param->name);
    if (!isfinite(param->min) ||
        !isfinite(param->max)) /* unused, but the description has them, and JSON has no such */
        return aob_fail(error, "technique '%s': choice '%s': min and max must be finite: leave them out",
                        technique->name, param->name);
    bool listed = param->initial >= 0 && param->initial < count && param->initial == floor(param->initial);
    return listed || aob_fail(error, "technique '%s': choice '%s' has %d names, and %g is none of them",
                              technique->name, param->name, count, param->initial);
}

/* A bound must be a value that the field can hold: packing rounds, and an int that does not fit would be another. */
static bool holds(const struct aob_param *param, double value)
{
    if (param->type == AOB_INT)
        return value == floor(value) && value >= INT32_MIN && value <= INT32_MAX;
    return fabs(value) <= (double)FLT_MAX;
}

static bool judge_numbers(const struct aob_technique *technique, const struct aob_param *param,
                          struct aob_error *error)
{
    if (!holds(param, param->min) || !holds(param, param->max) || !holds(param, param->initial))
        return aob_fail(
            error, "technique '%s': parameter '%s': min, max and default must be finite values of its type",
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

static bool judge_param(const struct aob_technique *technique, const struct aob_param *param,
                        struct aob_error *error)
{
    if (!is_name(param->name) || strncmp(param->name, "aob_", 4) == 0)
        return aob_fail(error,
                        "technique '%s': a parameter's name is missing, not lower_snake, or begins with aob_",
                        technique->name);
    if (!is_text(param->doc) || !*param->doc)
        return aob_fail(error, "technique '%s': parameter '%s' has no sentence, or one that is not UTF-8",
                        technique->name, param->name);
    if ((param->type != AOB_FLOAT && param->type != AOB_INT) || (unsigned)param->stage > AOB_HOST ||
        (unsigned)param->unit > AOB_UNIT_COUNT || (unsigned)param->scale > AOB_LOG2 ||
        (unsigned)param->rule > AOB_POWER_OF_TWO || (unsigned)param->output >= AOB_OUTPUT_COUNT ||
        param->offset % 4 || technique->values_size < 4 || param->offset > technique->values_size - 4)
        return aob_fail(error,
                        "technique '%s': parameter '%s' has a bad type, stage, unit, rule, output or offset",
                        technique->name, param->name);
    return param->choices ? judge_choices(technique, param, error) : judge_numbers(technique, param, error);
}

/* A second row of a name, or of a place, would take the user's value without a word; so would a run option's name. */
static bool judge_apart(const struct aob_technique *technique, uint32_t index, struct aob_error *error)
{
    const struct aob_param *param = &technique->params[index];
    if (aob_param_find(aob_option_params, AOB_OPTION_COUNT, param->name))
        return aob_fail(error, "technique '%s': parameter '%s' is called like a run option: rename it",
                        technique->name, param->name);
    for (uint32_t i = 0; i < index; i++) {
        const struct aob_param *other = &technique->params[i];
        if (strcmp(other->name, param->name) == 0 || other->offset == param->offset)
            return aob_fail(error, "technique '%s': parameters '%s' and '%s' have one name or one field",
                            technique->name, other->name, param->name);
    }
    return true;
}

static bool judge_params(const struct aob_technique *technique, struct aob_error *error)
{
    if (technique->param_count > AOB_MAX_PARAM || technique->values_size > 4 * AOB_MAX_PARAM)
        return aob_fail(error, "technique '%s' has more than %d parameters", technique->name, AOB_MAX_PARAM);
    if (technique->param_count && !technique->params)
        return aob_fail(error, "technique '%s' has no table for its %u parameters", technique->name,
                        technique->param_count);
    for (uint32_t i = 0; i < technique->param_count; i++)
        if (!judge_param(technique, &technique->params[i], error) || !judge_apart(technique, i, error))
            return false;
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

static bool judge_texts(const struct aob_technique *technique, struct aob_error *error)
{
    if (!technique->build || !technique->shaders || !is_text(technique->title) ||
        !is_text(technique->citation))
        return aob_fail(error,
                        "technique '%s' lacks a title, citation, build() or shaders, or they are not UTF-8",
                        technique->name);
    if ((technique->summary && !is_text(technique->summary)) ||
        (technique->notes && !is_text(technique->notes)))
        return aob_fail(error, "technique '%s': its summary or notes are not UTF-8 text", technique->name);
    for (const struct aob_shader *s = technique->shaders; s->name; s++)
        if (!s->text)
            return aob_fail(error, "technique '%s': shader '%s' has no text", technique->name, s->name);
    for (const struct aob_by_definition *d = technique->by_definition; d && d->property; d++)
        if (!is_name(d->property) || !is_text(d->because) || !*d->because)
            return aob_fail(
                error,
                "technique '%s': what fails by definition is not named in lower_snake, or without "
                "its sentence",
                technique->name);
    return true;
}

uint32_t aob_abi_number(uint32_t abi)
{
    return abi >> 16 ? abi >> 16 : abi;
}

bool aob_technique_judge(const struct aob_technique *technique, struct aob_error *error)
{
    if (technique->abi != AOB_ABI || technique->size != sizeof *technique)
        return aob_fail(
            error,
            "a technique made for module interface %u (%u bytes), this program has %u (%zu bytes): "
            "build it again",
            aob_abi_number(technique->abi), technique->size, AOB_ABI, sizeof *technique);
    if (!is_name(technique->name))
        return aob_fail(error, "a technique's name is missing or not lower_snake");
    return judge_texts(technique, error) && judge_params(technique, error) &&
           judge_sampling(technique, error);
}
