#include "target.h"
#include <math.h>
#include <string.h>
#include "base/json.h"
#include "base/text.h"

struct aob_target aob_target_of(const json_t *entry, const json_t *record)
{
    const json_t *target = json_object_get(entry, "target");
    const char *weighting = json_string_value(json_object_get(target, "weighting"));
    double radius = aob_json_to_number(json_is_object(target) ? json_object_get(target, "radius")
                                                              : json_object_get(record, "reference_radius"));
    return (struct aob_target){.radius = radius, .uniform = weighting && strcmp(weighting, "uniform") == 0};
}

/* A parameter's radius is a float, a config's is not: 0.3 of the two is one radius. */
int aob_target_compare(const struct aob_target *a, const struct aob_target *b)
{
    if (isnan(a->radius) || isnan(b->radius)) {
        if (isnan(a->radius) != isnan(b->radius))
            return isnan(a->radius) ? 1 : -1;
    } else if ((float)a->radius != (float)b->radius)
        return a->radius < b->radius ? -1 : 1;
    return (int)a->uniform - (int)b->uniform;
}

char *aob_target_say(const struct aob_target *target, bool screen)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s", screen ? "the screen-space bound" : "the truth");
    if (isinf(target->radius))
        aob_text_add(&text, " at any distance");
    else if (isfinite(target->radius))
        aob_text_add(&text, " within %.6g scene unit%s", target->radius, target->radius == 1 ? "" : "s");
    else
        aob_text_add(&text, " within a radius that the record does not name");
    if (target->uniform)
        aob_text_add(&text, ", directions weighted evenly");
    return text.data;
}

char *aob_target_slug(const struct aob_target *target)
{
    struct aob_text text = {0};
    aob_text_add(&text, isnan(target->radius) ? "unknown" : "%.6g", target->radius);
    aob_text_add(&text, target->uniform ? "-uniform" : "-cosine");
    return text.data;
}
