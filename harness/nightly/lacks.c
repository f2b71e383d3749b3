#include "lacks.h"
#include "reports/page/rows.h"

bool aob_run_lacks(const char *run, size_t *asked, size_t *missing, struct aob_error *error)
{
    static const char *const paths[] = {"key", NULL};
    struct aob_rows rows = {0};
    bool ok = aob_rows_read_only(&rows, run, paths, error);
    *asked = ok ? rows.runs[0].asked : 0;
    *missing = ok ? rows.runs[0].missing : 0;
    aob_rows_finish(&rows);
    return ok;
}
