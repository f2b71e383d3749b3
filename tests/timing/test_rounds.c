#include "check.h"
#include <stdlib.h>
#include <unistd.h>
#include <zstd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "base/text.h"
#include "script.h"
#include "timing/summary.h"

/* Raw rounds on their way through a file: what comes back is what was measured, so the figures of a record can be made of
 * it again, and what is no longer that is refused. */

static char folder[] = "/tmp/aobudget-rounds-XXXXXX", *path;

static int set_up(void **state)
{
    (void)state;
    path = mkdtemp(folder) ? aob_path_join(folder, "a.jsonl.zst") : NULL;
    return path ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    unlink(path);
    free(path);
    return rmdir(folder);
}

static double uneven(const struct script *s, int index, int round)
{
    return 4 + 0.01 * ((7 * round + 3 * index + 5 * s->process) % 11);
}

static struct aob_causes disturbed(const struct script *s, int index, int round)
{
    return (struct aob_causes){.involuntary = (round + index + s->process) % 3 == 0,
                               .minor_faults = round % 5};
}

static void measure(struct aob_processes *result)
{
    struct script_processes processes = {
        .cpu_ms = uneven, .cause = disturbed, .precision = 0.03, .fate = ".x"};
    const struct aob_processes_desc desc = {.case_count = SCRIPT_CASES,
                                            .seconds = 1,
                                            .precision = 0.03,
                                            .seed = 0xfedcba98,
                                            .run = script_process,
                                            .on_lost = script_lost,
                                            .user = &processes};
    assert_true(aob_processes_run(&desc, result, NULL));
    /* every kind of figure is there, and what may be unknown is so once */
    struct aob_slot *slot = &result->rounds.items[1].slots[3];
    slot->causes = (struct aob_causes){1, 2, 3, 4, AOB_CAUSE_UNKNOWN};
    slot->whole.ns[AOB_CLOCK_DEVICE] = 123456789012345;
    slot->passes[1].ns[AOB_CLOCK_DEVICE] = 7;
}

static void check_slot(const struct aob_slot *a, const struct aob_slot *b)
{
    assert_int_equal(a->place, b->place);
    assert_int_equal(a->frames, b->frames);
    assert_memory_equal(&a->whole, &b->whole, sizeof a->whole);
    assert_int_equal(a->pass_count, b->pass_count);
    assert_memory_equal(a->passes, b->passes, b->pass_count * sizeof *b->passes);
    assert_memory_equal(&a->causes, &b->causes, sizeof a->causes);
}

static void check_times(const struct aob_times *a, const struct aob_times *b)
{
    for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++)
        assert_true(a->ms[clock] == b->ms[clock] ||
                    (a->ms[clock] != a->ms[clock] && b->ms[clock] != b->ms[clock]));
}

static void check_ratio(struct aob_ratio a, struct aob_ratio b)
{
    assert_true(a.ratio == b.ratio && a.low == b.low && a.high == b.high && a.bounded == b.bounded);
}

/* To the last bit. */
static void check_summary(const struct aob_round_list *a, const struct aob_round_list *b, size_t slot)
{
    struct aob_summary p, q;
    aob_summarise(a, slot, &p);
    aob_summarise(b, slot, &q);
    check_times(&p.whole, &q.whole);
    check_ratio(p.to_fixed, q.to_fixed);
    assert_int_equal(p.processes, 3);
    assert_int_equal(q.processes, 3);
    assert_int_equal(p.rounds, q.rounds);
    assert_int_equal(p.clean_rounds, q.clean_rounds);
    assert_int_equal(p.pass_count, q.pass_count);
    for (size_t i = 0; i < p.pass_count; i++) {
        check_times(&p.passes[i], &q.passes[i]);
        check_ratio(p.pass_to_fixed[i], q.pass_to_fixed[i]);
    }
}

