#include "label.h"
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"
#include "technique/usual.h"

/* What the cases say of the values of one technique's parameters, or of the options. */
struct words {
    json_t *first;    /* the value that was met first, by name; a default as it stands in `defaults` */
    json_t *varying;  /* names of those that had another one since */
    json_t *defaults; /* values; NULL: not known */
};

static bool is_usual(const struct aob_row *row, const json_t *usual, const json_t *value)
{
    return aob_usual_is(usual, value, aob_member_number(row->json, "metre"));
}

static void meet(struct words *words, const struct aob_row *row, const json_t *values)
{
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)values, name, value)
    {
        const json_t *first = json_object_get(words->first, name);
        json_t *usual = json_object_get(words->defaults, name);
        value = usual && is_usual(row, usual, value) ? usual : value;
        if (!first)
            json_object_set(words->first, name, value);
        else if (!aob_usual_same(first, value))
            json_object_set_new(words->varying, name, json_true());
    }
}

static void add_pair(struct aob_text *text, const char *name, const json_t *value)
{
    char *shown = aob_member_show(value);
    aob_text_add(text, "%s%s=%s", text->size ? " " : "", name, shown);
    free(shown);
}

static void add_varying(struct aob_text *text, const struct words *words, const json_t *values)
{
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)values, name, value)
    {
        if (json_object_get(words->varying, name))
            add_pair(text, name, value);
    }
}

static void add_unusual(struct aob_text *text, const struct words *words, const struct aob_row *row,
                        const json_t *values)
{
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)values, name, value)
    {
        const json_t *usual = json_object_get(words->defaults, name);
        if (usual && !json_object_get(words->varying, name) && !is_usual(row, usual, value))
            add_pair(text, name, value);
    }
}

static char *text_of(struct aob_text *text)
{
    return text->data ? text->data : aob_strdup("");
}

/* What lights the case, where it matters to it. */
static void add_light(struct aob_text *text, const struct aob_row *row)
{
    const json_t *name = json_object_get(json_object_get(row->json, "light"), "name");
    if (json_is_string(name))
        add_pair(text, "light", name);
}

static char *label_of(const struct aob_row *row, const struct words *params, const struct words *options)
{
    struct aob_text text = {0};
    const json_t *p = json_object_get(row->json, "params"), *o = json_object_get(row->json, "options");
    add_varying(&text, params, p);
    add_varying(&text, options, o);
    add_unusual(&text, params, row, p);
    add_unusual(&text, options, row, o);
    add_light(&text, row);
    return text_of(&text);
}

static void add_all(struct aob_text *text, const json_t *values)
{
    const char *name;
    json_t *value;
    json_object_foreach((json_t *)values, name, value) add_pair(text, name, value);
}

static char *show(const struct aob_row *row, bool params, bool options)
{
    struct aob_text text = {0};
    if (params)
        add_all(&text, json_object_get(row->json, "params"));
    if (options) {
        add_all(&text, json_object_get(row->json, "options"));
        add_light(&text, row);
    }
    return text_of(&text);
}

char *aob_label_params(const struct aob_row *row)
{
    return show(row, true, false);
}

char *aob_label_options(const struct aob_row *row)
{
    return show(row, false, true);
}

char *aob_label_full(const struct aob_row *row)
{
    return show(row, true, true);
}

/* The first run that describes the technique has them. */
static json_t *defaults_of(const struct aob_rows *rows, const struct aob_row *row)
{
    for (size_t i = 0; i < rows->run_count; i++) {
        json_t *list = json_object_get(rows->runs[i].info, "techniques"), *info;
        size_t k;
        json_array_foreach(list, k, info)
        {
            if (aob_row_is_of(row, info))
                return aob_usual_params(info);
        }
    }
    return NULL;
}

static void finish(struct words *words)
{
    json_decref(words->first);
    json_decref(words->varying);
    json_decref(words->defaults);
}

void aob_labels_make(struct aob_rows *rows)
{
    struct words *params = AOB_NEW_ARRAY(struct words, rows->technique_count);
    struct words options = {json_object(), json_object(), aob_usual_options()};
    for (size_t i = 0; i < rows->count; i++) {
        const struct aob_row *row = &rows->list[i];
        struct words *own = &params[row->technique_place];
        if (!own->first)
            *own = (struct words){json_object(), json_object(), defaults_of(rows, row)};
        meet(own, row, json_object_get(row->json, "params"));
        meet(&options, row, json_object_get(row->json, "options"));
    }
    for (size_t i = 0; i < rows->count; i++)
        rows->list[i].label = label_of(&rows->list[i], &params[rows->list[i].technique_place], &options);
    for (size_t k = 0; k < rows->technique_count; k++)
        finish(&params[k]);
    finish(&options);
    free(params);
}
