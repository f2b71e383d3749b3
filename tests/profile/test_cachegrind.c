/* The misses of valgrind's cachegrind: another simulator, of a program that really runs. Each stream is touched by a
 * function of its own; of what cachegrind counts in it, the line of the source that reads once an access counts. */
#include <unistd.h>
#include "check.h"
#include "profile/tags.h"
#include "replay.h"
#include "streams.h"

struct found { /* of each stream */
    uint64_t misses[REPLAY_COUNT];
    bool there[REPLAY_COUNT];
};
struct columns {
    int reads, misses;
};

/* "events: Ir I1mr ..." */
static struct columns find_columns(char *line)
{
    struct columns columns = {-1, -1};
    char *rest = line, *name;
    strsep(&rest, " \n");
    for (int c = 0; (name = strsep(&rest, " \n")); c++) {
        if (strcmp(name, "Dr") == 0)
            columns.reads = c;
        if (strcmp(name, "D1mr") == 0)
            columns.misses = c;
    }
    return columns;
}

/* "LINE Ir I1mr ..." */
static void take_counts(struct found *found, int kind, struct columns columns, char *line)
{
    uint64_t counts[16] = {0};
    char *rest;
    strtoull(line, &rest, 10);
    for (int c = 0; c < 16; c++)
        counts[c] = strtoull(rest, &rest, 10);
    if (counts[columns.reads] != REPLAY_ACCESSES)
        return;
    assert_false(found->there[kind]);
    found->there[kind] = true;
    found->misses[kind] = counts[columns.misses];
}

static void read_counts(const char *path, struct found *found)
{
    char line[1024];
    int kind = -1;
    struct columns columns = {-1, -1};
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, "events:", 7) == 0)
            columns = find_columns(line);
        else if (strncmp(line, "fn=", 3) == 0)
            kind = sscanf(line, "fn=touch_%d", &kind) == 1 ? kind : -1;
        else if (kind >= 0 && kind < REPLAY_COUNT && *line >= '0' && *line <= '9')
            take_counts(found, kind, columns, line);
    }
    fclose(file);
    assert_true(columns.reads >= 0 && columns.misses >= 0);
}

static void run_cachegrind(uint32_t size, uint32_t ways, uint32_t line, struct found *found)
{
    char path[] = "/tmp/aobudget-cachegrind-XXXXXX", command[1024];
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    snprintf(command, sizeof command,
             "valgrind --tool=cachegrind --D1=%u,%u,%u --cachegrind-out-file=%s '%s/tests/replay' %u "
             ">/dev/null 2>&1",
             size, ways, line, path, getenv("AOBUDGET_BUILD"), line);
    int code = system(command);
    if (code)
        fail_msg("code %d of: %s; ./dev installs valgrind", code, command);
    read_counts(path, found);
    unlink(path);
}

static void test_misses(void **state)
{
    (void)state;
    static const uint32_t caches[][3] = {{16384, 4, 64}, {12288, 3, 64},  {32768, 8, 64},
                                         {8192, 1, 32},  {24576, 12, 64}, {16384, 256, 64}};
    assert_non_null(getenv("AOBUDGET_BUILD"));
    for (size_t c = 0; c < AOB_COUNT(caches); c++) {
        uint32_t size = caches[c][0], ways = caches[c][1], line = caches[c][2];
        struct found found = {{0}, {false}};
        run_cachegrind(size, ways, line, &found);
        for (int kind = 0; kind < REPLAY_COUNT; kind++) {
            struct aob_tags *tags = aob_tags_create(
                &(struct aob_tags_desc){.sets = size / line / ways, .ways = ways, .numbers = REPLAY_LINES});
            uint64_t misses = 0;
            for (uint32_t i = 0; i < REPLAY_ACCESSES; i++) {
                uint32_t number = replay_line(kind, i);
                misses += aob_tags_access(tags, &number, 1, NULL);
            }
            aob_tags_destroy(tags);
            assert_true(found.there[kind]);
            assert_int_equal(misses, found.misses[kind]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_misses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
