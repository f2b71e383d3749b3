#include "report.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "capture_words.h"
#include "plan/plan.h"

static const struct aob_case *planned(const struct aob_effects *e)
{
    return &aob_effects_sweep(e)->plan.cases[0];
}

/* Without a truth there is no target, and the technique's own radius tells. */
static double radius_of(const struct aob_effects *e)
{
    return e->answer.no_truth ? aob_case_radius(planned(e)) : planned(e)->reference_radius;
}

static const struct aob_effect_candidate *chosen_of(const struct aob_effects *e)
{
    return e->answer.chosen < 0 ? NULL : &e->answer.candidates[e->answer.chosen];
}

static json_t *names_to_json(unsigned set)
{
    json_t *names = json_array();
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        if (aob_effect_has(set, (enum aob_effect_id)id))
            json_array_append_new(names, json_string(aob_effect_rows[id].name));
    return names;
}

static json_t *candidate_to_json(const struct aob_effect_candidate *c)
{
    return c ? json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:b, s:b, s:b}", "effects",
                         names_to_json(c->set), "rmse", aob_json_number(c->error.rmse), "rmse_se",
                         aob_json_number(c->error.rmse_se), "flip", aob_json_number(c->error.flip), "flicker",
                         aob_json_number(c->flicker), "loss", aob_json_number(c->loss), "ms",
                         aob_json_number(c->ms), "timed", c->drawn, "within", c->within, "fits", c->fits)
             : json_null();
}

static const char *const whys[] = {[AOB_WHY_MEASURED] = "measured",
                                   [AOB_WHY_RULE] = "rule",
                                   [AOB_WHY_NO_DATA] = "no data",
                                   [AOB_WHY_BUDGET] = "budget"};

static json_t *row_to_json(const struct aob_effects *e, enum aob_effect_id id)
{
    const struct aob_effect_answer *a = &e->answer;
    const struct aob_effect_candidate *chosen = chosen_of(e);
    const struct aob_effect_candidate *other =
        chosen ? aob_effect_answer_find(a, aob_effect_turned(chosen->set, id)) : NULL;
    struct aob_text sentence = {0};
    aob_effect_answer_explain(a, id, &sentence);
    json_t *row = json_pack("{s:s, s:s, s:b, s:s, s:o, s:s, s:o}", "name", aob_effect_rows[id].name, "is",
                            aob_effect_rows[id].is, "called", chosen && aob_effect_has(chosen->set, id), "by",
                            whys[aob_effect_answer_why(a, id)], "most", aob_json_number(a->bounds.most[id]),
                            "sentence", sentence.data, "otherwise", candidate_to_json(other));
    aob_text_finish(&sentence);
    return row;
}

static json_t *lists_to_json(const struct aob_effects *e)
{
    const struct aob_effect_answer *a = &e->answer;
    json_t *rows = json_array(), *sets = json_array(), *ties = json_array();
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        json_array_append_new(rows, row_to_json(e, (enum aob_effect_id)id));
    for (size_t i = 0; i < a->count; i++) {
        json_array_append_new(sets, candidate_to_json(&a->candidates[i]));
        if (aob_effect_answer_ties(a, &a->candidates[i]))
            json_array_append_new(ties, names_to_json(a->candidates[i].set));
    }
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "effects", rows, "sets", sets, "chosen",
                     candidate_to_json(chosen_of(e)), "least", candidate_to_json(&a->candidates[a->least]),
                     "ties", ties);
}

