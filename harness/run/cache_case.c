#include "cache_case.h"
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "drawing.h"
#include "job/cache_job.h"

struct asked {
    struct aob_measurement *m;
    size_t index;
    json_t *figures; /* by profile */
};

static void put_refused(json_t *figures, const struct aob_plan_profile *profile, const char *status,
                        const char *reason)
{
    json_object_set_new(
        figures, profile->name,
        json_pack("{s:s, s:s, s:s}", "status", status, "reason", reason, "digest", profile->digest));
}

static void take_figures(const struct asked *asked, const struct aob_cache_answer *answer)
{
    const struct aob_plan_profile *profile = &asked->m->plan->profiles[answer->profile];
    if (!answer->figures) {
        put_refused(asked->figures, profile, answer->status, answer->reason ? answer->reason : "");
        return;
    }
    json_t *figures = json_pack("{s:s}", "status", "ok");
    json_object_update(figures, (json_t *)(uintptr_t)answer->figures);
    json_object_del(figures, "profile"); /* it is called by its name */
    json_object_set_new(asked->figures, profile->name, figures);
}

static void refuse_rest(const struct asked *asked, const char *reason)
{
    const struct aob_plan *plan = asked->m->plan;
    for (size_t i = 0; i < plan->profile_count; i++)
        if (!json_object_get(asked->figures, plan->profiles[i].name))
            put_refused(asked->figures, &plan->profiles[i], "failed", reason);
}

static void foretell(const struct asked *asked, const struct aob_cache_capture *capture)
{
    struct aob_text work = {0};
    aob_text_add(&work, "tracing at most %.3g million fetches in %.0f draws, about %.2g s",
                 1e-6 * capture->words, capture->strips, capture->seconds);
    if (asked->m->on_work)
        asked->m->on_work(asked->m->user, asked->index, work.data);
    if (asked->m->on_foretold)
        asked->m->on_foretold(asked->m->user, work.data, capture->seconds);
    aob_text_finish(&work);
}

static void take_answer(void *user, const json_t *object)
{
    struct asked *asked = user;
    struct aob_cache_capture capture;
    struct aob_cache_answer answer;
    if (aob_cache_capture_from_json(object, &capture))
        foretell(asked, &capture);
    else if (aob_cache_answer_from_json(object, &answer) && answer.profile < asked->m->plan->profile_count)
        take_figures(asked, &answer);
}

/* Ten times what a pixel of two hundred fetches takes with each profile, and what a block has for each frame before it. */
static double time_limit(const struct aob_plan *plan, const struct aob_case *c, size_t poses)
{
    double pixels = (double)c->width * c->height;
    return 300 + (3e-4 * (double)(1 + plan->profile_count) + 1e-5 * (double)poses) * pixels;
}

static bool send(struct asked *asked, const struct aob_view_files *files, struct aob_error *error)
{
    const struct aob_plan *plan = asked->m->plan;
    const struct aob_case *c = &plan->cases[asked->index];
    struct aob_cache_profile *profiles = AOB_NEW_ARRAY(struct aob_cache_profile, plan->profile_count);
    struct aob_drawing_environment env;
    for (size_t i = 0; i < plan->profile_count; i++)
        profiles[i] = (struct aob_cache_profile){plan->profiles[i].path, plan->profiles[i].digest};
    const struct aob_cache_job job = {.drawing = aob_job_drawing_of(asked->m, asked->index, files),
                                      .frame = aob_job_frame_of(c),
                                      .poses = aob_job_poses_of(files, 0),
                                      .pose_count = files->pose_count,
                                      .profiles = profiles,
                                      .profile_count = plan->profile_count,
                                      .map = asked->m->map};
    aob_drawing_environment_init(&env, asked->m, c);
    bool ok = aob_dispatch_job(asked->m->dispatch,
                               &(struct aob_job_desc){.job = aob_cache_job_to_json(&job),
                                                      .env = (const char *const *)env.texts,
                                                      .timeout_s = time_limit(plan, c, files->pose_count),
                                                      .on_answer = take_answer,
                                                      .user = asked},
                               error);
    aob_drawing_environment_finish(&env);
    free(job.poses);
    free(profiles);
    return ok;
}

json_t *aob_cache_case(struct aob_measurement *m, size_t index, const struct aob_view_files *files)
{
    struct asked asked = {m, index, json_object()};
    struct aob_error error = {{0}};
    if (m->on_work)
        m->on_work(m->user, index, "tracing fetches");
    if (!send(&asked, files, &error) && !*error.text)
        aob_fail(&error, "the worker gave no reason");
    refuse_rest(&asked, *error.text ? error.text : "the worker gave no answer for this profile");
    return asked.figures;
}

static bool is_of_now(const json_t *figures, const struct aob_plan_profile *profile)
{
    const char *status = json_string_value(json_object_get(figures, "status"));
    const char *digest = json_string_value(json_object_get(figures, "digest"));
    return status && digest && strcmp(status, "failed") != 0 && strcmp(digest, profile->digest) == 0;
}

bool aob_cache_case_is_done(const struct aob_plan *plan, const json_t *record)
{
    const json_t *cache = json_object_get(record, "cache");
    for (size_t i = 0; i < plan->profile_count; i++)
        if (!is_of_now(json_object_get(cache, plan->profiles[i].name), &plan->profiles[i]))
            return false;
    return true;
}

/* Nothing is traced of a case that could not be laid out this time. */
static bool prepare(struct aob_measurement *m, size_t index, struct aob_view_files *files,
                    struct aob_error *error)
{
    const struct aob_state *state = &m->states[index];
    if (state->stage == AOB_REFUSED)
        return aob_fail(error, "%s", state->reason);
    return aob_view_prepare(m, &index, 1, files, error);
}

static json_t *trace_again(struct aob_measurement *m, size_t index)
{
    struct aob_view_files files = {0};
    struct aob_error error = {{0}};
    if (prepare(m, index, &files, &error)) {
        json_t *figures = aob_cache_case(m, index, &files);
        aob_view_files_finish(&files);
        return figures;
    }
    const struct asked asked = {m, index, json_object()};
    refuse_rest(&asked, error.text);
    return asked.figures;
}

/* What is stored of a profile that has not changed stays where its figures failed this time. */
static void keep_stored(const struct aob_plan *plan, const json_t *record, json_t *figures)
{
    json_t *stored = json_object_get(record, "cache");
    for (size_t i = 0; i < plan->profile_count; i++) {
        const struct aob_plan_profile *profile = &plan->profiles[i];
        json_t *old = json_object_get(stored, profile->name);
        if (is_of_now(old, profile) && !is_of_now(json_object_get(figures, profile->name), profile))
            json_object_set(figures, profile->name, old);
    }
}

void aob_cache_case_again(struct aob_measurement *m, size_t index)
{
    struct aob_state *state = &m->states[index];
    json_t *record = json_deep_copy(state->stored), *figures = trace_again(m, index);
    keep_stored(m->plan, record, figures);
    json_object_set_new(record, "cache", figures);
    state->stage = AOB_DONE;
    m->on_record(m->user, index, record);
    json_decref(record);
}
