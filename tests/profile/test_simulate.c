/* A capture through the levels, against accesses that are put in order by sorting and go through lists. */
#include "check.h"
#include "made.h"
#include "profile/layout.h"
#include "streams.h"

enum { WIDTH = 70, HEIGHT = 140, SLOTS = 5, TEXTURE = 96 };

/* What a unit asks for, and when: `turn` is when the warps that take turns are complete. */
struct access {
    uint32_t turn, slot, warp, lane, unit;
    uint64_t address;
    uint32_t pixel;
};
struct plain_cache { /* of one level */
    struct plain_set *sets;
    uint8_t *held;
};
struct plain {
    struct access *items;
    size_t count, capacity;
    uint32_t turns, waiting[8]; /* of each unit the warps since its last turn */
    uint64_t misses[AOB_PROFILE_MAX_LEVEL], compulsory[AOB_PROFILE_MAX_LEVEL],
        accesses[AOB_PROFILE_MAX_LEVEL];
    uint32_t map[WIDTH * HEIGHT];
};

static int by_time(const void *a, const void *b)
{
    const struct access *x = a, *y = b;
    if (x->turn != y->turn)
        return x->turn < y->turn ? -1 : 1;
    if (x->slot != y->slot)
        return x->slot < y->slot ? -1 : 1;
    if (x->warp != y->warp)
        return x->warp < y->warp ? -1 : 1;
    return x->lane < y->lane ? -1 : x->lane > y->lane;
}

/* The lane of a pixel in its warp: two bits within the quad, then the quad. */
static uint32_t lane_of(int x, int y)
{
    return (uint32_t)((y % 4 / 2 * 4 + x % 8 / 2) * 4 + y % 2 * 2 + x % 2);
}

static bool asked_before(const uint32_t *words, int slot)
{
    for (int s = 0; s < slot; s++)
        if (words[s] == words[slot])
            return true;
    return false;
}

/* Appends the accesses of the warp whose first pixel is (x, y). */
static void list_warp(struct plain *plain, const uint32_t *words, const struct aob_placed *placed, int x,
                      int y, uint32_t unit, uint32_t warp)
{
    for (int dy = 0; dy < 4 && y + dy < HEIGHT; dy++)
        for (int dx = 0; dx < 8 && x + dx < WIDTH; dx++)
            for (int s = 0; s < SLOTS; s++) {
                uint32_t pixel = (uint32_t)((y + dy) * WIDTH + x + dx);
                const uint32_t *own = words + (size_t)pixel * SLOTS;
                if (own[s] == AOB_TRACE_NONE || asked_before(own, s))
                    continue;
                struct access *access = AOB_PUSH(plain->items, plain->count, plain->capacity);
                *access =
                    (struct access){0,    (uint32_t)s,
                                    warp, lane_of(dx, dy),
                                    unit, aob_layout_address(placed, own[s] % TEXTURE, own[s] / TEXTURE),
                                    pixel};
            }
}

/* Each unit's warps in groups of `flight`; those of a group are complete with its last, what is left over at the end. */
static void order(struct plain *plain, const struct aob_profile *profile, const uint32_t *words,
                  const struct aob_placed *placed, uint32_t flight)
{
    uint32_t warp = 0, warps[8] = {0}, *turn_of[8];
    for (int u = 0; u < profile->units; u++)
        turn_of[u] = AOB_NEW_ARRAY(uint32_t, 4096);
    for (int y = 0; y < HEIGHT; y += 8)
        for (int x = 0; x < WIDTH; x += 8)
            for (int half = 0; half < 8 && y + half < HEIGHT; half += 4, warp++) {
                uint32_t unit = (uint32_t)(y / 8 * ((WIDTH + 7) / 8) + x / 8) % (uint32_t)profile->units;
                size_t first = plain->count;
                list_warp(plain, words, placed, x, y + half, unit, warp);
                for (size_t i = first; i < plain->count; i++)
                    plain->items[i].turn = warps[unit] / flight; /* the group, for now */
                turn_of[unit][warps[unit] / flight] = warp + 1;
                if (++warps[unit] % flight)
                    turn_of[unit][warps[unit] / flight] = 1000000 + unit; /* unless it is filled */
            }
    for (size_t i = 0; i < plain->count; i++)
        plain->items[i].turn = turn_of[plain->items[i].unit][plain->items[i].turn];
    for (int u = 0; u < profile->units; u++)
        free(turn_of[u]);
    qsort(plain->items, plain->count, sizeof *plain->items, by_time);
}

