#include <math.h>
#include "base/json.h"
#include "budget_table.h"
#include "reports/page/answer_text.h"

json_t *aob_interval_to_json(const struct aob_interval *interval)
{
    bool bounded = isfinite(interval->low) && isfinite(interval->high);
    if (!isfinite(interval->at))
        return json_null();
    return json_pack("{s:f, s:o, s:o}", "at", interval->at, "low",
                     bounded ? json_real(interval->low) : json_null(), "high",
                     bounded ? json_real(interval->high) : json_null());
}

static json_t *pass_to_json(const struct aob_answer *answer, const struct aob_row *row)
{
    struct aob_answer_pass pass = aob_answer_dearest_pass(row, answer->ask.profile);
    if (!*pass.name)
        return json_null();
    return json_pack("{s:s, s:f, s:o}", "name", pass.name, "ms", pass.ms, "limit",
                     *pass.limit ? json_string(pass.limit) : json_null());
}

/* A case with its three columns. In a whole, which has no `view`, the costs and the error are those of the worst views. */
static json_t *candidate_to_json(const struct aob_answer *answer, const struct aob_answer_view *view,
                                 const struct aob_candidate *list, size_t at)
{
    if (at == AOB_NO_CANDIDATE)
        return json_null();
    const struct aob_candidate *candidate = &list[at];
    const struct aob_row *row = &answer->rows->list[candidate->of],
                         *none = view ? aob_answer_none(answer, view, row) : NULL;
    struct aob_interval cost = {candidate->ms, candidate->low, candidate->high},
                        room = aob_answer_room(candidate, answer->ask.ms),
                        measured = aob_costs_measured(row->json),
                        to_none = aob_costs_to_none(row->json, none ? none->json : NULL),
                        modelled = aob_costs_modelled(row->json, answer->ask.profile);
    json_t *object = json_pack(
        "{s:s, s:s, s:s, s:s, s:O?, s:O?, s:f, s:s, s:o, s:o, s:o}", "key", row->key, "scene", row->scene,
        "view", row->view, "technique", row->technique, "params", json_object_get(row->json, "params"),
        "options", json_object_get(row->json, "options"), "error", candidate->error, "fit",
        aob_fit_name(aob_candidate_fit(candidate, answer->ask.ms)), "judged_ms", aob_interval_to_json(&cost),
        "room_ms", aob_interval_to_json(&room), "dearest_pass", pass_to_json(answer, row));
    if (!view)
        return object;
    json_object_set_new(object, "measured_ms", aob_interval_to_json(&measured));
    json_object_set_new(object, "to_none", aob_interval_to_json(&to_none));
    json_object_set_new(object, "modelled_ms", aob_interval_to_json(&modelled));
    return object;
}

static void add_choice(json_t *object, const struct aob_answer *answer, const struct aob_answer_view *view,
                       const struct aob_candidate *list, const struct aob_choice *choice)
{
    json_object_set_new(object, "accurate", candidate_to_json(answer, view, list, choice->accurate));
    json_object_set_new(object, "hopeful", candidate_to_json(answer, view, list, choice->hopeful));
    json_object_set_new(object, "cheap", candidate_to_json(answer, view, list, choice->cheap));
    json_object_set_new(object, "least", candidate_to_json(answer, view, list, choice->least));
}

static json_t *where_to_json(const struct aob_answer *answer, const struct aob_row *row, size_t place)
{
    const struct aob_target *target = &answer->rows->targets[place];
    return json_pack("{s:s, s:i, s:i, s:{s:o, s:s}, s:s}", "backend", row->backend, "width", row->width,
                     "height", row->height, "target", "radius", aob_json_number(target->radius), "weighting",
                     target->uniform ? "uniform" : "cosine", "reference",
                     target->screen ? "screen" : "ray-traced");
}

static json_t *view_to_json(const struct aob_answer *answer, const struct aob_answer_view *view)
{
    json_t *object = where_to_json(answer, view->first, view->target), *front = json_array();
    json_object_set_new(object, "scene", json_string(view->first->scene));
    json_object_set_new(object, "view", json_string(view->first->view));
    json_object_set_new(object, "cases", json_integer((json_int_t)view->count));
    json_object_set_new(object, "unknown", json_integer((json_int_t)view->unknown));
    add_choice(object, answer, view, view->list, &view->choice);
    for (size_t i = 0; i < view->front_count; i++)
        json_array_append_new(front, candidate_to_json(answer, view, view->list, view->front[i]));
    json_object_set_new(object, "front", front);
    return object;
}

static json_t *whole_to_json(const struct aob_answer *answer, const struct aob_answer_whole *whole)
{
    json_t *object = where_to_json(answer, whole->first, whole->target);
    json_object_set_new(object, "views", json_integer((json_int_t)whole->views));
    json_object_set_new(object, "settings", json_integer((json_int_t)whole->count));
    add_choice(object, answer, NULL, whole->list, &whole->choice);
    return object;
}

json_t *aob_budget_answer_to_json(const struct aob_answer *answer)
{
    json_t *questions = json_array(), *settings = json_array();
    for (size_t i = 0; i < answer->view_count; i++)
        json_array_append_new(questions, view_to_json(answer, &answer->views[i]));
    for (size_t i = 0; i < answer->whole_count; i++)
        json_array_append_new(settings, whole_to_json(answer, &answer->wholes[i]));
    return json_pack("{s:f, s:o, s:o, s:b, s:o, s:o}", "ms", answer->ask.ms, "error",
                     aob_json_number(answer->ask.error), "profile",
                     answer->ask.profile ? json_string(answer->ask.profile) : json_null(), "fits",
                     aob_answer_fits(answer), "questions", questions, "settings", settings);
}
