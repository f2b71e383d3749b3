#include "check.h"
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include "base/child.h"
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "loader.h"
#include "section.h"
#include "timing/measure_lock.h"

/* The weights share the time that is left, so what one section leaves over is the next ones'. */
struct step {
    const char *section, *backend;
    double weight;
};
static const struct step steps[] = {
    {"device", "vulkan", 3},      {"device", "gl-egl", 3},  {"timer", "vulkan", 4},
    {"timer", "gl-egl", 4},       {"images", "vulkan", 14}, {"images", "gl-egl", 14},
    {"validation", "vulkan", 14}, {"times", "vulkan", 28},  {"times", "gl-egl", 16},
};

struct check {
    const struct aob_check_desc *desc;
    char *worker, *loaders; /* path of gpu-check-device; a variable of its environment, or NULL */
    json_t *sections;
    int64_t end_ns;
    struct aob_measure_lock lock;
};

static double seconds_until(int64_t ns)
{
    return (double)(ns - aob_clock_wall_ns()) * 1e-9;
}

static json_t *find_section(const struct check *check, const char *section, const char *backend)
{
    for (size_t i = 0; i < json_array_size(check->sections); i++) {
        json_t *s = json_array_get(check->sections, i);
        if (strcmp(json_string_value(json_object_get(s, "section")), section) == 0 &&
            strcmp(json_string_value(json_object_get(s, "backend")), backend) == 0)
            return s;
    }
    return NULL;
}

static const char *status_of(const json_t *object)
{
    const char *status = json_string_value(json_object_get(object, "status"));
    return status ? status : AOB_CHECK_SKIPPED;
}

bool aob_check_has(const char *section)
{
    for (size_t i = 0; i < AOB_COUNT(steps); i++)
        if (strcmp(steps[i].section, section) == 0)
            return true;
    return false;
}

/* What was asked for, and what that needs. */
static bool is_wanted(const struct check *check, const struct step *step)
{
    const char *section = check->desc->section, *backend = check->desc->backend;
    if (backend && strcmp(backend, step->backend) != 0)
        return false;
    if (!section || strcmp(step->section, section) == 0 || strcmp(step->section, "device") == 0)
        return true;
    return strcmp(section, "times") == 0 && strcmp(step->section, "timer") == 0;
}

/* A backend that does not open has nothing else to check. */
static bool is_open(const struct check *check, const char *backend)
{
    return strcmp(status_of(find_section(check, "device", backend)), AOB_CHECK_PASSED) == 0;
}

static bool is_due(const struct check *check, const struct step *step)
{
    return is_wanted(check, step) && (strcmp(step->section, "device") == 0 || is_open(check, step->backend));
}

static double share_of(const struct check *check, size_t at)
{
    double left = 0;
    for (size_t i = at; i < AOB_COUNT(steps); i++)
        if (is_wanted(check, &steps[i]))
            left += steps[i].weight;
    return steps[at].weight / left;
}

static int rank(const char *status)
{
    static const char *const order[] = {AOB_CHECK_SKIPPED, AOB_CHECK_PASSED, AOB_CHECK_CUT,
                                        AOB_CHECK_DISAGREES, AOB_CHECK_FAILED};
    for (size_t i = 0; i < AOB_COUNT(order); i++)
        if (strcmp(order[i], status) == 0)
            return (int)i;
    return 0;
}

/* The first item of the worst status gives the reason. */
static void add_item(json_t *section, json_t *item)
{
    json_array_append_new(json_object_get(section, "items"), item);
    if (json_array_size(json_object_get(section, "items")) > 1 &&
        rank(status_of(item)) <= rank(status_of(section)))
        return;
    json_object_set(section, "status", json_object_get(item, "status"));
    json_t *reason = json_object_get(item, "reason");
    json_object_set_new(section, "reason", reason ? json_incref(reason) : json_string(""));
}

static void take_line(void *user, const char *line)
{
    json_t *item = json_loads(line, JSON_REJECT_DUPLICATES, NULL);
    if (item && json_string_value(json_object_get(item, "status")))
        add_item(user, item);
    else
        json_decref(item);
}

static void fail_section(json_t *section, const char *reason)
{
    json_object_set_new(section, "status", json_string(AOB_CHECK_FAILED));
    json_object_set_new(section, "reason", json_string(reason));
}

/* Whether the system's loader of programs did not start it. What it says has no other sign. */
static bool lacks_library(const struct aob_child_result *end)
{
    static const char *const signs[] = {"error while loading shared libraries", "' not found (required by "};
    for (size_t i = 0; i < AOB_COUNT(signs); i++)
        if (end->exit_code > 0 && strstr(end->complaint, signs[i]))
            return true;
    return false;
}

/* A section without a device or a library was not begun, which is no fault of a driver. */
static void skip_section(json_t *section, const char *reason)
{
    json_object_set_new(section, "status", json_string(AOB_CHECK_SKIPPED));
    json_object_set_new(section, "reason", json_string(reason));
}