static void test_round_trip(void **state)
{
    (void)state;
    struct aob_processes measured;
    struct aob_round_list back;
    struct aob_error error = {{0}};
    measure(&measured);
    assert_true(aob_rounds_write(&measured.rounds, path, &error));
    assert_true(aob_rounds_read(path, &back, &error));
    assert_int_equal(back.count, measured.rounds.count);
    for (size_t r = 0; r < back.count; r++) {
        const struct aob_round *a = &back.items[r], *b = &measured.rounds.items[r];
        assert_true(a->process == b->process && a->number == b->number && a->seed == b->seed &&
                    a->clock == b->clock && a->slot_count == b->slot_count);
        for (size_t s = 0; s < b->slot_count; s++)
            check_slot(&a->slots[s], &b->slots[s]);
    }
    for (size_t s = 0; s < SCRIPT_SLOTS; s++)
        check_summary(&back, &measured.rounds, s);
    aob_rounds_finish(&back);
    aob_processes_finish(&measured);
}

/* Other programs read it: zstd takes the seal for a frame that it skips, and each line is a round. */
static void test_is_plain_zstd(void **state)
{
    (void)state;
    struct aob_processes measured;
    size_t size, lines = 0;
    measure(&measured);
    assert_true(aob_rounds_write(&measured.rounds, path, NULL));
    char *bytes = aob_file_read(path, 1 << 24, &size, NULL), *text = aob_alloc(1 << 24, 1);
    size_t got = ZSTD_decompress(text, 1 << 24, bytes, size);
    assert_false(ZSTD_isError(got));
    text[got] = '\0'; /* what lies behind may be anything */
    for (const char *line = text; *line; line = strchr(line, '\n') + 1) {
        json_t *round = json_loads(line, JSON_DISABLE_EOF_CHECK, NULL);
        assert_int_equal(json_integer_value(json_object_get(round, "process")),
                         measured.rounds.items[lines++].process);
        json_decref(round);
    }
    assert_int_equal(lines, measured.rounds.count);
    free(text);
    free(bytes);
    aob_processes_finish(&measured);
}

static void refuse(const char *cause)
{
    struct aob_round_list rounds;
    struct aob_error error = {{0}};
    assert_false(aob_rounds_read(path, &rounds, &error));
    assert_contains(error.text, path);
    assert_contains(error.text, cause);
    assert_true(!rounds.items && !rounds.count);
}

static void test_damage_is_told(void **state)
{
    (void)state;
    struct aob_processes measured;
    size_t size;
    unlink(path);
    refuse("No such file");
    measure(&measured);
    assert_true(aob_rounds_write(&measured.rounds, path, NULL));
    char *bytes = aob_file_read(path, 1 << 24, &size, NULL);
    bytes[size / 2] ^= 1;
    assert_true(aob_file_write(path, bytes, size, NULL));
    refuse("it is damaged");
    bytes[size / 2] ^= 1;
    assert_true(aob_file_write(path, bytes, size - 50, NULL));
    refuse("it was cut");
    free(bytes);
    aob_processes_finish(&measured);
}

/* A sealed file of these lines, as aob_rounds_write lays it out. */
static void write_lines(const char *text)
{
    static const unsigned char seal_frame[8] = {0x50, 0x2a, 0x4d, 0x18, 40, 0, 0, 0};
    char packed[4096];
    size_t size = ZSTD_compress(packed, sizeof packed, text, strlen(text), 1);
    const struct aob_piece pieces[] = {{packed, size}, {seal_frame, sizeof seal_frame}};
    assert_true(aob_sealed_write(path, pieces, 2, NULL));
}

#define SLOT(frames, ns)                                                                                     \
    "{\"place\":0,\"frames\":" frames ",\"cpu_ns\":" ns                                                      \
    ",\"wall_ns\":2,\"device_ns\":null,\"passes\":{\"cpu_ns\":[],\"wall_ns\":[],\"device_ns\":[]},"          \
    "\"involuntary\":0,\"voluntary\":0,\"minor_faults\":0,\"major_faults\":0,\"steal_ticks\":null}"
#define ROUND(clock, slots)                                                                                  \
    "{\"process\":0,\"round\":0,\"seed\":1,\"clock\":\"" clock "\",\"slots\":[" slots "]}\n"
#define THREE SLOT("1", "5") "," SLOT("1", "5") "," SLOT("1", "5")

