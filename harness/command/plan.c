#include <stdio.h>
#include "base/json.h"
#include "command.h"
#include "plan/shard.h"
#include "run/record.h"
#include "run/sweep.h"

struct options {
    struct aob_common common;
    const char *shard;
};

static const struct aob_flag flags[] = {
    {"shard", "I/N", "the cases of this part of the plan, such as 2/4; env: as for `run`", AOB_FLAG_TEXT,
     offsetof(struct options, shard)},
    {0},
};

static bool write_plan(const struct aob_plan *plan, const char *json, struct aob_error *error)
{
    json_t *cases = json_array();
    for (size_t i = 0; i < plan->case_count; i++)
        json_array_append_new(cases, aob_record_create(&(struct aob_record_desc){
                                         .config = plan->config, .c = &plan->cases[i], .status = "planned"}));
    json_t *document = json_pack("{s:s, s:f, s:o}", "name", plan->config->name, "estimated_s",
                                 aob_plan_estimate_s(plan), "cases", cases);
    bool ok = aob_json_write(document, json, error);
    json_decref(document);
    return ok;
}

static void print_plan(const struct aob_plan *plan, bool quiet, struct aob_text *out)
{
    for (size_t i = 0; i < plan->case_count && !quiet; i++) {
        struct aob_text text = {0};
        aob_case_describe(plan, &plan->cases[i], &text);
        aob_text_add_line(out, "%s", text.data);
        aob_text_finish(&text);
    }
    long seconds = (long)aob_plan_estimate_s(plan);
    aob_text_add_line(out, "%zu cases, about %ld:%02ld minutes", plan->case_count, seconds / 60,
                      seconds % 60);
}

static enum aob_exit plan(void *from, struct aob_error *error)
{
    struct options *options = from;
    struct aob_common *common = &options->common;
    struct aob_sweep sweep = {0};
    struct aob_shard shard = {0};
    if (options->shard && !aob_shard_parse(options->shard, &shard, error)) {
        aob_fail_in(error, "--shard");
        return AOB_EXIT_USAGE;
    }
    bool ok = aob_config_read(&sweep.config, common->words.items[0], error) &&
              aob_sweep_expand(&sweep, &common->dispatch, error);
    if (ok)
        aob_plan_keep_shard(&sweep.plan, &shard);
    if (ok && common->json)
        ok = write_plan(&sweep.plan, common->json, error);
    else if (ok)
        print_plan(&sweep.plan, common->quiet, &common->out);
    aob_sweep_finish(&sweep);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_command aob_command_plan = {
    .name = "plan",
    .help = "the cases that a config comes to",
    .usage = "CONFIG [--shard I/N]",
    .summary = "The expanded cases, their number and the estimated time.",
    .flags = flags,
    .modules = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct options),
    .run = plan,
};
