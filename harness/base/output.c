#include "output.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include "text.h"

static bool fail(struct aob_error *error)
{
    return aob_fail(error, "standard output: cannot write: %s", strerror(errno));
}

bool aob_output_write(const char *text, size_t size, struct aob_error *error)
{
    struct aob_text shown = {0};
    aob_text_add_shown(&shown, text, size, true);
    bool ok = fwrite(shown.data, 1, shown.size, stdout) == shown.size && fflush(stdout) == 0;
    if (!ok)
        fail(error);
    aob_text_finish(&shown);
    return ok;
}

bool aob_output_close(struct aob_error *error)
{
    return fclose(stdout) == 0 || errno == EBADF || fail(error);
}
