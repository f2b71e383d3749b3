#include "command.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"

enum { MAX_FLAGS = 64 };

static const struct aob_flag common_flags[] = {
    {"json", "FILE", "write one JSON document ('-': standard output)", AOB_FLAG_TEXT,
     offsetof(struct aob_common, json)},
    {"quiet", NULL, "no progress, no summary", AOB_FLAG_SWITCH, offsetof(struct aob_common, quiet)},
    {"help", NULL, "this text", AOB_FLAG_SWITCH, offsetof(struct aob_common, help)},
};
static const struct aob_flag module_flag = {"module", "FILE.so",
                                            "load the techniques of a module as well; may be repeated",
                                            AOB_FLAG_MANY, offsetof(struct aob_common, modules)};

/* Its own first, then those of every command; ended by a NULL name. */
static void gather_flags(const struct aob_command *command, struct aob_flag all[MAX_FLAGS])
{
    size_t count = 0;
    for (const struct aob_flag *flag = command->flags; flag && flag->name; flag++)
        all[count++] = *flag;
    if (command->modules)
        all[count++] = module_flag;
    for (size_t i = 0; i < AOB_COUNT(common_flags); i++)
        all[count++] = common_flags[i];
    all[count] = (struct aob_flag){0};
}

static bool asks_for_help(int argc, char **argv)
{
    for (int i = 0; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0)
            return true;
    return false;
}

static bool read_flags(const struct aob_command *command, const struct aob_flags_desc *flags,
                       struct aob_common *common, struct aob_error *error)
{
    if (!aob_flags_parse(flags, common, &common->words, error))
        return false;
    if (common->words.count < command->least || common->words.count > command->most)
        return aob_fail(error, "usage: aobudget %s %s", command->name, command->usage);
    common->dispatch.modules = (struct aob_modules){common->modules.items, common->modules.count};
    common->dispatch.validate = getenv("AOBUDGET_VALIDATE") != NULL;
    return true;
}

enum aob_exit aob_command_run(const struct aob_command *command, int argc, char **argv,
                              struct aob_error *error)
{
    struct aob_flag all[MAX_FLAGS];
    gather_flags(command, all);
    if (asks_for_help(argc, argv)) {
        printf("usage: aobudget %s %s\n%s\n", command->name, command->usage, command->summary);
        aob_flags_help(all);
        return AOB_EXIT_OK;
    }
    struct aob_common *common = aob_alloc(1, command->size);
    char *program = aob_path_program();
    common->dispatch.program = program;
    enum aob_exit code = AOB_EXIT_USAGE;
    if (read_flags(command, &(struct aob_flags_desc){command->name, all, argc, argv}, common, error))
        code = command->run(common, error);
    aob_words_finish(&common->modules);
    aob_words_finish(&common->words);
    free(program);
    free(common);
    return code;
}

bool aob_common_speaks(const struct aob_common *common)
{
    return !common->quiet && !(common->json && strcmp(common->json, "-") == 0);
}
