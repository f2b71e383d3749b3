/* The program: its commands and the jobs of its workers, each a row of an array. */
#include <fcntl.h>
#include <jansson.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>
#include "base/output.h"
#include "base/text.h"
#include "command/command.h"
#include "stress/ask.h"
#include "tune/fit.h"
#include "worker/worker.h"

static const struct aob_command *const commands[] = {
    &aob_command_list,    &aob_command_plan,      &aob_command_run_config,
    &aob_command_shot,    &aob_command_report,    &aob_command_papers,
    &aob_command_compare, &aob_command_calibrate, &aob_command_cache,
    &aob_command_budget,  &aob_command_effects,   &aob_command_tune,
    &aob_command_stress,  &aob_command_doctor,    &aob_command_nightly,
    &aob_command_history, &aob_command_merge,     NULL,
};
static const struct aob_worker_job *const jobs[] = {
    &aob_worker_describe, &aob_worker_probe, &aob_worker_devices, &aob_worker_timer,
    &aob_worker_layout,   &aob_worker_mesh,  &aob_worker_capture, &aob_worker_light,
    &aob_worker_check,    &aob_worker_view,  &aob_worker_block,   &aob_worker_cache,
    &aob_worker_stress,   &aob_worker_fuzz,  &aob_worker_tune,    NULL,
};

static enum aob_exit write_text(struct aob_text *text, struct aob_error *error)
{
    bool ok = aob_output_write(text->data, text->size, error);
    aob_text_finish(text);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

static enum aob_exit print_version(struct aob_error *error)
{
    struct aob_text text = {0};
    aob_text_add_line(&text, "aobudget %s", AOBUDGET_VERSION);
    return write_text(&text, error);
}

static enum aob_exit print_help(struct aob_error *error)
{
    struct aob_text text = {0};
    aob_text_add_line(&text,
                      "aobudget %s: what ambient occlusion costs, and how close it comes to ray-traced truth",
                      AOBUDGET_VERSION);
    aob_text_add_line(&text, "usage: aobudget COMMAND [--help]");
    for (const struct aob_command *const *c = commands; *c; c++)
        aob_text_add_line(&text, "  %-9s %s", (*c)->name, (*c)->help);
    aob_text_add_line(&text, "exit codes: 0 done; 1 the answer is bad; 2 usage or input; 3 done in part");
    return write_text(&text, error);
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

static enum aob_exit run(int argc, char **argv, struct aob_error *error)
{
    if (argc < 2 || strcmp(argv[1], "--help") == 0)
        return print_help(error);
    if (strcmp(argv[1], "--version") == 0)
        return print_version(error);
    if (!all_utf8(argc, argv, error))
        return AOB_EXIT_USAGE;
    for (const struct aob_command *const *c = commands; *c; c++)
        if (strcmp((*c)->name, argv[1]) == 0)
            return aob_command_run(*c, argc - 2, argv + 2, error);
    aob_fail(error, "unknown command '%s'; see: aobudget --help", argv[1]);
    return AOB_EXIT_USAGE;
}

/* A file that is opened while one of the first three descriptors is closed takes its number, and gets what is meant for
 * it. What is written to these fails, as it does where there is nothing. */
static void hold_descriptors(void)
{
    int file;
    do
        file = open("/dev/null", O_RDONLY);
    while (file >= 0 && file <= STDERR_FILENO);
    if (file >= 0)
        close(file);
}

int main(int argc, char **argv)
{
    struct aob_error error = {{0}};
    hold_descriptors();
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is an error with a line, as a full disk is */
    if (argc > 1 && strcmp(argv[1], "worker") == 0)
        return aob_worker_main(jobs);
    enum aob_exit code = run(argc, argv, &error);
    if (!aob_output_close(*error.text ? NULL : &error))
        code = AOB_EXIT_USAGE;
    if (*error.text)
        aob_error_print(&error);
    return code;
}
