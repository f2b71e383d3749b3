#include "rounds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zstd.h>
#include "base/json.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "base/text.h"

void aob_rounds_finish(struct aob_round_list *rounds)
{
    free(rounds->items);
    *rounds = (struct aob_round_list){0};
}

static double frame_ms(const struct aob_spent *spent, int frames, enum aob_clock clock)
{
    int64_t ns = spent->ns[clock];
    return ns == AOB_NO_TIME ? NAN : fmax((double)ns * 1e-6 / frames, 1e-9);
}

double aob_slot_ms(const struct aob_slot *slot, enum aob_clock clock)
{
    return frame_ms(&slot->whole, slot->frames, clock);
}

double aob_slot_pass_ms(const struct aob_slot *slot, size_t pass, enum aob_clock clock)
{
    return frame_ms(&slot->passes[pass], slot->frames, clock);
}

bool aob_slot_is_clean(const struct aob_slot *slot)
{
    return slot->causes.involuntary == 0 && slot->causes.steal_ticks <= 0;
}

double aob_round_seconds(const struct aob_round *round)
{
    double ns = 0;
    for (size_t s = 0; s < round->slot_count; s++)
        ns += (double)round->slots[s].whole.ns[AOB_CLOCK_WALL];
    return ns * 1e-9;
}

bool aob_round_fits(const struct aob_round *round, const struct aob_round *first)
{
    bool same = round->slot_count == first->slot_count && round->clock == first->clock;
    for (size_t i = 0; same && i < first->slot_count; i++)
        same = round->slots[i].pass_count == first->slots[i].pass_count;
    return same;
}

static const char *const clock_members[AOB_CLOCK_COUNT] = {"cpu_ns", "wall_ns", "device_ns"};
static const struct {
    const char *name;
    size_t offset;
} cause_members[] = {
    {"involuntary", offsetof(struct aob_causes, involuntary)},
    {"voluntary", offsetof(struct aob_causes, voluntary)},
    {"minor_faults", offsetof(struct aob_causes, minor_faults)},
    {"major_faults", offsetof(struct aob_causes, major_faults)},
    {"steal_ticks", offsetof(struct aob_causes, steal_ticks)},
};
_Static_assert(AOB_NO_TIME == AOB_CAUSE_UNKNOWN, "one number stands for null");

static json_t *count_to_json(int64_t count)
{
    return count == AOB_NO_TIME ? json_null() : json_integer(count);
}

static bool count_from_json(const json_t *value, int64_t *count)
{
    *count = json_is_null(value) ? AOB_NO_TIME : json_integer_value(value);
    return json_is_null(value) || (json_is_integer(value) && *count >= 0);
}

static int64_t *cause_of(struct aob_causes *causes, size_t i)
{
    return (int64_t *)(void *)((char *)causes + cause_members[i].offset);
}

static json_t *passes_to_json(const struct aob_slot *slot)
{
    json_t *passes = json_object();
    for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++) {
        json_t *times = json_array();
        for (size_t p = 0; p < slot->pass_count; p++)
            json_array_append_new(times, count_to_json(slot->passes[p].ns[clock]));
        json_object_set_new(passes, clock_members[clock], times);
    }
    return passes;
}

static json_t *slot_to_json(const struct aob_slot *slot)
{
    struct aob_causes causes = slot->causes;
    json_t *object = json_pack("{s:i, s:i}", "place", slot->place, "frames", slot->frames);
    for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++)
        json_object_set_new(object, clock_members[clock], count_to_json(slot->whole.ns[clock]));
    json_object_set_new(object, "passes", passes_to_json(slot));
    for (size_t i = 0; i < AOB_COUNT(cause_members); i++)
        json_object_set_new(object, cause_members[i].name, count_to_json(*cause_of(&causes, i)));
    return object;
}

json_t *aob_round_to_json(const struct aob_round *round)
{
    json_t *slots = json_array();
    for (size_t i = 0; i < round->slot_count; i++)
        json_array_append_new(slots, slot_to_json(&round->slots[i]));
    return json_pack("{s:i, s:i, s:I, s:s, s:o}", "process", round->process, "round", round->number, "seed",
                     (json_int_t)round->seed, "clock", aob_clock_name(round->clock), "slots", slots);
}

static bool passes_from_json(const json_t *object, struct aob_slot *slot)
{
    slot->pass_count = json_array_size(json_object_get(object, clock_members[0]));
    if (slot->pass_count > AOB_MAX_PASS)
        return false;
    for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++) {
        const json_t *times = json_object_get(object, clock_members[clock]);
        if (json_array_size(times) != slot->pass_count)
            return false;
        for (size_t p = 0; p < slot->pass_count; p++)
            if (!count_from_json(json_array_get(times, p), &slot->passes[p].ns[clock]))
                return false;
    }
    return true;
}

static bool slot_from_json(const json_t *object, struct aob_slot *slot)
{
    slot->place = (int)json_integer_value(json_object_get(object, "place"));
    slot->frames = (int)json_integer_value(json_object_get(object, "frames"));
    for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++)
        if (!count_from_json(json_object_get(object, clock_members[clock]), &slot->whole.ns[clock]))
            return false;
    for (size_t i = 0; i < AOB_COUNT(cause_members); i++)
        if (!count_from_json(json_object_get(object, cause_members[i].name), cause_of(&slot->causes, i)))
            return false;
    return slot->frames > 0 && passes_from_json(json_object_get(object, "passes"), slot);
}

