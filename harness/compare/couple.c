#include "couple.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/table.h"

void aob_row_describe(const struct aob_row *row, struct aob_text *text)
{
    aob_text_add(text, "%s/%s %s%s%s %s %dx%d", row->scene, row->view, row->name,
                 row->label && *row->label ? " " : "", row->label ? row->label : "", row->backend, row->width,
                 row->height);
}

/* A number is the same whether or not it is written with a fraction. Of a value that is no object or array itself. */
static json_t *as_real(const json_t *value)
{
    return json_is_number(value) ? json_real(json_number_value(value)) : json_deep_copy(value);
}

/* Values of an object, and those of its arrays (a camera's eye). */
static json_t *with_reals(const json_t *object)
{
    json_t *copy = json_object(), *value, *element;
    const char *name;
    size_t at;
    json_object_foreach((json_t *)(uintptr_t)object, name, value)
    {
        json_t *array = json_is_array(value) ? json_array() : NULL;
        json_array_foreach(value, at, element)
        {
            json_array_append_new(array, as_real(element));
        }
        json_object_set_new(copy, name, array ? array : as_real(value));
    }
    return copy;
}

static void add_member(struct aob_text *text, const json_t *record, const char *name)
{
    json_t *values = with_reals(json_object_get(record, name));
    char *member = json_dumps(values, JSON_SORT_KEYS | JSON_COMPACT);
    aob_text_add(text, "\n%s", member ? member : "");
    free(member);
    json_decref(values);
}

/* What the case is, without the build of its technique and without what it was compared with. free() it. */
static char *identity(const struct aob_row *row)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s\n%s\n%s\n%s %dx%d", row->scene, row->view, row->name, row->backend, row->width,
                 row->height);
    add_member(&text, row->json, "camera");
    add_member(&text, row->json, "params");
    add_member(&text, row->json, "options");
    return text.data;
}

/* Places of a side's rows by one of their texts. */
struct places {
    struct aob_table table; /* text -> place of the first row that has it */
    size_t *others;         /* of each place: rows that have the same text and came later */
};

static char *text_of(const struct aob_row *row, bool by_key)
{
    return by_key ? aob_strdup(row->key) : identity(row);
}

static void list_places(struct places *places, const struct aob_side *side, const bool *taken, bool by_key)
{
    *places = (struct places){.others = AOB_NEW_ARRAY(size_t, side->count + 1)};
    for (size_t i = 0; i < side->count; i++) {
        char *text = taken[i] ? NULL : text_of(side->rows[i], by_key);
        size_t first = text ? aob_table_put(&places->table, text, i) : i;
        if (first != i)
            places->others[first]++;
        free(text);
    }
}

static void finish_places(struct places *places)
{
    aob_table_finish(&places->table);
    free(places->others);
}

/* What is not taken yet and has the same text once on each side. `partner`: of each row of A its place in B. */
static void match(const struct aob_side *a, const struct aob_side *b, bool by_key, bool *taken[2],
                  size_t *partner)
{
    struct places of_a, of_b;
    list_places(&of_a, a, taken[0], by_key);
    list_places(&of_b, b, taken[1], by_key);
    for (size_t i = 0; i < a->count; i++) {
        char *text = taken[0][i] ? NULL : text_of(a->rows[i], by_key);
        size_t first, other;
        if (text && aob_table_find(&of_a.table, text, &first) && !of_a.others[first] &&
            aob_table_find(&of_b.table, text, &other) && !of_b.others[other]) {
            taken[0][i] = taken[1][other] = true;
            partner[i] = other;
        }
        free(text);
    }
    finish_places(&of_a);
    finish_places(&of_b);
}

static void list_alone(struct aob_couples *couples, int at, const struct aob_side *side, const bool *taken)
{
    for (size_t i = 0; i < side->count; i++)
        if (!taken[i])
            *AOB_PUSH(couples->alone[at], couples->alone_count[at], couples->alone_capacity[at]) =
                side->rows[i];
}

void aob_couples_find(struct aob_couples *couples, const struct aob_side *a, const struct aob_side *b)
{
    bool *taken[2] = {AOB_NEW_ARRAY(bool, a->count + 1), AOB_NEW_ARRAY(bool, b->count + 1)};
    bool *by_key = AOB_NEW_ARRAY(bool, a->count + 1);
    size_t *partner = AOB_NEW_ARRAY(size_t, a->count + 1);
    match(a, b, true, taken, partner);
    memcpy(by_key, taken[0], a->count * sizeof *by_key);
    match(a, b, false, taken, partner);
    for (size_t i = 0; i < a->count; i++)
        if (taken[0][i])
            *AOB_PUSH(couples->items, couples->count, couples->capacity) =
                (struct aob_couple){a->rows[i], b->rows[partner[i]], by_key[i]};
    list_alone(couples, 0, a, taken[0]);
    list_alone(couples, 1, b, taken[1]);
    free(taken[0]);
    free(taken[1]);
    free(by_key);
    free(partner);
}

void aob_couples_finish(struct aob_couples *couples)
{
    free(couples->items);
    free(couples->alone[0]);
    free(couples->alone[1]);
    *couples = (struct aob_couples){0};
}
