#include "ask.h"
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "job/stress_job.h"
#include "property.h"
#include "store/image.h"

/* A subject and its properties while they are asked. */
struct asking {
    struct aob_stress_job job;
    struct aob_registry registry;
    struct aob_gpu *gpu;
    struct aob_subject subject;
    bool has_subject;
};

static bool open_subject(struct aob_worker *worker, struct asking *asking, struct aob_error *error)
{
    const struct aob_stress_job *job = &asking->job;
    if (!job->technique.technique)
        return true;
    const struct aob_technique *technique = aob_registry_open(&asking->registry, &job->technique, error);
    const struct aob_gpu_desc desc = {.validate = job->validate, .robust = true, .device = job->device};
    asking->gpu = technique ? aob_gpu_open(job->backend, &desc, error) : NULL;
    if (!asking->gpu)
        return false;
    aob_subject_init(&asking->subject, technique, asking->gpu);
    asking->has_subject = true;
    aob_worker_reply(
        worker, aob_stress_answer_to_json(&(struct aob_stress_answer){.message = AOB_STRESS_OPENED,
                                                                      .device = asking->gpu->info.device,
                                                                      .driver = asking->gpu->info.driver}));
    return true;
}

static void add_wanted(struct aob_image *image, const struct aob_sight *sight, size_t count)
{
    float *error;
    memcpy(aob_image_add(image, "reference.AO"), sight->wanted, count * sizeof(float));
    error = aob_image_add(image, "error.AO");
    for (size_t i = 0; i < count; i++)
        error[i] = sight->image[i] - sight->wanted[i];
}

/* The image of the worst place, beside what it was compared with, as channels of one file. NULL where there is none, or it
 * cannot be written, which a warning tells. */
static char *write_sight(const struct asking *asking, const char *property, const struct aob_sight *sight)
{
    struct aob_error error = {{0}};
    struct aob_text name = {0};
    struct aob_image image = {.width = sight->width, .height = sight->height};
    const struct aob_address *technique = &asking->job.technique;
    size_t count = (size_t)sight->width * (size_t)sight->height;
    if (!asking->job.images || !sight->image)
        return NULL;
    aob_text_add(&name, "%s%s%.8s-%s-%s.exr", technique->technique, technique->module ? "-" : "",
                 technique->module ? technique->digest : "", asking->job.backend, property);
    memcpy(aob_image_add(&image, "technique.AO"), sight->image, count * sizeof(float));
    if (sight->wanted)
        add_wanted(&image, sight, count);
    char *path = aob_path_join(asking->job.images, name.data);
    if (!aob_image_write(&image, path, &error)) {
        aob_warn("%s", error.text);
        aob_text_finish(&name);
    }
    aob_image_finish(&image);
    free(path);
    return name.data;
}

/* Of processor time, of one property: all are small, so that one which takes longer has gone astray. */
enum { PROPERTY_S = 60 };

static void give_up(int signal)
{
    static const char line[] = "aobudget: error: the property took longer than 60 s of processor time\n";
    (void)signal;
    if (write(STDERR_FILENO, line, sizeof line - 1) < 0)
        _exit(AOB_EXIT_BAD); /* the code then tells it alone */
    _exit(AOB_EXIT_USAGE);
}

static void limit_work(void)
{
    signal(SIGPROF, give_up);
    setitimer(ITIMER_PROF, &(struct itimerval){.it_value.tv_sec = PROPERTY_S}, NULL);
}

static void ask(struct aob_worker *worker, struct asking *asking, const struct aob_property *property)
{
    struct aob_trial trial;
    struct aob_answer answer;
    aob_worker_reply(worker, aob_stress_answer_to_json(&(struct aob_stress_answer){
                                 .message = AOB_STRESS_BEGUN, .property = property->name}));
    limit_work();
    aob_trial_init(&trial, asking->has_subject ? &asking->subject : NULL, asking->job.quick);
    aob_property_ask(property, &trial, &answer);
    char *image = answer.outcome == AOB_FAILS || answer.outcome == AOB_BY_DEFINITION
                      ? write_sight(asking, property->name, &trial.sight)
                      : NULL;
    aob_worker_reply(worker, aob_stress_answer_to_json(
                                 &(struct aob_stress_answer){.message = AOB_STRESS_ANSWERED,
                                                             .property = property->name,
                                                             .outcome = aob_outcome_word(answer.outcome),
                                                             .worst = answer.worst,
                                                             .bound = answer.bound,
                                                             .declared = answer.declared,
                                                             .where = answer.where,
                                                             .reason = answer.reason,
                                                             .image = image,
                                                             .compared = trial.sight.wanted}));
    free(image);
    aob_trial_finish(&trial);
}

static bool ask_all(struct aob_worker *worker, struct asking *asking, struct aob_error *error)
{
    for (size_t i = 0; i < asking->job.property_count; i++) {
        const struct aob_property *property = aob_property_find(asking->job.properties[i]);
        if (!property)
            return aob_fail(error, "there is no property '%s'", asking->job.properties[i]);
        ask(worker, asking, property);
    }
    return true;
}

static bool run(struct aob_worker *worker, struct aob_error *error)
{
    struct asking *asking = AOB_NEW(struct asking);
    aob_registry_init(&asking->registry);
    bool ok = aob_stress_job_from_json(worker->job, &asking->job, error) &&
              open_subject(worker, asking, error) && ask_all(worker, asking, error);
    if (asking->has_subject)
        aob_subject_finish(&asking->subject);
    aob_gpu_close(asking->gpu);
    aob_registry_finish(&asking->registry);
    aob_stress_job_finish(&asking->job);
    free(asking);
    return ok;
}

const struct aob_worker_job aob_worker_stress = {"stress", run};
