#include "answer.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/table.h"
#include "base/text.h"

/* While an answer is made: numbers of texts. */
struct making {
    struct aob_answer *answer;
    struct aob_table frames, places, views, wholes, settings;
    size_t *place_of; /* of each row that is asked for */
    size_t setting;   /* of the row that is taken */
};

static size_t find_frame(struct making *making, const struct aob_row *row)
{
    struct aob_answer *answer = making->answer;
    struct aob_text text = {0};
    aob_text_add(&text, "%zu %dx%d %s", row->run, row->width, row->height, row->backend);
    size_t frame = aob_table_put(&making->frames, text.data, answer->frame_count);
    if (frame == answer->frame_count)
        *AOB_PUSH(answer->frames, answer->frame_count, answer->frame_capacity) =
            (struct aob_answer_frame){.first = row, .cost = AOB_NO_FRAME};
    aob_text_finish(&text);
    return frame;
}

static size_t find_place(struct making *making, const struct aob_row *row)
{
    struct aob_answer *answer = making->answer;
    struct aob_text text = {0};
    aob_text_add(&text, "%zu %dx%d %s", row->section, row->width, row->height, row->backend);
    size_t place = aob_table_put(&making->places, text.data, answer->place_count);
    if (place == answer->place_count) {
        size_t frame = find_frame(making, row);
        answer->frames[frame].places++;
        *AOB_PUSH(answer->places, answer->place_count, answer->place_capacity) =
            (struct aob_answer_place){.first = row, .frame = frame};
    }
    aob_text_finish(&text);
    return place;
}

static void count_case(struct aob_answer_cases *cases, const char *status)
{
    cases->ok += strcmp(status, "ok") == 0;
    cases->unsupported += strcmp(status, "unsupported") == 0;
    cases->invalid += strcmp(status, "invalid") == 0;
    cases->failed += strcmp(status, "failed") == 0;
}

/* The time that there is must be known before anything is judged. */
static void take_place(struct making *making, size_t at)
{
    struct aob_answer *answer = making->answer;
    const struct aob_row *row = &answer->rows->list[at];
    making->place_of[at] = find_place(making, row);
    struct aob_answer_place *place = &answer->places[making->place_of[at]];
    count_case(&place->cases, row->status);
    place->candidates += aob_row_is_ok(row) && aob_ask_may_choose(row->json);
    count_case(&answer->cases, row->status);
    aob_ask_take_frame(&answer->ask, row->json, &answer->frames[place->frame].cost);
}

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

static size_t find_whole(struct making *making, size_t frame, size_t target)
{
    struct aob_answer *answer = making->answer;
    struct aob_text text = {0};
    aob_text_add(&text, "%zu %zu", frame, target);
    size_t place = aob_table_put(&making->wholes, text.data, answer->whole_count);
    if (place == answer->whole_count)
        *AOB_PUSH(answer->wholes, answer->whole_count, answer->whole_capacity) =
            (struct aob_answer_whole){.first = answer->frames[frame].first,
                                      .target = target,
                                      .frame = frame,
                                      .ms = answer->frames[frame].ms};
    aob_text_finish(&text);
    return place;
}

static void print_view(const struct making *making, size_t at, size_t target, struct aob_text *text)
{
    aob_text_add(text, "%zu %zu", making->place_of[at], target);
}

