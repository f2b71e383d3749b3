#include "run/run.h"
#include "run/run_truths.h"
#include "command.h"
#include "config/config.h"
#include "effects/auto.h"

struct options {
    struct aob_common common;
    const char *out, *filter, *shard, *precision;
    bool resume, fresh, truth_only;
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
    {"truth-only", NULL, "only trace what the cases are compared with, into the cache; opens no device",
     AOB_FLAG_SWITCH, offsetof(struct options, truth_only)},
    {"precision", "P%", "timing a case ends where its interval is so narrow (as the config says, or 3%)",
     AOB_FLAG_TEXT, offsetof(struct options, precision)},
    {0},
};

static bool judge_flags(const struct options *o, struct aob_error *error)
{
    if (o->resume && o->fresh)
        return aob_fail(error, "run: give --resume or --fresh, not both");
    return !o->truth_only ||
           !(o->out || o->resume || o->fresh || o->precision || o->common.dispatch.device) ||
           aob_fail(error, "run: --truth-only makes no folder, times nothing and opens no device: it takes "
                           "no --out, --resume, "
                           "--fresh, --precision or --device");
}

static bool read_flags(const struct options *o, struct aob_run_desc *desc, struct aob_error *error)
{
    if (!judge_flags(o, error))
        return false;
    if (o->precision && !aob_config_parse_precision(o->precision, &desc->precision, error))
        return aob_fail_in(error, "--precision");
    return !o->shard || aob_shard_parse(o->shard, &desc->shard, error) || aob_fail_in(error, "--shard");
}

static enum aob_exit run(void *from, struct aob_error *error)
{
    const struct options *o = from;
    struct aob_effects_auto chooser = {
        .dispatch = &o->common.dispatch, .config = o->common.words.items[0], .quiet = o->common.quiet};
    const struct aob_sweep_choice choice = aob_effects_auto_choice(&chooser);
    struct aob_run_desc desc = {.choice = &choice,
                                .dispatch = o->common.dispatch,
                                .config = o->common.words.items[0],
                                .out = o->out,
                                .filter = o->filter,
                                .json = o->common.json,
                                .fresh = o->fresh,
                                .quiet = o->common.quiet};
    if (!read_flags(o, &desc, error))
        return AOB_EXIT_USAGE;
    return o->truth_only ? aob_run_truths(&desc, error) : aob_run(&desc, error);
}

const struct aob_command aob_command_run_config = {
    .name = "run",
    .help = "a sweep: times, errors, images, report",
    .usage =
        "CONFIG [--out DIR] [--resume|--fresh] [--truth-only] [--filter TEXT] [--shard I/N] [--precision P%] "
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
