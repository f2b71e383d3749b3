#include "simulate.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "gather.h"
#include "level.h"

enum { MAX_TEXELS = 4 }; /* of a word, which may be bilinear */

/* Warps that a unit has begun, until there are enough to take turns. */
struct pending {
    uint32_t *numbers, *pixels;
    size_t count, room;
    size_t *start; /* in_flight x (slots + 1): of each warp and fetch its first number */
    int warps, start_slots;
};
struct numbers { /* a stretch of accesses on their way through the levels */
    uint32_t *items, *pixels, *missed;
    size_t room;
};
struct aob_simulation {
    struct aob_simulation_desc desc;
    struct aob_cache_result result;
    struct aob_placed_frame placed;
    const struct aob_trace_frame *frame; /* NULL before the first pass */
    struct aob_trace_pass pass;
    struct aob_gather *gather;
    struct aob_level **caches[AOB_PROFILE_MAX_LEVEL][AOB_FLIGHT_COUNT];
    int cache_counts[AOB_PROFILE_MAX_LEVEL];
    uint64_t associative[AOB_PROFILE_MAX_LEVEL][AOB_FLIGHT_COUNT]; /* misses before this pass */
    struct pending *pending;                                       /* by unit */
    struct numbers work;
    struct aob_room own_room, *room;
    double turns_taken; /* of the room, by warps in flight */
};

struct aob_simulation *aob_simulation_create(const struct aob_simulation_desc *desc)
{
    struct aob_simulation *simulation = AOB_NEW(struct aob_simulation);
    const struct aob_profile *profile = desc->profile;
    simulation->desc = *desc;
    simulation->room = desc->room ? desc->room : &simulation->own_room;
    simulation->result.profile = profile;
    simulation->result.split = desc->curve != AOB_CURVE_NONE;
    simulation->pending = AOB_NEW_ARRAY(struct pending, (size_t)profile->units);
    for (int l = 0; l < profile->level_count; l++) {
        int shared = profile->levels[l].units ? profile->levels[l].units : profile->units;
        int count = (profile->units + shared - 1) / shared;
        simulation->cache_counts[l] = count;
        for (int f = 0; f < AOB_FLIGHT_COUNT; f++)
            simulation->caches[l][f] = AOB_NEW_ARRAY(struct aob_level *, (size_t)count);
    }
    return simulation;
}

static void empty_level(struct aob_simulation *simulation, int l, int f)
{
    for (int c = 0; c < simulation->cache_counts[l]; c++) {
        aob_level_destroy(simulation->caches[l][f][c]);
        simulation->caches[l][f][c] = NULL;
    }
}

void aob_simulation_destroy(struct aob_simulation *simulation)
{
    if (!simulation)
        return;
    aob_gather_destroy(simulation->gather);
    for (int l = 0; l < simulation->desc.profile->level_count; l++)
        for (int f = 0; f < AOB_FLIGHT_COUNT; f++) {
            empty_level(simulation, l, f);
            free(simulation->caches[l][f]);
        }
    for (int u = 0; u < simulation->desc.profile->units; u++) {
        free(simulation->pending[u].numbers);
        free(simulation->pending[u].pixels);
        free(simulation->pending[u].start);
    }
    free(simulation->pending);
    free(simulation->work.items);
    free(simulation->work.pixels);
    free(simulation->work.missed);
    aob_cache_result_finish(&simulation->result);
    free(simulation);
}

/* Where only one warp is in flight, both orders are the same, and one is simulated. */
static int flights(const struct aob_simulation *simulation)
{
    return simulation->desc.profile->in_flight == 1 ? 1 : AOB_FLIGHT_COUNT;
}

static struct aob_level_desc level_desc(const struct aob_simulation *simulation, int l)
{
    const struct aob_profile_level *level = &simulation->desc.profile->levels[l];
    return (struct aob_level_desc){level, (uint32_t)(simulation->placed.size / level->sector + 1),
                                   simulation->desc.curve, l > 0};
}

static bool take_room(struct aob_simulation *simulation, double bytes, struct aob_error *error)
{
    char who[128];
    snprintf(who, sizeof who, "profile %s: its simulation", simulation->desc.profile->name);
    return aob_room_take(simulation->room, bytes, who, "lower the size, the units or the warps in flight",
                         error);
}