/* What ended the worker; true if nothing but its own will. */
static bool judge_end(const struct aob_child_desc *child, const struct aob_child_result *end, double seconds,
                      json_t *section)
{
    static const char ours[] = "aobudget: error: ";
    const char *said = strstr(end->complaint, ours);
    bool opening = strcmp(json_string_value(json_object_get(section, "section")), "device") == 0;
    char text[700];
    if (end->exit_code == AOB_EXIT_OK)
        return true;
    if (end->exit_code == AOB_EXIT_USAGE && said) {
        (opening ? skip_section : fail_section)(section, said + strlen(ours));
        return false;
    }
    if (opening && lacks_library(end)) {
        skip_section(section, end->complaint);
        return false;
    }
    if (end->signal == SIGALRM)
        snprintf(text, sizeof text, "stopped after %.0f s: one step of it took longer than what was left",
                 seconds);
    else
        aob_child_explain(child, end, text, sizeof text);
    fail_section(section, text);
    return false;
}

/* What the layer says when a device is closed has no call that could fail: it is a warning of the worker. */
static void judge_closing(const struct aob_child_result *end, json_t *section)
{
    static const char closing[] = "validation, on closing: ";
    const char *said = strstr(end->complaint, closing);
    if (said)
        add_item(section, json_pack("{s:s, s:s, s:o}", "item", "closing the device", "status",
                                    AOB_CHECK_DISAGREES, "reason", aob_json_text(said + strlen(closing))));
}

/* The worker begins nothing after four fifths of its time, and stops itself at its end: a hanging driver must not take the
 * others' time. One that cannot even do that is stopped a little later. */
static void run_worker(const struct check *check, const struct step *step, double seconds, json_t *section)
{
    json_t *timer = find_section(check, "timer", step->backend);
    json_t *job = json_pack("{s:s, s:s, s:s?, s:s, s:f, s:f, s:f, s:b}", "section", step->section, "backend",
                            step->backend, "device", check->desc->device, "data", check->desc->data,
                            "seconds", 0.8 * seconds, "most", seconds, "precision", check->desc->precision,
                            "trusted", timer && strcmp(status_of(timer), AOB_CHECK_PASSED) == 0);
    char *input = aob_json_line(job, 17);
    struct aob_error error = {{0}};
    struct aob_child_result end = {0};
    const struct aob_child_desc child = {.argv = (const char *const[]){check->worker, NULL},
                                         .env = (const char *const[]){check->loaders, NULL},
                                         .input = input,
                                         .input_size = strlen(input),
                                         .timeout_s = seconds + 1,
                                         .on_line = take_line,
                                         .user = section};
    if (!aob_child_run(&child, &end, &error))
        fail_section(section, error.text);
    else if (judge_end(&child, &end, seconds, section))
        judge_closing(&end, section);
    free(input);
    json_decref(job);
}

static bool measures(const struct step *step)
{
    return strcmp(step->section, "timer") == 0 || strcmp(step->section, "times") == 0;
}

/* Another program that measures is waited for, which takes nothing of the check's own time. */
static bool lock_machine(struct check *check, const struct step *step, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    bool ok = !measures(step) || aob_measure_lock_take(&check->lock, error);
    check->end_ns += aob_clock_wall_ns() - start;
    return ok;
}

/* Of a lock that could be had when the check began. It is no fault of a driver. */
static void cut_section(json_t *section, const char *reason)
{
    add_item(section, json_pack("{s:s, s:s, s:o}", "item", "the lock of measuring", "status", AOB_CHECK_CUT,
                                "reason", aob_json_text(reason)));
}

static void run_step(struct check *check, size_t at)
{
    const struct step *step = &steps[at];
    struct aob_error error = {{0}};
    bool locked = lock_machine(check, step, &error);
    int64_t start = aob_clock_wall_ns();
    double seconds = fmax(share_of(check, at) * seconds_until(check->end_ns), 1);
    json_t *section = json_pack("{s:s, s:s, s:s, s:s, s:[]}", "section", step->section, "backend",
                                step->backend, "status", AOB_CHECK_SKIPPED, "reason", "", "items");
    if (locked)
        run_worker(check, step, seconds, section);
    else
        cut_section(section, error.text);
    aob_measure_lock_release(&check->lock);
    json_object_set_new(section, "seconds", json_real(-seconds_until(start)));
    json_array_append_new(check->sections, section);
}

static bool is_finding(const char *status)
{
    return strcmp(status, AOB_CHECK_DISAGREES) == 0 || strcmp(status, AOB_CHECK_FAILED) == 0;
}

