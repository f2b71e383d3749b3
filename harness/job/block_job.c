#include "block_job.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"

static json_t *truths_to_json(const struct aob_block_target *target)
{
    json_t *truths = json_object();
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        if (target->truth[which])
            json_object_set_new(truths, aob_output_name((enum aob_output)which),
                                aob_json_path(target->truth[which]));
    return truths;
}

static json_t *targets_to_json(const struct aob_block_job *job)
{
    json_t *targets = json_array();
    for (size_t i = 0; i < job->target_count; i++) {
        const struct aob_block_target *t = &job->targets[i];
        json_array_append_new(targets,
                              json_pack("{s:o, s:b, s:o, s:b}", "radius", aob_json_number(t->radius),
                                        "uniform", t->uniform, "truth", truths_to_json(t), "bent", t->bent));
    }
    return targets;
}

static json_t *case_to_json(const struct aob_block_case *c)
{
    json_t *object = json_pack("{s:I, s:o, s:o, s:o}", "target", (json_int_t)c->target, "definition",
                               aob_json_path(c->definition), "screen", aob_json_path(c->screen), "image",
                               aob_json_path(c->image));
    aob_job_frame_to_json(&c->frame, object);
    return object;
}

json_t *aob_block_job_to_json(const struct aob_block_job *job)
{
    json_t *cases = json_array();
    for (size_t i = 0; i < job->case_count; i++)
        json_array_append_new(cases, case_to_json(&job->cases[i]));
    json_t *object =
        json_pack("{s:s, s:b, s:b, s:b, s:o, s:o}", "job", "block", "score", job->score, "time", job->time,
                  "error", job->error, "targets", targets_to_json(job), "cases", cases);
    json_object_set_new(object, "timing",
                        json_pack("{s:i, s:I, s:f, s:f, s:s?, s:s?}", "process", job->process, "seed",
                                  (json_int_t)job->seed, "seconds", job->seconds, "precision", job->precision,
                                  "clock", job->clock, "clock_reason", job->clock_reason));
    json_object_set_new(object, "poses", aob_poses_to_json(job->poses, job->pose_count, job->target_count));
    aob_job_drawing_to_json(&job->drawing, object);
    return object;
}

static bool read_targets(const json_t *array, struct aob_block_job *job, struct aob_error *error)
{
    job->targets = AOB_NEW_ARRAY(struct aob_block_target, json_array_size(array));
    for (size_t i = 0; i < json_array_size(array); i++) {
        const json_t *object = json_array_get(array, i);
        struct aob_block_target *target = &job->targets[job->target_count++];
        *target = (struct aob_block_target){.radius = aob_json_to_number(json_object_get(object, "radius")),
                                            .uniform = json_is_true(json_object_get(object, "uniform")),
                                            .bent = json_is_true(json_object_get(object, "bent"))};
        for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
            target->truth[which] = json_string_value(
                json_object_get(json_object_get(object, "truth"), aob_output_name((enum aob_output)which)));
        if (!(job->targets[i].radius > 0))
            return aob_fail(error, "target %zu of a block job has no radius", i);
    }
    return true;
}

static bool read_case(const json_t *object, const struct aob_block_job *job, struct aob_block_case *c,
                      struct aob_error *error)
{
    *c = (struct aob_block_case){.target = (size_t)json_integer_value(json_object_get(object, "target")),
                                 .definition = json_string_value(json_object_get(object, "definition")),
                                 .screen = json_string_value(json_object_get(object, "screen")),
                                 .image = json_string_value(json_object_get(object, "image"))};
    if (!aob_job_frame_from_json(object, &c->frame, error))
        return false;
    return c->target < job->target_count || job->target_count == 0 ||
           aob_fail(error, "a block job's case has target %zu of %zu", c->target, job->target_count);
}

static bool read_cases(const json_t *array, struct aob_block_job *job, struct aob_error *error)
{
    size_t count = json_array_size(array);
    if (count < 1 || count > AOB_BLOCK_MAX)
        return aob_fail(error, "a block job has %zu cases: there must be 1 .. %d", count, AOB_BLOCK_MAX);
    job->cases = AOB_NEW_ARRAY(struct aob_block_case, count);
    job->case_count = count;
    for (size_t i = 0; i < count; i++)
        if (!read_case(json_array_get(array, i), job, &job->cases[i], error))
            return false;
    return true;
}

static bool read_flags(const json_t *object, struct aob_block_job *job, struct aob_error *error)
{
    int score, time, compare;
    if (json_unpack((json_t *)(uintptr_t)object, "{s:b, s:b, s:b}", "score", &score, "time", &time, "error",
                    &compare) != 0)
        return aob_fail(error, "a block job lacks a field");
    job->score = score;
    job->time = time;
    job->error = compare;
    return true;
}

