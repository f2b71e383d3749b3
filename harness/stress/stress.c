#include "stress.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "chosen.h"
#include "crew.h"
#include "reports/page/stress_page.h"

struct stress {
    const struct aob_stress_desc *desc;
    struct aob_technique_list techniques;
    struct aob_stress_row *rows;
    size_t count;
    char *images;
};

void aob_stress_list(struct aob_text *out)
{
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++) {
            const struct aob_bound *bound = aob_bound_find(p->name);
            aob_text_add_line(out, "%s (%s%s): %s", p->name, aob_property_group_name(p->group),
                              p->quick ? ", quick" : "", p->sentence);
            aob_text_add_line(out, "    %s, at most %g (GPU: %g). %s", p->measure,
                              bound ? bound->software : 0, bound ? bound->gpu : 0,
                              bound ? bound->reason : "");
            aob_text_add_line(out, "    %s", p->source);
        }
}

static bool is_wanted(const struct aob_stress_desc *desc, const struct aob_property *property, bool subject)
{
    bool named = !desc->property_count;
    for (size_t i = 0; i < desc->property_count; i++)
        named = named || strcmp(desc->properties[i], property->name) == 0;
    return named && (property->group != AOB_GROUP_INSTRUMENTS) == subject &&
           (!desc->quick || property->quick || desc->property_count);
}

/* A row without a property that is wanted is none. */
static void add_row(struct stress *stress, const struct aob_technique_info *technique, const char *backend)
{
    stress->rows = aob_realloc(stress->rows, stress->count + 1, sizeof *stress->rows);
    struct aob_stress_row *row = &stress->rows[stress->count];
    aob_stress_row_init(row, technique, backend);
    row->choice = stress->desc->dispatch.device;
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++)
            if (is_wanted(stress->desc, p, technique))
                aob_stress_row_add(row, p);
    if (row->cell_count)
        stress->count++;
    else
        aob_stress_row_finish(row);
}

static bool choose_rows(struct stress *stress, struct aob_error *error)
{
    const struct aob_stress_desc *desc = stress->desc;
    for (size_t i = 0; i < desc->property_count; i++)
        if (!aob_property_find(desc->properties[i]))
            return aob_fail(error, "--property: there is no '%s'; see: aobudget stress --list",
                            desc->properties[i]);
    const struct aob_chosen chosen = {&stress->techniques, &desc->dispatch.modules, desc->technique,
                                      desc->backend};
    if (!aob_chosen_check(&chosen, error))
        return false;
    for (size_t t = 0; t < stress->techniques.count; t++)
        for (const struct aob_gpu_fns *const *b = aob_gpu_backends; *b; b++)
            if (aob_chosen_backend(&chosen, (*b)->name) &&
                aob_chosen_technique(&chosen, &stress->techniques.items[t]))
                add_row(stress, &stress->techniques.items[t], (*b)->name);
    if (!desc->technique && !desc->backend && !desc->dispatch.modules.count)
        add_row(stress, NULL, NULL);
    else if (desc->property_count && !stress->count)
        add_row(stress, NULL, NULL);
    return stress->count || aob_fail(error, "nothing is to be asked: no property fits these flags");
}

static bool prepare(struct stress *stress, struct aob_error *error)
{
    const struct aob_stress_desc *desc = stress->desc;
    if (!aob_json_check(desc->json, error) ||
        !aob_dispatch_describe(&desc->dispatch, &desc->dispatch.modules, &stress->techniques, error) ||
        !choose_rows(stress, error))
        return false;
    if (!desc->out)
        return true;
    stress->images = aob_path_join(desc->out, "images");
    return aob_folder_create(desc->out, error) && aob_folder_create(stress->images, error);
}

static bool write_documents(const struct stress *stress, struct aob_error *error)
{
    const struct aob_stress_desc *desc = stress->desc;
    json_t *document = aob_stress_to_json(stress->rows, stress->count, desc->quick);
    char *path = desc->out ? aob_path_join(desc->out, "stress.json") : NULL;
    const struct aob_stress_page_desc page = {document, desc->out, desc->dispatch.program};
    bool ok = (!path || (aob_json_write(document, path, error) && aob_stress_page_write(&page, error))) &&
              (!desc->json || aob_json_write(document, desc->json, error));
    free(path);
    json_decref(document);
    return ok;
}

static enum aob_exit judge(const struct stress *stress)
{
    struct aob_stress_counts counts = aob_stress_count(stress->rows, stress->count);
    if (counts.by[AOB_FAILS])
        return AOB_EXIT_BAD;
    for (size_t r = 0; r < stress->count; r++)
        if (stress->rows[r].missing)
            return AOB_EXIT_PART;
    return AOB_EXIT_OK;
}

static size_t cells_of(const struct stress *stress)
{
    size_t cells = 0;
    for (size_t r = 0; r < stress->count; r++)
        cells += stress->rows[r].cell_count;
    return cells;
}

enum aob_exit aob_stress(const struct aob_stress_desc *desc, struct aob_text *table, struct aob_error *error)
{
    struct stress stress = {.desc = desc};
    struct aob_progress progress;
    enum aob_exit code = AOB_EXIT_USAGE;
    if (prepare(&stress, error)) {
        aob_progress_init(&progress, cells_of(&stress), desc->quiet);
        aob_crew_run(&(struct aob_crew_desc){.dispatch = &desc->dispatch,
                                             .rows = stress.rows,
                                             .count = stress.count,
                                             .quick = desc->quick,
                                             .images = stress.images,
                                             .progress = &progress});
        aob_progress_finish(&progress);
        aob_stress_print(stress.rows, stress.count, table);
        if (write_documents(&stress, error))
            code = judge(&stress);
    }
    for (size_t r = 0; r < stress.count; r++)
        aob_stress_row_finish(&stress.rows[r]);
    free(stress.rows);
    free(stress.images);
    aob_technique_list_finish(&stress.techniques);
    return code;
}
