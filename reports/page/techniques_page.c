#include "techniques_page.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "gallery_plan.h"
#include "markdown.h"
#include "techniques_text.h"

static const char *name_of(const struct aob_techniques *t, size_t technique)
{
    return aob_member_text(json_array_get(t->list, technique), "name");
}

/* The figures are those of the chosen rows, where there is something to see. */
static void plan(struct aob_techniques *t, const char *pictures)
{
    size_t sections = t->rows.section_count, used = 0;
    aob_techniques_choose(t);
    const struct aob_row **drawn = AOB_NEW_ARRAY(const struct aob_row *, t->count *sections);
    for (size_t k = 0; k < t->count; k++)
        for (size_t s = 0; s < sections; s++) {
            const struct aob_row *row = aob_techniques_row(t, k, s);
            if (row && aob_row_is_ok(row) && *row->image && !aob_techniques_is_oracle(t, s))
                drawn[used++] = row;
        }
    aob_gallery_plan_triptychs(&t->gallery, &t->rows, drawn, used, pictures);
    free(drawn);
}

/* Any technique's: they share name and claim. */
static const json_t *section_oracle(const struct aob_techniques *t, size_t section)
{
    const json_t *oracle = NULL;
    for (size_t i = 0; i < t->count && !oracle; i++)
        oracle = aob_techniques_oracle(aob_techniques_row(t, i, section));
    return oracle;
}

/* Where there is something to find; else everywhere. */
static double oracle_error(const json_t *oracle, const char *band, const char *all)
{
    double error = aob_member_number(oracle, band);
    return isfinite(error) ? error : aob_member_number(oracle, all);
}

static void add_reference_row(struct aob_text *page, const struct aob_techniques *t)
{
    aob_text_add(page, "| *ray-traced truth* |");
    for (size_t s = 0; s < t->rows.section_count; s++) {
        double worst = NAN;
        if (!aob_techniques_is_oracle(t, s))
            continue;
        for (size_t k = 0; k < t->count; k++)
            worst = fmax(worst, oracle_error(aob_techniques_oracle(aob_techniques_row(t, k, s)),
                                             "reference_band_rmse", "reference_rmse"));
        aob_md_number(page, worst, 4);
    }
    aob_text_add(page, "\n");
}

static void add_oracle_head(struct aob_text *page, const struct aob_techniques *t)
{
    size_t count = 0;
    for (size_t s = 0; s < t->rows.section_count; s++) {
        const json_t *oracle = section_oracle(t, s);
        if (!oracle)
            continue;
        aob_text_add(page, "- **");
        aob_md_escape(page, aob_member_text(oracle, "name"));
        aob_text_add(page, "**, ");
        aob_techniques_add_place(page, t, s);
        aob_text_add(page, ": ");
        aob_md_escape(page, aob_member_text(oracle, "claim"));
        aob_text_add(page, "\n");
    }
    aob_text_add(page, "\n| |");
    for (size_t s = 0; s < t->rows.section_count; s++)
        if (section_oracle(t, s)) {
            aob_text_add(page, " ");
            aob_md_escape(page, aob_member_text(section_oracle(t, s), "name"));
            aob_text_add(page, " ");
            aob_techniques_add_place(page, t, s);
            aob_text_add(page, " |");
            count++;
        }
    aob_text_add(page, "\n|---|");
    for (size_t i = 0; i < count; i++)
        aob_text_add(page, "---|");
    aob_text_add(page, "\n");
}

static void add_oracles(struct aob_text *page, const struct aob_techniques *t)
{
    bool any = false;
    for (size_t s = 0; s < t->rows.section_count; s++)
        any = any || aob_techniques_is_oracle(t, s);
    aob_text_add(page, "## Oracles\n\n");
    if (!any) {
        aob_text_add(page, "No case of this run has a closed form.\n\n");
        return;
    }
    aob_text_add(
        page,
        "Scenes whose visibility V is known in closed form, at every point that a pixel shows: d is the "
        "distance "
        "to the other plane, h a height, a a radius, r the length of a ray. The figures are RMS errors "
        "against "
        "that form for the technique's own radius, over the pixels where V is below 0.995; where there is "
        "none "
        "(V = 1), over all. The first row says how far the ray-traced truth itself is off. Some techniques "
        "compute another thing by definition: then the figure says by how much.\n\n");
    add_oracle_head(page, t);
    add_reference_row(page, t);
    for (size_t k = 0; k < t->count; k++) {
        aob_text_add(page, "| ");
        aob_md_code(page, name_of(t, k));
        aob_text_add(page, " |");
        for (size_t s = 0; s < t->rows.section_count; s++)
            if (aob_techniques_is_oracle(t, s))
                aob_md_number(
                    page,
                    oracle_error(aob_techniques_oracle(aob_techniques_row(t, k, s)), "band_rmse", "rmse"), 4);
        aob_text_add(page, "\n");
    }
    aob_text_add(page, "\n");
}

static const struct aob_row *first_good(const struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->count; i++)
        if (aob_row_is_ok(&rows->list[i]))
            return &rows->list[i];
    return NULL;
}

