#include "param.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

const struct aob_param *aob_param_find(const struct aob_param *params, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(params[i].name, name) == 0)
            return &params[i];
    return NULL;
}

static bool parse_choice(const struct aob_param *param, const char *text, double *value,
                         struct aob_error *error)
{
    struct aob_text all = {0};
    for (int i = 0; param->choices[i]; i++) {
        aob_text_add(&all, "%s%s", i ? ", " : "", param->choices[i]);
        if (strcmp(param->choices[i], text) == 0) {
            *value = i;
            aob_text_finish(&all);
            return true;
        }
    }
    aob_fail(error, "%s: '%s' is not one of %s", param->name, text, all.data ? all.data : "(none)");
    aob_text_finish(&all);
    return false;
}

const char *aob_param_rule(const struct aob_param *param)
{
    static const char *const rules[] = {
        [AOB_ANY] = NULL, [AOB_ODD] = "odd, or 0", [AOB_POWER_OF_TWO] = "a power of two"};
    return rules[param->rule];
}

bool aob_param_obeys(const struct aob_param *param, double value)
{
    switch (param->rule) {
    case AOB_ODD:
        return value == 0 || fmod(fabs(value), 2) == 1;
    case AOB_POWER_OF_TWO:
        return value >= 1 && log2(value) == floor(log2(value));
    default:
        return true;
    }
}

bool aob_param_parse(const struct aob_param *param, const char *text, double *value, struct aob_error *error)
{
    if (param->choices)
        return parse_choice(param, text, value, error);
    double v;
    if (!aob_parse_double(text, &v) || isinf(v))
        return aob_fail(error, "%s: '%s' is not a number", param->name, text);
    if (param->type == AOB_INT && v != floor(v))
        return aob_fail(error, "%s: '%s' is not a whole number", param->name, text);
    if (v < param->min || v > param->max)
        return aob_fail(error, "%s: %s is outside %g .. %g", param->name, text, param->min, param->max);
    if (!aob_param_obeys(param, v))
        return aob_fail(error, "%s: %s: must be %s", param->name, text, aob_param_rule(param));
    *value = param->type == AOB_FLOAT ? (double)(float)v : v; /* what the shader will see */
    return true;
}

void aob_param_print(const struct aob_param *param, double value, struct aob_text *text)
{
    if (param->choices)
        aob_text_add(text, "%s", param->choices[(int)value]);
    else if (param->type == AOB_INT)
        aob_text_add(text, "%d", (int)value);
    else
        for (int digits = 3; digits <= 9; digits++) {
            char number[40];
            double back = 0;
            snprintf(number, sizeof number, "%.*g", digits, value);
            if (aob_parse_double(number, &back) && ((float)back == (float)value || digits == 9)) {
                aob_text_add(text, "%s", number);
                return;
            }
        }
}

/* A scene may be so small or so large that the length would leave its bounds: the bound is the nearest that there is. */
static double default_value(const struct aob_param *param, double metre)
{
    if (param->type != AOB_FLOAT)
        return param->initial;
    double value = param->unit == AOB_UNIT_LENGTH ? param->initial * metre : param->initial;
    return (double)(float)fmin(fmax(value, param->min), param->max);
}

void aob_param_defaults(const struct aob_param *params, size_t count, double metre, double *values)
{
    for (size_t i = 0; i < count; i++)
        values[i] = default_value(&params[i], metre);
}

void aob_param_pack(const struct aob_param *params, size_t count, const double *values, void *into,
                    size_t size)
{
    memset(into, 0, size);
    for (size_t i = 0; i < count; i++) {
        char *field = (char *)into + params[i].offset;
        if (params[i].type == AOB_INT)
            memcpy(field, &(int32_t){(int32_t)values[i]}, 4);
        else
            memcpy(field, &(float){(float)values[i]}, 4);
    }
}

const char *aob_unit_name(enum aob_unit unit)
{
    static const char *const names[] = {[AOB_UNIT_NONE] = "",
                                        [AOB_UNIT_LENGTH] = "scene units",
                                        [AOB_UNIT_PIXEL] = "pixels",
                                        [AOB_UNIT_RADIAN] = "radians",
                                        [AOB_UNIT_COUNT] = "count"};
    return names[unit];
}
