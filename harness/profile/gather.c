#include "gather.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "order.h"

/* What an invocation has asked for, so that it is found again: a table that a new stamp empties. */
struct asked {
    uint32_t word, stamp;
};
struct aob_gather {
    struct aob_gather_desc desc;
    struct aob_order order;
    uint32_t shift;                     /* log2 of the bytes that the first level brings */
    uint32_t line_shift;                /* log2 of how often those are in a line */
    const struct aob_trace_plane *last; /* that a word was found in */
    int slots, lanes;                   /* lanes of the warp that is being filled */
    uint64_t warps;                     /* of fragments, so far */
    uint32_t *words;                    /* by slot and lane, without those asked twice */
    uint32_t *busy;                     /* by slot: lanes that fetch */
    uint32_t *lane_pixels;
    uint32_t *start, *numbers, *pixels; /* of the warp; room for four numbers a word */
    struct asked *asked;
    uint32_t asked_mask, stamp;
};

static const struct aob_trace_plane no_plane;

struct aob_gather *aob_gather_create(const struct aob_gather_desc *desc)
{
    struct aob_gather *gather = AOB_NEW(struct aob_gather);
    gather->desc = *desc;
    gather->order = aob_order_create(desc->profile);
    gather->shift = (uint32_t)__builtin_ctz(desc->profile->levels[0].sector);
    gather->line_shift = (uint32_t)__builtin_ctz(desc->profile->levels[0].line) - gather->shift;
    gather->last = desc->pass->plane_count ? desc->pass->planes : &no_plane;
    gather->lane_pixels = AOB_NEW_ARRAY(uint32_t, (size_t)gather->order.lanes);
    return gather;
}

static void free_words(struct aob_gather *gather)
{
    free(gather->words);
    free(gather->busy);
    free(gather->start);
    free(gather->numbers);
    free(gather->pixels);
    free(gather->asked);
}

void aob_gather_destroy(struct aob_gather *gather)
{
    if (!gather)
        return;
    free_words(gather);
    free(gather->lane_pixels);
    aob_order_finish(&gather->order);
    free(gather);
}

/* The slots are the same in all bands of a pass. */
static void make_room(struct aob_gather *gather, int slots)
{
    if (gather->start)
        return;
    size_t words = (size_t)gather->order.lanes * (size_t)slots;
    uint32_t table = 4;
    while (table < 4 * (uint32_t)slots)
        table *= 2;
    gather->slots = slots;
    gather->words = AOB_NEW_ARRAY(uint32_t, words + 1);
    gather->busy = AOB_NEW_ARRAY(uint32_t, (size_t)slots + 1);
    gather->start = AOB_NEW_ARRAY(uint32_t, (size_t)slots + 1);
    gather->numbers = AOB_NEW_ARRAY(uint32_t, 4 * words + 1);
    gather->pixels = gather->desc.pixels ? AOB_NEW_ARRAY(uint32_t, 4 * words + 1) : NULL;
    gather->asked = AOB_NEW_ARRAY(struct asked, table);
    gather->asked_mask = table - 1;
}

/* The table is passed by value: what is written elsewhere cannot change it, as far as a compiler knows. */
static inline bool asks_again(struct asked *asked, uint32_t mask, struct asked key)
{
    uint32_t at = (key.word * 2654435761u >> 8) & mask;
    for (; asked[at].stamp == key.stamp; at = (at + 1) & mask)
        if (asked[at].word == key.word)
            return true;
    asked[at] = key;
    return false;
}

static void next_stamp(struct aob_gather *gather)
{
    if (++gather->stamp)
        return;
    memset(gather->asked, 0, ((size_t)gather->asked_mask + 1) * sizeof *gather->asked);
    gather->stamp = 1;
}

/* An invocation becomes the next lane. */
static void add_lane(struct aob_gather *gather, const uint32_t *words, uint32_t pixel)
{
    uint32_t *out = gather->words + gather->lanes, *busy = gather->busy;
    uint64_t fetches = 0, distinct = 0;
    next_stamp(gather);
    struct asked *asked = gather->asked;
    uint32_t mask = gather->asked_mask, stamp = gather->stamp;
    int slots = gather->slots, lanes = gather->order.lanes;
    for (int s = 0; s < slots; s++, out += lanes) {
        uint32_t word = words[s];
        bool used = word != AOB_TRACE_NONE;
        bool first = used && !asks_again(asked, mask, (struct asked){word, stamp});
        *out = first ? word : AOB_TRACE_NONE;
        busy[s] += used;
        fetches += used;
        distinct += first;
    }
    gather->lane_pixels[gather->lanes++] = pixel;
    gather->desc.counts->invocations++;
    gather->desc.counts->fetches += fetches;
    gather->desc.counts->distinct += distinct;
}

