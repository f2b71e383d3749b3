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

/* Where a plan was measured in parts, by shards or filters, all runs of it are one here: a case counts once, and is good if it is
 * so in each of them that has it. Sets of names: the plan's config and program, and the key. */
struct parts {
    json_t *planned, *cases, *bad;
};

static bool same_plan(const struct aob_run *a, const struct aob_run *b)
{
    return strcmp(aob_member_text(a->info, "config_hash"), aob_member_text(b->info, "config_hash")) == 0 &&
           strcmp(aob_member_text(a->info, "build"), aob_member_text(b->info, "build")) == 0;
}

static bool is_of_parts(const struct aob_rows *rows, const struct aob_run *run)
{
    bool parts = false;
    for (size_t i = 0; i < rows->run_count; i++)
        parts = parts || (json_object_get(rows->runs[i].info, "asked") && same_plan(&rows->runs[i], run));
    return parts && json_object_get(run->info, "keys");
}

static void add_case(json_t *cases, const struct aob_run *run, const char *key)
{
    struct aob_text name = {0};
    aob_text_add(&name, "%s %s %s", aob_member_text(run->info, "config_hash"),
                 aob_member_text(run->info, "build"), key);
    json_object_set_new(cases, name.data, json_true());
    aob_text_finish(&name);
}

static void count_run(struct aob_page_summary *summary, const struct aob_rows *rows, size_t index,
                      struct parts *parts)
{
    const struct aob_run *run = &rows->runs[index];
    bool of_parts = is_of_parts(rows, run);
    const json_t *key;
    size_t i;
    for (size_t at = 0; at < rows->count; at++) {
        const struct aob_row *row = &rows->list[at];
        if (row->run != index)
            continue;
        summary->cases += !of_parts;
        summary->ok += !of_parts && aob_row_is_ok(row);
        if (of_parts)
            add_case(parts->cases, run, row->key);
        if (of_parts && !aob_row_is_ok(row))
            add_case(parts->bad, run, row->key);
    }
    summary->planned += of_parts ? 0 : run->planned;
    json_array_foreach(of_parts ? json_object_get(run->info, "keys") : NULL, i, key)
    {
        add_case(parts->planned, run, json_string_value(key) ? json_string_value(key) : "");
    }
}

static void summarise(struct aob_page_summary *summary, const struct aob_gallery *gallery)
{
    const struct aob_rows *rows = gallery->rows;
    struct parts parts = {json_object(), json_object(), json_object()};
    *summary = (struct aob_page_summary){.figures = gallery->count};
    for (size_t i = 0; i < rows->run_count; i++)
        count_run(summary, rows, i, &parts);
    summary->planned += json_object_size(parts.planned);
    summary->cases += json_object_size(parts.cases);
    summary->ok += json_object_size(parts.cases) - json_object_size(parts.bad);
    for (size_t i = 0; i < gallery->count; i++)
        summary->drawn += !gallery->figures[i].failure;
    aob_fail(&summary->damage, "%s", aob_rows_damage(rows));
    json_decref(parts.planned);
    json_decref(parts.cases);
    json_decref(parts.bad);
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
