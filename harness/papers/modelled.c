#include "modelled.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/json.h"

const char *const aob_modelled_part_names[] = {"alu", "texture", "fills", "memory", "targets"};

/* Levels of cache have names of their own. */
static enum aob_modelled_part part_of(const char *resource)
{
    for (int part = 0; part < AOB_MODELLED_PARTS; part++)
        if (part != AOB_MODELLED_FILLS && strcmp(resource, aob_modelled_part_names[part]) == 0)
            return (enum aob_modelled_part)part;
    return AOB_MODELLED_FILLS;
}

static double number_of(const json_t *object, const char *name)
{
    return aob_json_to_number(json_object_get(object, name));
}

/* What a pass takes anew for each of `scale` times as many pixels; the time between passes it has once. */
static double scaled(const json_t *pass, const char *name, double scale)
{
    const double launch = number_of(pass, "launch_ms");
    return scale * (number_of(pass, name) - launch) + launch;
}

/* `sums`: resource -> milliseconds, of all passes so far. */
static void add_pass(const json_t *pass, double scale, json_t *sums, struct aob_modelled *modelled)
{
    const char *resource;
    json_t *ms;
    modelled->ms += scaled(pass, "ms", scale);
    modelled->low += scaled(pass, "low_ms", scale);
    modelled->high += scaled(pass, "high_ms", scale);
    json_object_foreach(json_object_get(pass, "resources"), resource, ms)
    {
        double more = scale * json_number_value(ms);
        json_object_set_new(sums, resource,
                            json_real(json_number_value(json_object_get(sums, resource)) + more));
        modelled->parts[part_of(resource)] += more;
    }
}

static void find_limit(json_t *sums, struct aob_modelled *modelled)
{
    const char *resource;
    json_t *ms;
    double most = 0;
    json_object_foreach(sums, resource, ms)
    {
        if (json_number_value(ms) <= most)
            continue;
        most = json_number_value(ms);
        snprintf(modelled->limit, sizeof modelled->limit, "%s", resource);
    }
}

static bool begins(const json_t *pass, const char *prefix)
{
    const char *name = json_string_value(json_object_get(pass, "name"));
    return !prefix || (name && strncmp(name, prefix, strlen(prefix)) == 0);
}

/* Why the record has no modelled times of the profile. */
static bool fail_without(const struct aob_modelled_row *row, const json_t *figures, struct aob_error *error)
{
    const char *refused = json_string_value(json_object_get(figures, "reason")),
               *uncounted = json_string_value(json_object_get(figures, "not_modelled"));
    return aob_fail(error, "%s: %s", row->profile,
                    refused     ? refused
                    : uncounted ? uncounted
                    : figures   ? "the profile has no rates"
                                : "the run has no figures of it");
}

bool aob_modelled_read(const struct aob_modelled_row *row, const struct aob_paper_run *run,
                       struct aob_modelled *modelled, struct aob_error *error)
{
    const json_t *record = aob_paper_find(run, row->technique, row->values, error), *pass;
    *modelled = (struct aob_modelled){0};
    if (!record)
        return false;
    const json_t *figures = json_object_get(json_object_get(record, "cache"), row->profile);
    const json_t *passes = json_object_get(json_object_get(figures, "modelled"), "passes");
    if (!passes)
        return fail_without(row, figures, error);
    json_t *sums = json_object();
    const double scale = row->width / number_of(record, "width");
    size_t at;
    json_array_foreach(passes, at, pass) if (begins(pass, row->passes)) add_pass(pass, scale, sums, modelled);
    find_limit(sums, modelled);
    json_decref(sums);
    return modelled->ms > 0 ||
           aob_fail(error, "no pass '%s' has a modelled time", row->passes ? row->passes : "");
}

struct aob_modelled_sum aob_modelled_summarise(const double *ratios, size_t count)
{
    double sum = 0, squares = 0;
    size_t within = 0;
    for (size_t i = 0; i < count; i++) {
        sum += log(ratios[i]);
        within += fabs(log(ratios[i])) <= M_LN2;
    }
    const double mean = count ? sum / (double)count : NAN;
    for (size_t i = 0; i < count; i++)
        squares += (log(ratios[i]) - mean) * (log(ratios[i]) - mean);
    return (struct aob_modelled_sum){count, exp(mean),
                                     count > 1 ? exp(sqrt(squares / (double)(count - 1))) : NAN,
                                     count ? (double)within / (double)count : NAN};
}
