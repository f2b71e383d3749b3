#include "html.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "page/texts.h"
#include "places.h"

static const char *const statuses[] = {"ok", "unsupported", "invalid", "failed"};

static size_t count_status(const struct aob_rows *rows, const char *status)
{
    size_t count = 0;
    for (size_t i = 0; i < rows->count; i++)
        count += strcmp(rows->list[i].status, status) == 0;
    return count;
}

static void add_fact(struct aob_text *page, const char *name, const char *text)
{
    if (!*text)
        return;
    aob_text_add(page, "<dt>%s</dt><dd>", name);
    aob_html_escape(page, text);
    aob_text_add(page, "</dd>");
}

static json_t *device_key(const struct aob_row *row)
{
    json_t *print = json_object_get(row->json, "fingerprint");
    return json_pack("[s, O?, O?, O?, O?]", row->backend, json_object_get(print, "device"),
                     json_object_get(print, "driver"), json_object_get(print, "threads"),
                     json_object_get(print, "cpu"));
}

/* Why a case on that device is judged by wall time; empty: none is. */
static const char *clock_reason(const struct aob_rows *rows, const json_t *device)
{
    const char *reason = "";
    for (size_t i = 0; i < rows->count && !*reason; i++) {
        json_t *key = device_key(&rows->list[i]);
        if (json_equal(key, device))
            reason = aob_member_text(json_object_get(rows->list[i].json, "time"), "clock_reason");
        json_decref(key);
    }
    return reason;
}

static void add_device(struct aob_text *page, const struct aob_row *row, const char *reason)
{
    const json_t *print = json_object_get(row->json, "fingerprint");
    const json_t *threads = json_object_get(print, "threads");
    char *shown = aob_member_show(threads);
    aob_text_add(page, "<dt>");
    aob_html_escape(page, row->backend);
    aob_text_add(page, "</dt><dd>");
    aob_html_escape(page, aob_member_text(print, "device"));
    aob_text_add(page, " \u00b7 ");
    aob_html_escape(page, aob_member_text(print, "driver"));
    if (threads) {
        aob_text_add(page, " \u00b7 threads: ");
        aob_html_escape(page, shown);
    }
    if (*reason) {
        aob_text_add(page, " \u00b7 costs are wall time: ");
        aob_html_escape(page, reason);
    }
    aob_text_add(page, "</dd>");
    free(shown);
}

/* Rows that ran on the same backend, device and driver are one line. */
static void add_devices(struct aob_text *page, const struct aob_rows *rows)
{
    json_t *places = json_object();
    for (size_t i = 0; i < rows->count; i++) {
        const struct aob_row *row = &rows->list[i];
        if (!*aob_member_text(json_object_get(row->json, "fingerprint"), "device"))
            continue;
        size_t known = json_object_size(places);
        json_t *key = device_key(row);
        if (aob_place(places, json_incref(key)) == known)
            add_device(page, row, clock_reason(rows, key));
        json_decref(key);
    }
    json_decref(places);
}

static const char *first_processor(const struct aob_rows *rows)
{
    const char *name = "";
    for (size_t i = 0; i < rows->count && !*name; i++)
        name = aob_member_text(json_object_get(rows->list[i].json, "fingerprint"), "cpu");
    return name;
}

static void add_counts(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(page, "<p>");
    for (size_t i = 0; i < AOB_COUNT(statuses); i++) {
        size_t count = count_status(rows, statuses[i]);
        if (count || i == 0)
            aob_text_add(page, "<span class=\"chip %s\">%zu %s</span> ", statuses[i], count, statuses[i]);
    }
    aob_text_add(page, "</p>\n");
}

static void add_incomplete(struct aob_text *page, const struct aob_run *run)
{
    aob_text_add(page, "<p class=banner role=status><strong>Incomplete: %zu of %zu cases</strong> of ",
                 run->asked - run->missing, run->asked);
    aob_html_escape(page, run->name);
    aob_text_add(page, ". The same <code>aobudget run</code> command goes on where it stopped.</p>\n");
}

/* What a shard or a filter left out. */
static void add_part(struct aob_text *page, const struct aob_run *run)
{
    aob_text_add(page, "<p class=banner role=status><strong>A part: %zu of %zu cases</strong> of ",
                 run->asked, run->planned);
    aob_html_escape(page, run->name);
    aob_text_add(page, ". The run was asked for no more.</p>\n");
}