bool aob_round_from_json(const json_t *object, struct aob_round *round, struct aob_error *error)
{
    const json_t *slots = json_object_get(object, "slots");
    *round = (struct aob_round){.process = (int)json_integer_value(json_object_get(object, "process")),
                                .number = (int)json_integer_value(json_object_get(object, "round")),
                                .seed = (uint32_t)json_integer_value(json_object_get(object, "seed")),
                                .slot_count = json_array_size(slots)};
    if (round->slot_count <= AOB_SLOT_CASES || round->slot_count > AOB_SLOT_MAX)
        return aob_fail(error, "a round has %zu slots", round->slot_count);
    if (!aob_clock_find(json_string_value(json_object_get(object, "clock")), &round->clock))
        return aob_fail(error, "a round has no clock");
    for (size_t i = 0; i < round->slot_count; i++) {
        struct aob_slot *slot = &round->slots[i];
        if (!slot_from_json(json_array_get(slots, i), slot))
            return aob_fail(error, "slot %zu of a round lacks a figure", i);
        if (slot->whole.ns[round->clock] == AOB_NO_TIME)
            return aob_fail(error, "slot %zu of a round has no time by its clock", i);
    }
    return true;
}

/* A frame that every reader of zstd skips; the seal is its content. */
static const unsigned char seal_frame[8] = {0x50, 0x2a, 0x4d, 0x18, AOB_SEAL_SIZE, 0, 0, 0};

bool aob_rounds_write(const struct aob_round_list *rounds, const char *path, struct aob_error *error)
{
    struct aob_text text = {0};
    for (size_t i = 0; i < rounds->count; i++) {
        json_t *round = aob_round_to_json(&rounds->items[i]);
        char *line = aob_json_line(round, 17);
        aob_text_add(&text, "%s\n", line);
        free(line);
        json_decref(round);
    }
    size_t bound = ZSTD_compressBound(text.size);
    void *packed = aob_alloc(bound, 1);
    size_t size = ZSTD_compress(packed, bound, text.data, text.size, 3);
    bool ok =
        ZSTD_isError(size)
            ? aob_fail(error, "%s: cannot compress: %s", path, ZSTD_getErrorName(size))
            : aob_sealed_write(path, (struct aob_piece[]){{packed, size}, {seal_frame, sizeof seal_frame}}, 2,
                               error);
    free(packed);
    aob_text_finish(&text);
    return ok;
}

static bool read_line(const char *line, struct aob_round_list *rounds, struct aob_error *error)
{
    struct aob_round *round = AOB_PUSH(rounds->items, rounds->count, rounds->capacity);
    json_t *object = json_loads(line, JSON_REJECT_DUPLICATES, NULL);
    bool ok = object ? aob_round_from_json(object, round, error) : aob_fail(error, "it is no JSON");
    json_decref(object);
    return ok && (aob_round_fits(round, &rounds->items[0]) || aob_fail(error, "it is of another block"));
}

/* A file that is read line by line, so that it may be as long as a run makes it. */
struct reader {
    const char *path;
    struct aob_round_list *rounds;
    struct aob_text line; /* as much of it as was unpacked */
};
enum { LINE_MOST = 1 << 20 };

static bool take_line(struct reader *reader, struct aob_error *error)
{
    bool ok = !reader->line.size || read_line(reader->line.data, reader->rounds, error);
    aob_text_finish(&reader->line);
    return ok || aob_fail_in(error, "%s:%zu", reader->path, reader->rounds->count);
}

static bool take_bytes(struct reader *reader, const char *bytes, size_t size, struct aob_error *error)
{
    while (size) {
        const char *end = memchr(bytes, '\n', size);
        size_t part = end ? (size_t)(end - bytes) : size;
        if (reader->line.size + part > LINE_MOST)
            return aob_fail(error, "%s: it holds no rounds: a line has more than %d bytes", reader->path,
                            LINE_MOST);
        aob_text_add_bytes(&reader->line, bytes, part);
        if (end && !take_line(reader, error))
            return false;
        bytes += end ? part + 1 : part;
        size -= end ? part + 1 : part;
    }
    return true;
}

static bool unpack(struct reader *reader, ZSTD_DStream *stream, const char *packed, size_t size,
                   struct aob_error *error)
{
    char bytes[1 << 14];
    ZSTD_inBuffer in = {packed, size, 0};
    size_t left;
    do {
        ZSTD_outBuffer out = {bytes, sizeof bytes, 0};
        size_t before = in.pos;
        left = ZSTD_decompressStream(stream, &out, &in);
        if (ZSTD_isError(left) || (left && !out.pos && in.pos == before))
            return aob_fail(error, "%s: it holds no rounds: cannot decompress: %s", reader->path,
                            ZSTD_isError(left) ? ZSTD_getErrorName(left) : "it is cut");
        if (!take_bytes(reader, bytes, out.pos, error))
            return false;
    } while (left);
    return take_line(reader, error) &&
           (reader->rounds->count || aob_fail(error, "%s: it holds no rounds", reader->path));
}

static bool read_packed(const char *packed, size_t size, const char *path, struct aob_round_list *rounds,
                        struct aob_error *error)
{
    struct reader reader = {.path = path, .rounds = rounds};
    ZSTD_DStream *stream = ZSTD_createDStream();
    bool ok = unpack(&reader, stream, packed, size, error);
    ZSTD_freeDStream(stream);
    aob_text_finish(&reader.line);
    return ok;
}

bool aob_rounds_read(const char *path, struct aob_round_list *rounds, struct aob_error *error)
{
    size_t size;
    *rounds = (struct aob_round_list){0};
    char *packed = aob_sealed_read(path, &size, error);
    bool framed = packed && size > sizeof seal_frame;
    if (packed && !framed)
        aob_fail(error, "%s: it holds no rounds", path);
    bool ok = framed && read_packed(packed, size - sizeof seal_frame, path, rounds, error);
    if (!ok)
        aob_rounds_finish(rounds);
    free(packed);
    return ok;
}
