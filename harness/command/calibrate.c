#include "compare/calibrate.h"
#include "base/text.h"
#include "command.h"

struct options {
    struct aob_common common;
    const char *backend, *technique, *seconds, *out;
};

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct options, field)                                    \
    }
static const struct aob_flag flags[] = {
    TEXT("backend", "NAME", backend, "see: aobudget list backends (vulkan)"),
    TEXT("technique", "NAME", technique, "that is timed beside the fixed pass (gtao)"),
    TEXT("seconds", "S", seconds, "of measuring, 3 at least (60)"),
    TEXT("out", "DIR", out, "where its run goes (results/calibrate)"),
    {0},
};

static enum aob_exit calibrate(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_text table = {0};
    struct aob_calibrate_desc desc = {.dispatch = o->common.dispatch,
                                      .backend = o->backend,
                                      .technique = o->technique,
                                      .folder = o->out,
                                      .json = o->common.json,
                                      .quiet = o->common.quiet};
    if (o->seconds &&
        (!aob_parse_double(o->seconds, &desc.seconds) || !(desc.seconds >= 3) || desc.seconds > 1e5)) {
        aob_fail(error, "--seconds: '%s' is not a number of seconds within 3 .. 1e5", o->seconds);
        return AOB_EXIT_USAGE;
    }
    enum aob_exit code = aob_calibrate(&desc, &table, error);
    if (aob_common_speaks(&o->common) && table.size)
        aob_text_add_bytes(&o->common.out, table.data, table.size);
    aob_text_finish(&table);
    return code;
}

const struct aob_command aob_command_calibrate = {
    .name = "calibrate",
    .help = "what difference this machine can resolve, in how many seconds",
    .usage = "[--backend B] [--technique T] [--seconds S] [--out DIR]",
    .summary = "This machine's noise, the differences that it can resolve, and the precision to ask for.",
    .flags = flags,
    .devices = true,
    .size = sizeof(struct options),
    .run = calibrate,
};
