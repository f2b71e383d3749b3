#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "row.h"

const char *const aob_paper_verdicts[] = {"reproduced", "shape only", "not reproduced",
                                          "needs a device model", "could not be run"};

static bool in_order(const struct aob_paper_row *row, const double *measured)
{
    double factor = measured[0] / row->figures[0];
    if (row->count == 1 && !(factor >= 1 / 2.5 && factor <= 2.5))
        return false;
    for (size_t i = 0; i < row->count; i++)
        if ((row->figures[i] > 1 && measured[i] <= 1) || (row->figures[i] < 1 && measured[i] >= 1))
            return false;
    for (size_t i = 0; i < row->count; i++)
        for (size_t j = 0; j < row->count; j++)
            if (row->figures[i] < row->figures[j] && measured[i] >= measured[j])
                return false;
    return true;
}

enum aob_paper_verdict aob_paper_judge(const struct aob_paper_row *row, const struct aob_paper_result *result)
{
    bool near = true;
    if (row->figures[0] == 0)
        return result->holds   ? AOB_PAPER_REPRODUCED
               : result->shape ? AOB_PAPER_SHAPE
                               : AOB_PAPER_NOT_REPRODUCED;
    for (size_t i = 0; i < row->count; i++)
        near &= fabs(result->measured[i] / row->figures[i] - 1) <= 0.25;
    return near                              ? AOB_PAPER_REPRODUCED
           : in_order(row, result->measured) ? AOB_PAPER_SHAPE
                                             : AOB_PAPER_NOT_REPRODUCED;
}

static bool is_number(const json_t *own, double number)
{
    return fabs(aob_json_to_number(own) - number) <= 1e-6 * fabs(number);
}

static bool is_vector(const json_t *own, const char *numbers)
{
    const json_t *component;
    size_t at;
    json_array_foreach(own, at, component)
    {
        char *end;
        if (!is_number(component, strtod(numbers, &end)) || end == numbers)
            return false;
        numbers = *end == ',' ? end + 1 : end;
    }
    return !*numbers;
}

static bool has_value(const json_t *record, const char *name, const char *value)
{
    static const char *const objects[] = {"params", "options", "camera"};
    const json_t *own = NULL;
    double number;
    for (size_t i = 0; i < AOB_COUNT(objects) && !own; i++)
        own = json_object_get(json_object_get(record, objects[i]), name);
    if (json_is_array(own))
        return is_vector(own, value);
    if (json_is_string(own))
        return strcmp(json_string_value(own), value) == 0;
    return aob_parse_double(value, &number) && is_number(own, number);
}

static bool has_values(const json_t *record, const char *values)
{
    char *text = aob_strdup(values), *rest = text;
    bool all = true;
    for (char *word; all && (word = strtok_r(rest, " ", &rest));) {
        char *equals = strchr(word, '=');
        *equals = '\0';
        all = has_value(record, word, equals + 1);
    }
    free(text);
    return all;
}

const json_t *aob_paper_find(const struct aob_paper_run *run, const char *technique, const char *values,
                             struct aob_error *error)
{
    const json_t *record;
    size_t at;
    json_array_foreach(run->records, at, record)
    {
        if (strcmp(json_string_value(json_object_get(record, "technique")), technique) != 0 ||
            !has_values(record, values))
            continue;
        if (strcmp(json_string_value(json_object_get(record, "status")), "ok") == 0)
            return record;
        aob_fail(error, "%s %s: %s", technique, values, json_string_value(json_object_get(record, "reason")));
        return NULL;
    }
    aob_fail(error, "%s %s: the run has no such case", technique, values);
    return NULL;
}

double aob_paper_cost(const json_t *record, const char *passes)
{
    const json_t *time = json_object_get(record, "time"), *pass;
    size_t at;
    double sum = 0;
    json_array_foreach(json_object_get(time, "passes"), at, pass)
    {
        const char *name = json_string_value(json_object_get(pass, "name"));
        bool counts = !passes || strncmp(name, passes, strlen(passes)) == 0;
        sum += counts ? aob_json_to_number(json_object_get(pass, "cpu_ms")) : 0;
    }
    return sum / aob_json_to_number(json_object_get(time, "ref_cpu_ms"));
}

double aob_paper_error(const json_t *record, const char *field)
{
    return aob_json_to_number(json_object_get(json_object_get(record, "error"), field));
}

bool aob_paper_image(const struct aob_paper_run *run, const json_t *record, struct aob_image *image,
                     struct aob_error *error)
{
    const char *name = json_string_value(json_object_get(record, "image"));
    if (!name)
        return aob_fail(error, "%s: a case kept no image", run->folder);
    char *path = aob_path_join(run->folder, name);
    bool ok = aob_image_read(image, path, error);
    free(path);
    return ok;
}

bool aob_paper_compare(const struct aob_paper_run *run, const json_t *a, const json_t *b, double *rmse,
                       struct aob_error *error)
{
    struct aob_image first = {0}, second = {0};
    bool ok = aob_paper_image(run, a, &first, error) && aob_paper_image(run, b, &second, error);
    const float *p = ok ? aob_image_channel(&first, "technique.AO") : NULL,
                *q = ok ? aob_image_channel(&second, "technique.AO") : NULL;
    size_t count = (size_t)first.width * (size_t)first.height;
    double sum = 0;
    for (size_t i = 0; p && q && i < count; i++)
        sum += ((double)p[i] - q[i]) * ((double)p[i] - q[i]);
    *rmse = sqrt(sum / (double)count);
    aob_image_finish(&first);
    aob_image_finish(&second);
    return ok && ((p && q) || aob_fail(error, "%s: an image without technique.AO", run->folder));
}
