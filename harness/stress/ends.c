#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "numbers.h"
#include "sets.h"
#include "technique/param.h"

/* Adds " name=value" with the value nearest to `value` that keeps the parameter's rule. */
static void add_word(struct aob_text *set, const struct aob_param *param, double value)
{
    for (int i = 0; i < 64 && param->type == AOB_INT && !param->choices && !aob_param_obeys(param, value);
         i++)
        value = value > param->min ? value - 1 : param->max;
    aob_text_add(set, " %s=", param->name);
    aob_param_print(param, value, set);
}

static size_t choices_of(const struct aob_param *param)
{
    size_t count = 0;
    while (param->choices && param->choices[count])
        count++;
    return count;
}

/* The ends of a parameter. A count bounds a loop and costs by its value, so its upper end here is three times the default:
 * beyond it there is more of the same. */
static double end_of(const struct aob_param *param, bool upper)
{
    if (param->choices)
        return upper ? (double)(choices_of(param) - 1) : 0;
    bool counts = param->unit == AOB_UNIT_COUNT && param->stage != AOB_UNIFORM;
    return !upper ? param->min : counts ? fmin(param->max, fmax(3 * param->initial, 3)) : param->max;
}

/* Draws what the text sets; values that check() refuses are no question. */
static void ask_set(struct aob_trial *trial, struct aob_exhibit *exhibit, const char *set)
{
    const struct aob_technique *technique = trial->subject->technique;
    const struct aob_shot shot = {.exhibit = exhibit, .radius = 0.8, .set = set};
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    const char *why;
    if (!aob_subject_values(trial->subject, &shot, values, &options, NULL) ||
        (technique->check && !technique->check(values, &why)))
        return;
    const float *image = aob_trial_draw(trial, &shot);
    aob_trial_take(trial, 0, &(struct aob_seen){&shot, image, NULL}, "%s", set);
}

/* Those that programs are compiled for go to their ends together, since each value is another program. */
void aob_ask_parameter_ends(struct aob_trial *trial)
{
    const struct aob_technique *technique = trial->subject->technique;
    struct aob_exhibit *exhibit = aob_set_still_life_at(trial, 1, aob_vec(0, 0, 0), 48, 32);
    ask_set(trial, exhibit, "");
    for (int upper = 0; upper < 2; upper++) {
        struct aob_text together = {0};
        for (uint32_t i = 0; i < technique->param_count; i++) {
            const struct aob_param *param = &technique->params[i];
            struct aob_text alone = {0};
            if (param->stage == AOB_CONSTANT)
                add_word(&together, param, end_of(param, upper));
            else
                add_word(&alone, param, end_of(param, upper));
            if (alone.data)
                ask_set(trial, exhibit, alone.data);
            aob_text_finish(&alone);
        }
        if (together.data)
            ask_set(trial, exhibit, together.data);
        aob_text_finish(&together);
    }
}
