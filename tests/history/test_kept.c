/* What a history keeps besides figures: journal, raw rounds, modules; and how they go. Read back by SQL of its own. */
#include <sqlite3.h>
#include <zstd.h>
#include "base/hash.h"
#include "base/memory.h"
#include "night_folder.h"

static struct aob_history *history;

static int make(void **state)
{
    int made = night_folder_make(state);
    history = history_open(AOB_HISTORY_WRITE);
    return made;
}

static int remove_all(void **state)
{
    aob_history_close(history);
    return night_folder_remove(state);
}

/* Of one number, which a statement of its own connection asks for. */
static long long ask(const char *sql)
{
    sqlite3 *db = NULL;
    sqlite3_stmt *statement = NULL;
    assert_int_equal(sqlite3_open_v2(path, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, sql, -1, &statement, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    long long number = sqlite3_column_int64(statement, 0);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return number;
}

/* The bytes of one value; free() them. */
static char *ask_bytes(const char *sql, size_t *size)
{
    sqlite3 *db = NULL;
    sqlite3_stmt *statement = NULL;
    assert_int_equal(sqlite3_open_v2(path, &db, SQLITE_OPEN_READONLY, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_prepare_v2(db, sql, -1, &statement, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_step(statement), SQLITE_ROW);
    *size = (size_t)sqlite3_column_bytes(statement, 0);
    char *bytes = aob_alloc(*size + 1, 1);
    memcpy(bytes, sqlite3_column_blob(statement, 0), *size);
    sqlite3_finalize(statement);
    sqlite3_close(db);
    return bytes;
}

static void test_journal_whole(void **state)
{
    (void)state;
    json_t *records[] = {record_make(1, 2), record_make(2, 3)};
    json_object_set_new(records[1], "member of a later program", json_integer(1));
    journal_write(records, 2);
    night_keep(history, "nightly", true);
    size_t size, packed_size;
    char *file = aob_path_join(folder, "journal.jsonl");
    char *bytes = aob_file_read(file, 1 << 20, &size, &error);
    char *packed = ask_bytes("SELECT zstd FROM journal WHERE night = 1", &packed_size);
    char *unpacked = aob_alloc(size, 1);
    assert_int_equal(ask("SELECT size FROM journal"), size);
    assert_int_equal(ZSTD_decompress(unpacked, size, packed, packed_size), size);
    assert_memory_equal(bytes, unpacked, size);
    free(file);
    free(bytes);
    free(packed);
    free(unpacked);
}

static json_t *record_with_rounds(int series, const char *file)
{
    json_t *record = record_make(series, 2);
    record_set(json_object_get(record, "time"), "rounds_file", file);
    return record;
}

/* Four cases of three files: one is good, one was damaged, one is gone. */
static void test_rounds(void **state)
{
    (void)state;
    json_t *records[] = {
        record_with_rounds(1, "rounds/a.jsonl.zst"), record_with_rounds(2, "rounds/a.jsonl.zst"),
        record_with_rounds(3, "rounds/b.jsonl.zst"), record_with_rounds(4, "rounds/c.jsonl.zst")};
    char *rounds = aob_path_join(folder, "rounds"), *a = aob_path_join(rounds, "a.jsonl.zst");
    assert_int_equal(mkdir(rounds, 0755), 0);
    assert_true(aob_sealed_write(a, &(struct aob_piece){"the rounds", 10}, 1, &error));
    write_file("rounds/b.jsonl.zst", "no seal", 7);
    journal_write(records, 4);
    night_keep(history, "nightly", true);
    size_t size, kept_size;
    char *bytes = aob_file_read(a, 1 << 20, &size, &error);
    char *kept = ask_bytes("SELECT bytes FROM rounds WHERE file = 'rounds/a.jsonl.zst'", &kept_size);
    assert_int_equal(ask("SELECT count(*) FROM rounds"), 1);
    assert_int_equal(kept_size, size);
    assert_memory_equal(bytes, kept, size);
    free(bytes);
    free(kept);
    free(rounds);
    free(a);
}

static json_t *technique_of(const char *module, const char *digest)
{
    json_t *technique = json_of(technique_text);
    record_set(technique, "module", module);
    record_set(technique, "digest", digest);
    return technique;
}

/* A night of one module with these bytes, which the run is said to have measured as `digest`. */
static void keep_module(const char *bytes, const char *digest)
{
    json_t *record = record_make(1, 2);
    char *module = aob_path_join(folder, "a.so");
    record_set(record, "module", module);
    write_file("a.so", bytes, strlen(bytes));
    journal_write(&record, 1);
    info_write(json_pack("[o]", technique_of(module, digest)));
    night_keep(history, "nightly", true);
    free(module);
}

static void test_modules(void **state)
{
    (void)state;
    char digest[AOB_KEY_SIZE], other[AOB_KEY_SIZE];
    char *out = aob_path_join(place, "out.so");
    aob_hash_text("the module", digest);
    aob_hash_text("the next one", other);
    stderr_begin();
    keep_module("the module", digest);
    keep_module("the module", digest);
    char *calm = stderr_end();
    assert_string_equal(calm, "");
    free(calm);
    assert_int_equal(ask("SELECT count(*) FROM module"), 1);
    assert_int_equal(ask("SELECT count(*) FROM measured WHERE technique = 'gtao'"), 2);
    stderr_begin();
    keep_module("was built anew", other); /* its bytes are no longer those that were measured */
    char *said = stderr_end();
    assert_contains(said,
                    "/a.so: is not there any more as it was measured; the history keeps no file of this");
    assert_ptr_equal(strchr(said, '\n'), said + strlen(said) - 1);
    free(said);
    assert_int_equal(ask("SELECT count(*) FROM module"), 1);
    assert_true(aob_night_module_write(history, digest, out, &error));
    size_t size;
    char *bytes = aob_file_read(out, 1 << 20, &size, &error);
    assert_string_equal(bytes, "the module");
    free(bytes);
    assert_false(aob_night_module_write(history, other, out, &error));
    assert_contains(error.text, "keeps no module of the build");
    free(out);
}

/* A module of a config is seen from the config's folder, wherever the program works. */
static void test_module_of_a_config(void **state)
{
    (void)state;
    char digest[AOB_KEY_SIZE];
    json_t *record = record_make(1, 2);
    aob_hash_text("the module", digest);
    record_set(record, "module", "build/a.so");
    journal_write(&record, 1);
    char *build = aob_path_join(folder, "build"), *config = aob_path_join(folder, "nightly.yaml");
    assert_int_equal(mkdir(build, 0755), 0);
    write_file("build/a.so", "the module", 10);
    json_t *info =
        json_pack("{s:s, s:[o]}", "config", config, "techniques", technique_of("build/a.so", digest));
    char *text = json_dumps(info, 0);
    write_file("run.json", text, strlen(text));
    night_keep(history, "nightly", true);
    assert_int_equal(ask("SELECT size FROM module"), 10);
    free(text);
    free(build);
    free(config);
    json_decref(info);
}

/* A night of a module of these bytes. */
static void keep_night_of(const char *module)
{
    char digest[AOB_KEY_SIZE];
    aob_hash_text(module, digest);
    keep_module(module, digest);
}

static void test_prune(void **state)
{
    (void)state;
    struct aob_prune pruned;
    keep_night_of("first");
    keep_night_of("second");
    keep_night_of("second");
    run_write(2, 2);
    night_keep(history, "weekly", true);
    assert_false(aob_nights_prune(history, 0, false, &pruned, &error));
    assert_contains(error.text, "at least one night of each config is kept");
    assert_int_equal(ask("SELECT count(*) FROM night"), 4);
    assert_true(aob_nights_prune(history, 2, false, &pruned, &error));
    assert_int_equal(pruned.nights, 1);
    assert_int_equal(pruned.points, 1);
    assert_int_equal(ask("SELECT count(*) FROM night"), 3);
    assert_int_equal(ask("SELECT min(id) FROM night"), 2);
    assert_int_equal(ask("SELECT count(*) FROM module"), 1); /* nobody names the first any more */
    assert_int_equal(ask("SELECT count(*) FROM figures"), 4);
    assert_int_equal(ask("SELECT count(*) FROM journal"), 3);
    assert_true(aob_nights_prune(history, 1, false, &pruned, &error));
    assert_int_equal(pruned.nights, 1);
    assert_int_equal(ask("SELECT count(*) FROM night WHERE name = 'weekly'"), 1);
    assert_int_equal(ask("SELECT count(*) FROM night WHERE name = 'nightly'"), 1);
    assert_int_equal(ask("SELECT count(*) FROM line"), 3);
    assert_true(aob_nights_prune(history, 1, false, &pruned, &error));
    assert_int_equal(pruned.nights, 0);
    assert_int_equal(night_keep(history, "nightly", true), 5); /* no id is given twice */
}

/* A night that ended with nothing takes no good one's place, and none that is open goes. */
static void test_prune_empty_nights(void **state)
{
    (void)state;
    struct aob_prune pruned;
    for (int night = 1; night <= 4; night++) {
        run_write(night < 3 ? 2 : 0, 2);
        night_keep(history, "nightly", night < 4);
    }
    assert_true(aob_nights_prune(history, 1, true, &pruned, &error));
    assert_int_equal(pruned.nights, 1);
    assert_int_equal(ask("SELECT min(night) FROM journal"), 2);
    assert_true(aob_nights_prune(history, 1, false, &pruned, &error));
    assert_int_equal(pruned.nights, 1);
    assert_int_equal(pruned.points, 2);
    assert_int_equal(ask("SELECT min(id) FROM night"), 2);
    assert_int_equal(ask("SELECT count(*) FROM night"), 3);
    assert_int_equal(ask("SELECT count(*) FROM point WHERE night = 2"), 2);
    run_write(2, 2);
    night_keep(history, "nightly", true);
    assert_true(aob_nights_prune(history, 1, false, &pruned, &error));
    assert_int_equal(pruned.nights, 2);
    assert_int_equal(ask("SELECT min(id) FROM night"), 4); /* it has not ended */
    assert_int_equal(ask("SELECT max(id) FROM night"), 5);
}

static void test_prune_rounds(void **state)
{
    (void)state;
    struct aob_prune pruned;
    char *rounds = aob_path_join(folder, "rounds"), *a = aob_path_join(rounds, "a.jsonl.zst");
    char *noise = aob_alloc(1 << 20, 1);
    for (int i = 0; i < 1 << 20; i++)
        noise[i] = (char)((unsigned)i * 7919u >> 3);
    assert_int_equal(mkdir(rounds, 0755), 0);
    assert_true(aob_sealed_write(a, &(struct aob_piece){noise, 1 << 20}, 1, &error));
    for (int night = 0; night < 3; night++) {
        json_t *record = record_with_rounds(1, "rounds/a.jsonl.zst");
        journal_write(&record, 1);
        night_keep(history, "nightly", true);
    }
    assert_true(aob_nights_prune(history, 1, true, &pruned, &error));
    assert_int_equal(pruned.nights, 2);
    assert_int_equal(pruned.points, 0);
    assert_true(pruned.bytes >= 2 << 20);
    assert_true(aob_file_size(path) < 2 << 20);
    assert_int_equal(ask("SELECT count(*) FROM point"), 3);
    assert_int_equal(ask("SELECT count(*) FROM rounds WHERE night = 3"), 1);
    assert_int_equal(ask("SELECT count(*) FROM rounds"), 1);
    assert_int_equal(ask("SELECT count(*) FROM journal"), 1);
    assert_true(aob_nights_prune(history, 1, true, &pruned, &error));
    assert_int_equal(pruned.nights, 0);
    free(noise);
    free(rounds);
    free(a);
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, make, remove_all)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_journal_whole),
        TEST(test_rounds),
        TEST(test_modules),
        TEST(test_module_of_a_config),
        TEST(test_prune_empty_nights),
        TEST(test_prune),
        TEST(test_prune_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
