#include "job/layout_job.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "job/term.h"
#include "technique/graph.h"
#include "technique/param.h"
#include "worker.h"

/* Of a tabulated falloff, over the root of the distance: Alchemy's peak lies at sqrt(epsilon)/r. */
enum { FALLOFF_ROWS = 1025 };

/* False with a line if a value is not finite. Where it is 1 throughout the term keeps none: it is the truth then. */
static bool tabulate(const struct aob_definition *definition, const void *values, float table[FALLOFF_ROWS],
                     struct aob_term *term, struct aob_error *error)
{
    bool hard = true;
    for (int i = 0; i < FALLOFF_ROWS; i++) {
        double root = (double)i / (FALLOFF_ROWS - 1);
        table[i] = definition->falloff(values, (float)(root * root));
        hard = hard && table[i] == 1;
        if (!isfinite(table[i]))
            return aob_fail(error, "its definition's falloff is not finite");
    }
    term->falloff = hard ? NULL : table;
    term->falloff_count = hard ? 0 : FALLOFF_ROWS;
    return true;
}

static bool is_uniform(const struct aob_technique *technique, const void *values)
{
    const struct aob_param *row = aob_param_find(technique->params, technique->param_count, "weighting");
    int32_t weight = (int32_t)technique->definition.weight;
    if (row && row->type == AOB_INT)
        memcpy(&weight, (const char *)values + row->offset, sizeof weight);
    return weight == AOB_WEIGHT_UNIFORM;
}

/* NAN where the technique has none to trace. */
static float radius_of(const struct aob_technique *technique, const void *values)
{
    const struct aob_param *row = aob_param_find(technique->params, technique->param_count, "radius");
    float radius = NAN;
    if (technique->definition.radius)
        radius = technique->definition.radius(values);
    else if (row && row->type == AOB_FLOAT)
        memcpy(&radius, (const char *)values + row->offset, sizeof radius);
    return radius;
}

/* NULL where it claims nothing; false with a line if the definition makes no sense. */
static bool define(const struct aob_technique *technique, const void *values, json_t **term,
                   struct aob_error *error)
{
    const struct aob_definition *definition = &technique->definition;
    float table[FALLOFF_ROWS], radius = radius_of(technique, values);
    struct aob_term made = {.radius = (double)radius, .uniform = is_uniform(technique, values)};
    if (isnan(radius))
        return true;
    if (!(radius > 0))
        return aob_fail(error, "its definition's radius is %g: it must be above 0", (double)radius);
    if (definition->falloff && isfinite(radius) && !tabulate(definition, values, table, &made, error))
        return false;
    made.of_triangle = definition->distance && definition->distance(values) == AOB_DISTANCE_TRIANGLE;
    *term = aob_term_to_json(&made);
    return true;
}

static unsigned outputs_of(const struct aob_pass_graph *graph)
{
    unsigned outputs = 0;
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        if (aob_graph_gives(graph, (enum aob_output)which))
            outputs |= 1u << which;
    return outputs;
}

static json_t *describe(const struct aob_pass_graph *graph, const void *values, const json_t *definition)
{
    struct aob_text dot = {0};
    char key[AOB_KEY_SIZE];
    aob_graph_digest(graph, values, key);
    aob_graph_dot(graph, &dot);
    json_t *answer = aob_layout_answer_to_json(
        &(struct aob_layout_answer){.status = "ok",
                                    .graph = key,
                                    .dot = dot.data,
                                    .outputs = outputs_of(graph),
                                    .triangles = aob_graph_needs_triangles(graph),
                                    .definition = definition,
                                    .mapped = graph->technique->definition.map != NULL});
    aob_text_finish(&dot);
    return answer;
}

static json_t *lay_case(const struct aob_technique *technique, const double *params, size_t count)
{
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    struct aob_error error = {{0}};
    unsigned char values[4 * AOB_MAX_PARAM];
    json_t *definition = NULL, *answer;
    bool ok = aob_worker_values(technique, params, count, values, &error) &&
              aob_graph_build(graph, technique, values, AOB_OUTPUTS_REQUIRED, AOB_OUTPUTS_WANTED, &error);
    if (ok && !define(technique, values, &definition, &error))
        ok = aob_fail_in(&error, "%s", technique->name);
    answer = ok ? describe(graph, values, definition)
                : aob_layout_answer_to_json(
                      &(struct aob_layout_answer){.status = "invalid", .reason = error.text});
    json_decref(definition);
    free(graph);
    return answer;
}

static bool layout(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_registry registry;
    struct aob_layout_job job;
    if (!aob_layout_job_from_json(worker->job, &job, error))
        return false;
    bool ok = aob_worker_registry(&job.modules, &registry, error);
    const struct aob_registry_entry *entry = ok ? aob_registry_find(&registry, job.technique) : NULL;
    for (size_t i = 0; entry && i < job.case_count; i++)
        aob_worker_reply(worker,
                         lay_case(entry->technique, job.params + i * job.param_count, job.param_count));
    if (ok && !entry)
        aob_fail(error, "no technique '%s'", job.technique);
    if (ok)
        aob_registry_finish(&registry);
    aob_layout_job_finish(&job);
    return entry;
}

const struct aob_worker_job aob_worker_layout = {"layout", layout};
