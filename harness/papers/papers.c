#include "papers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/text.h"
#include "row.h"
#include "run/run.h"
#include "store/journal.h"

struct papers {
    const struct aob_papers_desc *desc;
    char *configs, *out;
    struct aob_text table; /* as Markdown */
    json_t *rows, *ran;    /* ran: config -> why it failed, or empty */
    json_t *fingerprint;   /* of the first case on a device; NULL until then */
    size_t failed;
};

static bool wanted(const struct papers *papers, const struct aob_paper_row *row)
{
    return !papers->desc->filter || strstr(row->name, papers->desc->filter);
}

static char *config_path(const struct papers *papers, const char *name)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s/%s.yaml", papers->configs, name);
    return text.data;
}

static void find_configs(struct papers *papers)
{
    char *program = aob_path_program_folder();
    papers->configs = aob_path_join(program, "../share/aobudget/papers");
    if (!aob_file_exists(papers->configs)) {
        free(papers->configs);
        papers->configs = aob_path_join(program, "../../configs/papers");
    }
    free(program);
}

static bool check_rows(const struct papers *papers, struct aob_error *error)
{
    size_t count = 0;
    bool ok = true;
    for (const struct aob_paper_row *row = aob_paper_rows; row->name && ok; row++) {
        if (!wanted(papers, row))
            continue;
        count++;
        char *path = row->config ? config_path(papers, row->config) : NULL;
        if (path && !aob_file_exists(path))
            ok =
                aob_fail(error, "%s: not found; row %s needs it: install the program whole", path, row->name);
        free(path);
    }
    return ok &&
           (count || aob_fail(error, "papers: no row's name holds '%s'; without --filter all are printed",
                              papers->desc->filter));
}

static bool check_modules(const struct papers *papers, struct aob_error *error)
{
    struct aob_technique_list list;
    bool ok = aob_dispatch_describe(&papers->desc->dispatch, &list, error);
    if (ok)
        aob_technique_list_finish(&list);
    return ok;
}

/* Once a config; rows share runs. Cases that are not ok are the rows' concern. */
static bool run_config(struct papers *papers, const char *name, const char *folder, struct aob_error *error)
{
    const json_t *earlier = json_object_get(papers->ran, name);
    if (earlier)
        return !*json_string_value(earlier) || aob_fail(error, "%s", json_string_value(earlier));
    bool quick = papers->desc->quick;
    char *path = config_path(papers, name);
    struct aob_run_desc desc = {.dispatch = papers->desc->dispatch,
                                .config = path,
                                .out = folder,
                                .fresh = true,
                                .quiet = true,
                                .no_page = true,
                                .max_width = quick ? 80 : 0,
                                .max_seconds = quick ? 0.1 : 0,
                                .max_spp = quick ? 64 : 0};
    if (!papers->desc->quiet)
        aob_note("papers: running %s", name);
    aob_run(&desc, error);
    json_object_set_new(papers->ran, name, json_string(error->text));
    free(path);
    return !*error->text;
}

static bool measure(struct papers *papers, const struct aob_paper_row *row, struct aob_paper_result *result,
                    struct aob_error *error)
{
    char *folder = aob_path_join(papers->out, row->config), *journal = aob_path_join(folder, "journal.jsonl");
    struct aob_paper_run run = {.folder = folder};
    json_t *records =
        run_config(papers, row->config, folder, error) ? aob_journal_read(journal, NULL, error) : NULL;
    run.records = records;
    bool ok = records && row->measure(&run, result, error);
    for (size_t i = 0; i < row->count && ok; i++)
        ok = isfinite(result->measured[i]) ||
             aob_fail(error, "figure %zu: a record lacks its time or its error", i + 1);
    json_t *fingerprint = json_object_get(json_array_get(records, 0), "fingerprint");
    if (!papers->fingerprint && json_object_get(fingerprint, "driver"))
        papers->fingerprint = json_incref(fingerprint);
    json_decref(records);
    free(journal);
    free(folder);
    return ok;
}

static void add_figures(struct aob_text *text, const double *figures, size_t count)
{
    for (size_t i = 0; i < count; i++)
        aob_text_add(text, "%s%.3g", i ? ", " : "", figures[i]);
}

static json_t *figures_to_json(const double *figures, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, aob_json_number(figures[i]));
    return array;
}

/* A cell of the table; a reason may be any text. */
static void add_cell(struct aob_text *table, const char *text)
{
    aob_text_add(table, " ");
    for (; *text; text++)
        aob_text_add(table, *text == '|' ? "\\|" : "%c", *text == '\n' ? ' ' : *text);
    aob_text_add(table, " |");
}

