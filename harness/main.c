/* The commands. Each reads its flags and calls its story. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "command/doctor.h"
#include "command/flags.h"
#include "command/list.h"
#include "papers/papers.h"
#include "command/report.h"
#include "run/run.h"
#include "command/shot.h"
#include "worker/worker.h"

struct command {
    const char *name, *help;
    enum aob_exit (*run)(int argc, char **argv, struct aob_error *error);
};

/* Flags that every command has. */
struct common {
    const char *json;
    bool quiet, help;
    struct aob_words modules, words;
    char *program;
};
#define COMMON_FLAGS(c)                                                                                      \
    {.name = "json",                                                                                         \
     .value = "FILE",                                                                                        \
     .text = &(c).json,                                                                                      \
     .help = "write one JSON document ('-': standard output)"},                                              \
        {.name = "quiet", .on = &(c).quiet, .help = "no progress, no summary"},                              \
        {.name = "help", .on = &(c).help, .help = "this text"},                                              \
    {                                                                                                        \
        .name = NULL                                                                                         \
    }
#define MODULE_FLAG(c)                                                                                       \
    {                                                                                                        \
        .name = "module", .value = "FILE.so", .many = &(c).modules,                                          \
        .help = "load the techniques of a module as well; may be repeated"                                   \
    }

static void common_finish(struct common *common)
{
    aob_words_finish(&common->modules);
    aob_words_finish(&common->words);
    free(common->program);
}

/* Parses; prints the help if asked. True if the command should go on. */
static bool start(const struct aob_flags *flags, struct common *common, int argc, char **argv,
                  enum aob_exit *code, struct aob_error *error)
{
    for (int i = 0; i < argc; i++)
        common->help |= strcmp(argv[i], "--help") == 0;
    *code = AOB_EXIT_OK;
    if (common->help) {
        aob_flags_help(flags);
        return false;
    }
    *code = AOB_EXIT_USAGE;
    common->program = aob_path_program();
    return aob_flags_parse(flags, argc, argv, &common->words, error);
}

static struct aob_dispatch make_dispatch(const struct common *common)
{
    return (struct aob_dispatch){.program = common->program,
                                 .modules = common->modules.items,
                                 .module_count = common->modules.count,
                                 .validate = getenv("AOBUDGET_VALIDATE") != NULL};
}

static enum aob_exit command_list(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    enum aob_exit code;
    const struct aob_flag flags[] = {MODULE_FLAG(common), COMMON_FLAGS(common)};
    const struct aob_flags table = {"list",
                                    "techniques|scenes|backends [--json FILE]",
                                    "What there is, with parameters, units, bounds and geometry.",
                                    flags,
                                    1,
                                    1};
    if (start(&table, &common, argc, argv, &code, error)) {
        struct aob_dispatch dispatch = make_dispatch(&common);
        code = aob_list(&dispatch, common.words.items[0], common.json, error);
    }
    common_finish(&common);
    return code;
}

static enum aob_exit command_plan(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    enum aob_exit code;
    const struct aob_flag flags[] = {MODULE_FLAG(common), COMMON_FLAGS(common)};
    const struct aob_flags table = {
        "plan", "CONFIG", "The expanded cases, their number and the estimated time.", flags, 1, 1};
    if (start(&table, &common, argc, argv, &code, error)) {
        struct aob_dispatch dispatch = make_dispatch(&common);
        code = aob_plan_print(&dispatch, common.words.items[0], common.json, common.quiet, error);
    }
    common_finish(&common);
    return code;
}

static enum aob_exit command_run(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    struct aob_run_desc desc = {0};
    bool resume = false;
    enum aob_exit code;
    const struct aob_flag flags[] = {
        {.name = "out", .value = "DIR", .text = &desc.out, .help = "where the run goes (results/NAME)"},
        {.name = "resume",
         .on = &resume,
         .help = "go on where DIR stopped (the default, if the config is the same)"},
        {.name = "fresh", .on = &desc.fresh, .help = "discard what DIR holds"},
        {.name = "filter",
         .value = "TEXT",
         .text = &desc.filter,
         .help = "only cases whose line in `plan` holds the text"},
        MODULE_FLAG(common),
        COMMON_FLAGS(common)};
    const struct aob_flags table = {
        "run",
        "CONFIG [--out DIR] [--resume|--fresh] [--filter TEXT] [--module FILE.so]",
        "The sweep: journal, images, report.",
        flags,
        1,
        1};
    if (start(&table, &common, argc, argv, &code, error)) {
        desc.dispatch = make_dispatch(&common);
        desc.config = common.words.items[0];
        desc.json = common.json;
        desc.quiet = common.quiet;
        code = resume && desc.fresh
                   ? (aob_fail(error, "run: give --resume or --fresh, not both"), AOB_EXIT_USAGE)
                   : aob_run(&desc, error);
    }
    common_finish(&common);
    return code;
}

