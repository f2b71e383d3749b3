#include "gbuffer/probe.h"
#include "job/light_job.h"
#include "worker.h"

static bool read_probe(struct aob_worker *worker, struct aob_error *error)
{
    const char *file;
    struct aob_light_projection projection;
    if (!aob_light_job_from_json(worker->job, &file, error) || !aob_probe_read(file, &projection, error))
        return false;
    aob_worker_reply(worker, aob_light_answer_to_json(&projection));
    return true;
}

const struct aob_worker_job aob_worker_light = {"light", read_probe};
