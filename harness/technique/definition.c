#include "definition.h"
#include <math.h>
#include <string.h>
#include "param.h"

/* A parameter of the technique, of that type; NULL if it has none. */
static const void *find_value(const struct aob_technique *technique, const void *values, const char *name,
                              enum aob_type type)
{
    const struct aob_param *row = aob_param_find(technique->params, technique->param_count, name);
    return row && row->type == type ? (const char *)values + row->offset : NULL;
}

static bool tabulate_falloff(const struct aob_definition *definition, const void *values,
                             struct aob_definition_table *table, struct aob_error *error)
{
    for (int i = 0; i < AOB_FALLOFF_ROWS; i++) {
        double root = (double)i / (AOB_FALLOFF_ROWS - 1);
        table->falloff[i] = definition->falloff(values, (float)(root * root));
        if (!isfinite(table->falloff[i]))
            return aob_fail(error, "its definition's falloff is not finite");
        table->fades = table->fades || table->falloff[i] != 1;
    }
    return true;
}

bool aob_definition_tabulate(const struct aob_technique *technique, const void *values,
                             struct aob_definition_table *table, struct aob_error *error)
{
    const struct aob_definition *definition = &technique->definition;
    const void *radius = find_value(technique, values, "radius", AOB_FLOAT);
    const void *weighting = find_value(technique, values, "weighting", AOB_INT);
    int32_t weight = (int32_t)definition->weight;
    *table = (struct aob_definition_table){.radius = NAN};
    if (definition->radius)
        table->radius = definition->radius(values);
    else if (radius)
        memcpy(&table->radius, radius, sizeof table->radius);
    if (isnan(table->radius))
        return true;
    if (!(table->radius > 0))
        return aob_fail(error, "its definition's radius is %g: it must be above 0", (double)table->radius);
    if (weighting)
        memcpy(&weight, weighting, sizeof weight);
    table->claims = true;
    table->uniform = weight == AOB_WEIGHT_UNIFORM;
    table->of_triangle = definition->distance && definition->distance(values) == AOB_DISTANCE_TRIANGLE;
    /* A share of an endless radius is no distance. */
    return !definition->falloff || !isfinite(table->radius) ||
           tabulate_falloff(definition, values, table, error);
}
