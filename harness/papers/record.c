#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "row.h"

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

bool aob_paper_find_all(const struct aob_paper_run *run, const char *technique, const char *const *values,
                        size_t count, const json_t **records, struct aob_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (!(records[i] = aob_paper_find(run, technique, values[i], error)))
            return false;
    return true;
}

/* A ratio to the fixed pass; too few rounds have no interval. */
static struct aob_paper_figure read_ratio(const json_t *object)
{
    const json_t *low = json_object_get(object, "ci_low"), *high = json_object_get(object, "ci_high");
    return (struct aob_paper_figure){aob_json_to_number(json_object_get(object, "ratio_to_ref")),
                                     json_is_number(low) ? json_number_value(low) : -INFINITY,
                                     json_is_number(high) ? json_number_value(high) : INFINITY};
}

struct aob_paper_figure aob_paper_cost(const json_t *record, const char *passes)
{
    const json_t *time = json_object_get(record, "time"), *pass;
    struct aob_paper_figure sum = aob_paper_exact(0);
    size_t at;
    if (!passes)
        return read_ratio(time);
    json_array_foreach(json_object_get(time, "passes"), at, pass)
    {
        const char *name = json_string_value(json_object_get(pass, "name"));
        if (strncmp(name, passes, strlen(passes)) == 0)
            sum = aob_paper_sum(sum, read_ratio(pass));
    }
    return sum;
}

void aob_paper_costs_to_first(const json_t *const *records, size_t count, const char *passes,
                              struct aob_paper_figure *figures)
{
    figures[0] = aob_paper_exact(1);
    for (size_t i = 1; i < count; i++)
        figures[i] =
            aob_paper_quotient(aob_paper_cost(records[i], passes), aob_paper_cost(records[0], passes));
}

double aob_paper_error(const json_t *record, const char *field)
{
    return aob_json_to_number(json_object_get(json_object_get(record, "error"), field));
}

double aob_paper_member(const json_t *record, const char *object, const char *name)
{
    return aob_json_to_number(json_object_get(json_object_get(record, object), name));
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

bool aob_paper_compare(const struct aob_paper_run *run, const json_t *a, const json_t *b,
                       struct aob_paper_figure *rmse, struct aob_error *error)
{
    struct aob_image first = {0}, second = {0};
    bool ok = aob_paper_image(run, a, &first, error) && aob_paper_image(run, b, &second, error);
    const float *p = ok ? aob_image_channel(&first, "technique.AO") : NULL,
                *q = ok ? aob_image_channel(&second, "technique.AO") : NULL;
    size_t count = (size_t)first.width * (size_t)first.height;
    double sum = 0;
    for (size_t i = 0; p && q && i < count; i++)
        sum += ((double)p[i] - q[i]) * ((double)p[i] - q[i]);
    *rmse = aob_paper_exact(sqrt(sum / (double)count));
    aob_image_finish(&first);
    aob_image_finish(&second);
    return ok && ((p && q) || aob_fail(error, "%s: an image without technique.AO", run->folder));
}
