#include "compare.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "builds.h"
#include "contest.h"

static const char *folder_of(const struct aob_compare_desc *desc)
{
    return desc->folder ? desc->folder : "results/compare";
}

/* Of the old module, stored and measured again. What was measured of the two builds stands without it. */
static bool judge_then(struct aob_contest *then)
{
    struct aob_error why = {{0}};
    bool ok = aob_contest_read(then, &why) && aob_contest_judge(then, 0, &why);
    if (!ok)
        aob_warn("the old module is not set against its stored run: %s", why.text);
    return ok;
}

/* `then`: a second table, of the old module when it was stored and now. NULL: there is none. */
static bool write_out(const struct aob_compare_desc *desc, const struct aob_contest *c,
                      const struct aob_contest *then, struct aob_text *out, struct aob_error *error)
{
    aob_compared_draw(&c->table, desc->dispatch.program);
    aob_compared_print(&c->table, out);
    if (then) {
        aob_compared_draw(&then->table, desc->dispatch.program);
        aob_text_add_line(out, "The old module, stored and measured again now:");
        aob_compared_print(&then->table, out);
    }
    if (!desc->json)
        return true;
    json_t *document = aob_compared_to_json(&c->table);
    if (then)
        json_object_set_new(document, "then_and_now", aob_compared_to_json(&then->table));
    bool ok = aob_json_write(document, desc->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit exit_code(const struct aob_contest *c)
{
    static const enum aob_exit codes[] = {AOB_EXIT_OK, AOB_EXIT_BAD, AOB_EXIT_PART};
    enum aob_exit code = codes[aob_compared_outcome(&c->table)];
    return code == AOB_EXIT_OK && c->partial ? AOB_EXIT_PART : code;
}

static enum aob_exit compare_runs(const struct aob_compare_desc *desc, struct aob_text *out,
                                  struct aob_error *error)
{
    struct aob_contest c = {.names = {desc->sides[0], desc->sides[1]},
                            .folders = {desc->sides[0], desc->sides[1]},
                            .maps = folder_of(desc),
                            .precision = desc->precision};
    bool ok = aob_contest_read(&c, error) && aob_contest_judge(&c, 0, error) &&
              write_out(desc, &c, NULL, out, error);
    enum aob_exit code = ok ? exit_code(&c) : AOB_EXIT_USAGE;
    aob_contest_finish(&c);
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
    struct aob_contest c = {.names = {old, desc->sides[1]},
                            .folders = {folder, NULL},
                            .modules = {name, desc->sides[1]},
                            .maps = folder,
                            .precision = desc->precision};
    struct aob_contest then = {.names = {desc->sides[0], old},
                               .folders = {desc->sides[0], folder},
                               .modules = {stored ? stored->name : NULL, name},
                               .maps = then_maps,
                               .precision = desc->precision};
    bool ok = measure(desc, stored, error) && aob_contest_read(&c, error) && aob_contest_judge(&c, 0, error);
    bool has_then = ok && stored && judge_then(&then);
    if (stored && !desc->config && c.couples.count < json_array_size(stored->records))
        c.partial = true; /* a warning said which */
    ok = ok && write_out(desc, &c, has_then ? &then : NULL, out, error);
    enum aob_exit code = ok ? exit_code(&c) : AOB_EXIT_USAGE;
    aob_contest_finish(&c);
    aob_contest_finish(&then);
    free(then_maps);
    return code;
}

static enum aob_exit compare_with_stored(const struct aob_compare_desc *desc, struct aob_text *out,
                                         struct aob_error *error)
{
    struct aob_old_module stored = {0};
    enum aob_exit code = aob_old_module_find(&stored, desc, NULL, error)
                             ? compare_builds(desc, &stored, out, error)
                             : AOB_EXIT_USAGE;
    aob_old_module_finish(&stored);
    return code;
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
    if (!aob_folder_exists(desc->sides[1]))
        return is_spared(desc, error) && aob_json_check(desc->json, error);
    if (!aob_folder_exists(desc->sides[0]))
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
    if (aob_folder_exists(desc->sides[1]))
        return compare_runs(desc, out, error);
    if (aob_folder_exists(desc->sides[0]))
        return compare_with_stored(desc, out, error);
    return compare_builds(desc, NULL, out, error);
}