static void add_idle_lane(struct aob_gather *gather)
{
    uint32_t *out = gather->words + gather->lanes++;
    for (int s = 0; s < gather->slots; s++, out += gather->order.lanes)
        *out = AOB_TRACE_NONE;
}

static inline bool holds(const struct aob_trace_plane *plane, uint32_t texel)
{
    return texel - plane->first < (uint32_t)plane->width * (uint32_t)plane->height;
}

static bool find_plane(struct aob_gather *gather, uint32_t texel)
{
    const struct aob_trace_pass *pass = gather->desc.pass;
    for (int p = 0; p < pass->plane_count; p++)
        if (holds(&pass->planes[p], texel)) {
            gather->last = &pass->planes[p];
            return true;
        }
    return false;
}

/* Where the words of a plane lie. It stays in registers while one word after the other is of the same plane. */
struct place {
    struct aob_trace_plane plane;
    struct aob_placed placed;
    uint32_t shift; /* log2 of the bytes of a number */
    uint64_t bytes; /* of a texel */
};

static void go_to_plane(const struct aob_gather *gather, struct place *place)
{
    place->plane = *gather->last;
    place->placed = gather->desc.placed->levels[gather->last->texture][gather->last->level];
    place->bytes = (uint64_t)gather->desc.placed->bytes[gather->last->texture];
    place->shift = gather->shift;
}

static inline uint32_t number_at(const struct place *place, uint32_t x, uint32_t y)
{
    return (uint32_t)(aob_layout_address(&place->placed, x, y) >> place->shift);
}

/* Writes the numbers of the other texels of a bilinear word, up to three, and returns how many. */
static uint32_t add_neighbours(const struct place *place, uint32_t word, uint32_t x, uint32_t y,
                               uint32_t *out)
{
    bool right = !(word & AOB_TRACE_ONE_COLUMN) && x + 1 < (uint32_t)place->plane.width;
    bool below = !(word & AOB_TRACE_ONE_ROW) && y + 1 < (uint32_t)place->plane.height;
    uint32_t count = 0;
    if (right)
        out[count++] = number_at(place, x + 1, y);
    if (below)
        out[count++] = number_at(place, x, y + 1);
    if (right && below)
        out[count++] = number_at(place, x + 1, y + 1);
    return count;
}

static inline uint32_t expand(const struct place *place, uint32_t word, uint32_t *out)
{
    uint32_t width = (uint32_t)place->plane.width, texel = aob_trace_texel(word) - place->plane.first;
    uint32_t y = texel / width, x = texel - y * width;
    *out = number_at(place, x, y);
    return word & AOB_TRACE_BILINEAR ? 1 + add_neighbours(place, word, x, y, out + 1) : 1;
}

static bool fail_word(const struct aob_gather *gather, uint32_t texel, struct aob_error *error)
{
    return aob_fail(error, "pass '%s': its trace names texel %u, which none of its textures has",
                    gather->desc.pass->name, texel);
}

/* What the lanes of a quad ask for in one fetch, from numbers[first] on. */
struct quad {
    uint32_t first, bytes;
    bool filtered;
};

/* The quad has asked for all up to numbers[count]; the next one begins. */
static inline void end_quad(const struct aob_gather *gather, struct quad *quad, const uint32_t *numbers,
                            uint32_t count)
{
    const struct aob_profile *profile = gather->desc.profile;
    if (profile->rates.clock > 0 && count > quad->first)
        aob_issue_add(&gather->desc.counts->issue, &profile->rates,
                      &(struct aob_issue_quad){numbers + quad->first, count - quad->first, gather->line_shift,
                                               quad->bytes, quad->filtered});
    *quad = (struct quad){.first = count};
}

/* What all lanes ask for in one fetch becomes numbers from gather->numbers[*at] on. */
static bool emit_slot(struct aob_gather *gather, const uint32_t *words, uint32_t *at, struct aob_error *error)
{
    struct place place;
    uint32_t *numbers = gather->numbers + *at, *pixels = gather->pixels ? gather->pixels + *at : NULL;
    uint32_t count = 0;
    uint64_t bytes = 0;
    struct quad quad = {0};
    go_to_plane(gather, &place);
    for (int lane = 0; lane < gather->order.lanes; lane++) {
        uint32_t word = words[lane], texel = aob_trace_texel(word);
        if (lane % AOB_ISSUE_LANES == 0)
            end_quad(gather, &quad, numbers, count);
        if (word == AOB_TRACE_NONE)
            continue;
        if (!holds(&place.plane, texel)) {
            if (!find_plane(gather, texel))
                return fail_word(gather, texel, error);
            go_to_plane(gather, &place);
        }
        uint32_t added = expand(&place, word, numbers + count);
        for (uint32_t i = 0; pixels && i < added; i++)
            pixels[count + i] = gather->lane_pixels[lane];
        count += added;
        bytes += added * place.bytes;
        quad.filtered |= (word & AOB_TRACE_BILINEAR) != 0;
        quad.bytes = place.bytes > quad.bytes ? (uint32_t)place.bytes : quad.bytes;
    }
    end_quad(gather, &quad, numbers, count);
    *at += count;
    gather->desc.counts->bytes_asked += bytes;
    return true;
}