static bool use(struct plain *plain, const struct aob_profile_level *level, struct plain_cache *cache, int l,
                uint64_t address)
{
    uint64_t line = address / level->line, sector = address / level->sector, bits = 0;
    for (uint32_t sets = level->sets; sets > 1; sets /= 2)
        bits++;
    uint64_t set = level->index == AOB_INDEX_MODULO ? line % level->sets
                                                    : (line ^ line >> bits ^ line >> 2 * bits) % level->sets;
    bool hit = plain_access(&cache->sets[set], level->ways, (uint32_t)line,
                            (uint32_t)(sector % (level->line / level->sector)));
    plain->accesses[l]++;
    plain->misses[l] += !hit;
    plain->compulsory[l] += !hit && !cache->held[sector];
    cache->held[sector] = 1;
    return hit;
}

/* Through the levels, each cache shared by as many units as its level says. */
static void simulate(struct plain *plain, const struct aob_profile *profile, uint64_t memory)
{
    struct plain_cache caches[AOB_PROFILE_MAX_LEVEL][8];
    for (int l = 0; l < profile->level_count; l++)
        for (int c = 0; c < 8; c++)
            caches[l][c] = (struct plain_cache){AOB_NEW_ARRAY(struct plain_set, profile->levels[l].sets),
                                                AOB_NEW_ARRAY(uint8_t, memory)};
    for (size_t i = 0; i < plain->count; i++)
        for (int l = 0; l < profile->level_count; l++) {
            int shared = profile->levels[l].units ? profile->levels[l].units : profile->units;
            if (use(plain, &profile->levels[l], &caches[l][(int)plain->items[i].unit / shared], l,
                    plain->items[i].address))
                break;
            plain->map[plain->items[i].pixel] += l == 0;
        }
    for (int l = 0; l < profile->level_count; l++)
        for (int c = 0; c < 8; c++) {
            free(caches[l][c].sets);
            free(caches[l][c].held);
        }
}

static uint32_t *random_words(uint32_t seed)
{
    uint32_t *words = AOB_NEW_ARRAY(uint32_t, WIDTH * HEIGHT * SLOTS);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        for (size_t s = 0; s < SLOTS; s++) { /* near the pixel, some slots unused, some twice the same */
            uint32_t x = (uint32_t)(i % WIDTH + random_below(&seed, 24)),
                     y = (uint32_t)(i / WIDTH * 2 / 3 + random_below(&seed, 3));
            bool unused = random_below(&seed, 8) == 0, again = s && random_below(&seed, 8) == 0;
            words[i * SLOTS + s] = unused ? AOB_TRACE_NONE : again ? words[i * SLOTS] : y * TEXTURE + x;
        }
    return words;
}

static struct aob_profile three_levels(void)
{
    struct aob_profile profile = made_profile();
    profile.units = 5;
    profile.levels[0] = (struct aob_profile_level){.name = "L0",
                                                   .size = 2048,
                                                   .line = 128,
                                                   .sector = 32,
                                                   .ways = 4,
                                                   .sets = 4,
                                                   .index = AOB_INDEX_XOR,
                                                   .units = 1,
                                                   .cold_at_pass = true};
    profile.levels[1] = (struct aob_profile_level){.name = "GL1",
                                                   .size = 6144,
                                                   .line = 128,
                                                   .sector = 64,
                                                   .ways = 3,
                                                   .sets = 16,
                                                   .index = AOB_INDEX_MODULO,
                                                   .units = 2,
                                                   .cold_at_pass = true};
    profile.levels[2] = (struct aob_profile_level){.name = "L2",
                                                   .size = 12288,
                                                   .line = 128,
                                                   .sector = 128,
                                                   .ways = 8,
                                                   .sets = 12,
                                                   .index = AOB_INDEX_MODULO};
    profile.level_count = 3;
    profile.layout = AOB_LAYOUT_MORTON;
    return profile;
}

