#include "result.h"
#include <stdlib.h>
#include "base/json.h"
#include "model_result.h"

static void finish_pass(struct aob_cache_pass *pass)
{
    for (int f = 0; f < AOB_FLIGHT_COUNT; f++)
        aob_curve_finish(&pass->curves[f]);
    free(pass->map);
}

void aob_cache_result_finish(struct aob_cache_result *result)
{
    for (size_t p = 0; p < result->pass_count; p++)
        finish_pass(&result->passes[p]);
    finish_pass(&result->frame);
    free(result->passes);
    *result = (struct aob_cache_result){0};
}

static void add_misses(struct aob_misses *sum, const struct aob_misses *misses)
{
    sum->accesses += misses->accesses;
    sum->misses += misses->misses;
    sum->compulsory += misses->compulsory;
    sum->capacity += misses->capacity;
    sum->conflict += misses->conflict;
}

void aob_cache_result_add(struct aob_cache_result *result, const struct aob_cache_pass *pass)
{
    struct aob_cache_pass *frame = &result->frame;
    frame->counted = false;
    if (pass->pixels > frame->pixels) {
        frame->width = pass->width;
        frame->height = pass->height;
        frame->pixels = pass->pixels;
    }
    frame->invocations += pass->invocations;
    frame->fetches += pass->fetches;
    frame->distinct += pass->distinct;
    frame->texels += pass->texels;
    frame->bytes_asked += pass->bytes_asked;
    frame->bytes_written += pass->bytes_written;
    frame->lanes_busy += pass->lanes_busy;
    frame->lanes_issued += pass->lanes_issued;
    frame->target_pixels += pass->target_pixels;
    frame->issue.least += pass->issue.least;
    frame->issue.banked += pass->issue.banked;
    frame->issue.most += pass->issue.most;
    for (int f = 0; f < AOB_FLIGHT_COUNT; f++) {
        for (int l = 0; l < AOB_PROFILE_MAX_LEVEL; l++)
            add_misses(&frame->levels[l][f], &pass->levels[l][f]);
        aob_curve_add(&frame->curves[f], &pass->curves[f]);
    }
}

void aob_cache_result_count(struct aob_cache_result *result, size_t pass,
                            const struct aob_operations *operations)
{
    struct aob_cache_pass *frame = &result->frame;
    result->passes[pass].operations = *operations;
    result->passes[pass].counted = true;
    frame->operations = (struct aob_operations){0};
    frame->counted = true;
    for (size_t p = 0; p < result->pass_count; p++) {
        frame->operations.alu += result->passes[p].operations.alu;
        frame->operations.special += result->passes[p].operations.special;
        frame->operations.image += result->passes[p].operations.image;
        frame->counted &= result->passes[p].counted;
    }
}

uint64_t aob_cache_filled(const struct aob_cache_result *result, const struct aob_cache_pass *pass, int level,
                          enum aob_flight flight)
{
    return pass->levels[level][flight].misses * result->profile->levels[level].sector;
}

static json_t *whole(uint64_t value)
{
    return json_integer((json_int_t)value);
}

static json_t *share(double part, double of)
{
    return of > 0 ? json_real(part / of) : json_null();
}

static json_t *misses_to_json(const struct aob_cache_result *result, const struct aob_cache_pass *pass,
                              int level, enum aob_flight flight)
{
    const struct aob_misses *m = &pass->levels[level][flight];
    double bytes = (double)aob_cache_filled(result, pass, level, flight), pixels = (double)pass->pixels;
    json_t *object = json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "accesses", whole(m->accesses), "misses",
                               whole(m->misses), "miss_ratio", share((double)m->misses, (double)m->accesses),
                               "fills_per_pixel", share((double)m->misses, pixels), "bytes_per_pixel",
                               share(bytes, pixels), "compulsory", whole(m->compulsory));
    json_object_set_new(object, "capacity", result->split ? json_integer(m->capacity) : json_null());
    json_object_set_new(object, "conflict", result->split ? json_integer(m->conflict) : json_null());
    return object;
}

static json_t *levels_to_json(const struct aob_cache_result *result, const struct aob_cache_pass *pass)
{
    json_t *array = json_array();
    for (int l = 0; l < result->profile->level_count; l++)
        json_array_append_new(array, json_pack("{s:s, s:o, s:o}", "name", result->profile->levels[l].name,
                                               "one", misses_to_json(result, pass, l, AOB_FLIGHT_ONE), "most",
                                               misses_to_json(result, pass, l, AOB_FLIGHT_MOST)));
    return array;
}

static json_t *curve_to_json(const struct aob_curve *curve)
{
    json_t *lines = json_array(), *misses = json_array();
    for (size_t i = 0; i < curve->count; i++) {
        json_array_append_new(lines, whole(curve->lines[i]));
        json_array_append_new(misses, whole(curve->misses[i]));
    }
    return json_pack("{s:o, s:o}", "lines", lines, "misses", misses);
}

static json_t *operations_to_json(const struct aob_operations *operations)
{
    return json_pack("{s:o, s:o, s:o}", "alu", json_real(operations->alu), "special",
                     json_real(operations->special), "image", json_real(operations->image));
}

static json_t *pass_to_json(const struct aob_cache_result *result, const struct aob_cache_pass *pass)
{
    json_t *object = json_pack(
        "{s:i, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "width", pass->width, "height", pass->height,
        "invocations", whole(pass->invocations), "fetches", whole(pass->fetches), "distinct",
        whole(pass->distinct), "texels", whole(pass->texels), "bytes_asked", whole(pass->bytes_asked),
        "bytes_written", whole(pass->bytes_written), "lanes_busy",
        share((double)pass->lanes_busy, (double)pass->lanes_issued), "levels", levels_to_json(result, pass));
    json_object_set_new(object, "operations",
                        pass->counted ? operations_to_json(&pass->operations) : json_null());
    if (pass->curves[AOB_FLIGHT_ONE].count)
        json_object_set_new(object, "curve",
                            json_pack("{s:o, s:o}", "one", curve_to_json(&pass->curves[AOB_FLIGHT_ONE]),
                                      "most", curve_to_json(&pass->curves[AOB_FLIGHT_MOST])));
    return object;
}

json_t *aob_cache_result_to_json(const struct aob_cache_result *result)
{
    json_t *passes = json_array();
    for (size_t p = 0; p < result->pass_count; p++) {
        json_t *pass = pass_to_json(result, &result->passes[p]);
        json_object_set_new(pass, "name", json_string(result->passes[p].name));
        json_array_append_new(passes, pass);
    }
    return json_pack("{s:s, s:i, s:i, s:o, s:o, s:o}", "profile", result->profile->name, "units",
                     result->profile->units, "in_flight", result->profile->in_flight, "frame",
                     pass_to_json(result, &result->frame), "passes", passes, "modelled",
                     aob_model_result_to_json(result));
}
