#include "record.h"
#include <string.h>
#include "base/json.h"
#include "base/machine.h"
#include "job/layout_job.h"
#include "job/term.h"
#include "scene/camera_json.h"
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
    return json_pack("{s:s, s:o, s:i}", "program", AOBUDGET_VERSION, "cpu", aob_json_text(processor), "cores",
                     aob_machine_cores());
}

/* Where the camera is in frame 0; in the last one it is the record's `camera`. */
static json_t *motion_to_json(const struct aob_motion *motion)
{
    const struct aob_vec3 e = motion->eye, t = motion->target;
    return json_pack("{s:i, s:[fff], s:[fff]}", "frames", motion->frames, "eye", e.x, e.y, e.z, "target", t.x,
                     t.y, t.z);
}

static json_t *identity(const struct aob_case *c)
{
    json_t *object = json_pack(
        "{s:s, s:s, s:s, s:f, s:s, s:i, s:o, s:o, s:s, s:i, s:i, s:o, s:o}", "key", c->key, "scene",
        c->scene->name, "view", c->scene->view, "metre", c->scene->metre, "technique", c->technique->name,
        "revision", (int)c->technique->revision, "params",
        values_to_json(c->technique->params, c->technique->param_count, c->params), "options",
        values_to_json(aob_option_params, AOB_OPTION_COUNT, c->options), "backend", c->backend, "width",
        c->width, "height", c->height, "reference_radius", aob_json_number(c->reference_radius), "camera",
        c->scene->framed ? json_null() : aob_camera_to_json(&c->scene->camera));
    if (c->scene->motion.frames)
        json_object_set_new(object, "motion", motion_to_json(&c->scene->motion));
    if (aob_case_is_lit(c))
        json_object_set_new(object, "light",
                            json_pack("{s:o, s:s}", "name", aob_json_text(c->scene->light_name), "digest",
                                      c->scene->light_digest));
    return object;
}

/* What the technique claims to compute, short enough for a record; NULL where its term cannot be read. */
static json_t *definition_to_json(const struct aob_state *state)
{
    struct aob_term term;
    if (!aob_term_from_json(state->definition, &term, NULL))
        return NULL;
    json_t *falloff = json_array();
    for (int i = 0; i <= 4; i++)
        json_array_append_new(falloff, aob_json_number(aob_term_falloff(&term, i / 4.0)));
    json_t *object = json_pack("{s:o, s:s, s:o, s:s, s:b}", "radius", aob_json_number(term.radius),
                               "weighting", term.uniform ? "uniform" : "cosine", "falloff", falloff,
                               "distance", term.of_triangle ? "triangle" : "ray", "mapped", state->mapped);
    aob_term_finish(&term);
    return object;
}

static void add_state(json_t *record, const struct aob_state *state)
{
    if (*state->graph)
        json_object_set_new(record, "graph", json_string(state->graph));
    if (state->outputs)
        json_object_set_new(record, "outputs", aob_outputs_to_json(state->outputs));
    json_t *definition = state->definition ? definition_to_json(state) : NULL;
    if (definition)
        json_object_set_new(record, "definition", definition);
}

/* What the worker measured; `error` is one of its `errors`. */
static void add_answer(json_t *record, const struct aob_record_desc *desc)
{
    const json_t *answer = desc->answer;
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)(uintptr_t)answer, name, value)
    {
        if (strcmp(name, "index") != 0)
            json_object_set(record, name, value);
    }
    json_t *errors = json_object_get(answer, "errors"), *entry;
    size_t at;
    json_array_foreach(errors, at, entry)
    {
        if (desc->truths && desc->truths[at])
            json_object_set_new(entry, "truth", json_string(desc->truths[at]));
    }
    json_t *own = json_array_get(errors, desc->target);
    if (own)
        json_object_set_new(record, "error", json_deep_copy(own));
}

/* A history is one of a class of devices, which is known only of a case that reached one. */
static void add_series(json_t *record, const struct aob_case *c)
{
    const char *class = json_string_value(json_object_get(json_object_get(record, "fingerprint"), "class"));
    char series[AOB_KEY_SIZE];
    if (!class)
        return;
    aob_case_series(c, class, series);
    json_object_set_new(record, "series", json_string(series));
}

json_t *aob_record_create(const struct aob_record_desc *desc)
{
    json_t *record = identity(desc->c);
    if (desc->c->technique->module)
        json_object_set_new(record, "module", json_string(desc->c->technique->module));
    bool scored = desc->config->measure_error;
    json_object_set_new(record, "spp", json_integer(scored ? desc->config->spp : 0));
    if (desc->state)
        add_state(record, desc->state);
    json_object_set_new(record, "status", json_string(desc->status));
    json_object_set_new(record, "reason", json_string(desc->reason ? desc->reason : ""));
    add_answer(record, desc);
    if (desc->image)
        json_object_set_new(record, "image", json_string(desc->image));
    if (!json_object_get(record, "fingerprint"))
        json_object_set_new(record, "fingerprint", bare_fingerprint());
    add_series(record, desc->c);
    return record;
}