static void add_machine(struct aob_text *page, const struct aob_row *row)
{
    const json_t *print = json_object_get(row->json, "fingerprint");
    char *threads = aob_member_show(json_object_get(print, "threads"));
    char *guard = aob_member_show(json_object_get(json_object_get(row->json, "options"), "guard_band"));
    aob_text_add(page, "Measured on ");
    aob_md_escape(page, aob_member_text(print, "cpu"));
    if (isfinite(aob_member_number(print, "cores")))
        aob_text_add(page, " (%.0f cores)", aob_member_number(print, "cores"));
    aob_text_add(page, ", ");
    aob_md_code(page, row->backend);
    aob_text_add(page, ": ");
    aob_md_escape(page, aob_member_text(print, "device"));
    aob_text_add(page, ", ");
    aob_md_escape(page, aob_member_text(print, "driver"));
    aob_text_add(page, ", threads: ");
    aob_md_escape(page, threads);
    aob_text_add(page, "; %d x %d pixels, guard band ", row->width, row->height);
    aob_md_escape(page, guard);
    aob_text_add(page, ". Times are of that machine.\n\n");
    free(threads);
    free(guard);
}

static void add_opening(struct aob_text *page, const struct aob_techniques *t)
{
    const struct aob_run *run = &t->rows.runs[0];
    const struct aob_row *row = first_good(&t->rows);
    aob_text_add(page, "# Techniques\n\nWritten by `aobudget report --techniques` from the run ");
    aob_md_code(page, run->name);
    aob_text_add(page, " (");
    aob_md_escape(page, aob_member_text(run->info, "date"));
    aob_text_add(page, ", aobudget ");
    aob_md_escape(page, aob_member_text(run->info, "program"));
    aob_text_add(page, "): what is changed by hand is lost.\n\n");
    if (run->missing)
        aob_text_add(page, "**Incomplete: %zu of %zu cases.**\n\n", run->asked - run->missing, run->asked);
    else if (run->asked < run->planned)
        aob_text_add(page, "**A part: %zu of %zu cases.**\n\n", run->asked, run->planned);
    if (row)
        add_machine(page, row);
    aob_text_add(page,
                 "Every parameter has its default. Visibility is 1 where open, 0 where closed; error "
                 "is the technique's "
                 "visibility minus the ray-traced one, in-band error that of the pixels whose truth is "
                 "below 0.995, and `definition` the RMS error of what the technique computes by definition, "
                 "which no number of its samples removes. Cost is a multiple of the fixed pass (24 depth "
                 "reads a pixel) with its 95 %% interval. "
                 "Pictures show the technique, "
                 "the truth and the error (blue: too dark, red: too bright); the colours of one scene "
                 "mean the same for all "
                 "techniques.\n\n");
    for (size_t k = 0; k < t->count; k++) {
        const json_t *technique = json_array_get(t->list, k);
        aob_text_add(page, "- ");
        aob_md_code(page, name_of(t, k));
        aob_text_add(page, ": ");
        aob_md_escape(page, aob_member_text(technique, "title"));
        aob_text_add(page, "\n");
    }
    aob_text_add(page, "\n");
}

static bool write_page(const struct aob_techniques *t, const char *file, struct aob_error *error)
{
    struct aob_text page = {0};
    add_opening(&page, t);
    add_oracles(&page, t);
    for (size_t k = 0; k < t->count; k++)
        aob_techniques_add_technique(&page, t, k);
    while (page.size > 1 && page.data[page.size - 2] == '\n')
        page.data[--page.size] = '\0';
    bool ok = aob_file_write(file, page.data, page.size, error);
    aob_text_finish(&page);
    return ok;
}

static void summarise(const struct aob_techniques *t, struct aob_techniques_summary *summary)
{
    *summary = (struct aob_techniques_summary){.techniques = t->count,
                                               .planned = t->rows.runs[0].planned,
                                               .cases = t->rows.count,
                                               .figures = t->gallery.count};
    for (size_t i = 0; i < t->rows.count; i++)
        summary->ok += aob_row_is_ok(&t->rows.list[i]);
    for (size_t i = 0; i < t->gallery.count; i++)
        summary->drawn += !t->gallery.figures[i].failure;
    aob_fail(&summary->damage, "%s", aob_rows_damage(&t->rows));
}

/* "docs/techniques.md" is docs and techniques. */
static bool split(const char *file, char **folder, char **name, struct aob_error *error)
{
    const char *slash = strrchr(file, '/'), *base = slash ? slash + 1 : file;
    size_t length = strlen(base);
    if (length < 4 || strcmp(base + length - 3, ".md") != 0)
        return aob_fail(error, "%s: the page is Markdown: give a name that ends in .md", file);
    struct aob_text text = {0}, stem = {0};
    aob_text_add(&text, "%.*s", slash > file ? (int)(slash - file) : 1, slash ? file : ".");
    aob_text_add(&stem, "%.*s", (int)(length - 3), base);
    *folder = text.data;
    *name = stem.data;
    return true;
}

static bool read_run(struct aob_techniques *t, const char *folder, struct aob_error *error)
{
    if (!aob_rows_read(&t->rows, &folder, 1, error))
        return false;
    t->list = json_object_get(t->rows.runs[0].info, "techniques");
    t->count = json_array_size(t->list);
    return t->count || aob_fail(error, "%s/run.json: describes no techniques: run its config again", folder);
}

bool aob_techniques_page_write(const struct aob_techniques_desc *desc, struct aob_techniques_summary *summary,
                               struct aob_error *error)
{
    struct aob_techniques t = {0};
    char *folder = NULL, *name = NULL, *plotter = aob_gallery_plotter(desc->program);
    bool ok = split(desc->file, &folder, &name, error) && read_run(&t, desc->folder, error) &&
              aob_folder_create(folder, error);
    if (ok) {
        plan(&t, name);
        aob_gallery_draw(&t.gallery, plotter, folder);
        ok = write_page(&t, desc->file, error);
        summarise(&t, summary);
    }
    aob_gallery_finish(&t.gallery);
    aob_rows_finish(&t.rows);
    free(t.chosen);
    free(folder);
    free(name);
    free(plotter);
    return ok;
}