static void add_row(struct papers *papers, const struct aob_paper_row *row)
{
    struct aob_paper_result result = {0};
    struct aob_error why = {{0}};
    enum aob_paper_verdict verdict = row->fixed;
    if (row->config)
        verdict = measure(papers, row, &result, &why) ? aob_paper_judge(row, &result) : AOB_PAPER_NOT_RUN;
    papers->failed += verdict == AOB_PAPER_NOT_RUN;
    const char *reason = *why.text ? why.text : verdict == AOB_PAPER_REPRODUCED ? "" : row->why;
    const char *setup = row->setup ? row->setup : "";
    size_t measured = row->config && verdict != AOB_PAPER_NOT_RUN ? row->count : 0;
    size_t given = row->figures[0] != 0 ? row->count : 0;
    struct aob_text *table = &papers->table;
    aob_text_add(table, "| %s | %s: %s | %s%s", row->name, row->text, row->claim, row->unit,
                 given ? ": " : "");
    add_figures(table, row->figures, given);
    aob_text_add(table, " | ");
    add_figures(table, result.measured, measured);
    aob_text_add(table, " | %s | %s |", setup, aob_paper_verdicts[verdict]);
    add_cell(table, reason);
    aob_text_add(table, "\n");
    json_array_append_new(papers->rows,
                          json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:s, s:s, s:s}", "name", row->name,
                                    "text", row->text, "claim", row->claim, "unit", row->unit, "figures",
                                    figures_to_json(row->figures, given), "measured",
                                    figures_to_json(result.measured, measured), "setup", setup, "verdict",
                                    aob_paper_verdicts[verdict], "reason", reason));
}

static const char words[] =
    "\n\nCosts are processor time in units of a fixed pass. Where a row has several, they are in units\n"
    "of its first; `a / b` is a quotient.\n\n"
    "- *reproduced*: each figure lies within 25 % of the text's; where the text has none, the claim\n"
    "  holds.\n"
    "- *shape only*: the figures lie in the text's order, each on its side of 1; a single figure on its\n"
    "  side of 1, within a factor of 2.5.\n"
    "- *not reproduced*: neither; the last column says why.\n"
    "- *needs a device model*: nothing is measured, since it is about the text's device.\n";

/* Whose times they are, what the words mean, the table. */
static void write_page(const struct papers *papers, struct aob_text *page)
{
    const json_t *machine = papers->fingerprint;
    aob_text_add(page, "# The texts' figures, measured again\n\nWritten by `aobudget papers%s`.",
                 papers->desc->quick ? " --quick" : "");
    if (machine)
        aob_text_add(page, " Times are of %s (%d cores), `%s`: %s.",
                     json_string_value(json_object_get(machine, "cpu")),
                     (int)json_integer_value(json_object_get(machine, "cores")),
                     json_string_value(json_object_get(machine, "backend")),
                     json_string_value(json_object_get(machine, "driver")));
    aob_text_add(page, "%s\n%s", words, papers->table.data);
}

static bool write_all(const struct papers *papers, struct aob_error *error)
{
    const struct aob_papers_desc *desc = papers->desc;
    char *path = aob_path_join(papers->out, "papers.md");
    struct aob_text page = {0};
    write_page(papers, &page);
    bool ok = aob_file_write(path, page.data, page.size, error);
    free(path);
    if (ok && !desc->quiet && !(desc->json && strcmp(desc->json, "-") == 0))
        ok = aob_output_write(page.data, page.size, error);
    aob_text_finish(&page);
    if (!ok || !desc->json)
        return ok;
    json_t *document = json_pack("{s:b, s:O?, s:O}", "quick", desc->quick, "fingerprint", papers->fingerprint,
                                 "rows", papers->rows);
    ok = aob_json_write(document, desc->json, error);
    json_decref(document);
    return ok;
}

enum aob_exit aob_papers(const struct aob_papers_desc *desc, struct aob_error *error)
{
    struct papers papers = {.desc = desc,
                            .out = aob_strdup(desc->out ? desc->out : "results/papers"),
                            .rows = json_array(),
                            .ran = json_object()};
    find_configs(&papers);
    aob_text_add(&papers.table,
                 "| row | text and claim | figures of the text | measured | set-up | verdict | why not |\n"
                 "|---|---|---|---|---|---|---|\n");
    bool ok = check_rows(&papers, error) && check_modules(&papers, error) &&
              aob_folder_create(papers.out, error) && aob_json_check(desc->json, error);
    for (const struct aob_paper_row *row = aob_paper_rows; row->name && ok; row++)
        if (wanted(&papers, row))
            add_row(&papers, row);
    ok = ok && write_all(&papers, error);
    json_decref(papers.rows);
    json_decref(papers.ran);
    json_decref(papers.fingerprint);
    aob_text_finish(&papers.table);
    free(papers.configs);
    free(papers.out);
    return !ok ? AOB_EXIT_USAGE : papers.failed ? AOB_EXIT_PART : AOB_EXIT_OK;
}