static struct aob_answer_view *find_view(struct making *making, size_t at, size_t target)
{
    struct aob_answer *answer = making->answer;
    size_t place = making->place_of[at], frame = answer->places[place].frame;
    struct aob_text text = {0};
    print_view(making, at, target, &text);
    size_t view = aob_table_put(&making->views, text.data, answer->view_count);
    if (view == answer->view_count) {
        answer->places[place].questions++;
        *AOB_PUSH(answer->views, answer->view_count, answer->view_capacity) =
            (struct aob_answer_view){.first = &answer->rows->list[at],
                                     .target = target,
                                     .place = place,
                                     .whole = find_whole(making, frame, target),
                                     .ms = answer->frames[frame].ms};
    }
    aob_text_finish(&text);
    return &answer->views[view];
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

/* Whether a score is against a target that is asked for. */
static bool is_asked(const struct aob_answer *answer, const struct aob_score *score)
{
    double radius = answer->rows->targets[score->target].radius, asked = answer->ask.radius;
    return isfinite(aob_costs_error(score->json)) && (isnan(asked) || (float)radius == (float)asked);
}

static void take_row(struct making *making, size_t at)
{
    const struct aob_row *row = &making->answer->rows->list[at];
    making->setting = number_setting(making, row);
    for (size_t i = 0; i < row->score_count; i++) {
        const struct aob_score *score = &row->scores[i];
        if (is_asked(making->answer, score))
            take_case(making, find_view(making, at, score->target), at, aob_costs_error(score->json));
    }
}

/* The view of a row that makes none; NULL: no case asks it. */
static struct aob_answer_view *known_view(struct making *making, size_t at, size_t target)
{
    struct aob_text text = {0};
    size_t view;
    print_view(making, at, target, &text);
    bool known = aob_table_find(&making->views, text.data, &view);
    aob_text_finish(&text);
    return known ? &making->answer->views[view] : NULL;
}

static void take_none(struct making *making, size_t at)
{
    const struct aob_row *row = &making->answer->rows->list[at];
    for (size_t i = 0; i < row->score_count; i++) {
        if (!is_asked(making->answer, &row->scores[i]))
            continue;
        struct aob_answer_view *view = known_view(making, at, row->scores[i].target);
        if (view)
            *AOB_PUSH(view->nones, view->none_count, view->none_capacity) = at;
    }
}

/* Only what may be chosen makes a question, so `none` comes when all of them are known. */
static void take_rows(struct making *making)
{
    const struct aob_ask *ask = &making->answer->ask;
    const struct aob_rows *rows = making->answer->rows;
    for (size_t i = 0; i < rows->count; i++)
        if (aob_ask_has(ask, rows->list[i].json) && aob_ask_may_choose(rows->list[i].json))
            take_row(making, i);
    for (size_t i = 0; i < rows->count; i++)
        if (aob_ask_has(ask, rows->list[i].json) && strcmp(rows->list[i].name, "none") == 0)
            take_none(making, i);
}

static void choose(struct aob_answer_view *view, double error)
{
    aob_choice_make(&view->choice, view->list, view->count, view->ms, error);
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
    aob_choice_make(&whole->choice, whole->list, whole->count, whole->ms, answer->ask.error);
    free(all);
}

/* Which cases are missing is known by their keys alone, so a scene that is asked for may have any of them. */
static void take_places(struct making *making)
{
    struct aob_answer *answer = making->answer;
    const struct aob_rows *rows = answer->rows;
    for (size_t i = 0; i < rows->count; i++)
        if (aob_ask_is_about(&answer->ask, rows->list[i].json))
            take_place(making, i);
    for (size_t i = 0; i < rows->run_count; i++)
        answer->cases.missing += rows->runs[i].missing;
    for (size_t i = 0; i < answer->frame_count; i++)
        answer->frames[i].ms = aob_ask_ms(&answer->ask, &answer->frames[i].cost);
}

void aob_answer_make(struct aob_answer *answer, const struct aob_rows *rows, const struct aob_ask *ask)
{
    *answer = (struct aob_answer){.rows = rows, .ask = *ask};
    struct making making = {.answer = answer, .place_of = AOB_NEW_ARRAY(size_t, rows->count + 1)};
    take_places(&making);
    take_rows(&making);
    for (size_t i = 0; i < answer->view_count; i++)
        choose(&answer->views[i], ask->error);
    for (size_t i = 0; i < answer->whole_count; i++)
        choose_setting(answer, i);
    aob_table_finish(&making.frames);
    aob_table_finish(&making.places);
    aob_table_finish(&making.views);
    aob_table_finish(&making.wholes);
    aob_table_finish(&making.settings);
    free(making.place_of);
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
    free(answer->frames);
    free(answer->places);
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
    return NULL;
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

bool aob_answer_is_known(const struct aob_answer *answer)
{
    bool known = true;
    for (size_t i = 0; i < answer->place_count; i++)
        known = known && answer->places[i].candidates;
    return known;
}

bool aob_answer_is_whole(const struct aob_answer *answer)
{
    const struct aob_answer_cases *c = &answer->cases;
    bool planned = true;
    for (size_t i = 0; i < answer->rows->run_count; i++)
        planned = planned && answer->rows->runs[i].planned;
    return planned && !(c->unsupported + c->invalid + c->failed + c->missing);
}