static enum aob_exit command_shot(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    struct aob_shot_desc desc = {0};
    struct aob_words params = {0};
    enum aob_exit code;
    const struct aob_flag flags[] = {
        {.name = "technique",
         .value = "NAME",
         .text = &desc.technique,
         .help = "see: aobudget list techniques"},
        {.name = "scene",
         .value = "NAME",
         .text = &desc.scene,
         .help = "a listed scene, a mesh file, or capture:FILE.exr"},
        {.name = "view", .value = "NAME", .text = &desc.view, .help = "a listed view (the scene's first)"},
        {.name = "eye", .value = "x,y,z", .text = &desc.eye, .help = "camera position, scene units"},
        {.name = "target", .value = "x,y,z", .text = &desc.target, .help = "what the camera looks at"},
        {.name = "fov", .value = "DEG", .text = &desc.fov, .help = "vertical field of view (60)"},
        {.name = "ortho", .value = "H", .text = &desc.ortho, .help = "orthographic, H scene units high"},
        {.name = "shift",
         .value = "x,y",
         .text = &desc.shift,
         .help = "image moved right, up; in its heights"},
        {.name = "size", .value = "WxH", .text = &desc.size, .help = "pixels (480x270)"},
        {.name = "backend",
         .value = "NAME",
         .text = &desc.backend,
         .help = "see: aobudget list backends (vulkan)"},
        {.name = "p",
         .value = "name=value",
         .many = &params,
         .help = "a parameter or run option; may be repeated"},
        {.name = "reference-spp",
         .value = "N",
         .text = &desc.reference_spp,
         .help = "rays a pixel (256); 0: none"},
        {.name = "target-radius", .value = "R", .text = &desc.target_radius, .help = "of the truth, or R,R"},
        {.name = "target-weighting", .value = "W", .text = &desc.target_weighting, .help = "cosine, uniform"},
        {.name = "reference-radius", .value = "R", .text = &desc.reference_radius, .help = "has a new name"},
        {.name = "out", .value = "FILE.exr", .text = &desc.out, .help = "the images"},
        {.name = "depth",
         .value = "KIND",
         .text = &desc.convention[AOB_CONVENTION_DEPTH],
         .help = "of a capture: planar, distance, device or device_reversed (planar)"},
        {.name = "near",
         .value = "D",
         .text = &desc.convention[AOB_CONVENTION_NEAR],
         .help = "near plane of a capture's device depth"},
        {.name = "far",
         .value = "D",
         .text = &desc.convention[AOB_CONVENTION_FAR],
         .help = "its far plane, inf allowed; of other depths: sky from here on"},
        {.name = "normals",
         .value = "SPACE",
         .text = &desc.convention[AOB_CONVENTION_NORMALS],
         .help = "of a capture: view, world or derived (view)"},
        {.name = "handed",
         .value = "SIDE",
         .text = &desc.convention[AOB_CONVENTION_HANDED],
         .help = "of a capture's normals: right or left (right)"},
        {.name = "up",
         .value = "x,y,z",
         .text = &desc.convention[AOB_CONVENTION_UP],
         .help = "the world's up, for normals world (0,1,0)"},
        {.name = "depth-channel",
         .value = "NAME",
         .text = &desc.convention[AOB_CONVENTION_DEPTH_CHANNEL],
         .help = "of a capture, where it is not found by its name"},
        {.name = "normal-channel",
         .value = "NAME",
         .text = &desc.convention[AOB_CONVENTION_NORMAL_CHANNEL],
         .help = "likewise, without .X .Y .Z"},
        MODULE_FLAG(common),
        COMMON_FLAGS(common)};
    const struct aob_flags table = {
        "shot", "--technique T --scene S [flags]", "One frame, timed and scored.", flags, 0, 0};
    if (start(&table, &common, argc, argv, &code, error)) {
        desc.dispatch = make_dispatch(&common);
        desc.params = params.items;
        desc.param_count = params.count;
        desc.json = common.json;
        desc.quiet = common.quiet;
        code = desc.technique && desc.scene
                   ? aob_shot(&desc, error)
                   : (aob_fail(error, "shot: --technique and --scene are needed"), AOB_EXIT_USAGE);
    }
    aob_words_finish(&params);
    common_finish(&common);
    return code;
}

