#include "beside.h"
#include "base/text.h"
#include "config/config.h"

bool aob_beside_read(const char *precision, const char *seconds, double *share, double *value,
                     struct aob_error *error)
{
    if (precision && !aob_config_parse_precision(precision, share, error))
        return aob_fail_in(error, "--precision");
    return !seconds || (aob_parse_double(seconds, value) && *value > 0 && *value <= 1e6) ||
           aob_fail(error, "--seconds: '%s' is not a number of seconds above 0, up to 1e6", seconds);
}