struct shot {
    struct aob_trace_frame frame;
    struct aob_trace_pass pass;
    struct aob_simulation *simulation;
    const struct aob_cache_result *result;
};

static void shoot(struct shot *shot, const struct aob_simulation_desc *desc, const uint32_t *words, int times)
{
    struct aob_error error = {{0}};
    *shot = (struct shot){.frame = {.texture_count = 0}};
    made_texture(&shot->frame, "own", AOB_R32F, TEXTURE, 100, 1);
    made_texture(&shot->frame, "out", AOB_RGBA16F, WIDTH, HEIGHT, 1);
    shot->pass = made_pass(&shot->frame, WIDTH, HEIGHT);
    shot->pass.writes[0] = (struct aob_trace_write){.texture = 1};
    shot->pass.write_count = 1;
    shot->simulation = aob_simulation_create(desc);
    struct aob_trace_sink sink = aob_simulation_sink(shot->simulation);
    for (int t = 0; t < times; t++)
        if (!made_send(&sink, &shot->frame, &shot->pass, words, SLOTS, &error))
            fail_msg("%s", error.text);
    shot->result = aob_simulation_result(shot->simulation);
}

static void compare(const struct aob_profile *profile, enum aob_flight flight)
{
    struct shot shot;
    uint32_t *words = random_words(11);
    struct plain *plain = AOB_NEW(struct plain);
    struct aob_placed placed = aob_layout_level(profile, 4, TEXTURE, 100, 0);
    shoot(&shot, &(struct aob_simulation_desc){.profile = profile, .map = true, .map_flight = flight}, words,
          1);
    order(plain, profile, words, &placed, flight == AOB_FLIGHT_ONE ? 1 : (uint32_t)profile->in_flight);
    simulate(plain, profile, placed.size);
    const struct aob_cache_pass *pass = &shot.result->passes[0];
    for (int l = 0; l < profile->level_count; l++) {
        assert_int_equal(pass->levels[l][flight].accesses, plain->accesses[l]);
        assert_int_equal(pass->levels[l][flight].misses, plain->misses[l]);
        assert_int_equal(pass->levels[l][flight].compulsory, plain->compulsory[l]);
        if (l > 0)
            assert_int_equal(plain->accesses[l], pass->levels[l - 1][flight].misses);
    }
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        assert_int_equal(pass->map[i], plain->map[i]);
    aob_simulation_destroy(shot.simulation);
    free(plain->items);
    free(plain);
    free(words);
}

static void test_one_level(void **state)
{
    (void)state;
    struct aob_profile profile = made_profile();
    compare(&profile, AOB_FLIGHT_ONE);
    compare(&profile, AOB_FLIGHT_MOST);
}

static void test_three_levels(void **state)
{
    (void)state;
    struct aob_profile profile = three_levels();
    for (profile.in_flight = 1; profile.in_flight < 20; profile.in_flight += 6) {
        compare(&profile, AOB_FLIGHT_ONE);
        compare(&profile, AOB_FLIGHT_MOST);
    }
}

/* The first level begins each pass empty, the last one does not. What is written counts as bytes alone. */
static void test_two_passes(void **state)
{
    (void)state;
    struct shot shot;
    struct aob_profile profile = three_levels();
    uint32_t *words = random_words(12);
    profile.levels[2].size = 1 << 20;
    profile.levels[2].sets = 1024;
    shoot(&shot, &(struct aob_simulation_desc){.profile = &profile, .curve = AOB_CURVE_POWERS}, words, 2);
    const struct aob_cache_pass *first = &shot.result->passes[0], *second = &shot.result->passes[1],
                                *frame = &shot.result->frame;
    for (int f = 0; f < AOB_FLIGHT_COUNT; f++) {
        assert_memory_equal(&first->levels[0][f], &second->levels[0][f], sizeof first->levels[0][f]);
        assert_memory_equal(&first->levels[1][f], &second->levels[1][f], sizeof first->levels[1][f]);
        assert_true(first->levels[2][f].misses > 0);
        assert_int_equal(second->levels[2][f].misses, 0);
        assert_int_equal(second->levels[2][f].capacity, 0);
        assert_int_equal(frame->levels[2][f].misses, first->levels[2][f].misses);
        assert_int_equal(frame->levels[0][f].misses, 2 * first->levels[0][f].misses);
        assert_int_equal(aob_cache_filled(shot.result, frame, 2, (enum aob_flight)f),
                         128 * first->levels[2][f].misses);
    }
    assert_int_equal(first->bytes_written, WIDTH * HEIGHT * 8);
    assert_int_equal(frame->bytes_written, 2 * WIDTH * HEIGHT * 8);
    assert_int_equal(frame->pixels, WIDTH * HEIGHT);
    assert_int_equal(first->bytes_asked, 4 * first->texels);
    aob_simulation_destroy(shot.simulation);
    free(words);
}

