#include <math.h>
#include <string.h>
#include "base/member.h"
#include "check.h"
#include "section.h"

static void print_device(const json_t *item, struct aob_text *out)
{
    const char *status = aob_member_text(item, "status");
    bool chosen = strcmp(status, AOB_CHECK_SKIPPED) != 0;
    const char *lacks =
        chosen ? "" : aob_member_text(item, "reason"); /* why it failed is the section's reason */
    aob_text_add_line(
        out, "  %c %d %s: %s%s; %s; %s%s%s", chosen ? '*' : ' ', (int)aob_member_number(item, "number"),
        aob_member_text(item, "item"), aob_member_text(item, "class"),
        json_is_true(json_object_get(item, "software")) ? ", software" : "", aob_member_text(item, "driver"),
        json_is_true(json_object_get(item, "timer")) ? "timer" : "no timer", *lacks ? "; it lacks " : "",
        lacks);
}

static void print_timer(const json_t *item, struct aob_text *out)
{
    const json_t *checks = json_object_get(item, "checks");
    aob_text_add_line(out, "  %s", aob_member_text(item, "item"));
    for (size_t i = 0; i < json_array_size(checks); i++) {
        const json_t *check = json_array_get(checks, i);
        aob_text_add_line(out, "    %-50s %8.4f of %.3g .. %.3g%s", aob_member_text(check, "what"),
                          aob_member_number(check, "measured"), aob_member_number(check, "low"),
                          aob_member_number(check, "high"),
                          json_is_true(json_object_get(check, "good")) ? "" : "  WRONG");
    }
}

static void print_status(const json_t *item, struct aob_text *out)
{
    aob_text_add_line(out, "  %-9s  %s", aob_member_text(item, "status"), aob_member_text(item, "item"));
}

static void print_image(const json_t *item, struct aob_text *out)
{
    if (!json_object_get(item, "pixels")) {
        print_status(item, out);
        return;
    }
    aob_text_add_line(out, "  %9.4f %% %+9.6f %9.6f %9.6f  %-9s  %s",
                      100 * aob_member_number(item, "visible_share"), aob_member_number(item, "bias"),
                      aob_member_number(item, "rms"), aob_member_number(item, "max"),
                      aob_member_text(item, "status"), aob_member_text(item, "item"));
}

/* " [1.23, 1.25]", or nothing where too few rounds gave no interval. */
static void add_interval(struct aob_text *text, const json_t *item, const char *low, const char *high)
{
    if (isfinite(aob_member_number(item, low)))
        aob_text_add(text, " [%.4g, %.4g]", aob_member_number(item, low), aob_member_number(item, high));
}

static void print_pass(const json_t *pass, struct aob_text *out)
{
    struct aob_text line = {0};
    if (isnan(aob_member_number(pass, "ms")))
        return; /* the clock sees whole frames only */
    aob_text_add(&line, "    %-26s %10.4f ms", aob_member_text(pass, "name"), aob_member_number(pass, "ms"));
    add_interval(&line, pass, "ms_low", "ms_high");
    aob_text_add_line(out, "%s", line.data);
    aob_text_finish(&line);
}

static void print_time(const json_t *item, struct aob_text *out)
{
    const json_t *passes = json_object_get(item, "passes");
    struct aob_text line = {0};
    aob_text_add(&line, "  %-28s %10.4f ms", aob_member_text(item, "item"), aob_member_number(item, "ms"));
    add_interval(&line, item, "ms_low", "ms_high");
    aob_text_add(&line, ", %.3f x fixed pass", aob_member_number(item, "ratio_to_ref"));
    add_interval(&line, item, "ci_low", "ci_high");
    aob_text_add(&line, ", A/A %.3f", aob_member_number(item, "control"));
    add_interval(&line, item, "control_low", "control_high");
    aob_text_add_line(out, "%s, %d rounds by the clock '%s'", line.data,
                      (int)aob_member_number(item, "rounds"), aob_member_text(item, "clock"));
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
                          100 * aob_member_number(item, "spread"));
    else if (!json_object_get(item, "spread"))
        print_status(item, out);
}

static const struct {
    const char *section, *head;
    void (*print)(const json_t *item, struct aob_text *out);
} tables[] = {
    {"device", "", print_device},
    {"timer", "", print_timer},
    {"images", ": pixels off by more than a step of 8 bits, mean, root mean square and largest difference",
     print_image},
    {"validation", ": messages of the Vulkan layer", print_status},
    {"times", ": medians of a frame, with 95 % intervals", print_time_item},
};

static void print_section(const json_t *section, struct aob_text *out)
{
    const json_t *items = json_object_get(section, "items");
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++) {
        if (strcmp(tables[t].section, aob_member_text(section, "section")) != 0)
            continue;
        aob_text_add_line(out, "%s on %s (%s, %.1f s)%s", tables[t].section,
                          aob_member_text(section, "backend"), aob_member_text(section, "status"),
                          aob_member_number(section, "seconds"), tables[t].head);
        for (size_t i = 0; i < json_array_size(items); i++)
            tables[t].print(json_array_get(items, i), out);
    }
    if (*aob_member_text(section, "reason"))
        aob_text_add_line(out, "  %s", aob_member_text(section, "reason"));
}

void aob_check_print(const json_t *document, struct aob_text *out)
{
    const json_t *machine = json_object_get(document, "machine"),
                 *sections = json_object_get(document, "sections");
    const json_t *findings = json_object_get(document, "findings"), *cuts = json_object_get(document, "cut"),
                 *packed = json_object_get(document, "packed_loaders");
    aob_text_add_line(out, "gpu-check %s, %s, %s, %s", aob_member_text(document, "program"),
                      aob_member_text(document, "date"), aob_member_text(machine, "cpu"),
                      aob_member_text(machine, "system"));
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
                      aob_member_text(document, "verdict"), json_array_size(findings), json_array_size(cuts),
                      aob_member_number(document, "seconds"));
}
