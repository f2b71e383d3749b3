#include "answer.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/table.h"
#include "base/text.h"

struct aob_ask aob_ask_of(const struct aob_budget *budget)
{
    return (struct aob_ask){.ms = aob_budget_left(budget, 0),
                            .error = budget->error,
                            .profile = budget->device,
                            .radius = NAN,
                            .width = budget->width,
                            .height = budget->height};
}

bool aob_ask_has(const struct aob_ask *ask, const json_t *record)
{
    bool scene = !ask->scene || strcmp(ask->scene, aob_member_text(record, "scene")) == 0;
    bool size = !ask->width || (aob_member_number(record, "width") == ask->width &&
                                aob_member_number(record, "height") == ask->height);
    return scene && size && strcmp(aob_member_text(record, "status"), "ok") == 0;
}

static bool is_of(const json_t *record, const char *technique)
{
    return strcmp(aob_member_text(record, "technique"), technique) == 0;
}

bool aob_ask_may_choose(const json_t *record)
{
    return !is_of(record, "none") && !is_of(record, "deferred");
}

struct aob_interval aob_ask_frame(const struct aob_ask *ask, const struct aob_rows *rows)
{
    struct aob_interval frame = {NAN, 0, 0};
    for (size_t i = 0; i < rows->count; i++) {
        const json_t *record = rows->list[i].json;
        struct aob_interval own = aob_ask_cost(ask, record);
        if (!is_of(record, "deferred") || !aob_ask_has(ask, record) || !isfinite(own.at))
            continue;
        frame = (struct aob_interval){fmax(frame.at, own.at), fmax(frame.low, own.low),
                                      fmax(frame.high, own.high)};
    }
    return frame;
}

void aob_ask_take_frame(struct aob_ask *ask, const struct aob_budget *budget,
                        const struct aob_interval *frame)
{
    if (isfinite(frame->at))
        ask->ms = aob_budget_left(budget, isfinite(frame->high) ? frame->high : frame->at);
}

struct aob_interval aob_ask_cost(const struct aob_ask *ask, const json_t *record)
{
    return ask->profile ? aob_costs_modelled(record, ask->profile) : aob_costs_measured(record);
}

/* While an answer is made: numbers of texts. */
struct making {
    struct aob_answer *answer;
    struct aob_table views, wholes, settings;
    size_t setting; /* of the row that is taken */
};

/* What two cases of one setting have in common: the build of the technique, and every value. */
static size_t number_setting(struct making *making, const struct aob_row *row)
{
    struct aob_text text = {0};
    char *params = json_dumps(json_object_get(row->json, "params"), JSON_SORT_KEYS | JSON_COMPACT),
         *options = json_dumps(json_object_get(row->json, "options"), JSON_SORT_KEYS | JSON_COMPACT);
    aob_text_add(&text, "%s\n%s\n%s\n%s", row->name, row->module, params ? params : "",
                 options ? options : "");
    size_t number = aob_table_put(&making->settings, text.data, making->settings.count);
    aob_text_finish(&text);
    free(params);
    free(options);
    return number;
}

static size_t find_whole(struct making *making, const struct aob_row *row, size_t target)
{
    struct aob_answer *answer = making->answer;
    struct aob_text text = {0};
    aob_text_add(&text, "%zu %zu %dx%d %s", row->run, target, row->width, row->height, row->backend);
    size_t place = aob_table_put(&making->wholes, text.data, answer->whole_count);
    if (place == answer->whole_count)
        *AOB_PUSH(answer->wholes, answer->whole_count, answer->whole_capacity) =
            (struct aob_answer_whole){.first = row, .target = target};
    aob_text_finish(&text);
    return place;
}

static struct aob_answer_view *find_view(struct making *making, const struct aob_row *row, size_t target)
{
    struct aob_answer *answer = making->answer;
    struct aob_text text = {0};
    aob_text_add(&text, "%zu %zu %dx%d %s", row->section, target, row->width, row->height, row->backend);
    size_t place = aob_table_put(&making->views, text.data, answer->view_count);
    if (place == answer->view_count)
        *AOB_PUSH(answer->views, answer->view_count, answer->view_capacity) = (struct aob_answer_view){
            .first = row, .target = target, .whole = find_whole(making, row, target)};
    aob_text_finish(&text);
    return &answer->views[place];
}

static void take_case(struct making *making, struct aob_answer_view *view, size_t at, double error)
{
    struct aob_interval cost = aob_ask_cost(&making->answer->ask, making->answer->rows->list[at].json);
    if (!isfinite(cost.at)) {
        view->unknown++;
        return;
    }
    *AOB_PUSH(view->list, view->count, view->capacity) = (struct aob_candidate){.of = at,
                                                                                .setting = making->setting,
                                                                                .ms = cost.at,
                                                                                .low = cost.low,
                                                                                .high = cost.high,
                                                                                .error = error};
}