/* The curve at the level's own size is compulsory + capacity, and both kinds of curve agree wherever both have a size. */
static void test_curves(void **state)
{
    (void)state;
    struct shot powers, every;
    struct aob_profile profile = three_levels();
    uint32_t *words = random_words(13);
    shoot(&powers, &(struct aob_simulation_desc){.profile = &profile, .curve = AOB_CURVE_POWERS}, words, 2);
    shoot(&every, &(struct aob_simulation_desc){.profile = &profile, .curve = AOB_CURVE_EVERY}, words, 2);
    for (int f = 0; f < AOB_FLIGHT_COUNT; f++) {
        const struct aob_curve *curve = &powers.result->frame.curves[f];
        for (size_t i = 0; i < curve->count; i++)
            assert_int_equal(curve->misses[i], aob_curve_at(&every.result->frame.curves[f], curve->lines[i]));
        for (int l = 0; l < profile.level_count; l++) {
            const struct aob_misses *a = &powers.result->frame.levels[l][f],
                                    *b = &every.result->frame.levels[l][f];
            assert_memory_equal(a, b, sizeof *a);
            assert_int_equal((int64_t)a->compulsory + a->capacity + a->conflict, a->misses);
            assert_true(a->capacity >= 0);
        }
        const struct aob_misses *first = &powers.result->frame.levels[0][f];
        assert_int_equal(aob_curve_at(curve, 16), first->compulsory + (uint64_t)first->capacity);
        assert_int_equal(curve->misses[curve->count - 1], first->compulsory);
    }
    aob_simulation_destroy(powers.simulation);
    aob_simulation_destroy(every.simulation);
    free(words);
}

/* A fan gives each of its sinks all. */
static void test_fan(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_profile one = made_profile(), three = three_levels();
    struct aob_simulation *simulations[2] = {
        aob_simulation_create(&(struct aob_simulation_desc){.profile = &one}),
        aob_simulation_create(&(struct aob_simulation_desc){.profile = &three})};
    struct aob_trace_sink sinks[2] = {aob_simulation_sink(simulations[0]),
                                      aob_simulation_sink(simulations[1])};
    struct aob_trace_fan fan = {sinks, 2};
    struct aob_trace_sink sink = aob_trace_fan_sink(&fan);
    struct shot alone;
    uint32_t *words = random_words(14);
    shoot(&alone, &(struct aob_simulation_desc){.profile = &three}, words, 1);
    assert_true(made_send(&sink, &alone.frame, &alone.pass, words, SLOTS, &error));
    const struct aob_cache_result *fanned = aob_simulation_result(simulations[1]);
    for (int l = 0; l < three.level_count; l++)
        assert_memory_equal(fanned->frame.levels[l], alone.result->frame.levels[l],
                            sizeof fanned->frame.levels[l]);
    assert_int_equal(aob_simulation_result(simulations[0])->frame.texels, fanned->frame.texels);
    aob_simulation_destroy(alone.simulation);
    for (int i = 0; i < 2; i++)
        aob_simulation_destroy(simulations[i]);
    free(words);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_level),  cmocka_unit_test(test_three_levels),
        cmocka_unit_test(test_two_passes), cmocka_unit_test(test_curves),
        cmocka_unit_test(test_fan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
