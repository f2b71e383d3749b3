/* gpu-check: what a machine's GPU makes of this project, in one file of results (docs/gpu.md). */
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/flags.h"
#include "base/json.h"
#include "base/output.h"
#include "check.h"
#include "check_data.h"

struct options {
    const char *out, *data, *backend, *device, *section, *seconds, *precision;
    bool help;
    struct aob_words words;
};
static const struct aob_flag flags[] = {
    {"out", "FILE", "where the results go (gpu-check.json)", AOB_FLAG_TEXT, offsetof(struct options, out)},
    {"data", "DIR", "what it was packed with (data/ beside this program)", AOB_FLAG_TEXT,
     offsetof(struct options, data)},
    {"backend", "NAME", "vulkan or gl-egl alone", AOB_FLAG_TEXT, offsetof(struct options, backend)},
    {"device", "NAME|N", "a device by a part of its name or its number; needs --backend", AOB_FLAG_TEXT,
     offsetof(struct options, device)},
    {"section", "NAME", "device, timer, images, validation or times alone, with what it needs", AOB_FLAG_TEXT,
     offsetof(struct options, section)},
    {"seconds", "S", "for everything together, 10 to 3600 (270)", AOB_FLAG_TEXT,
     offsetof(struct options, seconds)},
    {"precision", "P%", "of a technique's time, which ends there: 0.1% to 50% (1%)", AOB_FLAG_TEXT,
     offsetof(struct options, precision)},
    {"help", NULL, "this text", AOB_FLAG_SWITCH, offsetof(struct options, help)},
    {NULL},
};

static enum aob_exit print_help(struct aob_error *error)
{
    struct aob_text out = {0};
    aob_text_add_line(&out,
                      "usage: gpu-check [--out FILE] [--backend NAME [--device NAME|N]] [--section NAME] "
                      "[--seconds S] [--precision P%%]");
    aob_text_add_line(&out,
                      "Checks the drivers of this machine against images of software drivers, and times the "
                      "techniques by the device's clock.");
    aob_flags_help(flags, &out);
    aob_text_add_line(
        &out, "exit codes: 0 all passed; 1 something disagrees or failed; 2 nothing could be checked; 3 all "
              "passed, but some was cut for lack of time");
    bool ok = aob_output_write(out.data, out.size, error);
    aob_text_finish(&out);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

struct limits {
    double seconds, precision;
};

static bool read_limits(const struct options *options, struct limits *limits, struct aob_error *error)
{
    if (options->seconds && (!aob_parse_double(options->seconds, &limits->seconds) ||
                             !(limits->seconds >= 10 && limits->seconds <= 3600)))
        return aob_fail(error, "gpu-check: --seconds %s is outside 10 .. 3600", options->seconds);
    if (options->precision && (!aob_parse_percent(options->precision, &limits->precision) ||
                               !(limits->precision >= 0.001 && limits->precision <= 0.5)))
        return aob_fail(error, "gpu-check: --precision %s is no percentage within 0.1%% .. 50%%",
                        options->precision);
    return true;
}

static bool read_options(int argc, char **argv, struct options *options, struct limits *limits,
                         struct aob_error *error)
{
    const struct aob_flags_desc desc = {"gpu-check", flags, argc - 1, argv + 1};
    if (!aob_flags_parse(&desc, options, &options->words, error))
        return false;
    if (options->words.count)
        return aob_fail(error, "gpu-check: '%s' is not expected; --help names the flags",
                        options->words.items[0]);
    if (options->backend && strcmp(options->backend, "vulkan") != 0 &&
        strcmp(options->backend, "gl-egl") != 0)
        return aob_fail(error, "gpu-check: --backend '%s' is not one of vulkan, gl-egl", options->backend);
    if (options->device && !options->backend)
        return aob_fail(error, "gpu-check: --device needs --backend, as each has devices of its own");
    if (options->section && !aob_check_has(options->section))
        return aob_fail(error,
                        "gpu-check: --section '%s' is not one of device, timer, images, validation, times",
                        options->section);
    return read_limits(options, limits, error);
}

/* One line where nothing could be checked: the first backend's reason. */
static void explain(const json_t *document, struct aob_error *error)
{
    const json_t *section = json_array_get(json_object_get(document, "sections"), 0);
    aob_fail(error, "nothing could be checked: %s", json_string_value(json_object_get(section, "reason")));
}

static enum aob_exit write_results(const struct options *options, json_t *document, struct aob_error *error)
{
    struct aob_text out = {0};
    enum aob_exit code = aob_check_code(document);
    const char *file = options->out ? options->out : "gpu-check.json";
    aob_check_print(document, &out);
    if (!aob_json_write(document, file, error) || !aob_output_write(out.data, out.size, error))
        code = AOB_EXIT_USAGE;
    else if (code == AOB_EXIT_USAGE)
        explain(document, error);
    aob_text_finish(&out);
    return code;
}

static enum aob_exit run_check(const struct options *options, const struct aob_check_desc *desc,
                               json_t *made_on, struct aob_error *error)
{
    json_t *document = aob_check_run(desc, error);
    if (!document)
        return AOB_EXIT_USAGE;
    json_object_set(document, "made_on", made_on);
    enum aob_exit code = write_results(options, document, error);
    json_decref(document);
    return code;
}

static enum aob_exit check(const struct options *options, const struct limits *limits,
                           struct aob_error *error)
{
    char *folder = aob_path_program_folder();
    char *data = options->data ? aob_path_absolute(options->data) : aob_path_join(folder, "data");
    struct aob_check_data read;
    enum aob_exit code = AOB_EXIT_USAGE;
    if (aob_json_check(options->out ? options->out : "gpu-check.json", error) &&
        aob_check_data_load(&read, data, error)) {
        code = run_check(options,
                         &(struct aob_check_desc){.program = folder,
                                                  .data = data,
                                                  .backend = options->backend,
                                                  .device = options->device,
                                                  .section = options->section,
                                                  .seconds = limits->seconds,
                                                  .precision = limits->precision},
                         json_object_get(read.document, "made_on"), error);
        aob_check_data_finish(&read);
    }
    free(data);
    free(folder);
    return code;
}

int main(int argc, char **argv)
{
    struct aob_error error = {{0}};
    struct options options = {0};
    struct limits limits = {.seconds = 270, .precision = AOB_CHECK_PRECISION};
    enum aob_exit code = AOB_EXIT_USAGE;
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    if (read_options(argc, argv, &options, &limits, &error))
        code = options.help ? print_help(&error) : check(&options, &limits, &error);
    aob_words_finish(&options.words);
    if (!aob_output_close(*error.text ? NULL : &error))
        code = AOB_EXIT_USAGE;
    if (*error.text)
        aob_error_print(&error);
    return code;
}