static void add_banners(struct aob_text *page, const struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->run_count; i++) {
        const struct aob_run *run = &rows->runs[i];
        if (*run->damage.text) {
            aob_text_add(page, "<p class=banner role=status>");
            aob_html_escape(page, run->damage.text);
            aob_text_add(page, "</p>\n");
        }
        if (run->missing)
            add_incomplete(page, run);
        else if (run->asked < run->planned)
            add_part(page, run);
    }
}

static void add_header(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(page, "<header><h1>");
    for (size_t i = 0; i < rows->run_count; i++) {
        aob_text_add(page, "%s", i ? " \u00b7 " : "");
        aob_html_escape(page, rows->runs[i].name);
    }
    aob_text_add(page, "</h1>\n<p class=soft>Ambient occlusion: what accuracy costs in time</p>\n");
    add_banners(page, rows);
    add_counts(page, rows);
    aob_text_add(page, "<dl class=facts>");
    for (size_t i = 0; i < rows->run_count; i++) {
        add_fact(page, "date", aob_member_text(rows->runs[i].info, "date"));
        add_fact(page, "program", aob_member_text(rows->runs[i].info, "program"));
    }
    add_fact(page, "processor", first_processor(rows));
    add_devices(page, rows);
    aob_text_add(page, "</dl>\n");
}

/* Cases that did not run for one reason. */
struct trouble {
    const struct aob_row *row; /* the first of them */
    size_t count;
};

static void add_trouble(struct aob_text *page, const struct trouble *trouble)
{
    const struct aob_row *row = trouble->row;
    aob_text_add(page, "<li><strong>");
    aob_html_escape(page, row->technique);
    aob_text_add(page, "</strong> on ");
    aob_html_escape(page, row->backend);
    aob_text_add(page, ": ");
    aob_html_escape(page, *row->status ? row->status : "unknown");
    if (*row->reason) {
        aob_text_add(page, ", ");
        aob_html_escape(page, row->reason);
    }
    aob_text_add(page, " <small>(%zu case%s)</small></li>\n", trouble->count, trouble->count == 1 ? "" : "s");
}

static void add_troubles(struct aob_text *page, const struct aob_rows *rows)
{
    struct trouble *troubles = NULL;
    size_t count = 0, capacity = 0;
    json_t *places = json_object();
    for (size_t i = 0; i < rows->count; i++) {
        const struct aob_row *row = &rows->list[i];
        if (aob_row_is_ok(row))
            continue;
        size_t place = aob_place(
            places, json_pack("[s, s, s, s]", row->status, row->technique, row->backend, row->reason));
        if (place == count)
            AOB_PUSH(troubles, count, capacity)->row = row;
        troubles[place].count++;
    }
    if (count)
        aob_text_add(page, "<h3>What did not run</h3><ul class=troubles>\n");
    for (size_t i = 0; i < count; i++)
        add_trouble(page, &troubles[i]);
    aob_text_add(page, count ? "</ul>\n" : "");
    json_decref(places);
    free(troubles);
}

static void add_navigation(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(page, "<nav>");
    for (size_t i = 0; i < rows->run_count; i++)
        if (json_object_get(rows->runs[i].info, "budget")) {
            aob_text_add(page, "<a href=\"#budget\">budget</a>\n");
            break;
        }
    for (size_t i = 0; i < rows->section_count; i++) {
        aob_text_add(page, "<a href=\"#s%zu\">", i);
        aob_html_escape(page, rows->sections[i].scene);
        aob_text_add(page, " \u00b7 ");
        aob_html_escape(page, rows->sections[i].view);
        aob_text_add(page, "</a>\n");
    }
    aob_text_add(page, "<a href=\"#cases\">all cases</a></nav></header>\n");
}

void aob_html_head(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(page, "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
                       "content=\"width=device-width,initial-scale=1\">\n<title>");
    aob_html_escape(page, rows->runs[0].name);
    aob_text_add(page, " \u2013 aobudget</title>\n<style>\n%s</style></head>\n<body>\n", aob_text_page_style);
    add_header(page, rows);
    aob_html_agreement(page, rows);
    add_troubles(page, rows);
    add_navigation(page, rows);
}
