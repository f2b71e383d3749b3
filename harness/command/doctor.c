#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "base/text.h"
#include "command.h"
#include "gpu/gpu.h"
#include "scene/scene.h"
#include "store/cache.h"

struct checkup {
    const struct aob_dispatch *dispatch;
    json_t *findings; /* [{what, name, ok, says, cure}] */
    size_t drawing, missing;
};

static void find(struct checkup *checkup, const char *what, const char *name, bool ok, const char *says,
                 const char *cure)
{
    checkup->missing += !ok;
    json_array_append_new(checkup->findings,
                          json_pack("{s:s, s:s, s:b, s:s, s:s}", "what", what, "name", name, "ok", ok, "says",
                                    says, "cure", ok || !cure ? "" : cure));
}

/* What brings a driver of a backend; NULL: nothing does, as it draws nothing. */
static const char *packages_of(const struct aob_gpu_fns *backend)
{
    static const struct {
        const char *backend, *cure;
    } cures[] = {{"vulkan", "apt-get install libvulkan1 mesa-vulkan-drivers"},
                 {"gl-egl", "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri"},
                 {"gl-osmesa", "apt-get install libosmesa6"}};
    for (size_t i = 0; i < AOB_COUNT(cures); i++)
        if (strcmp(cures[i].backend, backend->name) == 0)
            return cures[i].cure;
    return NULL;
}

static bool any(const json_t *devices, bool (*is)(const json_t *device))
{
    const json_t *device;
    size_t at;
    json_array_foreach(devices, at, device)
    {
        if (is(device))
            return true;
    }
    return false;
}

static bool is_chosen(const json_t *device)
{
    return json_is_true(json_object_get(device, "chosen"));
}

static bool is_whole(const json_t *device)
{
    return !*json_string_value(json_object_get(device, "lacks"));
}

/* Of a backend whose device cannot be opened, by what it has without the user's choice. */
static const char *cure_of(const struct checkup *checkup, const struct aob_gpu_fns *backend)
{
    struct aob_dispatch dispatch = *checkup->dispatch;
    const char *cure = "another device (--device) or a newer driver";
    dispatch.device = NULL;
    json_t *devices = aob_dispatch_devices(&dispatch, backend->name, NULL);
    if (any(devices, is_chosen))
        cure = checkup->dispatch->device ? "choose a device that `aobudget list backends` shows" : cure;
    else if (any(devices, is_whole)) /* a processor, which is not taken unasked (gpu/gpu.h) */
        cure = "install that GPU's driver for EGL, or say --device as above";
    else if (!json_array_size(devices))
        cure = packages_of(backend);
    json_decref(devices);
    return cure;
}

static void check_backend(struct checkup *checkup, const struct aob_gpu_fns *backend)
{
    struct aob_error error = {{0}};
    json_t *device = aob_dispatch_probe(checkup->dispatch, backend->name, &error);
    bool ok = device;
    struct aob_text says = {0};
    if (ok)
        aob_text_add(&says, "%s; %s", json_string_value(json_object_get(device, "device")),
                     json_string_value(json_object_get(device, "driver")));
    else
        aob_text_add(&says, "%s", error.text);
    find(checkup, "backend", backend->name, ok, says.data, ok ? NULL : cure_of(checkup, backend));
    checkup->drawing += ok && packages_of(backend);
    aob_text_finish(&says);
    json_decref(device);
}

static void check_scene(struct checkup *checkup, const struct aob_scene_info *scene)
{
    char cure[128];
    if (!scene->file)
        return;
    bool ok = aob_file_exists(scene->file);
    snprintf(cure, sizeof cure, "apt-get install %s", scene->package ? scene->package : "?");
    find(checkup, "scene", scene->name, ok, scene->file, cure);
}

static void check_program(struct checkup *checkup)
{
    struct aob_error error = {{0}};
    char *folder = aob_path_program_folder(), *plot = aob_path_join(folder, "aobudget-plot");
    struct aob_cache cache = {0};
    find(checkup, "pictures", "aobudget-plot", aob_file_exists(plot), plot,
         "build the whole project: ./dev build");
    bool ok = aob_cache_open(&cache, &error);
    find(checkup, "cache", "folder", ok, ok ? cache.folder : error.text,
         "set AOBUDGET_CACHE to a folder of your own");
    free(plot);
    free(folder);
    aob_cache_close(&cache);
}

static void print_findings(const struct checkup *checkup, struct aob_text *out)
{
    char processor[256];
    json_t *finding;
    size_t at;
    aob_machine_processor(processor, sizeof processor);
    aob_text_add_line(out, "aobudget %s on %s, %d cores", AOBUDGET_VERSION, processor, aob_machine_cores());
    json_array_foreach(checkup->findings, at, finding)
    {
        const char *cure = json_string_value(json_object_get(finding, "cure"));
        aob_text_add_line(out, "%-8s %-9s %-14s %s",
                          json_is_true(json_object_get(finding, "ok")) ? "ok" : "missing",
                          json_string_value(json_object_get(finding, "what")),
                          json_string_value(json_object_get(finding, "name")),
                          json_string_value(json_object_get(finding, "says")));
        if (*cure)
            aob_text_add_line(out, "%-33s cure: %s", "", cure);
    }
}

static enum aob_exit verdict(const struct checkup *checkup, struct aob_error *error)
{
    if (!checkup->drawing) {
        aob_fail(error, "no backend that draws works: the cures are above");
        return AOB_EXIT_USAGE;
    }
    return checkup->missing ? AOB_EXIT_PART : AOB_EXIT_OK;
}

static enum aob_exit doctor(void *options, struct aob_error *error)
{
    struct aob_common *common = options;
    struct checkup checkup = {.dispatch = &common->dispatch, .findings = json_array()};
    for (const struct aob_gpu_fns *const *backend = aob_gpu_backends; *backend; backend++)
        check_backend(&checkup, *backend);
    for (const struct aob_scene_info *const *scene = aob_scenes; *scene; scene++)
        check_scene(&checkup, *scene);
    check_program(&checkup);
    bool ok = true;
    if (common->json) {
        json_t *document = json_pack("{s:s, s:O}", "program", AOBUDGET_VERSION, "findings", checkup.findings);
        ok = aob_json_write(document, common->json, error);
        json_decref(document);
    }
    if (aob_common_speaks(common))
        print_findings(&checkup, &common->out);
    json_decref(checkup.findings);
    return ok ? verdict(&checkup, error) : AOB_EXIT_USAGE;
}

const struct aob_command aob_command_doctor = {
    .name = "doctor",
    .help = "drivers and meshes: what is missing, and its cure",
    .usage = "[--device NAME|N]",
    .summary = "Drivers, helpers and meshes: what is there, and how to install the rest.",
    .devices = true,
    .size = sizeof(struct aob_common),
    .run = doctor,
};
