#include "rows.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "costs.h"
#include "label.h"
#include "places.h"
#include "rows_scores.h"
#include "store/journal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *aob_rows_damage(const struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->run_count; i++)
        if (*rows->runs[i].damage.text)
            return rows->runs[i].damage.text;
    return "";
}

bool aob_row_is_ok(const struct aob_row *row)
{
    return strcmp(row->status, "ok") == 0;
}

bool aob_row_is_of(const struct aob_row *row, const json_t *technique)
{
    return strcmp(aob_member_text(technique, "name"), row->name) == 0 &&
           (!*row->module || strcmp(aob_member_text(technique, "module"), row->module) == 0);
}

static int small_int(double value)
{
    return value >= 1 && value <= 65536 ? (int)value : 0;
}

static void take_line(struct aob_row *row, size_t run, const json_t *line)
{
    const json_t *time = json_object_get(line, "time");
    *row = (struct aob_row){
        .run = run,
        .json = line,
        .key = aob_member_text(line, "key"),
        .series = aob_member_text(line, "series"),
        .scene = aob_member_text(line, "scene"),
        .view = aob_member_text(line, "view"),
        .technique = aob_member_text(line, "technique"),
        .name = aob_member_text(line, "technique"),
        .module = aob_member_text(line, "module"),
        .backend = aob_member_text(line, "backend"),
        .status = aob_member_text(line, "status"),
        .reason = aob_member_text(line, "reason"),
        .image = aob_member_text(line, "image"),
        .width = small_int(aob_member_number(line, "width")),
        .height = small_int(aob_member_number(line, "height")),
        .cost_ms = aob_costs_ms(time),
        .ratio = aob_member_number(time, "ratio_to_ref"),
        .ci_low = aob_member_number(time, "ci_low"),
        .ci_high = aob_member_number(time, "ci_high"),
        .memory_bytes = aob_member_number(line, "memory_bytes"),
    };
}

static void read_info(struct aob_run *run)
{
    char *path = aob_path_join(run->folder, "run.json");
    run->info = json_load_file(path, 0, NULL);
    const char *name = aob_member_text(run->info, "name");
    double cases = aob_member_number(run->info, "cases");
    run->name = *name ? name : run->folder;
    run->planned = cases >= 1 && cases < 1e9 ? (size_t)cases : 0;
    free(path);
}

/* A list of keys in run.json, as names of an object; NULL where there is none. decref it. */
static json_t *keys_of(const struct aob_run *run, const char *list)
{
    json_t *array = json_object_get(run->info, list), *keys = json_is_array(array) ? json_object() : NULL,
           *key;
    size_t i;
    json_array_foreach(array, i, key)
    {
        if (json_is_string(key))
            json_object_set_new(keys, json_string_value(key), json_true());
    }
    return keys;
}

/* Takes the lines that are of the plan: a journal may also hold cases of an earlier state of the program or its modules. */
static void take_lines(struct aob_rows *rows, size_t index)
{
    struct aob_run *run = &rows->runs[index];
    json_t *planned = keys_of(run, "keys"), *asked = keys_of(run, "asked"), *line;
    json_t *open = asked ? asked : json_copy(planned);
    size_t i;
    run->asked = open ? json_object_size(open) : run->planned;
    json_array_foreach(run->lines, i, line)
    {
        if (planned && !json_object_get(planned, aob_member_text(line, "key")))
            continue;
        take_line(AOB_PUSH(rows->list, rows->count, rows->capacity), index, line);
        json_object_del(open, aob_member_text(line, "key"));
        run->cases++;
    }
    if (open)
        run->missing = json_object_size(open);
    else if (run->planned > run->cases)
        run->missing = run->planned - run->cases;
    json_decref(open);
    json_decref(planned);
}

static bool read_run(struct aob_rows *rows, size_t index, const char *const *paths, struct aob_error *error)
{
    struct aob_run *run = &rows->runs[index];
    char *path = aob_path_join(run->folder, "journal.jsonl");
    read_info(run);
    if (!aob_file_exists(path) && !run->info)
        aob_fail(error, "%s: is not the folder of a run: it has no journal.jsonl", run->folder);
    else
        run->lines = aob_journal_read_only(path, paths, &run->damage, error);
    free(path);
    take_lines(rows, index);
    return run->lines != NULL;
}