static json_t *findings_of(const struct check *check)
{
    json_t *findings = json_array();
    for (size_t i = 0; i < json_array_size(check->sections); i++) {
        const json_t *s = json_array_get(check->sections, i), *items = json_object_get(s, "items");
        const char *section = json_string_value(json_object_get(s, "section"));
        const char *backend = json_string_value(json_object_get(s, "backend"));
        size_t count = json_array_size(findings);
        for (size_t k = 0; k < json_array_size(items); k++) {
            const json_t *item = json_array_get(items, k);
            if (is_finding(status_of(item)))
                json_array_append_new(findings,
                                      json_sprintf("%s, %s: %s: %s", backend, section,
                                                   json_string_value(json_object_get(item, "item")),
                                                   json_string_value(json_object_get(item, "reason"))));
        }
        if (is_finding(status_of(s)) && json_array_size(findings) == count)
            json_array_append_new(findings, json_sprintf("%s, %s: %s", backend, section,
                                                         json_string_value(json_object_get(s, "reason"))));
    }
    return findings;
}

/* "vulkan, times: 3 of 10 items, the first is hbao: no time was left for it" of each section that was cut. */
static json_t *cuts_of(const struct check *check)
{
    json_t *cuts = json_array();
    for (size_t i = 0; i < json_array_size(check->sections); i++) {
        const json_t *s = json_array_get(check->sections, i), *items = json_object_get(s, "items"),
                     *first = NULL;
        size_t count = 0;
        for (size_t k = 0; k < json_array_size(items); k++) {
            const json_t *item = json_array_get(items, k);
            bool cut = strcmp(status_of(item), AOB_CHECK_CUT) == 0;
            first = cut && !first ? item : first;
            count += cut;
        }
        if (count)
            json_array_append_new(cuts, json_sprintf("%s, %s: %zu of %zu items, the first is %s: %s",
                                                     json_string_value(json_object_get(s, "backend")),
                                                     json_string_value(json_object_get(s, "section")), count,
                                                     json_array_size(items),
                                                     json_string_value(json_object_get(first, "item")),
                                                     json_string_value(json_object_get(first, "reason"))));
    }
    return cuts;
}

static const char *verdict_of(const struct check *check, const json_t *findings, const json_t *cuts)
{
    bool any = false;
    for (size_t i = 0; i < AOB_COUNT(steps); i++)
        any = any || (is_wanted(check, &steps[i]) && is_open(check, steps[i].backend));
    if (json_array_size(findings))
        return AOB_CHECK_DISAGREES;
    if (!any)
        return AOB_CHECK_CANNOT;
    return json_array_size(cuts) ? AOB_CHECK_CUT : AOB_CHECK_PASSED;
}

static json_t *describe_machine(void)
{
    char processor[256];
    struct utsname system = {0};
    aob_machine_processor(processor, sizeof processor);
    uname(&system);
    return json_pack("{s:o, s:i, s:o}", "cpu", aob_json_text(processor), "cores", aob_machine_cores(),
                     "system", json_sprintf("%s %s %s", system.sysname, system.release, system.machine));
}

static json_t *date_now(void)
{
    char date[32];
    time_t now = time(NULL);
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", gmtime(&now));
    return json_string(date);
}

static bool can_measure(const struct aob_check_desc *desc, struct aob_error *error)
{
    const struct check check = {.desc = desc};
    bool any = false;
    for (size_t i = 0; i < AOB_COUNT(steps); i++)
        any = any || (is_wanted(&check, &steps[i]) && measures(&steps[i]));
    return !any || aob_measure_lock_check(error);
}

json_t *aob_check_run(const struct aob_check_desc *desc, struct aob_error *error)
{
    if (!can_measure(desc, error))
        return NULL;
    int64_t start = aob_clock_wall_ns();
    json_t *packed = json_array();
    struct check check = {.desc = desc,
                          .worker = aob_path_join(desc->program, "gpu-check-device"),
                          .loaders = aob_loader_environment(desc->program, packed),
                          .sections = json_array(),
                          .end_ns = start + (int64_t)(desc->seconds * 1e9)};
    for (size_t i = 0; i < AOB_COUNT(steps); i++)
        if (is_due(&check, &steps[i]))
            run_step(&check, i);
    json_t *findings = findings_of(&check), *cuts = cuts_of(&check);
    free(check.worker);
    free(check.loaders);
    return json_pack("{s:s, s:s, s:o, s:o, s:o, s:f, s:s, s:o, s:o, s:o}", "schema", AOB_CHECK_SCHEMA,
                     "program", AOBUDGET_VERSION, "date", date_now(), "machine", describe_machine(),
                     "packed_loaders", packed, "seconds", -seconds_until(start), "verdict",
                     verdict_of(&check, findings, cuts), "findings", findings, "cut", cuts, "sections",
                     check.sections);
}

enum aob_exit aob_check_code(const json_t *document)
{
    static const struct {
        const char *verdict;
        enum aob_exit code;
    } codes[] = {
        {AOB_CHECK_PASSED, AOB_EXIT_OK}, {AOB_CHECK_DISAGREES, AOB_EXIT_BAD}, {AOB_CHECK_CUT, AOB_EXIT_PART}};
    const char *verdict = json_string_value(json_object_get(document, "verdict"));
    for (size_t i = 0; i < AOB_COUNT(codes); i++)
        if (strcmp(verdict, codes[i].verdict) == 0)
            return codes[i].code;
    return AOB_EXIT_USAGE;
}
