#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "gpu/gpu.h"
#include "timing/timing.h"
#include "measurement.h"
#include "technique/param.h"

/* A float by its shortest text, so that 0.2 is read as it was written. */
static json_t *value_to_json(const struct aob_param *param, double value)
{
    struct aob_text text = {0};
    double shortest = value;
    if (param->choices)
        return json_string(param->choices[(int)value]);
    if (param->type == AOB_INT)
        return json_integer((json_int_t)value);
    aob_param_print(param, value, &text);
    aob_parse_double(text.data, &shortest);
    aob_text_finish(&text);
    return json_real(shortest);
}

static json_t *values_to_json(const struct aob_param *params, size_t count, const double *values)
{
    json_t *object = json_object();
    for (size_t i = 0; i < count; i++)
        json_object_set_new(object, params[i].name, value_to_json(&params[i], values[i]));
    return object;
}

/* Who measured, as far as it is known without a device. */
static json_t *bare_fingerprint(void)
{
    char processor[256];
    aob_machine_processor(processor, sizeof processor);
    return json_pack("{s:s, s:s, s:i}", "program", AOBUDGET_VERSION, "cpu", processor, "cores",
                     aob_machine_cores());
}

static json_t *identity(const struct aob_case *c)
{
    return json_pack("{s:s, s:s, s:s, s:s, s:i, s:o, s:o, s:s, s:i, s:i, s:o, s:o}", "key", c->key, "scene",
                     c->scene->name, "view", c->scene->view, "technique", c->technique->name, "revision",
                     (int)c->technique->revision, "params",
                     values_to_json(c->technique->params, c->technique->param_count, c->params), "options",
                     values_to_json(aob_option_params, AOB_OPTION_COUNT, c->options), "backend", c->backend,
                     "width", c->width, "height", c->height, "reference_radius",
                     aob_json_number(c->reference_radius), "camera",
                     c->scene->framed ? json_null() : aob_camera_to_json(&c->scene->camera));
}

/* At a share t of the radius; the table is over the root of t, NULL is 1 throughout. */
static double falloff_at(const json_t *table, double t)
{
    size_t count = json_array_size(table);
    if (count < 2)
        return 1;
    double place = sqrt(t) * (double)(count - 1);
    size_t low = place < (double)(count - 2) ? (size_t)place : count - 2;
    double a = json_number_value(json_array_get(table, low)),
           b = json_number_value(json_array_get(table, low + 1));
    return a + (b - a) * (place - (double)low);
}

/* What the technique claims to compute, short enough for a record. */
static json_t *definition_to_json(const struct aob_state *state)
{
    const json_t *d = state->definition, *table = json_object_get(d, "falloff");
    json_t *falloff = json_array();
    for (int i = 0; i <= 4; i++)
        json_array_append_new(falloff, aob_json_number(falloff_at(table, i / 4.0)));
    return json_pack("{s:O, s:s, s:o, s:s, s:b}", "radius", json_object_get(d, "radius"), "weighting",
                     json_is_true(json_object_get(d, "uniform")) ? "uniform" : "cosine", "falloff", falloff,
                     "distance", json_is_true(json_object_get(d, "of_triangle")) ? "triangle" : "ray",
                     "mapped", state->mapped);
}

json_t *aob_record_create(const struct aob_measurement *m, size_t index, const char *status,
                          const char *reason, const json_t *answer)
{
    json_t *record = identity(&m->plan->cases[index]), *value;
    const char *name;
    bool measured = m->plan->config->measure_error;
    json_object_set_new(record, "spp", json_integer(measured ? m->plan->config->spp : 0));
    if (m->states && *m->states[index].graph)
        json_object_set_new(record, "graph", json_string(m->states[index].graph));
    if (m->states && m->states[index].definition)
        json_object_set_new(record, "definition", definition_to_json(&m->states[index]));
    json_object_set_new(record, "status", json_string(status));
    json_object_set_new(record, "reason", json_string(reason ? reason : ""));
    json_object_foreach((json_t *)(uintptr_t)answer, name, value)
    {
        if (strcmp(name, "index") != 0)
            json_object_set(record, name, value);
    }
    if (!json_object_get(record, "fingerprint"))
        json_object_set_new(record, "fingerprint", bare_fingerprint());
    return record;
}

/* A block under way: what its worker has answered. */
struct block {
    struct aob_measurement *m;
    const size_t *indices;
    size_t count;
    bool answered[AOB_BLOCK_MAX];
};

static void finish_case(struct block *block, size_t i, const char *status, const char *reason,
                        const json_t *answer)
{
    size_t index = block->indices[i];
    json_t *record = aob_record_create(block->m, index, status, reason, answer);
    block->answered[i] = true;
    block->m->states[index].stage = AOB_DONE;
    block->m->on_record(block->m->user, index, record);
    json_decref(record);
}

static char *image_name(const struct aob_measurement *m, size_t index)
{
    char name[AOB_KEY_SIZE + 16];
    snprintf(name, sizeof name, "images/%s.exr", m->plan->cases[index].key);
    return aob_strdup(name);
}