static bool take_caches(struct aob_simulation *simulation, struct aob_error *error)
{
    const struct aob_profile *profile = simulation->desc.profile;
    double need = 0;
    for (int l = 0; l < profile->level_count; l++) {
        if (simulation->placed.size / profile->levels[l].sector >= UINT32_MAX - 1)
            return aob_fail(
                error,
                "profile %s: textures of %.0f GiB have more lines than can be numbered: lower the size",
                profile->name, (double)simulation->placed.size / 0x1p30);
        struct aob_level_desc desc = level_desc(simulation, l);
        need += aob_level_bytes(&desc) * simulation->cache_counts[l] * flights(simulation);
    }
    return take_room(simulation, need, error);
}

/* Bytes of the warps that wait for their turn, and of one unit's on their way through the levels. */
static double turn_bytes(const struct aob_simulation *simulation, int slots)
{
    const struct aob_profile *profile = simulation->desc.profile;
    const struct aob_trace_pass *pass = &simulation->pass;
    double lanes = (double)profile->warp.width * profile->warp.height;
    double all = pass->fragments ? INFINITY : (double)pass->width * pass->height; /* lanes of the pass */
    double word = MAX_TEXELS * sizeof(uint32_t) * (simulation->desc.map ? 2 : 1);
    double in_turn = fmin(all, lanes * profile->in_flight), waiting = fmin(all, in_turn * profile->units);
    double starts = sizeof(size_t) * (slots + 1.0) * profile->in_flight * profile->units;
    double work = in_turn * slots * (word + MAX_TEXELS * sizeof(uint32_t));
    return flights(simulation) == 1 ? work : work + 2 * waiting * slots * word + starts;
}

/* What an earlier pass has taken is used again. */
static bool take_turns_room(struct aob_simulation *simulation, int slots, struct aob_error *error)
{
    double more = turn_bytes(simulation, slots) - simulation->turns_taken;
    if (more <= 0)
        return true;
    simulation->turns_taken += more;
    return take_room(simulation, more, error);
}

static bool begin_frame(struct aob_simulation *simulation, const struct aob_trace_frame *frame,
                        struct aob_error *error)
{
    simulation->frame = frame;
    return aob_layout_place(simulation->desc.profile, frame, &simulation->placed, error) &&
           take_caches(simulation, error);
}

static void begin_caches(struct aob_simulation *simulation)
{
    const struct aob_profile *profile = simulation->desc.profile;
    for (int l = 0; l < profile->level_count; l++)
        for (int f = 0; f < flights(simulation); f++) {
            struct aob_level_desc desc = level_desc(simulation, l);
            if (profile->levels[l].cold_at_pass)
                empty_level(simulation, l, f);
            simulation->associative[l][f] = 0;
            for (int c = 0; c < simulation->cache_counts[l]; c++) {
                struct aob_level **cache = &simulation->caches[l][f][c];
                if (!*cache)
                    *cache = aob_level_create(&desc);
                if (simulation->result.split)
                    simulation->associative[l][f] += aob_level_associative(*cache);
            }
        }
}

static struct aob_cache_pass *current(struct aob_simulation *simulation)
{
    return &simulation->result.passes[simulation->result.pass_count - 1];
}

static void make_room(struct aob_simulation *simulation, size_t count)
{
    struct numbers *work = &simulation->work;
    if (count < work->room)
        return;
    work->room = count + 1; /* never nothing: copies of nothing need a place as well */
    work->items = aob_realloc(work->items, work->room, sizeof *work->items);
    work->missed = aob_realloc(work->missed, work->room, sizeof *work->missed);
    if (simulation->desc.map)
        work->pixels = aob_realloc(work->pixels, work->room, sizeof *work->pixels);
}

static void mark_pixels(struct aob_simulation *simulation, enum aob_flight flight, const uint32_t *pixels,
                        size_t misses)
{
    struct aob_cache_pass *pass = current(simulation);
    bool wanted = flight == simulation->desc.map_flight || flights(simulation) == 1;
    for (size_t i = 0; pass->map && wanted && i < misses; i++)
        pass->map[pixels[simulation->work.missed[i]]]++;
}