static bool read_timing(const json_t *object, struct aob_block_job *job, struct aob_error *error)
{
    json_int_t seed;
    if (json_unpack((json_t *)(uintptr_t)object, "{s:i, s:I, s:F, s:F}", "process", &job->process, "seed",
                    &seed, "seconds", &job->seconds, "precision", &job->precision) != 0)
        return aob_fail(error, "a block job does not say how it is timed");
    job->seed = (uint32_t)seed;
    job->clock = json_string_value(json_object_get(object, "clock"));
    job->clock_reason = json_string_value(json_object_get(object, "clock_reason"));
    return !job->clock || job->clock_reason ||
           aob_fail(error, "a block job does not say why it has its clock");
}

bool aob_block_job_from_json(const json_t *object, struct aob_block_job *job, struct aob_error *error)
{
    *job = (struct aob_block_job){0};
    if (read_flags(object, job, error) && read_timing(json_object_get(object, "timing"), job, error) &&
        aob_job_drawing_from_json(object, &job->drawing, error) &&
        read_targets(json_object_get(object, "targets"), job, error) &&
        aob_poses_from_json(json_object_get(object, "poses"), job->target_count, &job->poses,
                            &job->pose_count, error) &&
        read_cases(json_object_get(object, "cases"), job, error))
        return true;
    aob_block_job_finish(job);
    return false;
}

void aob_block_job_finish(struct aob_block_job *job)
{
    free(job->targets);
    free(job->poses);
    free(job->cases);
    *job = (struct aob_block_job){0};
}

json_t *aob_block_timed_to_json(const struct aob_block_timed *timed)
{
    json_t *cases = json_array();
    for (size_t i = 0; i < timed->count; i++) {
        const struct aob_block_timed_case *c = &timed->cases[i];
        json_array_append_new(cases, json_pack("{s:I, s:f, s:O}", "index", (json_int_t)c->index, "setup_ms",
                                               c->setup_ms, "passes", c->passes));
    }
    return json_pack("{s:{s:s, s:o, s:i, s:o}}", "timed", "clock", aob_clock_name(timed->clock),
                     "clock_reason", aob_json_text(timed->clock_reason), "threads", timed->threads, "cases",
                     cases);
}

static bool read_timed_case(const json_t *object, size_t case_count, struct aob_block_timed *timed)
{
    json_int_t index;
    double setup_ms;
    json_t *passes;
    if (timed->count == AOB_BLOCK_MAX ||
        json_unpack((json_t *)(uintptr_t)object, "{s:I, s:F, s:o}", "index", &index, "setup_ms", &setup_ms,
                    "passes", &passes) != 0 ||
        index < 0 || (size_t)index >= case_count)
        return false;
    timed->cases[timed->count++] =
        (struct aob_block_timed_case){(size_t)index, setup_ms, json_incref(passes)};
    return true;
}

bool aob_block_timed_from_json(const json_t *object, size_t case_count, struct aob_block_timed *timed)
{
    const json_t *head = json_object_get(object, "timed"), *cases = json_object_get(head, "cases");
    *timed = (struct aob_block_timed){.threads = (int)json_integer_value(json_object_get(head, "threads"))};
    const char *reason = json_string_value(json_object_get(head, "clock_reason"));
    bool ok = reason && aob_clock_find(json_string_value(json_object_get(head, "clock")), &timed->clock);
    if (ok)
        snprintf(timed->clock_reason, sizeof timed->clock_reason, "%s", reason);
    for (size_t i = 0; ok && i < json_array_size(cases); i++)
        ok = read_timed_case(json_array_get(cases, i), case_count, timed);
    if (ok && timed->count)
        return true;
    aob_block_timed_finish(timed);
    return false;
}

void aob_block_timed_finish(struct aob_block_timed *timed)
{
    for (size_t i = 0; i < timed->count; i++)
        json_decref(timed->cases[i].passes);
    *timed = (struct aob_block_timed){0};
}

json_t *aob_block_shares_to_json(const struct aob_block_shares *shares)
{
    return json_pack("{s:{s:f, s:f, s:f}}", "shares", "measured_s", shares->measured, "warmup_s",
                     shares->warmup, "images_s", shares->images);
}

bool aob_block_shares_from_json(const json_t *object, struct aob_block_shares *shares)
{
    const json_t *s = json_object_get(object, "shares");
    *shares = (struct aob_block_shares){.measured = json_number_value(json_object_get(s, "measured_s")),
                                        .warmup = json_number_value(json_object_get(s, "warmup_s")),
                                        .images = json_number_value(json_object_get(s, "images_s"))};
    return json_is_object(s);
}
