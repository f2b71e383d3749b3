#include <math.h>
#include <string.h>
#include "base/json.h"
#include "check.h"
#include "section.h"

static const char *text_of(const json_t *object, const char *name)
{
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : "";
}

static double number_of(const json_t *object, const char *name)
{
    return aob_json_to_number(json_object_get(object, name));
}

static void print_device(const json_t *item, struct aob_text *out)
{
    bool chosen = strcmp(text_of(item, "status"), AOB_CHECK_PASSED) == 0;
    const char *lacks = text_of(item, "reason");
    aob_text_add_line(out, "  %c %d %s: %s%s; %s; %s%s%s", chosen ? '*' : ' ', (int)number_of(item, "number"),
                      text_of(item, "item"), text_of(item, "class"),
                      json_is_true(json_object_get(item, "software")) ? ", software" : "",
                      text_of(item, "driver"),
                      json_is_true(json_object_get(item, "timer")) ? "timer" : "no timer",
                      *lacks ? "; it lacks " : "", lacks);
}

static void print_timer(const json_t *item, struct aob_text *out)
{
    const json_t *checks = json_object_get(item, "checks");
    aob_text_add_line(out, "  %s", text_of(item, "item"));
    for (size_t i = 0; i < json_array_size(checks); i++) {
        const json_t *check = json_array_get(checks, i);
        aob_text_add_line(out, "    %-50s %8.4f of %.3g .. %.3g%s", text_of(check, "what"),
                          number_of(check, "measured"), number_of(check, "low"), number_of(check, "high"),
                          json_is_true(json_object_get(check, "good")) ? "" : "  WRONG");
    }
}

static void print_status(const json_t *item, struct aob_text *out)
{
    aob_text_add_line(out, "  %-9s  %s", text_of(item, "status"), text_of(item, "item"));
}

static void print_image(const json_t *item, struct aob_text *out)
{
    if (!json_object_get(item, "pixels")) {
        print_status(item, out);
        return;
    }
    aob_text_add_line(out, "  %9.4f %% %+9.6f %9.6f %9.6f  %-9s  %s", 100 * number_of(item, "visible_share"),
                      number_of(item, "bias"), number_of(item, "rms"), number_of(item, "max"),
                      text_of(item, "status"), text_of(item, "item"));
}

/* " [1.23, 1.25]", or nothing where too few rounds gave no interval. */
static void add_interval(struct aob_text *text, const json_t *item, const char *low, const char *high)
{
    if (isfinite(number_of(item, low)))
        aob_text_add(text, " [%.4g, %.4g]", number_of(item, low), number_of(item, high));
}

static void print_pass(const json_t *pass, struct aob_text *out)
{
    struct aob_text line = {0};
    if (isnan(number_of(pass, "ms")))
        return; /* the clock sees whole frames only */
    aob_text_add(&line, "    %-26s %10.4f ms", text_of(pass, "name"), number_of(pass, "ms"));
    add_interval(&line, pass, "ms_low", "ms_high");
    aob_text_add_line(out, "%s", line.data);
    aob_text_finish(&line);
}

static void print_time(const json_t *item, struct aob_text *out)
{
    const json_t *passes = json_object_get(item, "passes");
    struct aob_text line = {0};
    aob_text_add(&line, "  %-28s %10.4f ms", text_of(item, "item"), number_of(item, "ms"));
    add_interval(&line, item, "ms_low", "ms_high");
    aob_text_add(&line, ", %.3f x fixed pass", number_of(item, "ratio_to_ref"));
    add_interval(&line, item, "ci_low", "ci_high");
    aob_text_add(&line, ", A/A %.3f", number_of(item, "control"));
    add_interval(&line, item, "control_low", "control_high");
    aob_text_add_line(out, "%s, %d rounds by the clock '%s'", line.data, (int)number_of(item, "rounds"),
                      text_of(item, "clock"));
    aob_text_finish(&line);
    for (size_t p = 0; json_array_size(passes) > 1 && p < json_array_size(passes); p++)
        print_pass(json_array_get(passes, p), out);
}

static void print_time_item(const json_t *item, struct aob_text *out)
{
    if (json_object_get(item, "ms"))
        print_time(item, out);
    else if (json_is_number(json_object_get(item, "spread")))
        aob_text_add_line(out, "  the fixed pass beside itself: within %.2f %%",
                          100 * number_of(item, "spread"));
    else if (!json_object_get(item, "spread"))
        print_status(item, out);
}

static const struct {
    const char *section, *head;
    void (*print)(const json_t *item, struct aob_text *out);
} tables[] = {
    {"device", "", print_device},
    {"timer", "", print_timer},
    {"images", ": pixels off by more than 1/255, mean, root mean square and largest difference", print_image},
    {"validation", ": messages of the Vulkan layer", print_status},
    {"times", ": medians of a frame, with 95 % intervals", print_time_item},
};

static void print_section(const json_t *section, struct aob_text *out)
{
    const json_t *items = json_object_get(section, "items");
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++) {
        if (strcmp(tables[t].section, text_of(section, "section")) != 0)
            continue;
        aob_text_add_line(out, "%s on %s (%s, %.1f s)%s", tables[t].section, text_of(section, "backend"),
                          text_of(section, "status"), number_of(section, "seconds"), tables[t].head);
        for (size_t i = 0; i < json_array_size(items); i++)
            tables[t].print(json_array_get(items, i), out);
    }
    if (*text_of(section, "reason"))
        aob_text_add_line(out, "  %s", text_of(section, "reason"));
}

void aob_check_print(const json_t *document, struct aob_text *out)
{
    const json_t *machine = json_object_get(document, "machine"),
                 *sections = json_object_get(document, "sections");
    const json_t *findings = json_object_get(document, "findings"), *cuts = json_object_get(document, "cut"),
                 *packed = json_object_get(document, "packed_loaders");
    aob_text_add_line(out, "gpu-check %s, %s, %s, %s", text_of(document, "program"),
                      text_of(document, "date"), text_of(machine, "cpu"), text_of(machine, "system"));
    for (size_t i = 0; i < json_array_size(packed); i++)
        aob_text_add_line(out, "this system has no %s, so the packed one is used",
                          json_string_value(json_array_get(packed, i)));
    for (size_t i = 0; i < json_array_size(sections); i++)
        print_section(json_array_get(sections, i), out);
    for (size_t i = 0; i < json_array_size(cuts); i++)
        aob_text_add_line(out, "CUT %s", json_string_value(json_array_get(cuts, i)));
    for (size_t i = 0; i < json_array_size(findings); i++)
        aob_text_add_line(out, "FINDING %s", json_string_value(json_array_get(findings, i)));
    aob_text_add_line(out, "verdict: %s, %zu findings, %zu sections cut, %.0f s",
                      text_of(document, "verdict"), json_array_size(findings), json_array_size(cuts),
                      number_of(document, "seconds"));
}
