#include "base/json.h"
#include "section.h"

/* All that the backend sees are items; the chosen one, which the other sections use, is the only one that passes. */
static void reply_device(const struct aob_section_job *job, const struct aob_gpu_device *device,
                         size_t number, bool chosen)
{
    json_t *item = json_pack("{s:o, s:s, s:i, s:o, s:s, s:b, s:b}", "item", aob_json_text(device->name),
                             "status", chosen ? AOB_CHECK_PASSED : AOB_CHECK_SKIPPED, "number", (int)number,
                             "driver", aob_json_text(device->driver), "class", device->device_class,
                             "software", device->software, "timer", device->timer);
    json_object_set_new(item, "reason", aob_json_text(device->lacks));
    aob_section_reply(job, item);
}

static bool choose(const struct aob_section_job *job, const struct aob_gpu_device_list *list, size_t *chosen,
                   struct aob_error *error)
{
    if (job->device)
        return aob_gpu_choose(list, job->backend, job->device, chosen, error);
    struct aob_gpu *gpu =
        aob_section_open(job, &(struct aob_gpu_desc){0}, error); /* says why there is no default */
    aob_gpu_close(gpu);
    return gpu;
}

static bool run_device(const struct aob_section_job *job, struct aob_error *error)
{
    struct aob_gpu_device_list list;
    size_t chosen;
    if (!aob_gpu_devices(aob_gpu_find(job->backend), &list, &chosen, error) ||
        !choose(job, &list, &chosen, error))
        return false;
    for (size_t i = 0; i < list.count; i++)
        reply_device(job, &list.items[i], i, i == chosen);
    return true;
}

const struct aob_section aob_section_device = {"device", run_device};
