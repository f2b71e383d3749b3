#include "target.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/text.h"

struct aob_target aob_target_of(const json_t *entry, const json_t *record)
{
    const json_t *target = json_object_get(entry, "target");
    const char *weighting = json_string_value(json_object_get(target, "weighting"));
    double radius = aob_json_to_number(json_is_object(target) ? json_object_get(target, "radius")
                                                              : json_object_get(record, "reference_radius"));
    const char *reference = json_string_value(json_object_get(entry, "reference"));
    return (struct aob_target){.radius = radius,
                               .uniform = weighting && strcmp(weighting, "uniform") == 0,
                               .screen = reference && strcmp(reference, "screen") == 0};
}

/* A parameter's radius is a float, a config's is not: 0.3 of the two is one radius. */
int aob_target_compare(const struct aob_target *a, const struct aob_target *b)
{
    if (isnan(a->radius) || isnan(b->radius)) {
        if (isnan(a->radius) != isnan(b->radius))
            return isnan(a->radius) ? 1 : -1;
    } else if ((float)a->radius != (float)b->radius)
        return a->radius < b->radius ? -1 : 1;
    if (a->uniform != b->uniform)
        return (int)a->uniform - (int)b->uniform;
    return (int)a->screen - (int)b->screen;
}

/* The shortest text that gives the same float again, so that two radii have one text only where they compare equal. */
static void print_radius(char text[32], double radius)
{
    for (int digits = 6; digits <= 9; digits++) {
        snprintf(text, 32, "%.*g", digits, (double)(float)radius);
        if (strtof(text, NULL) == (float)radius)
            return;
    }
}

char *aob_target_say(const struct aob_target *target)
{
    struct aob_text text = {0};
    char radius[32];
    print_radius(radius, target->radius);
    aob_text_add(&text, "%s", target->screen ? "the screen-space bound" : "the truth");
    if (isinf(target->radius))
        aob_text_add(&text, " at any distance");
    else if (isfinite(target->radius))
        aob_text_add(&text, " within %s scene unit%s", radius, strcmp(radius, "1") == 0 ? "" : "s");
    else
        aob_text_add(&text, " within a radius that the record does not name");
    if (target->uniform)
        aob_text_add(&text, ", directions weighted evenly");
    return text.data;
}

char *aob_target_slug(const struct aob_target *target)
{
    struct aob_text text = {0};
    char radius[32];
    print_radius(radius, target->radius);
    aob_text_add(&text, "%s%s%s", isnan(target->radius) ? "unknown" : radius,
                 target->uniform ? "-uniform" : "-cosine", target->screen ? "-screen" : "");
    return text.data;
}
