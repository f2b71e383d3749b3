#include "timing/timer.h"
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "gpu/gpu.h"
#include "worker.h"

static json_t *checks_to_json(const struct aob_timer *timer)
{
    json_t *checks = json_array();
    for (size_t i = 0; i < AOB_TIMER_CHECKS; i++)
        if (timer->checks[i].what)
            json_array_append_new(checks,
                                  json_pack("{s:s, s:o, s:f, s:f, s:f}", "what", timer->checks[i].what,
                                            "measured", aob_json_number(timer->checks[i].measured),
                                            "expected", timer->checks[i].expected, "low",
                                            timer->checks[i].low, "high", timer->checks[i].high));
    return checks;
}

static bool run(struct aob_worker *worker, struct aob_error *error)
{
    const char *backend = json_string_value(json_object_get(worker->job, "backend"));
    const struct aob_gpu_desc desc = {.as_gpu = true,
                                      .device = json_string_value(json_object_get(worker->job, "device"))};
    struct aob_timer *timer = AOB_NEW(struct aob_timer);
    struct aob_gpu *gpu = aob_gpu_open(backend ? backend : "", &desc, error);
    bool ok = gpu && aob_timer_test(gpu, timer, error);
    if (ok)
        aob_worker_reply(worker, json_pack("{s:b, s:o, s:o}", "trusted", timer->trusted, "why_not",
                                           aob_json_text(timer->why_not), "checks", checks_to_json(timer)));
    if (gpu)
        aob_gpu_close(gpu);
    free(timer);
    return ok;
}

const struct aob_worker_job aob_worker_timer = {"timer", run};