json_t *aob_effects_to_json(const struct aob_effects *e)
{
    const struct aob_effect_ask *ask = &e->answer.ask;
    const struct aob_case *c = planned(e);
    const json_t *fingerprint = json_object_get(json_array_get(e->time_records[0], 0), "fingerprint");
    json_t *document = json_pack("{s:o, s:s, s:s, s:i, s:i, s:i, s:s, s:o, s:o, s:o, s:o, s:i, s:i}", "scene",
                                 aob_json_text(c->scene->name), "view", c->scene->view, "backend", c->backend,
                                 "width", c->width, "height", c->height, "frames", e->answer.frames, "light",
                                 c->scene->light_name, "radius", aob_json_number(radius_of(e)), "tolerance",
                                 aob_json_number(aob_effect_ask_tolerance(ask)), "budget_ms",
                                 isfinite(ask->budget_ms) ? json_real(ask->budget_ms) : json_null(),
                                 "profile", ask->profile ? aob_json_text(ask->profile) : json_null(), "spp",
                                 e->spp, "flip_shrink", e->answer.shrink);
    struct aob_text against = {0};
    aob_effect_against(&e->answer, e->spp, &against);
    json_object_set_new(document, "reference", json_string(e->answer.no_truth ? "own" : "ray-traced"));
    json_object_set_new(document, "reference_effects",
                        e->answer.no_truth ? names_to_json(e->answer.reference) : json_null());
    json_object_set_new(document, "against", json_string(against.data));
    aob_text_finish(&against);
    json_object_set_new(document, "materials", json_boolean(e->seen.has_material));
    json_object_set_new(
        document, "seconds",
        json_pack("{s:f, s:f, s:f}", "truth", e->truth_s, "images", e->images_s, "times", e->times_s));
    json_object_set(document, "fingerprint", (json_t *)(uintptr_t)fingerprint);
    json_t *lists = lists_to_json(e);
    json_object_update(document, lists);
    json_decref(lists);
    return document;
}

/* Whether another set is no worse in error, flicker and time, and better in one. */
static bool is_beaten(const struct aob_effect_answer *a, const struct aob_effect_candidate *c)
{
    for (size_t i = 0; i < a->count; i++) {
        const struct aob_effect_candidate *other = &a->candidates[i];
        if (other->error.rmse <= c->error.rmse && other->ms <= c->ms && !(other->flicker > c->flicker) &&
            (other->error.rmse < c->error.rmse || other->ms < c->ms || other->flicker < c->flicker))
            return true;
    }
    return false;
}

static void print_candidate(const struct aob_effects *e, const struct aob_effect_candidate *c,
                            struct aob_text *out)
{
    struct aob_text name = {0};
    char flicker[16] = "";
    aob_effect_set_print(c->set, &name);
    if (isfinite(c->flicker))
        snprintf(flicker, sizeof flicker, " %7.2f", 100 * c->flicker);
    aob_text_add_line(out, "%s %-58s %7.2f +-%.2f %7.3f%s %9.3g%s", c == chosen_of(e) ? "*" : " ", name.data,
                      100 * c->error.rmse, 200 * c->error.rmse_se, c->error.flip, flicker, c->ms,
                      aob_effect_answer_ties(&e->answer, c) ? "  as good as the chosen one" : "");
    aob_text_finish(&name);
}

/* What is wrong with a set that is taken all the same. */
static const char *shortfall_of(const struct aob_effect_answer *a, const struct aob_effect_candidate *c)
{
    if (c->within)
        return "";
    if (isfinite(a->ask.budget_ms) && !isnan(a->ask.tolerance))
        return "; no set within the tolerance fits the budget";
    return "; no set is near the least in both error and flicker";
}

static void print_choice(const struct aob_effects *e, struct aob_text *out)
{
    const struct aob_effect_answer *a = &e->answer;
    const struct aob_effect_candidate *c = chosen_of(e);
    struct aob_text name = {0};
    aob_effect_set_print(c ? c->set : 0, &name);
    if (c)
        aob_text_add_line(out, "take: %s: %.3g ms, %s by %.3g %%%s", name.data, c->ms,
                          a->no_truth ? "differs" : "off", 100 * c->error.rmse, shortfall_of(a, c));
    else
        aob_text_add_line(out, "nothing fits %g ms: the lit image without any occlusion takes %.3g ms",
                          a->ask.budget_ms, a->candidates[0].ms);
    aob_text_finish(&name);
}

static void print_head(const struct aob_effects *e, struct aob_text *out)
{
    const struct aob_case *c = planned(e);
    struct aob_text against = {0};
    aob_effect_against(&e->answer, e->spp, &against);
    aob_text_add_line(out, "%s/%s, %dx%d, %s, light %s, radius %.4g: the lit image %s", c->scene->name,
                      c->scene->view, c->width, c->height, c->backend, c->scene->light_name, radius_of(e),
                      against.data);
    aob_text_finish(&against);
}

