#include "crew.h"
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include "base/machine.h"
#include "base/memory.h"
#include "base/text.h"
#include "gpu/gpu.h"

/* What the threads share; the lock is for all of it and for what is printed. */
struct crew {
    const struct aob_crew_desc *desc;
    pthread_mutex_t lock;
    size_t next; /* row that nobody has begun */
};

/* One row while a worker asks it. */
struct shift {
    struct crew *crew;
    struct aob_stress_row *row;
    const struct aob_property *begun; /* and not answered */
    int deaths;                       /* of workers */
};

enum { MAX_CREW = 16 };

/* A property stops its own worker long before (ask.c), unless that sleeps. */
static const double job_s = 120, property_s = 30;

/* Properties that killed their workers, after which a row is given up. */
enum { MOST_DEATHS = 8 };

static void say(struct shift *shift, const struct aob_property *property)
{
    struct aob_text what = {0};
    const struct aob_stress_row *row = shift->row;
    aob_text_add(&what, "%s %s: %s", row->technique ? row->technique->name : "instruments",
                 row->backend ? row->backend : "", property->name);
    aob_progress_step(shift->crew->desc->progress, what.data);
    aob_text_finish(&what);
}

static void take(void *user, const json_t *object)
{
    struct shift *shift = user;
    struct aob_stress_answer answer;
    if (!aob_stress_answer_from_json(object, &answer))
        return;
    pthread_mutex_lock(&shift->crew->lock);
    if (answer.message == AOB_STRESS_OPENED && !shift->row->device) {
        shift->row->device = aob_strdup(answer.device);
        shift->row->driver = aob_strdup(answer.driver);
    } else if (answer.message == AOB_STRESS_BEGUN)
        shift->begun = aob_property_find(answer.property);
    else if (answer.message == AOB_STRESS_ANSWERED && aob_stress_row_take(shift->row, &answer)) {
        say(shift, aob_property_find(answer.property));
        shift->begun = NULL;
    }
    pthread_mutex_unlock(&shift->crew->lock);
}

/* The same for a property that nobody answers: it killed its worker, or could not be asked. */
static void take_outcome(struct shift *shift, const char *property, enum aob_outcome outcome,
                         const char *reason)
{
    pthread_mutex_lock(&shift->crew->lock);
    aob_stress_row_take(shift->row, &(struct aob_stress_answer){.message = AOB_STRESS_ANSWERED,
                                                                .property = property,
                                                                .outcome = aob_outcome_word(outcome),
                                                                .worst = NAN,
                                                                .bound = NAN,
                                                                .reason = reason});
    say(shift, aob_property_find(property));
    pthread_mutex_unlock(&shift->crew->lock);
}

static struct aob_stress_job job_of(const struct shift *shift, const char **names)
{
    const struct aob_crew_desc *desc = shift->crew->desc;
    const struct aob_stress_row *row = shift->row;
    struct aob_stress_job job = {.backend = row->backend,
                                 .device = desc->dispatch->device,
                                 .validate = desc->dispatch->validate,
                                 .quick = desc->quick,
                                 .properties = names,
                                 .images = desc->images};
    if (row->technique)
        job.technique = aob_technique_address(row->technique);
    for (size_t i = 0; i < row->cell_count; i++)
        if (!row->cells[i].asked)
            names[job.property_count++] = row->cells[i].property->name;
    return job;
}

void aob_crew_environment(const char *backend, const char *env[AOB_CREW_ENVIRONMENT])
{
    size_t used = 0;
    env[used++] = "LP_NUM_THREADS=1";
    env[used++] = "OMP_NUM_THREADS=1";
    for (const char *const *e = backend ? aob_gpu_find(backend)->environment : NULL;
         e && *e && used < AOB_CREW_ENVIRONMENT - 1; e++)
        env[used++] = *e;
    env[used] = NULL;
}

static size_t unasked(const struct aob_stress_row *row)
{
    size_t count = 0;
    for (size_t i = 0; i < row->cell_count; i++)
        count += !row->cells[i].asked;
    return count;
}

/* False: nothing more can be asked of the row. */
static bool ask_rest(struct shift *shift)
{
    const char **names = AOB_NEW_ARRAY(const char *, shift->row->cell_count + 1), *env[AOB_CREW_ENVIRONMENT];
    struct aob_error error = {{0}};
    struct aob_stress_job job = job_of(shift, names);
    aob_crew_environment(shift->row->backend, env);
    const struct aob_job_desc desc = {.job = aob_stress_job_to_json(&job),
                                      .env = env,
                                      .timeout_s = job_s + property_s * (double)job.property_count,
                                      .on_answer = take,
                                      .user = shift};
    shift->begun = NULL;
    bool ok = aob_dispatch_job(shift->crew->desc->dispatch, &desc, &error);
    free(names);
    if (!unasked(shift->row)) /* what a worker does after its last answer is no property's fault */
        return false;
    if (ok) /* a module may end the process, with a good code too */
        aob_fail(&error, "the worker ended without an answer");
    if (!shift->begun) {
        shift->row->missing = aob_strdup(error.text);
        return false;
    }
    take_outcome(shift, shift->begun->name, AOB_FAILS, error.text);
    return ++shift->deaths < MOST_DEATHS && unasked(shift->row);
}

static void ask_row(struct shift *shift)
{
    while (ask_rest(shift))
        continue;
    const char *missing = shift->row->missing;
    for (size_t i = 0; i < shift->row->cell_count; i++)
        if (!shift->row->cells[i].asked)
            take_outcome(shift, shift->row->cells[i].property->name, missing ? AOB_NOT_APPLICABLE : AOB_FAILS,
                         missing ? missing
                                 : "it was not asked: too many properties before it killed their worker");
}

static void *work(void *user)
{
    struct crew *crew = user;
    for (;;) {
        pthread_mutex_lock(&crew->lock);
        size_t at = crew->next++;
        pthread_mutex_unlock(&crew->lock);
        if (at >= crew->desc->count)
            return NULL;
        ask_row(&(struct shift){.crew = crew, .row = &crew->desc->rows[at]});
    }
}

void aob_crew_share(void *(*work)(void *user), void *user, size_t most)
{
    pthread_t threads[MAX_CREW];
    size_t want = (size_t)aob_machine_cores(), used = 0;
    want = want > MAX_CREW ? MAX_CREW : want;
    for (; used + 1 < want && used + 1 < most; used++)
        if (pthread_create(&threads[used], NULL, work, user) != 0)
            break;
    work(user); /* this thread is one of them, and does all where no other could be made */
    for (size_t i = 0; i < used; i++)
        pthread_join(threads[i], NULL);
}

void aob_crew_run(const struct aob_crew_desc *desc)
{
    struct crew crew = {.desc = desc};
    pthread_mutex_init(&crew.lock, NULL);
    aob_crew_share(work, &crew, desc->count);
    pthread_mutex_destroy(&crew.lock);
}
