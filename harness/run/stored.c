#include "stored.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/sealed.h"

bool aob_stored_is_precise(const struct aob_config *config, const json_t *time)
{
    return aob_json_to_number(json_object_get(time, "precision")) <= config->precision;
}

/* A time that was asked to be no finer than this is not what is wanted now. One that was, and ran out of its seconds, would
 * run out of them again. */
static bool is_coarse(const struct aob_config *config, const json_t *time)
{
    const double rounding = 1 + 1e-6; /* of a figure in the journal */
    double asked = aob_json_to_number(json_object_get(time, "precision_wanted"));
    return asked > config->precision * rounding && !aob_stored_is_precise(config, time);
}

double aob_stored_seconds_needed(const struct aob_config *config, const json_t *time)
{
    const double rounding = 1e-6;
    double asked = aob_json_to_number(json_object_get(time, "precision_wanted"));
    if (!(fabs(asked / config->precision - 1) <= rounding))
        return NAN;
    return aob_json_to_number(json_object_get(time, "seconds_needed"));
}

/* Below the run's folder: a file that is there and not known to be wrong. One that cannot be read may be good. */
static bool has_file(const char *folder, const json_t *name)
{
    if (!json_is_string(name))
        return false;
    char *path = aob_path_join(folder, json_string_value(name));
    enum aob_sealed state = aob_sealed_judge(path, NULL);
    free(path);
    return state == AOB_SEALED_GOOD || state == AOB_SEALED_SHUT;
}

bool aob_stored_is_finished(const struct aob_plan *plan, const char *folder, const json_t *record)
{
    const char *status = json_string_value(json_object_get(record, "status"));
    if (!status)
        return false;
    if (strcmp(status, "invalid") == 0)
        return true;
    const struct aob_config *config = plan->config;
    const json_t *error = json_object_get(record, "error"), *time = json_object_get(record, "time");
    if (strcmp(status, "ok") != 0 || (config->measure_time && !time) || (config->measure_error && !error))
        return false;
    if (config->measure_time && is_coarse(config, time))
        return false;
    return !config->images || (has_file(folder, json_object_get(record, "image")) &&
                               (!error || has_file(folder, json_object_get(error, "truth"))));
}
