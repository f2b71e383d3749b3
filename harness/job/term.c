#include "term.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "scene/light_json.h"

bool aob_term_same_trace(const struct aob_term *a, const struct aob_term *b)
{
    if (a->output != AOB_OUT_VISIBILITY || b->output != AOB_OUT_VISIBILITY)
        return a == b;
    if (a->uniform != b->uniform || a->of_triangle != b->of_triangle || a->bound != b->bound)
        return false;
    return !a->bound || a->thickness == b->thickness;
}

bool aob_term_has_light(const struct aob_term *term)
{
    return term->output == AOB_OUT_IRRADIANCE || term->output == AOB_OUT_LIT;
}

static bool has_bounces(const struct aob_term *term)
{
    return term->output == AOB_OUT_VISIBILITY_RGB || term->output == AOB_OUT_LIT;
}

json_t *aob_term_to_json(const struct aob_term *term)
{
    json_t *falloff = term->falloff ? json_array() : json_null();
    for (size_t i = 0; term->falloff && i < term->falloff_count; i++)
        json_array_append_new(falloff, aob_json_number((double)term->falloff[i]));
    json_t *object = json_pack("{s:o, s:b, s:o, s:b}", "radius", aob_json_number(term->radius), "uniform",
                               term->uniform, "falloff", falloff, "of_triangle", term->of_triangle);
    if (term->bound)
        aob_term_set_bound(object, term->thickness);
    if (term->bent)
        json_object_set_new(object, "bent", json_true());
    if (term->output != AOB_OUT_VISIBILITY)
        json_object_set_new(object, "output", json_string(aob_output_name(term->output)));
    if (has_bounces(term))
        json_object_set_new(object, "bounces", json_integer(term->bounces));
    if (aob_term_has_light(term))
        json_object_set_new(object, "light", aob_light_to_json(&term->light));
    return object;
}

void aob_term_set_bound(json_t *term, double thickness)
{
    json_object_set_new(term, "screen", aob_json_number(thickness));
}

static bool read_falloff(const json_t *array, struct aob_term *term, struct aob_error *error)
{
    size_t count = json_array_size(array);
    if (!json_is_array(array))
        return true;
    if (count < 2)
        return aob_fail(error, "a term's falloff has %zu rows: two or more are needed", count);
    float *table = AOB_NEW_ARRAY(float, count);
    term->falloff = table;
    term->falloff_count = count;
    for (size_t i = 0; i < count; i++) {
        table[i] = (float)aob_json_to_number(json_array_get(array, i));
        if (!isfinite(table[i]))
            return aob_fail(error, "row %zu of a term's falloff is no finite number", i);
    }
    return true;
}

static bool read_output(const json_t *object, struct aob_term *term, struct aob_error *error)
{
    const json_t *name = json_object_get(object, "output");
    int which = 0;
    while (name && which < AOB_OUTPUT_COUNT &&
           (!json_is_string(name) ||
            strcmp(json_string_value(name), aob_output_name((enum aob_output)which)) != 0))
        which++;
    if (which == AOB_OUTPUT_COUNT)
        return aob_fail(error, "a term has an output that nobody knows");
    term->output = (enum aob_output)which;
    term->bounces = (int)json_integer_value(json_object_get(object, "bounces"));
    return !aob_term_has_light(term) || aob_light_from_json(json_object_get(object, "light"), &term->light) ||
           aob_fail(error, "a term has no light");
}

bool aob_term_from_json(const json_t *object, struct aob_term *term, struct aob_error *error)
{
    const json_t *thickness = json_object_get(object, "screen");
    *term = (struct aob_term){.radius = aob_json_to_number(json_object_get(object, "radius")),
                              .uniform = json_is_true(json_object_get(object, "uniform")),
                              .of_triangle = json_is_true(json_object_get(object, "of_triangle")),
                              .bent = json_is_true(json_object_get(object, "bent")),
                              .bound = thickness != NULL,
                              .thickness = thickness ? aob_json_to_number(thickness) : 0};
    if (!(term->radius > 0))
        return aob_fail(error, "a term has no radius above 0");
    if (!(term->thickness >= 0))
        return aob_fail(error, "a term's bound has no thickness");
    if (read_output(object, term, error) && read_falloff(json_object_get(object, "falloff"), term, error))
        return true;
    aob_term_finish(term);
    return false;
}

void aob_term_finish(struct aob_term *term)
{
    free((void *)(uintptr_t)term->falloff);
    *term = (struct aob_term){0};
}

double aob_term_falloff(const struct aob_term *term, double t)
{
    if (!term->falloff)
        return 1;
    double place = sqrt(t) * (double)(term->falloff_count - 1);
    size_t low = place < (double)(term->falloff_count - 2) ? (size_t)place : term->falloff_count - 2;
    double a = (double)term->falloff[low], b = (double)term->falloff[low + 1];
    return a + (b - a) * (place - (double)low);
}
