#include "nightly/nightly.h"
#include "base/text.h"
#include "beside.h"
#include "command.h"

struct options {
    struct aob_common common;
    const char *history, *old, *out, *markdown, *precision, *seconds;
};

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct options, field)                                    \
    }
static const struct aob_flag flags[] = {
    TEXT("history", "F.db", history, "the history that the night is kept in; made if it is not there"),
    TEXT("old", "MODULES", old,
         "a module, or a folder of them: the old builds (those that the history keeps)"),
    TEXT("out", "DIR", out, "each night has a folder here, named by its date (results/nightly/NAME)"),
    TEXT("markdown", "FILE", markdown, "a summary for a pull request"),
    TEXT("precision", "P%", precision, "the difference that counts (2%)"),
    TEXT("seconds", "S", seconds, "of timing a suspect beside its old build, at most (6)"),
    {0},
};

static enum aob_exit nightly(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_text screen = {0};
    struct aob_nightly_desc desc = {.dispatch = o->common.dispatch,
                                    .config = o->common.words.items[0],
                                    .history = o->history,
                                    .old = o->old,
                                    .out = o->out,
                                    .markdown = o->markdown,
                                    .json = o->common.json,
                                    .quiet = o->common.quiet};
    if (!o->history) {
        aob_fail(error, "nightly: --history F.db is missing: the file that keeps the nights");
        return AOB_EXIT_USAGE;
    }
    if (!aob_beside_read(o->precision, o->seconds, &desc.precision, &desc.seconds, error))
        return AOB_EXIT_USAGE;
    enum aob_exit code = aob_nightly(&desc, &screen, error);
    if (aob_common_speaks(&o->common) && screen.size)
        aob_text_add_bytes(&o->common.out, screen.data, screen.size);
    aob_text_finish(&screen);
    return code;
}

const struct aob_command aob_command_nightly = {
    .name = "nightly",
    .help = "a night's run, kept in a history and judged against the nights before",
    .usage = "CONFIG|DIR --history F.db [--old MODULES] [--out DIR] [--markdown FILE] [--precision P%] "
             "[--seconds S] "
             "[--device NAME|N] [--module FILE.so]",
    .summary = "One night: CONFIG is run, or DIR is the folder of a run already. What stands out against "
               "earlier nights is "
               "measured again, the old build of its module beside the new one.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct options),
    .run = nightly,
};