static bool emit(struct aob_gather *gather, int unit, struct aob_error *error)
{
    struct aob_cache_pass *counts = gather->desc.counts;
    uint32_t at = 0;
    for (int s = 0; s < gather->slots; s++) {
        gather->start[s] = at;
        if (!emit_slot(gather, gather->words + (size_t)s * (size_t)gather->order.lanes, &at, error))
            return false;
        counts->lanes_busy += gather->busy[s];
        counts->lanes_issued += gather->busy[s] ? (uint64_t)gather->order.lanes : 0;
        gather->busy[s] = 0;
    }
    gather->start[gather->slots] = at;
    counts->texels += at;
    gather->lanes = 0;
    struct aob_warp warp = {unit, gather->slots, gather->start, gather->numbers, gather->pixels};
    gather->desc.take(gather->desc.self, &warp);
    return true;
}

/* The tile whose first pixel is (x, y) of the band. Warps that no pixel of the area belongs to do not run. */
static bool add_tile(struct aob_gather *gather, const struct aob_trace_band *band, int x, int y, int unit,
                     struct aob_error *error)
{
    const struct aob_order *order = &gather->order;
    int width = gather->desc.pass->width;
    for (int first = 0; first < order->pixels; first += order->lanes) {
        bool any = false;
        for (int n = first; n < first + order->lanes; n++) {
            int px = x + order->x[n], py = y + order->y[n];
            bool inside = px < width && py < band->rows;
            size_t place = (size_t)py * (size_t)width + (size_t)px;
            any |= inside;
            if (inside)
                add_lane(gather, band->words + place * (size_t)band->slots,
                         (uint32_t)(band->row * width) + (uint32_t)place);
            else
                add_idle_lane(gather);
        }
        if (any && !emit(gather, unit, error))
            return false;
        gather->lanes = 0;
    }
    return true;
}

static bool add_tiles(struct aob_gather *gather, const struct aob_trace_band *band, struct aob_error *error)
{
    const struct aob_profile *profile = gather->desc.profile;
    struct aob_size2 tile = profile->tile;
    int columns = (gather->desc.pass->width + tile.width - 1) / tile.width;
    for (int y = 0; y < band->rows; y += tile.height)
        for (int c = 0; c < columns; c++) {
            int number = (band->row + y) / tile.height * columns + c;
            if (!add_tile(gather, band, c * tile.width, y, number % profile->units, error))
                return false;
        }
    return true;
}

static bool emit_fragments(struct aob_gather *gather, struct aob_error *error)
{
    while (gather->lanes < gather->order.lanes)
        add_idle_lane(gather);
    return emit(gather, (int)(gather->warps++ % (uint64_t)gather->desc.profile->units), error);
}

/* Fragments fill warps in their own order, across bands. */
static bool add_fragments(struct aob_gather *gather, const struct aob_trace_band *band,
                          struct aob_error *error)
{
    const struct aob_trace_pass *pass = gather->desc.pass;
    for (size_t i = 0; i < band->count; i++) {
        uint32_t x = band->pixels[i] & 0xffff, y = band->pixels[i] >> 16;
        if (x >= (uint32_t)pass->width || y >= (uint32_t)pass->height)
            return aob_fail(error, "pass '%s': its trace has a fragment at (%u, %u), outside its area",
                            pass->name, x, y);
        add_lane(gather, band->words + i * (size_t)band->slots, y * (uint32_t)pass->width + x);
        if (gather->lanes == gather->order.lanes && !emit_fragments(gather, error))
            return false;
    }
    return true;
}

bool aob_gather_band(struct aob_gather *gather, const struct aob_trace_band *band, struct aob_error *error)
{
    make_room(gather, band->slots);
    return gather->desc.pass->fragments ? add_fragments(gather, band, error) : add_tiles(gather, band, error);
}

bool aob_gather_end(struct aob_gather *gather, struct aob_error *error)
{
    return gather->lanes == 0 || emit_fragments(gather, error);
}
