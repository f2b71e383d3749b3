#include "page.h"
#include "csv.h"
#include "gallery_plan.h"
#include "html.h"
#include "base/file.h"
#include "page/texts.h"
#include <stdlib.h>
#include <string.h>

static char *page_text(const struct aob_gallery *gallery)
{
    struct aob_text page = {0};
    aob_html_head(&page, gallery->rows);
    aob_html_target_control(&page, gallery->rows);
    aob_text_add(&page, "<main>\n");
    aob_html_budget(&page, gallery->rows);
    for (size_t i = 0; i < gallery->rows->section_count; i++)
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

/* Runs of parts of one plan, by its shards or by filters, are one run here: its cases count once, and are good if they are in one of
 * them. */
struct parts {
    json_t *planned, *ok; /* names of an object: the plan's config and program, and the key */
};

static bool is_part(const struct aob_run *run)
{
    return json_object_get(run->info, "asked") && json_object_get(run->info, "keys");
}

static void add_case(json_t *cases, const struct aob_run *run, const char *key)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s %s %s", aob_member_text(run->info, "config_hash"),
                 aob_member_text(run->info, "build"), key);
    json_object_set_new(cases, name.data, json_true());
    aob_text_finish(&name);
}

static void count_planned(struct aob_page_summary *summary, const struct aob_run *run, struct parts *parts)
{
    const json_t *key;
    size_t i;
    if (!is_part(run)) {
        summary->planned += run->planned;
        return;
    }
    json_array_foreach(json_object_get(run->info, "keys"), i, key)
    {
        add_case(parts->planned, run, json_string_value(key) ? json_string_value(key) : "");
    }
}

static void summarise(struct aob_page_summary *summary, const struct aob_gallery *gallery)
{
    const struct aob_rows *rows = gallery->rows;
    struct parts parts = {json_object(), json_object()};
    *summary = (struct aob_page_summary){.cases = rows->count, .figures = gallery->count};
    for (size_t i = 0; i < rows->count; i++) {
        const struct aob_run *run = &rows->runs[rows->list[i].run];
        if (!aob_row_is_ok(&rows->list[i]))
            continue;
        if (is_part(run))
            add_case(parts.ok, run, rows->list[i].key);
        else
            summary->ok++;
    }
    for (size_t i = 0; i < rows->run_count; i++)
        count_planned(summary, &rows->runs[i], &parts);
    summary->planned += json_object_size(parts.planned);
    summary->ok += json_object_size(parts.ok);
    for (size_t i = 0; i < gallery->count; i++)
        summary->drawn += !gallery->figures[i].failure;
    aob_fail(&summary->damage, "%s", aob_rows_damage(rows));
    json_decref(parts.planned);
    json_decref(parts.ok);
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
        ok = write_page(desc, &gallery, error) && aob_csv_write(&rows, desc->out, error);
    }
    if (desc->summary)
        summarise(desc->summary, &gallery);
    free(plotter);
    aob_gallery_finish(&gallery);
    aob_rows_finish(&rows);
    return ok;
}
