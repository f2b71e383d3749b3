#include "page.h"
#include "gallery.h"
#include "html.h"
#include "base/file.h"
#include "base/memory.h"
#include "page/texts.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

static bool same_fact(const struct aob_row *a, const struct aob_row *b, const char *name)
{
    const json_t *x = json_object_get(json_object_get(a->json, "fingerprint"), name);
    const json_t *y = json_object_get(json_object_get(b->json, "fingerprint"), name);
    return x == y || json_equal(x, y);
}

/* Rows that ran on the same backend, device and driver are one line. */
static bool is_new_device(const struct aob_rows *rows, size_t index)
{
    for (size_t i = 0; i < index; i++)
        if (strcmp(rows->list[i].backend, rows->list[index].backend) == 0 &&
            same_fact(&rows->list[i], &rows->list[index], "device") &&
            same_fact(&rows->list[i], &rows->list[index], "driver") &&
            same_fact(&rows->list[i], &rows->list[index], "threads") &&
            same_fact(&rows->list[i], &rows->list[index], "cpu"))
            return false;
    return *aob_member_text(json_object_get(rows->list[index].json, "fingerprint"), "device") != '\0';
}

static void add_device(struct aob_text *page, const struct aob_row *row)
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
    aob_text_add(page, "</dd>");
    free(shown);
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

static void add_banners(struct aob_text *page, const struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->run_count; i++) {
        const struct aob_run *run = &rows->runs[i];
        if (run->planned <= run->cases)
            continue;
        aob_text_add(page, "<p class=banner role=status><strong>Incomplete: %zu of %zu cases</strong> of ",
                     run->cases, run->planned);
        aob_html_escape(page, run->name);
        aob_text_add(page, ". The same <code>aobudget run</code> command goes on where it stopped.</p>\n");
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
    for (size_t i = 0; i < rows->count; i++)
        if (is_new_device(rows, i))
            add_device(page, &rows->list[i]);
    aob_text_add(page, "</dl>\n");
}

static bool same_trouble(const struct aob_row *a, const struct aob_row *b)
{
    return strcmp(a->status, b->status) == 0 && strcmp(a->technique, b->technique) == 0 &&
           strcmp(a->backend, b->backend) == 0 && strcmp(a->reason, b->reason) == 0;
}

static void add_trouble(struct aob_text *page, const struct aob_rows *rows, size_t index)
{
    const struct aob_row *row = &rows->list[index];
    size_t count = 0;
    for (size_t i = 0; i < rows->count; i++) {
        count += same_trouble(&rows->list[i], row);
        if (i < index && count)
            return;
    }
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
    aob_text_add(page, " <small>(%zu case%s)</small></li>\n", count, count == 1 ? "" : "s");
}

static void add_troubles(struct aob_text *page, const struct aob_rows *rows)
{
    if (count_status(rows, "ok") == rows->count)
        return;
    aob_text_add(page, "<h3>What did not run</h3><ul class=troubles>\n");
    for (size_t i = 0; i < rows->count; i++)
        if (!aob_row_is_ok(&rows->list[i]))
            add_trouble(page, rows, i);
    aob_text_add(page, "</ul>\n");
}

static void add_head(struct aob_text *page, const struct aob_rows *rows)
{
    aob_text_add(page, "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
                       "content=\"width=device-width,initial-scale=1\">\n<title>");
    aob_html_escape(page, rows->runs[0].name);
    aob_text_add(page, " \u2013 aobudget</title>\n<style>\n%s</style></head>\n<body>\n", aob_text_page_style);
}

static void add_navigation(struct aob_text *page, const struct aob_gallery *gallery)
{
    aob_text_add(page, "<nav>");
    for (size_t i = 0; i < gallery->section_count; i++) {
        aob_text_add(page, "<a href=\"#s%zu\">", i);
        aob_html_escape(page, gallery->sections[i].scene);
        aob_text_add(page, " \u00b7 ");
        aob_html_escape(page, gallery->sections[i].view);
        aob_text_add(page, "</a>\n");
    }
    aob_text_add(page, "<a href=\"#cases\">all cases</a></nav></header>\n");
}

static char *page_text(const struct aob_gallery *gallery)
{
    struct aob_text page = {0};
    add_head(&page, gallery->rows);
    add_header(&page, gallery->rows);
    add_troubles(&page, gallery->rows);
    add_navigation(&page, gallery);
    aob_text_add(&page, "<main>\n");
    for (size_t i = 0; i < gallery->section_count; i++)
        aob_html_section(&page, gallery, i);
    aob_html_table(&page, gallery->rows);
    aob_text_add(
        &page,
        "</main>\n<footer>Error is technique minus reference, in units of visibility (0 closed, 1 open); "
        "blue is too dark, red too bright. The reference is ray-traced and carries a standard error of its "
        "own. Lengths are in scene units.</footer>\n<script>\n%s</script>\n</body></html>\n",
        aob_text_page_script);
    return page.data;
}

static void summarise(struct aob_page_summary *summary, const struct aob_gallery *gallery)
{
    const struct aob_rows *rows = gallery->rows;
    *summary = (struct aob_page_summary){
        .cases = rows->count, .ok = count_status(rows, "ok"), .figures = gallery->count};
    for (size_t i = 0; i < rows->run_count; i++)
        summary->planned += rows->runs[i].planned;
    for (size_t i = 0; i < gallery->count; i++)
        summary->drawn += !gallery->figures[i].failure;
}

static bool write_page(const struct aob_page_desc *desc, const struct aob_gallery *gallery,
                       struct aob_error *error)
{
    char *text = page_text(gallery), *path = aob_path_join(desc->out, "index.html");
    bool ok = aob_file_write(path, text, strlen(text), error);
    free(path);
    free(text);
    return ok;
}

bool aob_page_write(const struct aob_page_desc *desc, struct aob_error *error)
{
    struct aob_rows rows;
    struct aob_gallery gallery;
    size_t folders = 0;
    while (desc->folders[folders])
        folders++;
    if (!aob_rows_read(&rows, desc->folders, folders, error))
        return false;
    aob_gallery_plan(&gallery, &rows);
    char *plotter = aob_gallery_plotter(desc->program);
    bool ok = aob_folder_create(desc->out, error);
    if (ok) {
        aob_gallery_draw(&gallery, plotter, desc->out);
        ok = write_page(desc, &gallery, error);
    }
    if (desc->summary)
        summarise(desc->summary, &gallery);
    free(plotter);
    aob_gallery_finish(&gallery);
    aob_rows_finish(&rows);
    return ok;
}