static void test_content_is_judged(void **state)
{
    (void)state;
    static const struct {
        const char *text, *cause;
    } rows[] = {
        {"", "no rounds"},
        {"{", "a.jsonl.zst:1: it is no JSON"},
        {"{}\n", ":1: a round has 0 slots"},
        {ROUND("cpu", SLOT("1", "5")), ":1: a round has 1 slots"},
        {ROUND("sun", THREE), ":1: a round has no clock"},
        {ROUND("cpu", THREE) ROUND("cpu", THREE "," SLOT("1", "5")), ":2: it is of another block"},
        {ROUND("cpu", THREE) ROUND("wall", THREE), ":2: it is of another block"},
        {ROUND("device", THREE), "slot 0 of a round has no time by its clock"},
        {ROUND("cpu", SLOT("0", "5") "," THREE), "slot 0 of a round lacks a figure"},
        {ROUND("cpu", THREE "," SLOT("1", "-5")), "slot 3 of a round lacks a figure"},
        {ROUND("cpu", THREE "," SLOT("1", "true")), "slot 3 of a round lacks a figure"},
    };
    struct aob_round_list rounds;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        write_lines(rows[i].text);
        refuse(rows[i].cause);
    }
    write_lines(ROUND("cpu", THREE));
    assert_true(aob_rounds_read(path, &rounds, NULL));
    aob_rounds_finish(&rounds);
    assert_true(aob_sealed_write(path, &(struct aob_piece){"x", 1}, 1, NULL));
    refuse("no rounds");
    assert_true(aob_sealed_write(path, &(struct aob_piece){"no zstd, and long enough", 24}, 1, NULL));
    refuse("no rounds");
}

/* By a writer that does not say how long it is. */
static void write_stream(const struct aob_text *text)
{
    static const unsigned char seal_frame[8] = {0x50, 0x2a, 0x4d, 0x18, 40, 0, 0, 0};
    size_t room = ZSTD_compressBound(text->size);
    char *packed = aob_alloc(room, 1);
    ZSTD_CStream *stream = ZSTD_createCStream();
    ZSTD_outBuffer out = {packed, room, 0};
    ZSTD_inBuffer in = {text->data, text->size, 0};
    while (in.pos < in.size)
        assert_false(ZSTD_isError(ZSTD_compressStream(stream, &out, &in)));
    assert_int_equal(ZSTD_endStream(stream, &out), 0);
    ZSTD_freeCStream(stream);
    assert_true(ZSTD_getFrameContentSize(packed, out.pos) == ZSTD_CONTENTSIZE_UNKNOWN);
    const struct aob_piece pieces[] = {{packed, out.pos}, {seal_frame, sizeof seal_frame}};
    assert_true(aob_sealed_write(path, pieces, 2, NULL));
    free(packed);
}

/* A file may be of any length: its lines run over the borders of what is unpacked at a time. */
static void test_any_length(void **state)
{
    (void)state;
    enum { LINES = 3000 };
    struct aob_text text = {0};
    struct aob_round_list rounds;
    for (int k = 0; k < LINES; k++)
        aob_text_add(&text, "%s", ROUND("cpu", THREE));
    write_stream(&text);
    assert_true(aob_rounds_read(path, &rounds, NULL));
    assert_int_equal(rounds.count, LINES);
    for (size_t r = 0; r < LINES; r++)
        assert_true(rounds.items[r].slot_count == 3 && rounds.items[r].slots[2].whole.ns[AOB_CLOCK_CPU] == 5);
    aob_rounds_finish(&rounds);
    aob_text_finish(&text);
}

/* But a line has a bound, as a small file of one endless line would otherwise take all memory. */
static void test_endless_line(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "%s%*s", ROUND("cpu", THREE), 1100000, "");
    write_stream(&text);
    refuse("a line has more than 1048576 bytes");
    aob_text_finish(&text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip),     cmocka_unit_test(test_is_plain_zstd),
        cmocka_unit_test(test_damage_is_told), cmocka_unit_test(test_content_is_judged),
        cmocka_unit_test(test_any_length),     cmocka_unit_test(test_endless_line)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
