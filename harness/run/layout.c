#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "measurement.h"

bool aob_measurement_init(struct aob_measurement *m, const struct aob_dispatch *dispatch,
                          struct aob_plan *plan, struct aob_error *error)
{
    *m = (struct aob_measurement){.dispatch = dispatch, .plan = plan, .cache = aob_path_cache_folder()};
    m->states = AOB_NEW_ARRAY(struct aob_state, plan->case_count);
    if (aob_folder_create(m->cache, error))
        return true;
    aob_fail_in(error, "cache (set AOBUDGET_CACHE to move it)");
    aob_measurement_finish(m);
    return false;
}

void aob_measurement_finish(struct aob_measurement *m)
{
    for (size_t i = 0; m->states && i < m->plan->case_count; i++)
        json_decref(m->states[i].definition);
    free(m->states);
    free(m->cache);
    *m = (struct aob_measurement){0};
}

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
static void keep_graph(const struct aob_measurement *m, struct aob_state *state, const json_t *answer)
{
    const char *graph = json_string_value(json_object_get(answer, "graph"));
    const char *dot = json_string_value(json_object_get(answer, "dot"));
    if (!graph || !dot)
        return;
    snprintf(state->graph, sizeof state->graph, "%s", graph);
    char *folder = m->folder ? aob_path_join(m->folder, "graphs") : NULL;
    if (folder && aob_folder_create(folder, NULL)) {
        struct aob_text path = {0};
        aob_text_add(&path, "%s/%s.dot", folder, graph);
        aob_file_write(path.data, dot, strlen(dot), NULL);
        aob_text_finish(&path);
    }
    free(folder);
}

static void take_answer(void *user, json_t *answer)
{
    struct layout *layout = user;
    const char *status = json_string_value(json_object_get(answer, "status"));
    const char *reason = json_string_value(json_object_get(answer, "reason"));
    if (!status || layout->answered == layout->count)
        return;
    struct aob_state *state = &layout->m->states[layout->indices[layout->answered++]];
    const struct aob_case *c = &layout->m->plan->cases[state - layout->m->states];
    keep_graph(layout->m, state, answer);
    state->triangles = json_is_true(json_object_get(answer, "triangles"));
    if (strcmp(status, "ok") != 0)
        refuse(state, status, reason ? reason : "refused without a reason");
    else if (state->triangles && c->scene->gbuffer)
        refuse(state, "unsupported", "it needs the scene's triangles, and a capture has none");
    else if (json_is_object(json_object_get(answer, "definition"))) {
        state->definition = json_incref(json_object_get(answer, "definition"));
        state->mapped = json_is_true(json_object_get(answer, "mapped"));
    }
}

static json_t *layout_job(const struct layout *layout)
{
    const struct aob_plan *plan = layout->m->plan;
    json_t *cases = json_array();
    for (size_t i = layout->answered; i < layout->count; i++) {
        const struct aob_case *c = &plan->cases[layout->indices[i]];
        json_array_append_new(cases, aob_json_vector(c->params, c->technique->param_count));
    }
    return json_pack("{s:s, s:o, s:s, s:o}", "job", "layout", "modules",
                     aob_dispatch_modules(layout->m->dispatch), "technique",
                     plan->cases[layout->indices[0]].technique->name, "cases", cases);
}

/* A module that dies on a case costs that case; after three deaths the rest of its cases are given up. */
static void run_layout(struct layout *layout)
{
    for (int deaths = 0; layout->answered < layout->count;) {
        struct aob_error error = {{0}};
        struct aob_job_desc desc = {.job = layout_job(layout),
                                    .timeout_s = 10,
                                    .memory_limit = (size_t)4 << 30,
                                    .on_answer = take_answer,
                                    .user = layout};
        if (aob_dispatch_job(layout->m->dispatch, &desc, &error) && layout->answered == layout->count)
            return;
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
    for (size_t first = 0; first < m->plan->case_count; first++) {
        const struct aob_technique_info *technique = m->plan->cases[first].technique;
        bool seen = m->states[first].stage != AOB_PENDING;
        for (size_t i = 0; i < first && !seen; i++)
            seen = m->plan->cases[i].technique == technique && m->states[i].stage != AOB_DONE;
        if (seen)
            continue;
        layout.count = layout.answered = 0;
        for (size_t i = first; i < m->plan->case_count; i++)
            if (m->plan->cases[i].technique == technique && m->states[i].stage == AOB_PENDING)
                *AOB_PUSH(layout.indices, layout.count, layout.capacity) = i;
        run_layout(&layout);
    }
    free(layout.indices);
}