void aob_effects_print(const struct aob_effects *e, struct aob_text *out)
{
    const struct aob_effect_answer *a = &e->answer;
    print_head(e, out);
    for (int id = 0; id < AOB_EFFECT_COUNT; id++) {
        struct aob_text sentence = {0};
        aob_effect_answer_explain(a, (enum aob_effect_id)id, &sentence);
        aob_text_add_line(out, "%-13s %s", aob_effect_rows[id].name, sentence.data);
        aob_text_finish(&sentence);
    }
    aob_text_add_line(out, "  %-58s %14s %7s%s %9s", "set", a->no_truth ? "differs by, %" : "off by, %",
                      "FLIP", a->frames ? " flick,%" : "", a->ask.profile ? "model ms" : "ms");
    for (size_t i = 0; i < a->count; i++)
        if (&a->candidates[i] == chosen_of(e) || !is_beaten(a, &a->candidates[i]))
            print_candidate(e, &a->candidates[i], out);
    print_choice(e, out);
}

static void add_params(unsigned set, struct aob_text *text)
{
    const char *between = "";
    for (int id = 0; id < AOB_EFFECT_COUNT; id++) {
        const struct aob_effect_row *row = &aob_effect_rows[id];
        if (!row->param.name)
            continue;
        aob_text_add(text, "%s%s: %s", between, row->param.name,
                     aob_effect_has(set, (enum aob_effect_id)id) ? row->param.on : row->param.off);
        between = ", ";
    }
}

static void add_axes(const struct aob_axis *axes, size_t count, const char *between, struct aob_text *text)
{
    for (size_t i = 0; i < count; i++) {
        if (aob_effect_is_choice(axes[i].name))
            continue;
        aob_text_add(text, "%s%s: %s", between, axes[i].name, axes[i].values[0].text);
        between = ", ";
    }
}

static void add_set(const struct aob_effects *e, unsigned set, struct aob_text *text)
{
    const struct aob_config *config = &aob_effects_sweep(e)->config;
    aob_text_add(text, "options: {lit: %s", e->answer.unlit ? "off" : "on");
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        if (aob_effect_rows[id].option && aob_effect_has(set, (enum aob_effect_id)id))
            aob_text_add(text, ", %s: on", aob_effect_rows[id].option);
    add_axes(config->options, config->option_count, ", ", text);
    aob_text_add(text, "}\ntechniques:\n");
    if (!set) {
        aob_text_add(text, "  - name: none\n");
        return;
    }
    aob_text_add(text, "  - name: %s\n    params: {", config->techniques[0].name.text);
    add_params(set, text);
    add_axes(config->techniques[0].axes, config->techniques[0].axis_count, ", ", text);
    aob_text_add(text, "}\n");
}

/* The fewest that give the same float. */
static int digits_of(double radius)
{
    char text[32];
    int digits = 5;
    do
        snprintf(text, sizeof text, "%.*g", ++digits, radius);
    while (digits < 9 && strtof(text, NULL) != (float)radius);
    return digits;
}

void aob_effects_write_config(const struct aob_effects *e, const char *scene, struct aob_text *text)
{
    const struct aob_case *c = planned(e);
    const struct aob_effect_candidate *chosen = chosen_of(e);
    const char *profile = e->answer.ask.profile;
    struct aob_text name = {0};
    aob_effect_set_print(chosen->set, &name);
    aob_text_add(
        text, "# Written by `aobudget effects`: %s.\n# %.3g ms a frame%s%s; the lit image %s by %.3g %%%s.\n",
        name.data, chosen->ms, profile ? " modelled on " : "", profile ? profile : "",
        e->answer.no_truth ? "differs" : "is off", 100 * chosen->error.rmse,
        e->answer.no_truth ? " from its own of full size" : "");
    aob_text_finish(&name);
    aob_text_add(text, "name: effects\nscenes: [%s]\nresolutions: [%dx%d]\nbackends: [\"%s\"]\n", scene,
                 c->width, c->height, c->backend);
    add_set(e, chosen->set, text);
    aob_text_add(text, "target: {radius: %.*g}\n", digits_of(radius_of(e)), radius_of(e));
}