/* Accesses of a unit go down the levels: each gets what the one before missed, in numbers of its own, larger sectors. */
static void use(struct aob_simulation *simulation, enum aob_flight flight, int unit, const uint32_t *numbers,
                const uint32_t *pixels, size_t count)
{
    const struct aob_profile *profile = simulation->desc.profile;
    struct aob_cache_pass *pass = current(simulation);
    struct numbers *work = &simulation->work;
    make_room(simulation, count);
    for (int l = 0; l < profile->level_count; l++) {
        int shared = profile->levels[l].units ? profile->levels[l].units : profile->units;
        count = aob_level_access(simulation->caches[l][flight][unit / shared], numbers, count, work->missed,
                                 &pass->levels[l][flight]);
        if (l == 0)
            mark_pixels(simulation, flight, pixels, count);
        if (l + 1 == profile->level_count)
            return;
        int shift = __builtin_ctz(profile->levels[l + 1].sector / profile->levels[l].sector);
        for (size_t i = 0; i < count; i++)
            work->items[i] = numbers[work->missed[i]] >> shift;
        numbers = work->items;
    }
}

/* Of all warps the first fetch, then of all the second: lanes of a warp stay together. */
static void take_turns(struct aob_simulation *simulation, int unit)
{
    struct pending *pending = &simulation->pending[unit];
    struct numbers *work = &simulation->work;
    size_t at = 0, stride = (size_t)pending->start_slots + 1;
    make_room(simulation, pending->count);
    for (size_t s = 0; s + 1 < stride; s++)
        for (int w = 0; w < pending->warps; w++) {
            const size_t *start = pending->start + (size_t)w * stride + s;
            size_t count = start[1] - start[0];
            memcpy(work->items + at, pending->numbers + start[0], count * sizeof *work->items);
            if (pending->pixels)
                memcpy(work->pixels + at, pending->pixels + start[0], count * sizeof *work->pixels);
            at += count;
        }
    pending->warps = 0;
    pending->count = 0;
    use(simulation, AOB_FLIGHT_MOST, unit, work->items, work->pixels, at);
}

static void begin_pending(struct pending *pending, const struct aob_profile *profile, int slots)
{
    pending->start_slots = slots;
    pending->start =
        aob_realloc(pending->start, (size_t)profile->in_flight * ((size_t)slots + 1), sizeof *pending->start);
}

static void grow_pending(struct pending *pending, size_t count, bool pixels)
{
    if (pending->count + count < pending->room)
        return;
    pending->room = 2 * (pending->count + count) + 1;
    pending->numbers = aob_realloc(pending->numbers, pending->room, sizeof *pending->numbers);
    if (pixels)
        pending->pixels = aob_realloc(pending->pixels, pending->room, sizeof *pending->pixels);
}

static void wait_turn(struct aob_simulation *simulation, const struct aob_warp *warp)
{
    const struct aob_profile *profile = simulation->desc.profile;
    struct pending *pending = &simulation->pending[warp->unit];
    size_t count = warp->start[warp->slots];
    if (!pending->start || pending->start_slots != warp->slots)
        begin_pending(pending, profile, warp->slots);
    grow_pending(pending, count, warp->pixels != NULL);
    size_t *start = pending->start + (size_t)pending->warps * ((size_t)warp->slots + 1);
    for (int s = 0; s <= warp->slots; s++)
        start[s] = pending->count + warp->start[s];
    memcpy(pending->numbers + pending->count, warp->numbers, count * sizeof *warp->numbers);
    if (warp->pixels)
        memcpy(pending->pixels + pending->count, warp->pixels, count * sizeof *warp->pixels);
    pending->count += count;
    if (++pending->warps == profile->in_flight)
        take_turns(simulation, warp->unit);
}

static void take_warp(void *self, const struct aob_warp *warp)
{
    struct aob_simulation *simulation = self;
    use(simulation, AOB_FLIGHT_ONE, warp->unit, warp->numbers, warp->pixels, warp->start[warp->slots]);
    if (flights(simulation) > 1)
        wait_turn(simulation, warp);
}

