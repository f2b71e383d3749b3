#include "job/layout_job.h"
#include <stdlib.h>
#include "base/memory.h"
#include "job/term.h"
#include "technique/definition.h"
#include "technique/graph.h"
#include "worker.h"

/* The definition as a term; *term stays NULL where the technique claims nothing. */
static bool define(const struct aob_technique *technique, const void *values, json_t **term,
                   struct aob_error *error)
{
    struct aob_definition_table table;
    if (!aob_definition_tabulate(technique, values, &table, error))
        return aob_fail_in(error, "%s", technique->name);
    if (table.claims)
        *term = aob_term_to_json(&(struct aob_term){.radius = (double)table.radius,
                                                    .uniform = table.uniform,
                                                    .of_triangle = table.of_triangle,
                                                    .falloff = table.fades ? table.falloff : NULL,
                                                    .falloff_count = table.fades ? AOB_FALLOFF_ROWS : 0});
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

/* False with a line about the first wanted output that the technique does not give. */
static bool gives_all(const struct aob_pass_graph *graph, struct aob_error *error)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        if (graph->wanted >> which & 1 && graph->outputs[which] < 0)
            return aob_fail(error, "%s gives no %s: leave the option %s off for it", graph->technique->name,
                            aob_output_name((enum aob_output)which), aob_output_name((enum aob_output)which));
    if (graph->wanted & AOB_WANT_THRIFT && !aob_graph_leaves_out(graph))
        return aob_fail(error, "%s leaves nothing out%s%s: leave the option thrift off for it",
                        graph->technique->name, graph->unclear ? ", because " : "",
                        graph->unclear ? graph->unclear : "");
    return true;
}

static json_t *refuse(const char *status, const struct aob_error *error)
{
    return aob_layout_answer_to_json(&(struct aob_layout_answer){.status = status, .reason = error->text});
}

static json_t *lay_case(const struct aob_technique *technique, const double *params, size_t count,
                        unsigned wanted)
{
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    struct aob_error error = {{0}};
    unsigned char values[4 * AOB_MAX_PARAM];
    json_t *definition = NULL, *answer;
    bool ok = aob_worker_values(technique, params, count, values, &error) &&
              aob_graph_build(graph, technique, values, wanted, &error) &&
              define(technique, values, &definition, &error);
    if (!ok)
        answer = refuse("invalid", &error);
    else if (!gives_all(graph, &error))
        answer = refuse("unsupported", &error);
    else
        answer = describe(graph, values, definition);
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
    aob_registry_init(&registry);
    const struct aob_technique *technique = aob_registry_open(&registry, &job.technique, error);
    for (size_t i = 0; technique && i < job.case_count; i++)
        aob_worker_reply(
            worker, lay_case(technique, job.params + i * job.param_count, job.param_count, job.wanted[i]));
    aob_registry_finish(&registry);
    aob_layout_job_finish(&job);
    return technique;
}

const struct aob_worker_job aob_worker_layout = {"layout", layout};
