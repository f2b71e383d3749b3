#include "cell.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "chosen.h"

void aob_stress_row_init(struct aob_stress_row *row, const struct aob_technique_info *technique,
                         const char *backend)
{
    *row = (struct aob_stress_row){.technique = technique, .backend = backend};
}

struct aob_stress_cell *aob_stress_row_add(struct aob_stress_row *row, const struct aob_property *property)
{
    row->cells = aob_realloc(row->cells, row->cell_count + 1, sizeof *row->cells);
    struct aob_stress_cell *cell = &row->cells[row->cell_count++];
    *cell = (struct aob_stress_cell){.property = property, .worst = NAN, .bound = NAN};
    return cell;
}

void aob_stress_row_finish(struct aob_stress_row *row)
{
    for (size_t i = 0; i < row->cell_count; i++) {
        free(row->cells[i].where);
        free(row->cells[i].reason);
        free(row->cells[i].image);
    }
    free(row->cells);
    free(row->device);
    free(row->driver);
    free(row->missing);
    *row = (struct aob_stress_row){0};
}

static enum aob_outcome outcome_of(const char *word)
{
    for (int i = 0; i <= AOB_NOT_APPLICABLE; i++)
        if (strcmp(word, aob_outcome_word((enum aob_outcome)i)) == 0)
            return (enum aob_outcome)i;
    return AOB_FAILS;
}

bool aob_stress_row_take(struct aob_stress_row *row, const struct aob_stress_answer *answer)
{
    for (size_t i = 0; i < row->cell_count; i++) {
        struct aob_stress_cell *cell = &row->cells[i];
        if (cell->asked || strcmp(cell->property->name, answer->property) != 0)
            continue;
        cell->asked = true;
        cell->outcome = outcome_of(answer->outcome);
        cell->worst = answer->worst;
        cell->bound = answer->bound;
        cell->declared = answer->declared;
        cell->compared = answer->compared;
        cell->where = aob_strdup(answer->where ? answer->where : "");
        cell->reason = aob_strdup(answer->reason ? answer->reason : "");
        cell->image = aob_strdup(answer->image);
        return true;
    }
    return false;
}

struct aob_stress_counts aob_stress_count(const struct aob_stress_row *rows, size_t count)
{
    struct aob_stress_counts counts = {{0}};
    for (size_t r = 0; r < count; r++)
        for (size_t i = 0; i < rows[r].cell_count; i++)
            counts.by[rows[r].cells[i].outcome]++;
    return counts;
}

void aob_stress_command(const struct aob_stress_row *row, const struct aob_stress_cell *cell,
                        struct aob_text *text)
{
    aob_chosen_command(row->technique, row->backend, row->choice, text);
    aob_text_add(text, " --property %s", cell->property->name);
}

static json_t *property_to_json(const struct aob_property *p)
{
    const struct aob_bound *bound = aob_bound_find(p->name);
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:b, s:o, s:o, s:s}", "name", p->name, "group",
                     aob_property_group_name(p->group), "sentence", p->sentence, "measure", p->measure,
                     "source", p->source, "quick", p->quick, "bound_software",
                     aob_json_number(bound ? bound->software : NAN), "bound_gpu",
                     aob_json_number(bound ? bound->gpu : NAN), "bound_reason", bound ? bound->reason : "");
}

static bool has_cell(const struct aob_stress_row *rows, size_t count, const struct aob_property *property)
{
    for (size_t r = 0; r < count; r++)
        for (size_t i = 0; i < rows[r].cell_count; i++)
            if (rows[r].cells[i].property == property)
                return true;
    return false;
}

/* Those that somebody was asked. */
static json_t *properties_to_json(const struct aob_stress_row *rows, size_t count)
{
    json_t *properties = json_array();
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++)
            if (has_cell(rows, count, p))
                json_array_append_new(properties, property_to_json(p));
    return properties;
}

static json_t *cell_to_json(const struct aob_stress_row *row, const struct aob_stress_cell *cell)
{
    struct aob_text command = {0};
    aob_stress_command(row, cell, &command);
    json_t *object =
        json_pack("{s:s, s:s, s:o, s:o, s:b, s:o, s:o, s:s?, s:b, s:s}", "property", cell->property->name,
                  "outcome", aob_outcome_word(cell->outcome), "worst", aob_json_number(cell->worst), "bound",
                  aob_json_number(cell->bound), "declared", cell->declared, "where",
                  aob_json_text(cell->where ? cell->where : ""), "reason",
                  aob_json_text(cell->reason ? cell->reason : ""), "image", cell->image, "compared",
                  cell->compared, "command", command.data);
    aob_text_finish(&command);
    return object;
}

static json_t *row_to_json(const struct aob_stress_row *row)
{
    json_t *cells = json_array();
    for (size_t i = 0; i < row->cell_count; i++)
        json_array_append_new(cells, cell_to_json(row, &row->cells[i]));
    const struct aob_technique_info *t = row->technique;
    return json_pack("{s:s?, s:s?, s:s?, s:s?, s:s?, s:s?, s:s?, s:o}", "technique", t ? t->name : NULL,
                     "module", t ? t->module : NULL, "digest", t ? t->digest : NULL, "backend", row->backend,
                     "device", row->device, "driver", row->driver, "missing", row->missing, "cells", cells);
}

json_t *aob_stress_to_json(const struct aob_stress_row *rows, size_t count, bool quick)
{
    struct aob_stress_counts counts = aob_stress_count(rows, count);
    json_t *list = json_array(), *sums = json_object();
    for (size_t r = 0; r < count; r++)
        json_array_append_new(list, row_to_json(&rows[r]));
    for (int i = 0; i <= AOB_NOT_APPLICABLE; i++)
        json_object_set_new(sums, aob_outcome_word((enum aob_outcome)i),
                            json_integer((json_int_t)counts.by[i]));
    return json_pack("{s:b, s:o, s:o, s:o}", "quick", quick, "counts", sums, "properties",
                     properties_to_json(rows, count), "rows", list);
}
