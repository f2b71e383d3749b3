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

static void summarise(struct aob_page_summary *summary, const struct aob_gallery *gallery)
{
    const struct aob_rows *rows = gallery->rows;
    *summary = (struct aob_page_summary){.cases = rows->count, .figures = gallery->count};
    for (size_t i = 0; i < rows->count; i++)
        summary->ok += aob_row_is_ok(&rows->list[i]);
    for (size_t i = 0; i < rows->run_count; i++)
        summary->planned += rows->runs[i].planned;
    for (size_t i = 0; i < gallery->count; i++)
        summary->drawn += !gallery->figures[i].failure;
    aob_fail(&summary->damage, "%s", aob_rows_damage(rows));
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
