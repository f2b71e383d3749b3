#include "base/json.h"
#include "section.h"
#include "timing/timer.h"

/* A clock that lies is found on a GPU; that of a software driver is not needed, as its work is processor time. */
static const char *verdict_of(const struct aob_timer *timer, bool software)
{
    if (timer->trusted)
        return AOB_CHECK_PASSED;
    return software ? AOB_CHECK_SKIPPED : AOB_CHECK_DISAGREES;
}

static bool is_good(const struct aob_timer_check *check)
{
    return check->measured >= check->low && check->measured <= check->high;
}

static bool run_timer(const struct aob_section_job *job, struct aob_error *error)
{
    struct aob_timer timer;
    struct aob_gpu *gpu = aob_section_open(job, &(struct aob_gpu_desc){.as_gpu = true}, error);
    bool ok = gpu && aob_timer_test(gpu, &timer, error);
    if (ok) {
        json_t *checks = json_array();
        for (size_t i = 0; i < AOB_TIMER_CHECKS && timer.checks[i].what; i++)
            json_array_append_new(checks, json_pack("{s:s, s:o, s:f, s:f, s:b}", "what", timer.checks[i].what,
                                                    "measured", aob_json_number(timer.checks[i].measured),
                                                    "low", timer.checks[i].low, "high", timer.checks[i].high,
                                                    "good", is_good(&timer.checks[i])));
        aob_section_reply(job, json_pack("{s:s, s:s, s:s, s:o}", "item",
                                         timer.trusted ? "the clock is trusted" : "the clock is not trusted",
                                         "status", verdict_of(&timer, gpu->info.software), "reason",
                                         timer.why_not, "checks", checks));
    }
    aob_gpu_close(gpu);
    return ok;
}

const struct aob_section aob_section_timer = {"timer", run_timer};
