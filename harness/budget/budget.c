#include "budget.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "base/shelf.h"
#include "base/text.h"
#include "config/yaml.h"

enum { MAX_FILE = 1 << 20 };

void aob_budget_finish(struct aob_budget *budget)
{
    free(budget->name);
    free(budget->path);
    free(budget->title);
    free(budget->source);
    free(budget->device);
    *budget = (struct aob_budget){0};
}

/* A number of the file and its bounds. */
struct number {
    const char *key;
    size_t offset;
    double low, high;
};
static const struct number numbers[] = {
    {"frame", offsetof(struct aob_budget, frame_ms), 0.01, 1e6},
    {"rest", offsetof(struct aob_budget, rest_ms), 0, 1e6},
    {"ao", offsetof(struct aob_budget, ao_ms), 0.001, 1e6},
    {"error", offsetof(struct aob_budget, error), 0, 1},
};
static const struct {
    const char *key;
    size_t offset;
} texts[] = {
    {"title", offsetof(struct aob_budget, title)},
    {"source", offsetof(struct aob_budget, source)},
    {"device", offsetof(struct aob_budget, device)},
};

static bool read_size(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_budget *budget)
{
    const char *text;
    return aob_yaml_text(yaml, node, &text) &&
           (aob_parse_size(text, &budget->width, &budget->height) ||
            aob_yaml_fail(yaml, node, "'%s' is no resolution: write it as 1280x720", text));
}

static bool read_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    char *budget = user;
    const char *text;
    for (size_t i = 0; i < AOB_COUNT(numbers); i++)
        if (strcmp(key, numbers[i].key) == 0)
            return aob_yaml_number(yaml, node, numbers[i].low, numbers[i].high,
                                   (double *)(void *)(budget + numbers[i].offset));
    for (size_t i = 0; i < AOB_COUNT(texts); i++)
        if (strcmp(key, texts[i].key) == 0) {
            if (!aob_yaml_text(yaml, node, &text))
                return false;
            *(char **)(void *)(budget + texts[i].offset) = aob_strdup(text);
            return true;
        }
    return read_size(yaml, node, user);
}

static bool judge(struct aob_yaml *yaml, const yaml_node_t *root, const struct aob_budget *budget)
{
    const char *lacks = !budget->title      ? "title"
                        : !budget->source   ? "source"
                        : !budget->frame_ms ? "frame"
                                            : NULL;
    if (lacks)
        return aob_yaml_fail(yaml, root, "'%s' is missing", lacks);
    const yaml_node_t *rest = aob_yaml_find(yaml, root, "rest"), *ao = aob_yaml_find(yaml, root, "ao");
    if (budget->rest_ms >= budget->frame_ms)
        return aob_yaml_fail(yaml, rest, "the rest takes %g ms, which is the whole frame of %g ms",
                             budget->rest_ms, budget->frame_ms);
    if (ao && budget->ao_ms > budget->frame_ms - budget->rest_ms)
        return aob_yaml_fail(yaml, ao,
                             "a slice of %g ms is more than the %g ms that the rest leaves of the frame",
                             budget->ao_ms, budget->frame_ms - budget->rest_ms);
    return true;
}

static bool read_root(struct aob_yaml *yaml, struct aob_budget *budget)
{
    static const char *const keys[] = {"title",      "source", "frame", "rest", "ao",
                                       "resolution", "device", "error", NULL};
    const yaml_node_t *root = yaml_document_get_root_node(&yaml->document);
    budget->ao_ms = budget->error = INFINITY;
    return aob_yaml_mapping(yaml, root, keys, read_entry, budget) && judge(yaml, root, budget);
}

static bool read_file(struct aob_budget *budget, const char *path, struct aob_error *error)
{
    struct aob_yaml yaml;
    size_t size;
    char *text = aob_file_read(path, MAX_FILE, &size, error);
    if (!text)
        return false;
    budget->path = aob_strdup(path);
    budget->name = aob_shelf_name(path);
    bool ok = aob_yaml_load(&yaml, path, text, size, error);
    if (ok) {
        ok = read_root(&yaml, budget);
        aob_yaml_finish(&yaml);
    }
    free(text);
    return ok;
}

bool aob_budget_find(struct aob_budget *budget, const char *name, struct aob_error *error)
{
    *budget = (struct aob_budget){0};
    char *path = aob_shelf_find(AOB_BUDGET_SHELF, "budget", name, error);
    bool ok = path && read_file(budget, path, error);
    free(path);
    if (!ok)
        aob_budget_finish(budget);
    return ok;
}

double aob_budget_left(const struct aob_budget *budget, double other_ms)
{
    return fmin(budget->ao_ms, budget->frame_ms - budget->rest_ms - other_ms);
}

json_t *aob_budget_to_json(const struct aob_budget *budget)
{
    return json_pack("{s:s, s:s, s:s, s:f, s:f, s:o, s:o, s:i, s:i, s:s?}", "name", budget->name, "title",
                     budget->title, "source", budget->source, "frame_ms", budget->frame_ms, "rest_ms",
                     budget->rest_ms, "ao_ms", aob_json_number(budget->ao_ms), "error",
                     aob_json_number(budget->error), "width", budget->width, "height", budget->height,
                     "device", budget->device);
}

bool aob_budget_from_json(struct aob_budget *budget, const json_t *object)
{
    double width = aob_member_number(object, "width"), height = aob_member_number(object, "height");
    *budget = (struct aob_budget){.frame_ms = aob_member_number(object, "frame_ms"),
                                  .rest_ms = aob_member_number(object, "rest_ms"),
                                  .ao_ms = aob_member_number(object, "ao_ms"),
                                  .error = aob_member_number(object, "error")};
    bool sized = width >= 0 && width <= 16384 && height >= 0 && height <= 16384;
    if (!sized || !(budget->frame_ms > 0) || !(budget->rest_ms >= 0) || !(budget->ao_ms > 0) ||
        !(budget->error >= 0))
        return false;
    budget->width = (int)width;
    budget->height = (int)height;
    budget->name = aob_strdup(aob_member_text(object, "name"));
    budget->title = aob_strdup(aob_member_text(object, "title"));
    budget->source = aob_strdup(aob_member_text(object, "source"));
    budget->device = aob_strdup(json_string_value(json_object_get(object, "device")));
    return true;
}
