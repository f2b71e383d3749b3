/* `aobudget calibrate`: what this machine can resolve, and how long it takes. */
#ifndef AOB_COMPARE_CALIBRATE_H
#define AOB_COMPARE_CALIBRATE_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "run/dispatch.h"

struct aob_calibrate_desc {
    struct aob_dispatch dispatch;
    const char *backend;   /* NULL: vulkan */
    const char *technique; /* that is timed beside the fixed pass; NULL: gtao */
    const char *folder;    /* of its run, which is discarded first; NULL: results/calibrate */
    double seconds;        /* of measuring; 0: AOB_CALIBRATE_SECONDS */
    const char *json;      /* NULL: no document */
    bool quiet;
};
#define AOB_CALIBRATE_SECONDS 60.0

/* Times the technique at its defaults with the fixed pass and its control, tests the device's own clock, and adds the table
 * to `out`. USAGE after a line if it could not be timed; else OK, whatever the table says. */
enum aob_exit aob_calibrate(const struct aob_calibrate_desc *desc, struct aob_text *out,
                            struct aob_error *error);
#endif
