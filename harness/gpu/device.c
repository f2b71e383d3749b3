#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "backends.h"
#include "base/memory.h"
#include "base/text.h"

bool aob_gpu_devices(const struct aob_gpu_fns *fns, struct aob_gpu_device_list *list, size_t *chosen,
                     struct aob_error *error)
{
    *list = (struct aob_gpu_device_list){0};
    return fns->devices(list, chosen, error);
}

static int rank_of(const struct aob_gpu_device *device)
{
    static const char *const order[] = {"cpu", "gpu", "virtual", "integrated", "discrete"};
    for (size_t i = 0; i < AOB_COUNT(order); i++)
        if (!strcmp(order[i], device->device_class))
            return (int)i;
    return -1;
}

size_t aob_gpu_default_device(const struct aob_gpu_device_list *list)
{
    size_t best = list->count;
    for (size_t i = 0; i < list->count; i++)
        if (!*list->items[i].lacks &&
            (best == list->count || rank_of(&list->items[i]) > rank_of(&list->items[best])))
            best = i;
    return best;
}

static bool holds(const char *text, const char *part, size_t size)
{
    for (; strlen(text) >= size; text++)
        if (!strncasecmp(text, part, size))
            return true;
    return false;
}

static bool is_like(const struct aob_gpu_device *device, const struct aob_gpu_device *like)
{
    const char *end = strstr(like->name, " (");
    if (device->node && like->node)
        return device->node == like->node;
    return holds(device->name, like->name, end ? (size_t)(end - like->name) : strlen(like->name));
}

size_t aob_gpu_default_like(const struct aob_gpu_device_list *list, const struct aob_gpu_device *like)
{
    size_t best = aob_gpu_default_device(list);
    if (like->software || best == list->count)
        return best;
    for (size_t i = 0; i < list->count; i++)
        if (!*list->items[i].lacks && is_like(&list->items[i], like))
            return i;
    return list->items[best].software ? list->count : best;
}

static bool fail_choice(const struct aob_gpu_device_list *list, const char *backend, const char *wanted,
                        const char *what, struct aob_error *error)
{
    struct aob_text there = {0};
    for (size_t i = 0; i < list->count; i++)
        aob_text_add(&there, "%s%zu %s", i ? "; " : "", i, list->items[i].name);
    aob_fail(error, "%s: %s '%s': there %s %s", backend, what, wanted, list->count == 1 ? "is" : "are",
             list->count ? there.data : "none");
    aob_text_finish(&there);
    return false;
}

static bool is_number(const char *text)
{
    return *text && strspn(text, "0123456789") == strlen(text);
}

/* How many devices are meant, and the last of them. */
static size_t find_meant(const struct aob_gpu_device_list *list, const char *wanted, bool whole,
                         size_t *chosen)
{
    size_t found = 0;
    for (size_t i = 0; i < list->count; i++) {
        const char *name = list->items[i].name;
        if (whole ? !strcasecmp(name, wanted) : holds(name, wanted, strlen(wanted))) {
            *chosen = i;
            found++;
        }
    }
    return found;
}

bool aob_gpu_choose(const struct aob_gpu_device_list *list, const char *backend, const char *wanted,
                    size_t *chosen, struct aob_error *error)
{
    size_t found = 0;
    if (is_number(wanted)) {
        *chosen = strtoul(wanted, NULL, 10);
        found = *chosen < list->count;
    } else if (*wanted) {
        found = find_meant(list, wanted, true, chosen);
        if (!found)
            found = find_meant(list, wanted, false, chosen);
    }
    if (found != 1)
        return fail_choice(list, backend, wanted,
                           found ? "give a number, as several devices are" : "no device", error);
    const struct aob_gpu_device *device = &list->items[*chosen];
    return !*device->lacks || aob_fail(error, "%s: %s lacks %s: use another device or a newer driver",
                                       backend, device->name, device->lacks);
}

static void describe_open(const struct aob_gpu *gpu, struct aob_gpu_device_list *list)
{
    struct aob_gpu_device *device = &list->items[list->count++];
    *device = (struct aob_gpu_device){
        .device_class = gpu->info.device_class, .software = gpu->info.software, .timer = gpu->info.timer};
    snprintf(device->name, sizeof device->name, "%s", gpu->info.device);
    snprintf(device->driver, sizeof device->driver, "%s", gpu->info.driver);
}

bool aob_gpu_single_device(const struct aob_gpu_fns *fns, struct aob_gpu_device_list *list, size_t *chosen,
                           struct aob_error *error)
{
    static const struct aob_gpu_desc plain;
    struct aob_gpu *gpu = fns->open(&plain, error);
    if (!gpu)
        return false;
    *chosen = 0;
    describe_open(gpu, list);
    aob_gpu_close(gpu);
    return true;
}

struct aob_gpu *aob_gpu_keep_single(struct aob_gpu *gpu, const struct aob_gpu_desc *desc,
                                    struct aob_error *error)
{
    struct aob_gpu_device_list list = {0};
    size_t chosen;
    if (!gpu || !desc->device)
        return gpu;
    describe_open(gpu, &list);
    if (aob_gpu_choose(&list, gpu->info.backend, desc->device, &chosen, error))
        return gpu;
    aob_gpu_close(gpu);
    return NULL;
}
