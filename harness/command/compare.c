#include "compare/compare.h"
#include "base/text.h"
#include "beside.h"
#include "command.h"

struct options {
    struct aob_common common;
    const char *config, *technique, *precision, *seconds, *out;
};

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct options, field)                                    \
    }
static const struct aob_flag flags[] = {
    TEXT("precision", "P%", precision, "the difference that counts (2%)"),
    TEXT("config", "FILE", config,
         "of modules: the cases (those of the run A; else atrium, 480x270, vulkan, defaults)"),
    TEXT("technique", "NAME", technique, "of two modules: this one only (all that both have)"),
    TEXT("seconds", "S", seconds, "of two modules: of timing a case, at most (6)"),
    TEXT("out", "DIR", out, "what is measured, and maps of what moved (results/compare)"),
    {0},
};

static enum aob_exit compare(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_text table = {0};
    struct aob_compare_desc desc = {.dispatch = o->common.dispatch,
                                    .sides = {o->common.words.items[0], o->common.words.items[1]},
                                    .folder = o->out,
                                    .config = o->config,
                                    .technique = o->technique,
                                    .json = o->common.json,
                                    .quiet = o->common.quiet};
    if (!aob_beside_read(o->precision, o->seconds, &desc.precision, &desc.seconds, error))
        return AOB_EXIT_USAGE;
    enum aob_exit code = aob_compare(&desc, &table, error);
    if (aob_common_speaks(&o->common) && table.size)
        aob_text_add_bytes(&o->common.out, table.data, table.size);
    aob_text_finish(&table);
    return code;
}

const struct aob_command aob_command_compare = {
    .name = "compare",
    .help = "two runs or two builds of a module, with verdicts",
    .usage = "A B [--precision P%] [--config FILE] [--technique NAME] [--seconds S] [--out DIR]",
    .summary =
        "Two runs, or two builds of a module (.so), case by case: FASTER, SLOWER, SAME, AMBIGUOUS, INVALID "
        "or MOVED.",
    .flags = flags,
    .devices = true,
    .least = 2,
    .most = 2,
    .size = sizeof(struct options),
    .run = compare,
};
