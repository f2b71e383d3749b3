#include "papers/papers.h"
#include "command.h"

struct options {
    struct aob_common common;
    const char *filter, *out;
    bool quick;
};

static const struct aob_flag flags[] = {
    {"quick", NULL, "the middle columns of each picture, short timing: under a minute", AOB_FLAG_SWITCH,
     offsetof(struct options, quick)},
    {"filter", "TEXT", "only rows, measured or modelled, whose name holds the text", AOB_FLAG_TEXT,
     offsetof(struct options, filter)},
    {"out", "DIR", "where the runs go (results/papers)", AOB_FLAG_TEXT, offsetof(struct options, out)},
    {0},
};

static enum aob_exit papers(void *from, struct aob_error *error)
{
    const struct options *options = from;
    return aob_papers(&(struct aob_papers_desc){.dispatch = options->common.dispatch,
                                                .filter = options->filter,
                                                .out = options->out,
                                                .json = options->common.json,
                                                .quick = options->quick,
                                                .quiet = options->common.quiet},
                      error);
}

const struct aob_command aob_command_papers = {
    .name = "papers",
    .help = "the texts' figures beside those measured and modelled here",
    .usage = "[--quick] [--filter TEXT] [--out DIR] [--device NAME|N] [--module FILE.so]",
    .summary =
        "The figures of the techniques' texts beside those measured here, and the texts' milliseconds beside "
        "modelled ones.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .size = sizeof(struct options),
    .run = papers,
};
