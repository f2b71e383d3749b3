#include <stdlib.h>
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "gpu/gpu.h"
#include "job/modules.h"
#include "worker.h"

static bool describe(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_registry registry;
    struct aob_modules modules;
    bool ok = true;
    aob_modules_from_json(json_object_get(worker->job, "modules"), &modules);
    aob_registry_init(&registry);
    for (size_t i = 0; ok && i < modules.count; i++)
        ok = aob_registry_load(&registry, modules.paths[i], error);
    for (size_t i = 0; ok && i < registry.count; i++)
        aob_worker_reply(worker, aob_technique_to_json(&registry.entries[i]));
    aob_registry_finish(&registry);
    aob_modules_finish(&modules);
    return ok;
}

static bool probe(struct aob_worker *worker, struct aob_error *error)
{
    const char *backend = json_string_value(json_object_get(worker->job, "backend"));
    const struct aob_gpu_desc desc = {.device = json_string_value(json_object_get(worker->job, "device"))};
    struct aob_gpu *gpu = aob_gpu_open(backend ? backend : "", &desc, error);
    if (!gpu)
        return false;
    json_t *answer = json_pack("{s:o, s:o, s:s}", "device", aob_json_text(gpu->info.device), "driver",
                               aob_json_text(gpu->info.driver), "class", gpu->info.device_class);
    if (gpu->info.software) { /* the processor is the device, and drivers call all of them by one name */
        char processor[256];
        aob_machine_processor(processor, sizeof processor);
        json_object_set_new(answer, "cpu", aob_json_text(processor));
        json_object_set_new(answer, "cores", json_integer(aob_machine_cores()));
    }
    aob_worker_reply(worker, answer);
    aob_gpu_close(gpu);
    return true;
}

static void reply_devices(struct aob_worker *worker, const struct aob_gpu_device_list *list, size_t chosen)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct aob_gpu_device *d = &list->items[i];
        aob_worker_reply(worker,
                         json_pack("{s:o, s:o, s:s, s:b, s:b, s:s, s:b}", "name", aob_json_text(d->name),
                                   "driver", aob_json_text(d->driver), "class", d->device_class, "software",
                                   d->software, "timer", d->timer, "lacks", d->lacks, "chosen", i == chosen));
    }
    if (chosen == list->count)
        aob_worker_reply(worker, json_pack("{s:o}", "none", aob_json_text(list->none.text)));
}

static bool devices(struct aob_worker *worker, struct aob_error *error)
{
    const char *backend = json_string_value(json_object_get(worker->job, "backend"));
    const char *wanted = json_string_value(json_object_get(worker->job, "device"));
    const struct aob_gpu_fns *fns = backend ? aob_gpu_find(backend) : NULL;
    struct aob_gpu_device_list *list = AOB_NEW(struct aob_gpu_device_list);
    size_t chosen;
    bool ok = fns ? aob_gpu_devices(fns, list, &chosen, error) : aob_fail(error, "no such backend");
    if (ok && wanted)
        ok = aob_gpu_choose(list, backend, wanted, &chosen, error);
    if (ok)
        reply_devices(worker, list, chosen);
    free(list);
    return ok;
}

const struct aob_worker_job aob_worker_describe = {"describe", describe};
const struct aob_worker_job aob_worker_probe = {"probe", probe};
const struct aob_worker_job aob_worker_devices = {"devices", devices};
