#include "usual.h"
#include <math.h>
#include <string.h>
#include "base/member.h"
#include "option.h"

bool aob_usual_same(const json_t *a, const json_t *b)
{
    if (!json_is_number(a) || !json_is_number(b))
        return json_equal(a, b);
    double x = json_number_value(a), y = json_number_value(b);
    return fabs(x - y) <= 1e-6 * fmax(fabs(x), fabs(y));
}

json_t *aob_usual_params(const json_t *technique)
{
    json_t *defaults = json_object(), *param;
    size_t i;
    json_array_foreach(json_object_get(technique, "params"), i, param)
    {
        const json_t *choices = json_object_get(param, "choices");
        double initial = aob_member_number(param, "initial");
        bool length = strcmp(aob_member_text(param, "unit"), "scene_units") == 0;
        if (json_is_array(choices))
            json_object_set(defaults, aob_member_text(param, "name"),
                            json_array_get(choices, initial >= 0 && initial < 1e6 ? (size_t)initial : 0));
        else if (isfinite(initial))
            json_object_set_new(defaults, aob_member_text(param, "name"),
                                length ? json_pack("{s:f}", "metres", initial) : json_real(initial));
    }
    return defaults;
}

json_t *aob_usual_options(void)
{
    json_t *defaults = json_object();
    for (size_t i = 0; i < AOB_OPTION_COUNT; i++) {
        const struct aob_param *param = &aob_option_params[i];
        json_object_set_new(defaults, param->name,
                            param->choices ? json_string(param->choices[(size_t)param->initial])
                                           : json_real(param->initial));
    }
    return defaults;
}

bool aob_usual_is(const json_t *usual, const json_t *value, double metre)
{
    if (!json_is_object(usual))
        return aob_usual_same(usual, value);
    json_t *length = json_real(aob_member_number(usual, "metres") * (isfinite(metre) ? metre : 1));
    bool same = aob_usual_same(length, value);
    json_decref(length);
    return same;
}
