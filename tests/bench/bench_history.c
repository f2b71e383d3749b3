/* bench_history RUN WORK NIGHTS CASES: how long a history takes to grow and to read. The nights are of CASES cases made of the
 * first record of RUN's journal, each with its own series and times, in blocks of six with a file of raw rounds each. Lines
 * "NAME VALUE UNIT". */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "base/text.h"
#include "history/line.h"
#include "history/night.h"
#include "random.h"
#include "store/journal.h"

struct work {
    char *path, *run; /* of the database, of the run that is taken */
    json_t *record;   /* that all are made of */
    char *rounds;     /* bytes of a file of raw rounds, without its seal */
    size_t rounds_size;
    int nights, cases;
    uint32_t seed;
    struct aob_error error;
};

static double seconds_since(int64_t start)
{
    return (double)(aob_clock_wall_ns() - start) * 1e-9;
}

static int fail(const struct work *work)
{
    fprintf(stderr, "bench_history: %s\n", work->error.text);
    return 2;
}

static void name_file(char name[64], int block)
{
    snprintf(name, 64, "rounds/%032d.jsonl.zst", block);
}

static bool read_run(struct work *work, const char *run)
{
    char *journal = aob_path_join(run, "journal.jsonl"), *info = aob_path_join(run, "run.json");
    json_t *records = aob_journal_read(journal, NULL, &work->error), *json = json_load_file(info, 0, NULL);
    work->record = json_incref(json_array_get(records, 0));
    const json_t *time = json_object_get(work->record, "time");
    const char *name = json_string_value(json_object_get(time, "rounds_file"));
    char *file = aob_path_join(run, name ? name : "");
    char *copy = aob_path_join(work->run, "run.json");
    work->rounds = aob_sealed_read(file, &work->rounds_size, &work->error);
    json_object_del(json, "keys"); /* the cases have keys of their own */
    bool ok = work->rounds && aob_json_write(json, copy, &work->error);
    free(journal);
    free(info);
    free(file);
    free(copy);
    json_decref(records);
    json_decref(json);
    return ok;
}

static json_t *make_record(struct work *work, int number)
{
    char key[AOB_KEY_SIZE], name[64];
    json_t *record = json_deep_copy(work->record), *time = json_object_get(record, "time");
    double ratio = (1 + number * .01) * (1 + random_below(&work->seed, 1000) * 1e-5);
    snprintf(key, sizeof key, "%032d", number);
    name_file(name, number / 6);
    json_object_set_new(record, "key", json_string(key));
    json_object_set_new(record, "series", json_string(key));
    json_object_set_new(json_object_get(record, "params"), "slices", json_integer(number + 1));
    json_object_set_new(time, "ratio_to_ref", json_real(ratio));
    json_object_set_new(time, "ci_low", json_real(ratio * .98));
    json_object_set_new(time, "ci_high", json_real(ratio * 1.02));
    json_object_set_new(time, "rounds_file", json_string(name));
    return record;
}

static bool write_rounds(struct work *work)
{
    char *folder = aob_path_join(work->run, "rounds"), name[64];
    bool ok = aob_folder_create(folder, &work->error);
    for (int block = 0; block <= (work->cases - 1) / 6 && ok; block++) {
        name_file(name, block);
        char *file = aob_path_join(work->run, name);
        ok = aob_sealed_write(file, &(struct aob_piece){work->rounds, work->rounds_size}, 1, &work->error);
        free(file);
    }
    free(folder);
    return ok;
}

static bool write_journal(struct work *work)
{
    struct aob_text text = {0};
    char *path = aob_path_join(work->run, "journal.jsonl");
    for (int i = 0; i < work->cases; i++) {
        json_t *record = make_record(work, i);
        char *line = aob_json_line(record, 9);
        aob_text_add(&text, "%s\n", line);
        free(line);
        json_decref(record);
    }
    bool ok = aob_file_write(path, text.data, text.size, &work->error);
    aob_text_finish(&text);
    free(path);
    return ok;
}

/* Of opening, beginning, taking, ending and closing. */
static bool keep_night(struct work *work, double *seconds)
{
    int64_t start = aob_clock_wall_ns();
    struct aob_history *history = aob_history_open(work->path, AOB_HISTORY_WRITE, &work->error);
    const struct aob_night_desc desc = {
        .name = "bench", .config_hash = "c", .folder = work->run, .modules = "m"};
    int64_t night = history ? aob_night_begin(history, &desc, &work->error) : 0;
    bool ok = night && aob_night_take(history, night, NULL, &work->error) &&
              aob_night_end(history, night, "{}", &work->error);
    aob_history_close(history);
    *seconds = seconds_since(start);
    return ok;
}

static bool read_lines(struct work *work, bool figures, double *seconds)
{
    struct aob_lines lines = {0};
    int64_t start = aob_clock_wall_ns();
    struct aob_history *history = aob_history_open(work->path, AOB_HISTORY_READ, &work->error);
    bool ok =
        history && aob_lines_read(history, &(struct aob_lines_ask){.figures = figures}, &lines, &work->error);
    *seconds = seconds_since(start);
    size_t points = 0;
    for (size_t i = 0; i < lines.count; i++)
        points += lines.items[i].count;
    if (!figures)
        printf("points %zu\n", points);
    aob_lines_finish(&lines);
    aob_history_close(history);
    return ok;
}

static bool measure(struct work *work)
{
    double fill = 0, take = 0, read = 0, figures = 0;
    for (int i = 0; i <= work->nights; i++) {
        if (!write_journal(work) || !keep_night(work, &take))
            return false;
        fill += i < work->nights ? take : 0;
    }
    printf("mean %.2f s\nlast %.2f s\n", fill / work->nights, take);
    if (!read_lines(work, false, &read) || !read_lines(work, true, &figures))
        return false;
    printf("read %.2f s\nfigures %.2f s\nsize %.0f MB\n", read, figures,
           (double)aob_file_size(work->path) * 1e-6);
    return true;
}

int main(int argc, char **argv)
{
    struct work work = {
        .nights = argc == 5 ? atoi(argv[3]) : 0, .cases = argc == 5 ? atoi(argv[4]) : 0, .seed = 1};
    if (work.nights < 1 || work.cases < 1) {
        fprintf(stderr, "bench_history: RUN WORK NIGHTS CASES\n");
        return 2;
    }
    work.path = aob_path_join(argv[2], "history.db");
    work.run = aob_path_join(argv[2], "run");
    bool ok = aob_folder_create(work.run, &work.error) && read_run(&work, argv[1]) && write_rounds(&work) &&
              measure(&work);
    json_decref(work.record);
    free(work.rounds);
    free(work.path);
    free(work.run);
    return ok ? 0 : fail(&work);
}
