#include "techniques_cases.h"
#include <stdlib.h>
#include "base/memory.h"
#include "markdown.h"
#include "technique/usual.h"

const struct aob_row *aob_techniques_row(const struct aob_techniques *t, size_t technique, size_t section)
{
    return t->chosen[technique * t->rows.section_count + section];
}

const json_t *aob_techniques_oracle(const struct aob_row *row)
{
    const struct aob_score *own = row ? aob_row_own_score(row) : NULL;
    const json_t *oracle = own ? json_object_get(own->json, "oracle") : NULL;
    return json_is_object(oracle) ? oracle : NULL;
}

bool aob_techniques_is_oracle(const struct aob_techniques *t, size_t section)
{
    for (size_t i = 0; i < t->count; i++)
        if (aob_techniques_oracle(aob_techniques_row(t, i, section)))
            return true;
    return false;
}

void aob_techniques_add_place(struct aob_text *page, const struct aob_techniques *t, size_t section)
{
    struct aob_text place = {0};
    aob_text_add(&place, "%s/%s", t->rows.sections[section].scene, t->rows.sections[section].view);
    aob_md_code(page, place.data);
    aob_text_finish(&place);
}

void aob_techniques_add_head(struct aob_text *page, const char *const *names)
{
    size_t count = 0;
    aob_text_add(page, "|");
    for (; names[count]; count++)
        aob_text_add(page, " %s |", names[count]);
    aob_text_add(page, "\n|");
    for (size_t i = 0; i < count; i++)
        aob_text_add(page, "---|");
    aob_text_add(page, "\n");
}

/* A parameter that the record lacks is none at its default. */
static bool is_default(const json_t *defaults, const struct aob_row *row)
{
    const json_t *values = json_object_get(row->json, "params");
    double metre = aob_member_number(row->json, "metre");
    const char *name;
    json_t *initial;
    json_object_foreach((json_t *)defaults, name, initial)
    {
        if (!aob_usual_is(initial, json_object_get(values, name), metre))
            return false;
    }
    return true;
}

/* The place of the row's technique in the list; `count`: it is not there. */
static size_t place_of(const struct aob_techniques *t, const struct aob_row *row)
{
    size_t k = 0;
    while (k < t->count && !aob_row_is_of(row, json_array_get(t->list, k)))
        k++;
    return k;
}

void aob_techniques_choose(struct aob_techniques *t)
{
    json_t **defaults = AOB_NEW_ARRAY(json_t *, t->count);
    t->chosen = AOB_NEW_ARRAY(const struct aob_row *, t->count * t->rows.section_count);
    for (size_t k = 0; k < t->count; k++)
        defaults[k] = aob_usual_params(json_array_get(t->list, k));
    for (size_t i = 0; i < t->rows.count; i++) {
        const struct aob_row *row = &t->rows.list[i];
        size_t k = place_of(t, row);
        if (k == t->count || !is_default(defaults[k], row))
            continue;
        const struct aob_row **place = &t->chosen[k * t->rows.section_count + row->section];
        if (!*place || (!aob_row_is_ok(*place) && aob_row_is_ok(row)))
            *place = row;
    }
    for (size_t k = 0; k < t->count; k++)
        json_decref(defaults[k]);
    free(defaults);
}
