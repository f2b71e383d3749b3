#include "model.h"
#include <math.h>

static const double per_ms = 1e6; /* of a G a second */

/* The lower end, the middle and the upper one of a resource's time. */
struct span {
    double low, middle, high;
};

static struct span exact(double ms)
{
    return (struct span){ms, ms, ms};
}

/* A special function either holds the lanes up or runs beside them. */
static struct span alu_span(const struct aob_rates *rates, const struct aob_operations *operations)
{
    double slots = rates->lanes * rates->alu_clock * per_ms;
    double full = operations->alu / slots, special = operations->special / (slots * rates->special);
    return exact(rates->special_blocks ? full + special : fmax(full, special));
}

static struct span texture_span(const struct aob_rates *rates, const struct aob_issue *issue)
{
    double texels = rates->texture_units * rates->clock * per_ms;
    return (struct span){(double)issue->least / texels, (double)issue->banked / texels,
                         (double)issue->most / texels};
}

/* `fixed` bytes are moved whatever the number of warps in flight. */
static struct span byte_span(const double filled[AOB_FLIGHT_COUNT], double fixed, double bytes_a_ms)
{
    double one = (filled[AOB_FLIGHT_ONE] + fixed) / bytes_a_ms,
           most = (filled[AOB_FLIGHT_MOST] + fixed) / bytes_a_ms;
    return (struct span){fmin(one, most), (one + most) / 2, fmax(one, most)};
}

static void measure(const struct aob_profile *profile, const struct aob_model_input *input,
                    struct span spans[AOB_RESOURCE_COUNT])
{
    const struct aob_rates *rates = &profile->rates;
    int last = profile->level_count - 1;
    for (int r = 0; r < AOB_RESOURCE_COUNT; r++)
        spans[r] = exact(0);
    spans[AOB_RESOURCE_ALU] = alu_span(rates, &input->operations);
    spans[AOB_RESOURCE_TEXTURE] = texture_span(rates, &input->issue);
    for (int l = 0; l < last; l++)
        spans[AOB_RESOURCE_FILL + l] =
            byte_span(input->filled[l], 0,
                      (double)profile->levels[l].fill * profile->levels[l].ports * rates->clock * per_ms);
    spans[AOB_RESOURCE_MEMORY] = byte_span(input->filled[last], input->written, rates->memory * per_ms);
    spans[AOB_RESOURCE_TARGETS] = exact(input->pixels / (rates->rops * rates->clock * per_ms));
}

struct aob_model_time aob_model_pass(const struct aob_profile *profile, const struct aob_model_input *input)
{
    struct aob_model_time modelled = {0};
    struct span spans[AOB_RESOURCE_COUNT];
    double squares = 0;
    measure(profile, input, spans);
    for (int r = 0; r < AOB_RESOURCE_COUNT; r++) {
        modelled.resources[r] = spans[r].middle;
        squares += spans[r].middle * spans[r].middle;
        modelled.low_ms = fmax(modelled.low_ms, spans[r].low);
        modelled.high_ms += spans[r].high;
    }
    modelled.launch_ms = profile->rates.launch / 1e3;
    modelled.ms = sqrt(squares) + modelled.launch_ms;
    modelled.low_ms += modelled.launch_ms;
    modelled.high_ms += modelled.launch_ms;
    return modelled;
}

void aob_model_add(struct aob_model_time *frame, const struct aob_model_time *pass)
{
    frame->ms += pass->ms;
    frame->low_ms += pass->low_ms;
    frame->high_ms += pass->high_ms;
    frame->launch_ms += pass->launch_ms;
    for (int r = 0; r < AOB_RESOURCE_COUNT; r++)
        frame->resources[r] += pass->resources[r];
}

enum aob_resource aob_model_limit(const struct aob_model_time *modelled)
{
    int limit = 0;
    for (int r = 1; r < AOB_RESOURCE_COUNT; r++)
        if (modelled->resources[r] > modelled->resources[limit])
            limit = r;
    return (enum aob_resource)limit;
}

const char *aob_model_resource_name(const struct aob_profile *profile, enum aob_resource resource)
{
    static const char *const names[AOB_RESOURCE_COUNT] = {[AOB_RESOURCE_ALU] = "alu",
                                                          [AOB_RESOURCE_TEXTURE] = "texture",
                                                          [AOB_RESOURCE_MEMORY] = "memory",
                                                          [AOB_RESOURCE_TARGETS] = "targets"};
    int level = (int)resource - AOB_RESOURCE_FILL;
    if (level >= 0 && level < profile->level_count - 1)
        return profile->levels[level].name;
    return names[resource];
}