static void add_image(const struct block *block, size_t i, json_t *answer)
{
    char *name = image_name(block->m, block->indices[i]);
    char *path = block->m->folder ? aob_path_join(block->m->folder, name) : NULL;
    if (path && aob_file_exists(path))
        json_object_set_new(answer, "image", json_string(name));
    free(path);
    free(name);
}

static void take_answer(void *user, json_t *answer)
{
    struct block *block = user;
    const json_t *shares = json_object_get(answer, "shares"), *index = json_object_get(answer, "index");
    if (shares) {
        block->m->shares.measured += json_number_value(json_object_get(shares, "measured_s"));
        block->m->shares.warmup += json_number_value(json_object_get(shares, "warmup_s"));
        block->m->shares.images += json_number_value(json_object_get(shares, "images_s"));
    }
    size_t i = (size_t)json_integer_value(index);
    const char *status = json_string_value(json_object_get(answer, "status"));
    if (!index || i >= block->count || block->answered[i] || !status)
        return;
    add_image(block, i, answer);
    finish_case(block, i, status, json_string_value(json_object_get(answer, "reason")), answer);
}

static json_t *case_job(const struct block *block, size_t i, const struct aob_view_files *files)
{
    const struct aob_case *c = &block->m->plan->cases[block->indices[i]];
    json_t *job =
        json_pack("{s:s, s:o, s:o, s:o, s:b, s:s?, s:s?, s:s?}", "technique", c->technique->name, "params",
                  aob_json_vector(c->params, c->technique->param_count), "options",
                  aob_json_vector(c->options, AOB_OPTION_COUNT), "radius",
                  aob_json_number(c->reference_radius), "captured", c->scene->gbuffer != NULL, "reference",
                  files->reference[i], "definition", files->definition[i], "screen", files->screen[i]);
    if (block->m->image)
        json_object_set_new(job, "image", json_string(block->m->image));
    else if (block->m->folder && block->m->plan->config->images) {
        char *name = image_name(block->m, block->indices[i]), *path = aob_path_join(block->m->folder, name);
        json_object_set_new(job, "image", json_string(path));
        free(path);
        free(name);
    }
    return job;
}

static json_t *block_job(const struct block *block, const struct aob_view_files *files)
{
    const struct aob_case *c = &block->m->plan->cases[block->indices[0]];
    const struct aob_config *config = block->m->plan->config;
    json_t *cases = json_array();
    bool triangles = false;
    for (size_t i = 0; i < block->count; i++) {
        json_array_append_new(cases, case_job(block, i, files));
        triangles = triangles || block->m->states[block->indices[i]].triangles;
    }
    return json_pack("{s:s, s:s, s:b, s:b, s:o, s:s, s:o, s:i, s:i, s:i, s:s, s:f, s:b, s:b, s:b, s:o}",
                     files->mesh ? "mesh" : "scene", files->mesh ? files->mesh : c->scene->name, "job",
                     "block", "raster", aob_case_options(c).gbuffer == AOB_GBUFFER_RASTER, "triangles",
                     triangles, "modules", aob_dispatch_modules(block->m->dispatch), "backend", c->backend,
                     "camera", aob_camera_to_json(&c->scene->camera), "width", c->width, "height", c->height,
                     "guard", (int)aob_case_options(c).guard_band, "gbuffer", files->gbuffer, "seconds",
                     config->seconds, "time", config->measure_time, "error", config->measure_error,
                     "validate", block->m->dispatch->validate, "cases", cases);
}

static bool run_worker(struct block *block, const struct aob_view_files *files, struct aob_error *error)
{
    enum { ROOM = 32 };
    const struct aob_case *c = &block->m->plan->cases[block->indices[0]];
    const char *env[ROOM] = {0};
    char threads[40];
    size_t used = 0;
    for (const char *const *e = aob_gpu_find(c->backend)->environment; *e && used < ROOM - 2; e++)
        env[used++] = *e;
    snprintf(threads, sizeof threads, "LP_NUM_THREADS=%d", (int)aob_case_options(c).threads);
    if (aob_case_options(c).threads)
        env[used++] = threads;
    struct aob_job_desc desc = {.job = block_job(block, files),
                                .env = env,
                                .timeout_s =
                                    120 + 10 * block->m->plan->config->seconds * (double)block->count,
                                .on_answer = take_answer,
                                .user = block};
    return aob_dispatch_job(block->m->dispatch, &desc, error);
}

static void fail_rest(struct block *block, const char *reason)
{
    for (size_t i = 0; i < block->count; i++)
        if (!block->answered[i])
            finish_case(block, i, "failed", reason, NULL);
}

static void retry_alone(struct block *block)
{
    for (size_t i = 0; i < block->count; i++)
        if (!block->answered[i])
            aob_measurement_block(block->m, &block->indices[i], 1);
}

void aob_measurement_block(struct aob_measurement *m, const size_t *indices, size_t count)
{
    struct block block = {.m = m, .indices = indices, .count = count};
    struct aob_view_files files;
    struct aob_error error = {{0}};
    if (!aob_view_prepare(m, indices, count, &files, &error)) {
        fail_rest(&block, error.text);
        return;
    }
    bool ok = run_worker(&block, &files, &error);
    aob_view_files_finish(&files);
    if (!ok && count > 1)
        retry_alone(&block);
    else
        fail_rest(&block, ok ? "the worker gave no answer for this case" : error.text);
}