static bool begin(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                  struct aob_error *error)
{
    struct aob_simulation *simulation = self;
    struct aob_cache_result *result = &simulation->result;
    if ((!simulation->frame && !begin_frame(simulation, frame, error)) ||
        !aob_layout_judge(frame, pass, error))
        return false;
    begin_caches(simulation);
    simulation->pass = *pass;
    struct aob_cache_pass *counts = AOB_PUSH(result->passes, result->pass_count, result->pass_capacity);
    snprintf(counts->name, sizeof counts->name, "%s", pass->name);
    counts->index = pass->index;
    counts->width = pass->width;
    counts->height = pass->height;
    counts->pixels = (uint64_t)pass->width * (uint64_t)pass->height;
    if (simulation->desc.map)
        counts->map = AOB_NEW_ARRAY(float, counts->pixels);
    simulation->gather = aob_gather_create(&(struct aob_gather_desc){.profile = simulation->desc.profile,
                                                                     .placed = &simulation->placed,
                                                                     .pass = &simulation->pass,
                                                                     .counts = counts,
                                                                     .pixels = simulation->desc.map,
                                                                     .self = simulation,
                                                                     .take = take_warp});
    return true;
}

static bool band(void *self, const struct aob_trace_band *rows, struct aob_error *error)
{
    struct aob_simulation *simulation = self;
    return take_turns_room(simulation, rows->slots, error) &&
           aob_gather_band(simulation->gather, rows, error);
}

/* What the caches of a level would have missed in this pass if they were fully associative. */
static void split(const struct aob_simulation *simulation, int l, int f, struct aob_misses *misses)
{
    uint64_t associative = 0;
    for (int c = 0; c < simulation->cache_counts[l]; c++)
        associative += aob_level_associative(simulation->caches[l][f][c]);
    associative -= simulation->associative[l][f];
    misses->capacity = (int64_t)(associative - misses->compulsory);
    misses->conflict = (int64_t)(misses->misses - associative);
}

static void add_curves(const struct aob_simulation *simulation, int f, struct aob_curve *sum)
{
    for (int c = 0; c < simulation->cache_counts[0]; c++) {
        struct aob_curve curve;
        aob_level_curve(simulation->caches[0][f][c], &curve);
        aob_curve_add(sum, &curve);
        aob_curve_finish(&curve);
    }
}

static void count_written(struct aob_simulation *simulation, struct aob_cache_pass *counts)
{
    for (int w = 0; w < simulation->pass.write_count; w++)
        counts->bytes_written +=
            counts->invocations * (uint64_t)simulation->placed.bytes[simulation->pass.writes[w].texture];
    counts->target_pixels = counts->invocations * (uint64_t)simulation->pass.write_count;
}

static bool end(void *self, struct aob_error *error)
{
    struct aob_simulation *simulation = self;
    struct aob_cache_pass *counts = current(simulation);
    if (!aob_gather_end(simulation->gather, error))
        return false;
    for (int u = 0; u < simulation->desc.profile->units; u++)
        if (simulation->pending[u].warps)
            take_turns(simulation, u);
    count_written(simulation, counts);
    for (int f = 0; simulation->result.split && f < flights(simulation); f++) {
        for (int l = 0; l < simulation->desc.profile->level_count; l++)
            split(simulation, l, f, &counts->levels[l][f]);
        add_curves(simulation, f, &counts->curves[f]);
    }
    if (flights(simulation) == 1) {
        for (int l = 0; l < simulation->desc.profile->level_count; l++)
            counts->levels[l][AOB_FLIGHT_MOST] = counts->levels[l][AOB_FLIGHT_ONE];
        aob_curve_add(&counts->curves[AOB_FLIGHT_MOST], &counts->curves[AOB_FLIGHT_ONE]);
    }
    aob_cache_result_add(&simulation->result, counts);
    aob_gather_destroy(simulation->gather);
    simulation->gather = NULL;
    return true;
}

struct aob_trace_sink aob_simulation_sink(struct aob_simulation *simulation)
{
    return (struct aob_trace_sink){simulation, begin, band, end};
}

void aob_simulation_count(struct aob_simulation *simulation, size_t pass,
                          const struct aob_operations *operations)
{
    aob_cache_result_count(&simulation->result, pass, operations);
}

const struct aob_cache_result *aob_simulation_result(const struct aob_simulation *simulation)
{
    return &simulation->result;
}
