#include "run/run.h"
#include "command.h"
#include "config/config.h"
#include "effects/auto.h"

struct options {
    struct aob_common common;
    const char *out, *filter, *shard, *precision;
    bool resume, fresh;
};

static const struct aob_flag flags[] = {
    {"out", "DIR", "where the run goes (results/NAME)", AOB_FLAG_TEXT, offsetof(struct options, out)},
    {"resume", NULL, "go on where DIR stopped (the default, if the config is the same)", AOB_FLAG_SWITCH,
     offsetof(struct options, resume)},
    {"fresh", NULL, "discard what DIR holds", AOB_FLAG_SWITCH, offsetof(struct options, fresh)},
    {"filter", "TEXT", "only cases whose line in `plan` holds the text", AOB_FLAG_TEXT,
     offsetof(struct options, filter)},
    {"shard", "I/N",
     "only this part of the plan, such as 2/4; env: of the array of tasks that this is one of", AOB_FLAG_TEXT,
     offsetof(struct options, shard)},
    {"precision", "P%", "timing a case ends where its interval is so narrow (as the config says, or 3%)",
     AOB_FLAG_TEXT, offsetof(struct options, precision)},
    {0},
};

static enum aob_exit run(void *from, struct aob_error *error)
{
    const struct options *options = from;
    double precision = 0;
    struct aob_shard shard = {0};
    if (options->resume && options->fresh) {
        aob_fail(error, "run: give --resume or --fresh, not both");
        return AOB_EXIT_USAGE;
    }
    if (options->precision && !aob_config_parse_precision(options->precision, &precision, error)) {
        aob_fail_in(error, "--precision");
        return AOB_EXIT_USAGE;
    }
    if (options->shard && !aob_shard_parse(options->shard, &shard, error)) {
        aob_fail_in(error, "--shard");
        return AOB_EXIT_USAGE;
    }
    struct aob_effects_auto chooser = {.dispatch = &options->common.dispatch,
                                       .config = options->common.words.items[0],
                                       .quiet = options->common.quiet};
    const struct aob_sweep_choice choice = aob_effects_auto_choice(&chooser);
    return aob_run(&(struct aob_run_desc){.choice = &choice,
                                          .dispatch = options->common.dispatch,
                                          .config = options->common.words.items[0],
                                          .out = options->out,
                                          .filter = options->filter,
                                          .shard = shard,
                                          .json = options->common.json,
                                          .precision = precision,
                                          .fresh = options->fresh,
                                          .quiet = options->common.quiet},
                   error);
}

const struct aob_command aob_command_run_config = {
    .name = "run",
    .help = "a sweep: times, errors, images, report",
    .usage = "CONFIG [--out DIR] [--resume|--fresh] [--filter TEXT] [--shard I/N] [--precision P%] "
             "[--device NAME|N] [--module FILE.so]",
    .summary = "The sweep: journal, images, report.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct options),
    .run = run,
};