static void take_row(struct making *making, size_t at)
{
    const struct aob_ask *ask = &making->answer->ask;
    const struct aob_row *row = &making->answer->rows->list[at];
    making->setting = number_setting(making, row);
    for (size_t i = 0; i < row->score_count; i++) {
        const struct aob_score *score = &row->scores[i];
        double radius = making->answer->rows->targets[score->target].radius,
               error = aob_costs_error(score->json);
        if (!isfinite(error) || (!isnan(ask->radius) && (float)radius != (float)ask->radius))
            continue;
        struct aob_answer_view *view = find_view(making, row, score->target);
        if (is_of(row->json, "none"))
            *AOB_PUSH(view->nones, view->none_count, view->none_capacity) = at;
        else if (aob_ask_may_choose(row->json))
            take_case(making, view, at, error);
    }
}

static void choose(struct aob_answer_view *view, const struct aob_ask *ask)
{
    aob_choice_make(&view->choice, view->list, view->count, ask->ms, ask->error);
    view->front = AOB_NEW_ARRAY(size_t, view->count + 1);
    view->front_count = aob_front_find(view->list, view->count, view->front);
}

/* The candidates of all views of a whole behind each other; free() them. */
static struct aob_candidate *gather(struct aob_answer *answer, size_t place, size_t *count)
{
    struct aob_candidate *all = NULL;
    size_t capacity = 0, views = 0;
    *count = 0;
    for (size_t i = 0; i < answer->view_count; i++) {
        struct aob_answer_view *view = &answer->views[i];
        if (view->whole != place)
            continue;
        for (size_t k = 0; k < view->count; k++) {
            view->list[k].view = views;
            *AOB_PUSH(all, *count, capacity) = view->list[k];
        }
        views++;
    }
    answer->wholes[place].views = views;
    return all;
}

static void choose_setting(struct aob_answer *answer, size_t place)
{
    struct aob_answer_whole *whole = &answer->wholes[place];
    size_t count;
    struct aob_candidate *all = gather(answer, place, &count);
    whole->list = AOB_NEW_ARRAY(struct aob_candidate, count + 1);
    whole->count = aob_worst_find(all, count, whole->views, whole->list);
    aob_choice_make(&whole->choice, whole->list, whole->count, answer->ask.ms, answer->ask.error);
    free(all);
}

void aob_answer_make(struct aob_answer *answer, const struct aob_rows *rows, const struct aob_ask *ask)
{
    *answer = (struct aob_answer){.rows = rows, .ask = *ask};
    struct making making = {.answer = answer};
    for (size_t i = 0; i < rows->count; i++)
        if (aob_ask_has(ask, rows->list[i].json))
            take_row(&making, i);
    for (size_t i = 0; i < answer->view_count; i++)
        choose(&answer->views[i], ask);
    for (size_t i = 0; i < answer->whole_count; i++)
        choose_setting(answer, i);
    aob_table_finish(&making.views);
    aob_table_finish(&making.wholes);
    aob_table_finish(&making.settings);
}

void aob_answer_finish(struct aob_answer *answer)
{
    for (size_t i = 0; i < answer->view_count; i++) {
        free(answer->views[i].list);
        free(answer->views[i].nones);
        free(answer->views[i].front);
    }
    for (size_t i = 0; i < answer->whole_count; i++)
        free(answer->wholes[i].list);
    free(answer->views);
    free(answer->wholes);
    *answer = (struct aob_answer){0};
}

const struct aob_row *aob_answer_none(const struct aob_answer *answer, const struct aob_answer_view *view,
                                      const struct aob_row *row)
{
    const json_t *options = json_object_get(row->json, "options");
    for (size_t i = 0; i < view->none_count; i++) {
        const struct aob_row *none = &answer->rows->list[view->nones[i]];
        if (json_equal(options, json_object_get(none->json, "options")))
            return none;
    }
    return view->none_count ? &answer->rows->list[view->nones[0]] : NULL;
}

bool aob_answer_fits(const struct aob_answer *answer)
{
    bool all = true;
    for (size_t i = 0; i < answer->view_count; i++)
        all = all && answer->views[i].choice.accurate != AOB_NO_CANDIDATE;
    for (size_t i = 0; i < answer->whole_count; i++)
        all = all && answer->wholes[i].choice.accurate != AOB_NO_CANDIDATE;
    return all;
}