static void take_section(struct aob_rows *rows, size_t index, json_t *places)
{
    struct aob_row *row = &rows->list[index];
    json_t *key = json_pack("[I, s, s]", (json_int_t)row->run, row->scene, row->view);
    row->section = aob_place(places, key);
    if (row->section == rows->section_count)
        *AOB_PUSH(rows->sections, rows->section_count, rows->section_capacity) =
            (struct aob_section){.run = row->run, .scene = row->scene, .view = row->view, .backend = ""};
    struct aob_section *section = &rows->sections[row->section];
    *AOB_PUSH(section->rows, section->count, section->capacity) = index;
    if (!*section->backend && aob_row_is_ok(row))
        section->backend = row->backend;
}

/* Builds are told apart by their modules, where there are several. */
static void name_builds(struct aob_rows *rows)
{
    json_t *modules = json_object(), *several = json_object();
    for (size_t i = 0; i < rows->count; i++) {
        const struct aob_row *row = &rows->list[i];
        const json_t *first = json_object_get(modules, row->name);
        if (!first)
            json_object_set_new(modules, row->name, json_string(row->module));
        else if (strcmp(json_string_value(first), row->module) != 0)
            json_object_set_new(several, row->name, json_true());
    }
    for (size_t i = 0; i < rows->count; i++) {
        struct aob_row *row = &rows->list[i];
        struct aob_text text = {0};
        if (!*row->module || !json_object_get(several, row->name))
            continue;
        aob_text_add(&text, "%s (%s)", row->name, row->module);
        row->technique = row->build = text.data;
    }
    json_decref(modules);
    json_decref(several);
}

static void list_places(struct aob_rows *rows)
{
    json_t *sections = json_object(), *techniques = json_object();
    for (size_t i = 0; i < rows->count; i++) {
        struct aob_row *row = &rows->list[i];
        take_section(rows, i, sections);
        row->technique_place = aob_place(techniques, json_pack("[s]", row->technique));
        if (row->technique_place == rows->technique_count)
            *AOB_PUSH(rows->techniques, rows->technique_count, rows->technique_capacity) = row->technique;
    }
    json_decref(sections);
    json_decref(techniques);
}

/* A folder that is given twice, by whatever path, would count each of its cases twice. */
static bool check_folders(const char *const *folders, size_t count, struct aob_error *error)
{
    bool ok = true;
    char **real = AOB_NEW_ARRAY(char *, count);
    for (size_t i = 0; i < count && ok; i++) {
        real[i] = realpath(folders[i], NULL); /* NULL: the reader says that it is no run */
        for (size_t k = 0; k < i && ok; k++)
            if (real[i] && real[k] && strcmp(real[i], real[k]) == 0)
                ok = aob_fail(error, "%s: is the same folder as %s: name each run once", folders[i],
                              folders[k]);
    }
    for (size_t i = 0; i < count; i++)
        free(real[i]);
    free(real);
    return ok;
}

static bool read_runs(struct aob_rows *rows, const char *const *folders, size_t folder_count,
                      const char *const *paths, struct aob_error *error)
{
    *rows = (struct aob_rows){.run_count = folder_count};
    rows->runs = AOB_NEW_ARRAY(struct aob_run, folder_count);
    bool ok = check_folders(folders, folder_count, error);
    for (size_t i = 0; i < folder_count && ok; i++) {
        rows->runs[i].folder = folders[i];
        ok = read_run(rows, i, paths, error);
    }
    if (ok) {
        name_builds(rows);
        list_places(rows);
        aob_rows_read_scores(rows);
        aob_labels_make(rows);
    }
    if (!ok)
        aob_rows_finish(rows);
    return ok;
}

bool aob_rows_read(struct aob_rows *rows, const char *const *folders, size_t folder_count,
                   struct aob_error *error)
{
    return read_runs(rows, folders, folder_count, NULL, error);
}

bool aob_rows_read_only(struct aob_rows *rows, const char *folder, const char *const *paths,
                        struct aob_error *error)
{
    return read_runs(rows, &folder, 1, paths, error);
}

void aob_rows_finish(struct aob_rows *rows)
{
    for (size_t i = 0; i < rows->count; i++) {
        free(rows->list[i].label);
        free(rows->list[i].build);
        free(rows->list[i].scores);
    }
    for (size_t i = 0; i < rows->section_count; i++)
        free(rows->sections[i].rows);
    for (size_t i = 0; i < rows->run_count; i++) {
        json_decref(rows->runs[i].info);
        json_decref(rows->runs[i].lines);
    }
    free(rows->sections);
    free(rows->techniques);
    free(rows->targets);
    free(rows->list);
    free(rows->runs);
    *rows = (struct aob_rows){0};
}
