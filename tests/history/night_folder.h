/* A run's folder that a test writes: records made of one that a run wrote (record.json beside this), and the database that
 * takes them. Each test process has its own folder below /tmp, which night_folder_remove removes. */
#ifndef AOB_TESTS_HISTORY_NIGHT_FOLDER_H
#define AOB_TESTS_HISTORY_NIGHT_FOLDER_H
#include <ftw.h>
#include <jansson.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/json.h"
#include "base/sealed.h"
#include "base/text.h"
#include "check.h"
#include "history/line.h"
#include "history/night.h"

static char place[128];  /* the test's folder */
static char path[192];   /* of the database */
static char folder[192]; /* of the run */
static struct aob_error error;

static inline int night_folder_remove_one(const char *name, const struct stat *info, int kind, struct FTW *at)
{
    (void)info;
    (void)kind;
    (void)at;
    return remove(name);
}

static inline int night_folder_remove(void **state)
{
    (void)state;
    chmod(place, 0755);
    return nftw(place, night_folder_remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

static inline int night_folder_make(void **state)
{
    (void)state;
    snprintf(place, sizeof place, "/tmp/aobudget-history-%ld", (long)getpid());
    snprintf(path, sizeof path, "%s/h %%31?#.db", place); /* letters that mean something in a URI */
    snprintf(folder, sizeof folder, "%s/run", place);
    error = (struct aob_error){{0}};
    return mkdir(place, 0755) || mkdir(folder, 0755);
}

/* What is written to standard error between the two; free() it. */
static int outer_stderr;
static inline void stderr_begin(void)
{
    char *file = aob_path_join(place, "stderr");
    fflush(stderr);
    outer_stderr = dup(2);
    assert_non_null(freopen(file, "w", stderr));
    free(file);
}
static inline char *stderr_end(void)
{
    size_t size;
    char *file = aob_path_join(place, "stderr");
    fflush(stderr);
    dup2(outer_stderr, 2);
    close(outer_stderr);
    char *said = aob_file_read(file, 1 << 20, &size, &error);
    free(file);
    return said;
}

/* A key or a digest of 32 digits. */
static inline const char *key_of(int number)
{
    static char keys[8][AOB_KEY_SIZE];
    static int next;
    char *key = keys[next++ % 8];
    snprintf(key, AOB_KEY_SIZE, "%032x", (unsigned)number);
    return key;
}

/* JSON whose texts stand in single quotes. */
static inline json_t *json_of(const char *text)
{
    char *copy = strdup(text);
    for (char *c = copy; *c; c++)
        *c = *c == '\'' ? '"' : *c;
    json_t *value = json_loads(copy, 0, NULL);
    free(copy);
    assert_non_null(value);
    return value;
}

static const char record_text[] =
    "{'scene':'corner','view':'front','metre':1,'technique':'gtao','revision':5,'params':{'radius':0.5,'"
    "slices':3},"
    "'options':{'guard_band':0,'fetch':'sampled','threads':0},'backend':'vulkan','width':480,'height':270,"
    "'reference_radius':0.5,'status':'ok','reason':'','memory_bytes':1036800,'fingerprint':{'program':'0.1.0'"
    ","
    "'cpu':'Xeon','cores':2,'backend':'vulkan','device':'llvmpipe','driver':'Mesa "
    "22.3','class':'cpu','fixed_pass':1,"
    "'threads':'default'},'image_digest':'00000000000000000000000000000abc','time':{'clock':'cpu','cpu_ms':3."
    "25,"
    "'wall_ms':2.5,'device_ms':null,'threads':2,'ref_ms':0.625},'error':{'target':{'radius':0.5,'weighting':"
    "'cosine'},'reference':'ray-traced','rmse':0.06,'band_rmse':0.11,'reference_se':0.003,'band_pixels':1558,"
    "'flip':0.05,'covariance':{'definition_missing':-0.004}},'cache':{'ps4':{'status':'ok','frame':{'levels':"
    "["
    "{'name':'l1','one':{'miss_ratio':0.1,'fills_per_pixel':2.5,'bytes_per_pixel':160},'most':{'miss_ratio':"
    "0.2,"
    "'fills_per_pixel':null,'bytes_per_pixel':320}}]}}}}";
static const char technique_text[] =
    "{'name':'gtao','module':null,'digest':'000000000000000000000000000000d1','params':[{'name':'radius','"
    "unit':"
    "'scene_units','initial':0.5},{'name':'slices','unit':'count','initial':3}]}";

/* A timed case whose series has this number, which is its slices as well; its ratio to the fixed pass as given. */
static inline json_t *record_make(int series, double ratio)
{
    json_t *record = json_of(record_text), *time = json_object_get(record, "time");
    json_object_set_new(record, "key", json_string(key_of(1000 + series)));
    json_object_set_new(record, "series", json_string(key_of(series)));
    json_object_set_new(json_object_get(record, "params"), "slices", json_integer(series));
    json_object_set_new(time, "ratio_to_ref", json_real(ratio));
    json_object_set_new(time, "ci_low", json_real(ratio * .98));
    json_object_set_new(time, "ci_high", json_real(ratio * 1.03));
    return record;
}

/* Takes the text over the number that the record had; NULL takes the member away. */
static inline void record_set(json_t *record, const char *member, const char *text)
{
    if (text)
        json_object_set_new(record, member, json_string(text));
    else
        json_object_del(record, member);
}

static inline void write_file(const char *name, const void *bytes, size_t size)
{
    char *file = aob_path_join(folder, name);
    assert_true(aob_file_write(file, bytes, size, &error));
    free(file);
}

/* Makes the records, which it takes over, the journal of the run's folder. */
static inline void journal_write(json_t **records, size_t count)
{
    struct aob_text text = {0};
    for (size_t i = 0; i < count; i++) {
        char *line = aob_json_line(records[i], 9);
        aob_text_add(&text, "%s\n", line);
        free(line);
        json_decref(records[i]);
    }
    write_file("journal.jsonl", text.data ? text.data : "", text.size);
    aob_text_finish(&text);
}

/* run.json with this list of techniques, which it takes over. */
static inline void info_write(json_t *techniques)
{
    json_t *info = json_pack("{s:s, s:s, s:o}", "name", "nightly", "build", "b1", "techniques", techniques);
    char *text = json_dumps(info, JSON_INDENT(1));
    write_file("run.json", text, strlen(text));
    free(text);
    json_decref(info);
}

/* A journal of cases of the series 1 .. count, whose ratios are `ratio` times their series. */
static inline void run_write(int count, double ratio)
{
    json_t **records = calloc((size_t)count + 1, sizeof *records);
    for (int i = 0; i < count; i++)
        records[i] = record_make(i + 1, ratio * (i + 1));
    journal_write(records, (size_t)count);
    free(records);
    info_write(json_pack("[o]", json_of(technique_text)));
}

static inline struct aob_history *history_open(enum aob_history_use use)
{
    struct aob_history *history = aob_history_open(path, use, &error);
    if (!history)
        fail_msg("%s", error.text);
    return history;
}

/* Begins a night of the folder as it is now, takes it, and ends it if it shall be whole. Returns its id. */
static inline int64_t night_keep(struct aob_history *history, const char *name, bool whole)
{
    const struct aob_night_desc desc = {.name = name, .config_hash = "c1", .folder = folder, .modules = "m1"};
    int64_t night = aob_night_begin(history, &desc, &error);
    if (!night || !aob_night_take(history, night, NULL, &error) ||
        (whole && !aob_night_end(history, night, "{\"line\": \"all well\"}", &error)))
        fail_msg("%s", error.text);
    return night;
}
#endif
