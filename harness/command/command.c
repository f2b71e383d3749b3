#include "command.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/output.h"

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

static const struct aob_flag device_flag = {"device", "NAME|N",
                                            "of a backend, by name or number; see: aobudget list backends",
                                            AOB_FLAG_TEXT, offsetof(struct aob_common, dispatch.device)};

/* Its own first, then those of every command; ended by a NULL name. */
static void gather_flags(const struct aob_command *command, struct aob_flag all[MAX_FLAGS])
{
    size_t count = 0;
    for (const struct aob_flag *flag = command->flags; flag && flag->name; flag++)
        all[count++] = *flag;
    if (command->modules)
        all[count++] = module_flag;
    if (command->devices)
        all[count++] = device_flag;
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
    common->dispatch.modules = (struct aob_modules){
        .paths = common->modules.items,
        .names = common->modules.items,
        .count = common->modules.count,
        .offered = common->modules.count,
    };
    common->dispatch.validate = getenv("AOBUDGET_VALIDATE") != NULL;
    return true;
}

static enum aob_exit print_help(const struct aob_command *command, const struct aob_flag *all,
                                struct aob_error *error)
{
    struct aob_text out = {0};
    aob_text_add_line(&out, "usage: aobudget %s %s", command->name, command->usage);
    aob_text_add_line(&out, "%s", command->summary);
    aob_flags_help(all, &out);
    bool ok = aob_output_write(out.data, out.size, error);
    aob_text_finish(&out);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

/* A command that failed has said why; that its words were lost as well is no second line. */
static enum aob_exit write_out(enum aob_exit code, const struct aob_text *out, struct aob_error *error)
{
    bool ok = !out->size || aob_output_write(out->data, out->size, *error->text ? NULL : error);
    return ok ? code : AOB_EXIT_USAGE;
}

enum aob_exit aob_command_run(const struct aob_command *command, int argc, char **argv,
                              struct aob_error *error)
{
    struct aob_flag all[MAX_FLAGS];
    gather_flags(command, all);
    if (asks_for_help(argc, argv))
        return print_help(command, all, error);
    struct aob_common *common = aob_alloc(1, command->size);
    char *program = aob_path_program();
    common->dispatch.program = program;
    enum aob_exit code = AOB_EXIT_USAGE;
    if (read_flags(command, &(struct aob_flags_desc){command->name, all, argc, argv}, common, error))
        code = write_out(command->run(common, error), &common->out, error);
    aob_text_finish(&common->out);
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
