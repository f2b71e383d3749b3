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
                                 const struct aob_candidate *list, size_t at, double ms)
{
    if (at == AOB_NO_CANDIDATE)
        return json_null();
    const struct aob_candidate *candidate = &list[at];
    const struct aob_row *row = &answer->rows->list[candidate->of],
                         *none = view ? aob_answer_none(answer, view, row) : NULL;
    struct aob_interval cost = {candidate->ms, candidate->low, candidate->high},
                        room = aob_answer_room(candidate, ms), measured = aob_costs_measured(row->json),
                        to_none = aob_costs_to_none(row->json, none ? none->json : NULL),
                        modelled = aob_costs_modelled(row->json, answer->ask.profile);
    json_t *object = json_pack(
        "{s:s, s:s, s:s, s:s, s:O?, s:O?, s:f, s:s, s:o, s:o, s:o}", "key", row->key, "scene", row->scene,
        "view", row->view, "technique", row->technique, "params", json_object_get(row->json, "params"),
        "options", json_object_get(row->json, "options"), "error", candidate->error, "fit",
        aob_fit_name(aob_candidate_fit(candidate, ms)), "judged_ms", aob_interval_to_json(&cost), "room_ms",
        aob_interval_to_json(&room), "dearest_pass", pass_to_json(answer, row));
    if (!view)
        return object;
    json_object_set_new(object, "measured_ms", aob_interval_to_json(&measured));
    json_object_set_new(object, "to_none", aob_interval_to_json(&to_none));
    json_object_set_new(object, "modelled_ms", aob_interval_to_json(&modelled));
    return object;
}

static void add_choice(json_t *object, const struct aob_answer *answer, const struct aob_answer_view *view,
                       const struct aob_candidate *list, const struct aob_choice *choice, double ms)
{
    json_object_set_new(object, "accurate", candidate_to_json(answer, view, list, choice->accurate, ms));
    json_object_set_new(object, "hopeful", candidate_to_json(answer, view, list, choice->hopeful, ms));
    json_object_set_new(object, "cheap", candidate_to_json(answer, view, list, choice->cheap, ms));
    json_object_set_new(object, "least", candidate_to_json(answer, view, list, choice->least, ms));
}

static json_t *where_to_json(const struct aob_row *row)
{
    return json_pack("{s:s, s:i, s:i}", "backend", row->backend, "width", row->width, "height", row->height);
}

/* Where, against what, and how much time there is. */
static json_t *question_to_json(const struct aob_answer *answer, const struct aob_answer_frame *frame,
                                size_t place)
{
    const struct aob_target *target = &answer->rows->targets[place];
    json_t *object = where_to_json(frame->first);
    json_object_set_new(object, "target",
                        json_pack("{s:o, s:s}", "radius", aob_json_number(target->radius), "weighting",
                                  target->uniform ? "uniform" : "cosine"));
    json_object_set_new(object, "reference", json_string(target->screen ? "screen" : "ray-traced"));
    json_object_set_new(object, "ms", json_real(frame->ms));
    json_object_set_new(object, "frame_ms", aob_interval_to_json(&frame->cost));
    return object;
}

static json_t *cases_to_json(const struct aob_answer_cases *cases)
{
    return json_pack("{s:I, s:I, s:I, s:I, s:I}", "ok", (json_int_t)cases->ok, "unsupported",
                     (json_int_t)cases->unsupported, "invalid", (json_int_t)cases->invalid, "failed",
                     (json_int_t)cases->failed, "missing", (json_int_t)cases->missing);
}

/* Scenes and views of which no case answers. */
static json_t *unanswered_to_json(const struct aob_answer *answer)
{
    json_t *places = json_array();
    for (size_t i = 0; i < answer->place_count; i++) {
        const struct aob_answer_place *place = &answer->places[i];
        if (place->questions)
            continue;
        json_t *object = where_to_json(place->first);
        json_object_set_new(object, "scene", json_string(place->first->scene));
        json_object_set_new(object, "view", json_string(place->first->view));
        json_object_set_new(object, "status", cases_to_json(&place->cases));
        json_array_append_new(places, object);
    }
    return places;
}

static json_t *view_to_json(const struct aob_answer *answer, const struct aob_answer_view *view)
{
    const struct aob_answer_place *place = &answer->places[view->place];
    json_t *object = question_to_json(answer, &answer->frames[place->frame], view->target),
           *front = json_array();
    json_object_set_new(object, "scene", json_string(view->first->scene));
    json_object_set_new(object, "view", json_string(view->first->view));
    json_object_set_new(object, "cases", json_integer((json_int_t)view->count));
    json_object_set_new(object, "unknown", json_integer((json_int_t)view->unknown));
    json_object_set_new(object, "status", cases_to_json(&place->cases));
    add_choice(object, answer, view, view->list, &view->choice, view->ms);
    for (size_t i = 0; i < view->front_count; i++)
        json_array_append_new(front, candidate_to_json(answer, view, view->list, view->front[i], view->ms));
    json_object_set_new(object, "front", front);
    return object;
}

static json_t *whole_to_json(const struct aob_answer *answer, const struct aob_answer_whole *whole)
{
    const struct aob_answer_frame *frame = &answer->frames[whole->frame];
    json_t *object = question_to_json(answer, frame, whole->target);
    json_object_set_new(object, "views", json_integer((json_int_t)whole->views));
    json_object_set_new(object, "places", json_integer((json_int_t)frame->places));
    json_object_set_new(object, "settings", json_integer((json_int_t)whole->count));
    add_choice(object, answer, NULL, whole->list, &whole->choice, whole->ms);
    return object;
}

json_t *aob_budget_answer_to_json(const struct aob_answer *answer)
{
    json_t *questions = json_array(), *settings = json_array();
    for (size_t i = 0; i < answer->view_count; i++)
        json_array_append_new(questions, view_to_json(answer, &answer->views[i]));
    for (size_t i = 0; i < answer->whole_count; i++)
        json_array_append_new(settings, whole_to_json(answer, &answer->wholes[i]));
    return json_pack("{s:o, s:o, s:b, s:o, s:o, s:o, s:o}", "error", aob_json_number(answer->ask.error),
                     "profile", answer->ask.profile ? json_string(answer->ask.profile) : json_null(), "fits",
                     aob_answer_fits(answer) && aob_answer_is_known(answer), "status",
                     cases_to_json(&answer->cases), "unanswered", unanswered_to_json(answer), "questions",
                     questions, "settings", settings);
}
