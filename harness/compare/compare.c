#include "compare.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "builds.h"
#include "compared.h"

/* One table, from its two sides to what is said of them. */
struct comparison {
    const struct aob_compare_desc *desc;
    const char *names[2];   /* of its sides */
    const char *folders[2]; /* the runs that these are in: one and NULL, or two */
    const char *modules[2]; /* whose cases of those runs they are; NULL: all */
    const char *maps;       /* the folder that the maps of what moved go to */
    struct aob_rows rows;
    const struct aob_row **sides[2];
    size_t counts[2];
    bool partial; /* a run lacks cases that it was asked for, or some cannot be measured again */
    struct aob_couples couples;
    struct aob_compared_table table;
};

static const char *folder_of(const struct aob_compare_desc *desc)
{
    return desc->folder ? desc->folder : "results/compare";
}

/* The rows of each side: of its run, and of its module. */
static void choose_sides(struct comparison *c)
{
    for (int side = 0; side < 2; side++) {
        size_t run = c->folders[1] ? (size_t)side : 0;
        c->sides[side] = AOB_NEW_ARRAY(const struct aob_row *, c->rows.count + 1);
        for (size_t i = 0; i < c->rows.count; i++) {
            const struct aob_row *row = &c->rows.list[i];
            if (row->run == run && (!c->modules[side] || strcmp(row->module, c->modules[side]) == 0))
                c->sides[side][c->counts[side]++] = row;
        }
    }
}

/* A run that was stopped, or a journal that was cut: what it lacks cannot be seen from its cases. What its filters left out
 * it does not lack. */
static void judge_whole(struct comparison *c)
{
    for (size_t i = 0; i < c->rows.run_count; i++) {
        const struct aob_run *run = &c->rows.runs[i];
        if (!run->missing)
            continue;
        c->partial = true;
        aob_warn("%s: its journal has %zu of %zu cases; start the run again to measure the rest", run->folder,
                 run->asked - run->missing, run->asked);
    }
}

static bool read_rows(struct comparison *c, struct aob_error *error)
{
    if (!aob_rows_read(&c->rows, c->folders, c->folders[1] ? 2 : 1, error))
        return false;
    if (*aob_rows_damage(&c->rows))
        aob_warn("%s", aob_rows_damage(&c->rows));
    judge_whole(c);
    choose_sides(c);
    const struct aob_side a = {c->sides[0], c->counts[0]}, b = {c->sides[1], c->counts[1]};
    aob_couples_find(&c->couples, &a, &b);
    return c->couples.count ||
           aob_fail(error,
                    "no case of %s (%zu) has a partner in %s (%zu): scene, view, technique, parameters, "
                    "options, backend and size must be the same",
                    c->names[0], c->counts[0], c->names[1], c->counts[1]);
}

static bool same_program(const struct comparison *c)
{
    const char *a = aob_member_text(c->rows.runs[0].info, "build");
    const char *b = aob_member_text(c->rows.runs[c->rows.run_count - 1].info, "build");
    return *a && strcmp(a, b) == 0;
}

static bool judge(struct comparison *c, struct aob_error *error)
{
    const struct aob_compare_desc *desc = c->desc;
    if (!read_rows(c, error))
        return false;
    c->table = (struct aob_compared_table){.rows = &c->rows,
                                           .couples = &c->couples,
                                           .names = {c->names[0], c->names[1]},
                                           .folder = c->maps,
                                           .precision =
                                               desc->precision > 0 ? desc->precision : AOB_COMPARE_PRECISION,
                                           .same_program = same_program(c)};
    return aob_compared_judge(&c->table, error);
}

/* Of the old module, stored and measured again. What was measured of the two builds stands without it. */
static bool judge_then(struct comparison *then)
{
    struct aob_error why = {{0}};
    bool ok = judge(then, &why);
    if (!ok)
        aob_warn("the old module is not set against its stored run: %s", why.text);
    return ok;
}

static void finish(struct comparison *c)
{
    aob_compared_finish(&c->table);
    aob_couples_finish(&c->couples);
    aob_rows_finish(&c->rows);
    free(c->sides[0]);
    free(c->sides[1]);
}