static enum aob_exit command_report(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    const char *out = NULL, *techniques = NULL;
    enum aob_exit code;
    const struct aob_flag flags[] = {{.name = "out",
                                      .value = "DIR",
                                      .text = &out,
                                      .help = "where the page goes (the first folder's report/)"},
                                     {.name = "techniques",
                                      .value = "FILE.md",
                                      .text = &techniques,
                                      .help = "in place of it: a page of what each technique is"},
                                     COMMON_FLAGS(common)};
    const struct aob_flags table = {"report",
                                    "DIR... [--out DIR] | DIR --techniques FILE.md",
                                    "Page and pictures from journals.",
                                    flags,
                                    1,
                                    64};
    if (start(&table, &common, argc, argv, &code, error))
        code = aob_report(&(struct aob_report_desc){.program = common.program,
                                                    .folders = common.words.items,
                                                    .folder_count = common.words.count,
                                                    .out = out,
                                                    .techniques = techniques,
                                                    .json = common.json,
                                                    .quiet = common.quiet},
                          error);
    common_finish(&common);
    return code;
}

static enum aob_exit command_papers(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    struct aob_papers_desc desc = {0};
    enum aob_exit code;
    const struct aob_flag flags[] = {
        {.name = "quick",
         .on = &desc.quick,
         .help = "the middle columns of each picture, short timing: under a minute"},
        {.name = "filter",
         .value = "TEXT",
         .text = &desc.filter,
         .help = "only rows whose name holds the text"},
        {.name = "out", .value = "DIR", .text = &desc.out, .help = "where the runs go (results/papers)"},
        MODULE_FLAG(common),
        COMMON_FLAGS(common)};
    const struct aob_flags table = {"papers",
                                    "[--quick] [--filter TEXT] [--out DIR] [--module FILE.so]",
                                    "The figures of the techniques' texts beside those measured here.",
                                    flags,
                                    0,
                                    0};
    if (start(&table, &common, argc, argv, &code, error)) {
        desc.dispatch = make_dispatch(&common);
        desc.json = common.json;
        desc.quiet = common.quiet;
        code = aob_papers(&desc, error);
    }
    common_finish(&common);
    return code;
}

static enum aob_exit command_doctor(int argc, char **argv, struct aob_error *error)
{
    struct common common = {0};
    enum aob_exit code;
    const struct aob_flag flags[] = {COMMON_FLAGS(common)};
    const struct aob_flags table = {
        "doctor", "", "Drivers, helpers and meshes: what is there, and how to install the rest.",
        flags,    0,  0};
    if (start(&table, &common, argc, argv, &code, error)) {
        struct aob_dispatch dispatch = make_dispatch(&common);
        code = aob_doctor(&dispatch, common.json, common.quiet, error);
    }
    common_finish(&common);
    return code;
}

static const struct command commands[] = {
    {"list", "what there is: techniques, scenes, backends", command_list},
    {"plan", "the cases that a config comes to", command_plan},
    {"run", "a sweep: times, errors, images, report", command_run},
    {"shot", "one frame, timed and scored", command_shot},
    {"report", "page and pictures from finished runs", command_report},
    {"papers", "the texts' figures beside those measured here", command_papers},
    {"doctor", "drivers and meshes: what is missing, and its cure", command_doctor},
};

static int print_help(void)
{
    printf("aobudget %s: what ambient occlusion costs, and how close it comes to ray-traced truth\n"
           "usage: aobudget COMMAND [--help]\n",
           AOBUDGET_VERSION);
    for (size_t i = 0; i < AOB_COUNT(commands); i++)
        printf("  %-8s %s\n", commands[i].name, commands[i].help);
    printf("exit codes: 0 done; 1 the answer is bad; 2 usage or input; 3 done in part\n");
    return AOB_EXIT_OK;
}

/* Jobs and journals are JSON, which has no other text. */
static bool all_utf8(int argc, char **argv, struct aob_error *error)
{
    for (int i = 1; i < argc; i++) {
        json_t *text = json_string(argv[i]);
        if (!text)
            return aob_fail(error, "argument %d is not UTF-8 text; rename the file", i);
        json_decref(text);
    }
    return true;
}

int main(int argc, char **argv)
{
    struct aob_error error = {{0}};
    enum aob_exit code = AOB_EXIT_USAGE;
    bool known = false;
    signal(SIGPIPE, SIG_IGN);
    if (!all_utf8(argc, argv, &error)) {
        aob_error_print(&error);
        return AOB_EXIT_USAGE;
    }
    if (argc < 2 || strcmp(argv[1], "--help") == 0)
        return print_help();
    if (strcmp(argv[1], "--version") == 0)
        return printf("aobudget %s\n", AOBUDGET_VERSION) < 0;
    if (strcmp(argv[1], "worker") == 0)
        return aob_worker_main();
    for (size_t i = 0; i < AOB_COUNT(commands) && !known; i++)
        if (strcmp(commands[i].name, argv[1]) == 0) {
            known = true;
            code = commands[i].run(argc - 2, argv + 2, &error);
        }
    if (!known)
        aob_fail(&error, "unknown command '%s'; see: aobudget --help", argv[1]);
    if (*error.text)
        aob_error_print(&error);
    return code;
}
