#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "job/layout_job.h"
#include "measurement.h"

static void refuse(struct aob_state *state, const char *status, const char *reason)
{
    state->stage = AOB_REFUSED;
    snprintf(state->status, sizeof state->status, "%s", status);
    aob_line_print(state->reason, sizeof state->reason, "%s", reason);
}

/* The cases of one technique that a layout worker is working through. */
struct layout {
    struct aob_measurement *m;
    size_t *indices;
    size_t count, capacity, answered;
};

/* The digest goes into the record, the picture into the run's folder: graphs/DIGEST.dot. */
static void keep_graph(const struct aob_measurement *m, struct aob_state *state,
                       const struct aob_layout_answer *answer)
{
    if (!answer->graph || !answer->dot)
        return;
    snprintf(state->graph, sizeof state->graph, "%s", answer->graph);
    char *folder = m->folder ? aob_path_join(m->folder, "graphs") : NULL;
    if (folder && aob_folder_create(folder, NULL)) {
        struct aob_text path = {0};
        aob_text_add(&path, "%s/%s.dot", folder, answer->graph);
        if (!aob_file_exists(path.data))
            aob_file_write(path.data, answer->dot, strlen(answer->dot), NULL);
        aob_text_finish(&path);
    }
    free(folder);
}

static bool is_raster(const struct aob_case *c)
{
    return aob_case_options(c).gbuffer == AOB_GBUFFER_RASTER;
}

static void take_answer(void *user, const json_t *object)
{
    struct layout *layout = user;
    struct aob_layout_answer answer;
    if (!aob_layout_answer_from_json(object, &answer) || layout->answered == layout->count)
        return;
    struct aob_state *state = &layout->m->states[layout->indices[layout->answered++]];
    const struct aob_case *c = &layout->m->plan->cases[state - layout->m->states];
    keep_graph(layout->m, state, &answer);
    state->triangles = answer.triangles;
    state->outputs = answer.outputs;
    if (strcmp(answer.status, "ok") != 0)
        refuse(state, answer.status, answer.reason ? answer.reason : "refused without a reason");
    else if (state->triangles && c->scene->gbuffer)
        refuse(state, "unsupported", "it needs the scene's triangles, and a capture has none");
    else if (c->scene->motion.frames && (state->triangles || is_raster(c)))
        refuse(state, "unsupported",
               state->triangles
                   ? "it draws the scene's triangles, which a sequence does not bring along: leave "
                     "motion out"
                   : "a sequence is of ray-cast G-buffers: gbuffer must be canonical");
    else if (answer.definition) {
        state->definition = json_incref((json_t *)(uintptr_t)answer.definition);
        state->mapped = answer.mapped;
    }
}

/* The job for the cases that have no answer yet. */
static json_t *make_job(const struct layout *layout)
{
    const struct aob_plan *plan = layout->m->plan;
    const struct aob_technique_info *technique = plan->cases[layout->indices[0]].technique;
    struct aob_layout_job job = {.technique = aob_technique_address(technique),
                                 .case_count = layout->count - layout->answered,
                                 .param_count = technique->param_count};
    job.params = AOB_NEW_ARRAY(double, job.case_count *job.param_count);
    job.wanted = AOB_NEW_ARRAY(unsigned, job.case_count);
    for (size_t i = 0; i < job.case_count; i++) {
        const struct aob_case *c = &plan->cases[layout->indices[layout->answered + i]];
        struct aob_options options = aob_case_options(c);
        memcpy(job.params + i * job.param_count, c->params, job.param_count * sizeof *job.params);
        job.wanted[i] = aob_options_wanted(&options);
    }
    json_t *object = aob_layout_job_to_json(&job);
    aob_layout_job_finish(&job);
    return object;
}

/* An answer is a table of 1025 rows and a picture of the passes: about 15 KB. */
static size_t output_limit(size_t cases)
{
    return ((size_t)64 << 20) + cases * ((size_t)64 << 10);
}

/* A module that dies on a case costs that case; after three deaths the rest of its cases are given up. */
static void run_layout(struct layout *layout)
{
    for (int deaths = 0; layout->answered < layout->count;) {
        struct aob_error error = {{0}};
        struct aob_job_desc desc = {.job = make_job(layout),
                                    .timeout_s =
                                        10 + floor(1e-3 * (double)(layout->count - layout->answered)),
                                    .memory_limit = (size_t)4 << 30,
                                    .output_limit = output_limit(layout->count - layout->answered),
                                    .on_answer = take_answer,
                                    .user = layout};
        aob_dispatch_job(layout->m->dispatch, &desc, &error);
        if (layout->answered == layout->count)
            return; /* what a worker does after its last answer is no case's fault */
        const struct aob_case *c = &layout->m->plan->cases[layout->indices[layout->answered]];
        if (!*error.text)
            aob_fail(&error, "the worker ended without an answer: does the module end the process?");
        aob_fail_in(&error, "%s: laying out its passes", c->technique->name);
        deaths++;
        do
            refuse(&layout->m->states[layout->indices[layout->answered++]], "failed", error.text);
        while (deaths == 3 && layout->answered < layout->count);
    }
}

void aob_measurement_layout(struct aob_measurement *m)
{
    struct layout layout = {.m = m};
    const struct aob_technique_list *list = m->plan->techniques;
    for (size_t t = 0; t < list->count; t++) {
        layout.count = layout.answered = 0;
        for (size_t i = 0; i < m->plan->case_count; i++)
            if (m->plan->cases[i].technique == &list->items[t] && m->states[i].stage == AOB_PENDING)
                *AOB_PUSH(layout.indices, layout.count, layout.capacity) = i;
        if (layout.count)
            run_layout(&layout);
    }
    free(layout.indices);
}
