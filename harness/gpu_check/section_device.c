#include "base/json.h"
#include "section.h"

/* All that the backend sees are items; the chosen one, which the other sections use, is the only one that passes, or fails
 * where its driver has no more to say against it and yet does not open it. */
static void reply_device(const struct aob_section_job *job, const struct aob_gpu_device *device,
                         size_t number, const char *status, const char *reason)
{
    json_t *item =
        json_pack("{s:o, s:s, s:i, s:o, s:s, s:b, s:b}", "item", aob_json_text(device->name), "status",
                  status, "number", (int)number, "driver", aob_json_text(device->driver), "class",
                  device->device_class, "software", device->software, "timer", device->timer);
    json_object_set_new(item, "reason", aob_json_text(reason));
    aob_section_reply(job, item);
}

static bool run_device(const struct aob_section_job *job, struct aob_error *error)
{
    struct aob_gpu_device_list list;
    size_t chosen;
    if (!aob_gpu_devices(aob_gpu_find(job->backend), &list, &chosen, error) ||
        (job->device && !aob_gpu_choose(&list, job->backend, job->device, &chosen, error)))
        return false;
    struct aob_gpu *gpu = aob_section_open(job, &(struct aob_gpu_desc){0}, error);
    bool opened = gpu;
    aob_gpu_close(gpu);
    if (!opened && chosen == list.count)
        return false; /* the line says why there is no default */
    for (size_t i = 0; i < list.count; i++) {
        bool other = i != chosen;
        const char *chosen_status = opened ? AOB_CHECK_PASSED : AOB_CHECK_FAILED;
        reply_device(job, &list.items[i], i, other ? AOB_CHECK_SKIPPED : chosen_status,
                     other || opened ? list.items[i].lacks : error->text);
    }
    return true;
}

const struct aob_section aob_section_device = {"device", run_device};
