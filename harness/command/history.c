#include "history.h"
#include <string.h>

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct aob_history_options, field)                        \
    }
static const struct aob_flag flags[] = {
    TEXT("config", "NAME", config, "list, export: only nights of the config of this name"),
    TEXT("from", "DATE", from, "export: only nights that began at DATE or later, such as 2026-11-30"),
    TEXT("out", "FILE", out, "export: the table; FILE ends in .csv or .jsonl"),
    TEXT("keep", "N", keep, "prune: the latest nights of each config that stay, 1 or more"),
    {"rounds", NULL, "prune: only journals and raw rounds of older nights, not their figures",
     AOB_FLAG_SWITCH, offsetof(struct aob_history_options, rounds)},
    {0},
};

static const struct aob_history_action *const actions[] = {&aob_history_list, &aob_history_prune,
                                                           &aob_history_export_table, NULL};

static const struct aob_history_action *find_action(const char *name, struct aob_error *error)
{
    struct aob_text names = {0};
    for (const struct aob_history_action *const *a = actions; *a; a++) {
        if (strcmp((*a)->name, name) == 0) {
            aob_text_finish(&names);
            return *a;
        }
        aob_text_add(&names, "%s%s", names.size ? ", " : "", (*a)->name);
    }
    aob_fail(error, "history: there is no '%s'; there are %s", name, names.data);
    aob_text_finish(&names);
    return NULL;
}

static bool was_given(const struct aob_history_options *options, const struct aob_flag *flag)
{
    const char *field = (const char *)options + flag->offset;
    return flag->kind == AOB_FLAG_SWITCH ? *(const bool *)field : *(const char *const *)field != NULL;
}

static bool takes(const struct aob_history_action *action, const char *flag)
{
    size_t length = strlen(flag);
    for (const char *at = action->takes; (at = strstr(at, flag)); at += length)
        if ((at == action->takes || at[-1] == ' ') && (!at[length] || at[length] == ' '))
            return true;
    return false;
}

static bool check_flags(const struct aob_history_action *action, const struct aob_history_options *options,
                        struct aob_error *error)
{
    for (const struct aob_flag *flag = flags; flag->name; flag++)
        if (was_given(options, flag) && !takes(action, flag->name))
            return aob_fail(error, "history %s: takes no --%s", action->name, flag->name);
    return !action->check || action->check(options, error);
}

static enum aob_exit history(void *from, struct aob_error *error)
{
    struct aob_history_options *options = from;
    const struct aob_history_action *action = find_action(options->common.words.items[1], error);
    if (!action || !check_flags(action, options, error))
        return AOB_EXIT_USAGE;
    struct aob_history *opened = aob_history_open(options->common.words.items[0], action->use, error);
    enum aob_exit code = opened ? action->run(options, opened, error) : AOB_EXIT_USAGE;
    aob_history_close(opened);
    return code;
}

const struct aob_command aob_command_history = {
    .name = "history",
    .help = "what is kept of every night: list, prune and export it",
    .usage = "F.db list|prune|export [--config NAME] [--from DATE] [--out FILE.csv|FILE.jsonl] [--keep N "
             "[--rounds]]",
    .summary = "Lists the nights of a history, removes old ones, or writes all figures as a table.",
    .flags = flags,
    .least = 2,
    .most = 2,
    .size = sizeof(struct aob_history_options),
    .run = history,
};