/* `then`: a second table, of the old module when it was stored and now. NULL: there is none. */
static bool write_out(const struct comparison *c, const struct comparison *then, struct aob_text *out,
                      struct aob_error *error)
{
    aob_compared_draw(&c->table, c->desc->dispatch.program);
    aob_compared_print(&c->table, out);
    if (then) {
        aob_compared_draw(&then->table, c->desc->dispatch.program);
        aob_text_add_line(out, "The old module, stored and measured again now:");
        aob_compared_print(&then->table, out);
    }
    if (!c->desc->json)
        return true;
    json_t *document = aob_compared_to_json(&c->table);
    if (then)
        json_object_set_new(document, "then_and_now", aob_compared_to_json(&then->table));
    bool ok = aob_json_write(document, c->desc->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit exit_code(const struct comparison *c)
{
    static const enum aob_exit codes[] = {AOB_EXIT_OK, AOB_EXIT_BAD, AOB_EXIT_PART};
    enum aob_exit code = codes[aob_compared_outcome(&c->table)];
    return code == AOB_EXIT_OK && c->partial ? AOB_EXIT_PART : code;
}

static enum aob_exit compare_runs(const struct aob_compare_desc *desc, struct aob_text *out,
                                  struct aob_error *error)
{
    struct comparison c = {.desc = desc,
                           .names = {desc->sides[0], desc->sides[1]},
                           .folders = {desc->sides[0], desc->sides[1]},
                           .maps = folder_of(desc)};
    bool ok = judge(&c, error) && write_out(&c, NULL, out, error);
    enum aob_exit code = ok ? exit_code(&c) : AOB_EXIT_USAGE;
    finish(&c);
    return code;
}

/* A copy is one build: its cases have one key, and there is no difference to look for. */
static enum aob_exit tell_identical(const struct aob_compare_desc *desc, const char *old,
                                    struct aob_text *out, struct aob_error *error)
{
    aob_text_add_line(out, "SAME: %s and %s are one build, byte for byte; nothing was measured", old,
                      desc->sides[1]);
    if (!desc->json)
        return AOB_EXIT_OK;
    json_t *document = json_pack("{s:o, s:o, s:b, s:[]}", "a", aob_json_text(old), "b",
                                 aob_json_text(desc->sides[1]), "identical", true, "cases");
    bool ok = aob_json_write(document, desc->json, error);
    json_decref(document);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

/* `stored`: of sides[0], which is a run; NULL: that is a module. */
static bool measure(const struct aob_compare_desc *desc, const struct aob_old_module *stored,
                    struct aob_error *error)
{
    if (stored && !desc->config)
        return aob_builds_measure_again(desc, stored, folder_of(desc), error);
    struct aob_compare_desc now = *desc;
    now.sides[0] = stored ? stored->file : desc->sides[0];
    return aob_builds_measure(&now, folder_of(desc), error);
}

static enum aob_exit compare_builds(const struct aob_compare_desc *desc, const struct aob_old_module *stored,
                                    struct aob_text *out, struct aob_error *error)
{
    const char *old = stored ? stored->file : desc->sides[0];
    const char *name = stored && !desc->config ? stored->name : old; /* in what is measured now */
    bool identical;
    if (!aob_builds_identical(old, desc->sides[1], &identical, error))
        return AOB_EXIT_USAGE;
    if (identical)
        return tell_identical(desc, old, out, error);
    const char *folder = folder_of(desc);
    char *then_maps = aob_path_join(folder, "then");
    struct comparison c = {.desc = desc,
                           .names = {old, desc->sides[1]},
                           .folders = {folder, NULL},
                           .modules = {name, desc->sides[1]},
                           .maps = folder};
    struct comparison then = {.desc = desc,
                              .names = {desc->sides[0], old},
                              .folders = {desc->sides[0], folder},
                              .modules = {stored ? stored->name : NULL, name},
                              .maps = then_maps};
    bool ok = measure(desc, stored, error) && judge(&c, error);
    bool has_then = ok && stored && judge_then(&then);
    if (stored && !desc->config && c.couples.count < json_array_size(stored->records))
        c.partial = true; /* a warning said which */
    ok = ok && write_out(&c, has_then ? &then : NULL, out, error);
    enum aob_exit code = ok ? exit_code(&c) : AOB_EXIT_USAGE;
    finish(&c);
    finish(&then);
    free(then_maps);
    return code;
}

static enum aob_exit compare_with_stored(const struct aob_compare_desc *desc, struct aob_text *out,
                                         struct aob_error *error)
{
    struct aob_old_module stored = {0};
    enum aob_exit code = aob_old_module_find(&stored, desc, error) ? compare_builds(desc, &stored, out, error)
                                                                   : AOB_EXIT_USAGE;
    aob_old_module_finish(&stored);
    return code;
}

static bool is_folder(const char *path)
{
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

/* What is measured takes the place of what its folder held, so that must not be a side. */
static bool is_spared(const struct aob_compare_desc *desc, struct aob_error *error)
{
    struct stat stored, folder;
    if (stat(desc->sides[0], &stored) != 0 || stat(folder_of(desc), &folder) != 0)
        return true;
    return stored.st_dev != folder.st_dev || stored.st_ino != folder.st_ino ||
           aob_fail(
               error,
               "%s is the run to compare with, and what is measured would take its place: give another --out",
               desc->sides[0]);
}

static bool check(const struct aob_compare_desc *desc, struct aob_error *error)
{
    for (int i = 0; i < 2; i++)
        if (!aob_file_exists(desc->sides[i]))
            return aob_fail(error, "%s: not found; compare takes folders of runs or module files",
                            desc->sides[i]);
    if (!is_folder(desc->sides[1]))
        return is_spared(desc, error) && aob_json_check(desc->json, error);
    if (!is_folder(desc->sides[0]))
        return aob_fail(error, "%s is a module and %s is a run: name the old one, the run, first",
                        desc->sides[0], desc->sides[1]);
    if (desc->config || desc->technique || desc->seconds > 0)
        return aob_fail(error,
                        "--config, --technique and --seconds are of modules: runs are measured already");
    return aob_json_check(desc->json, error);
}

enum aob_exit aob_compare(const struct aob_compare_desc *desc, struct aob_text *out, struct aob_error *error)
{
    if (!check(desc, error))
        return AOB_EXIT_USAGE;
    if (is_folder(desc->sides[1]))
        return compare_runs(desc, out, error);
    if (is_folder(desc->sides[0]))
        return compare_with_stored(desc, out, error);
    return compare_builds(desc, NULL, out, error);
}
