#include "papers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/text.h"
#include "cell.h"
#include "modelled_table.h"
#include "row.h"
#include "runs.h"

enum { AOB_PAPERS_RUNS = 3 }; /* of a config, at most */

struct papers {
    const struct aob_papers_desc *desc;
    char *out;
    struct aob_paper_runs runs;
    struct aob_text table; /* as Markdown */
    json_t *rows;
    json_t *fingerprint; /* of the first case on a device; NULL until then */
    size_t failed;
};

static bool is_wanted(const struct papers *papers, const char *name)
{
    return !papers->desc->filter || strstr(name, papers->desc->filter);
}

/* Counts what the filter leaves of a table whose rows have a name and a config. */
static bool check_row(const struct papers *papers, const char *name, const char *config, size_t *count,
                      struct aob_error *error)
{
    if (!is_wanted(papers, name))
        return true;
    ++*count;
    return aob_paper_runs_have(&papers->runs, config, name, error);
}

static bool check_rows(const struct papers *papers, struct aob_error *error)
{
    size_t count = 0;
    for (const struct aob_paper_row *row = aob_paper_rows; row->name; row++)
        if (!check_row(papers, row->name, row->config, &count, error))
            return false;
    for (const struct aob_modelled_row *row = aob_modelled_rows; row->name; row++)
        if (!check_row(papers, row->name, row->config, &count, error))
            return false;
    return count || aob_fail(error, "papers: no row's name holds '%s'; without --filter all are printed",
                             papers->desc->filter);
}

static bool check_modules(const struct papers *papers, struct aob_error *error)
{
    struct aob_technique_list list;
    bool ok = aob_dispatch_describe(&papers->desc->dispatch, &papers->desc->dispatch.modules, &list, error);
    if (ok)
        aob_technique_list_finish(&list);
    return ok;
}

static bool measure_row(const struct aob_paper_run *run, struct aob_paper_outcome *outcome,
                        struct aob_error *error)
{
    bool ok = outcome->row->measure(run, &outcome->result, error);
    for (size_t i = 0; i < outcome->row->count && ok; i++)
        ok = isfinite(outcome->result.measured[i].value) ||
             aob_fail(error, "figure %zu: a record lacks its time or its error", i + 1);
    return ok;
}

/* Whether an interval of one of the config's rows is still too wide for a verdict. */
static bool is_open(const struct papers *papers, const char *name, const struct aob_paper_run *run)
{
    bool open = false;
    for (const struct aob_paper_row *row = aob_paper_rows; row->name; row++) {
        struct aob_paper_outcome outcome = {.row = row, .run = run};
        if (is_wanted(papers, row->name) && row->config && !row->open && strcmp(row->config, name) == 0 &&
            measure_row(run, &outcome, NULL))
            open = open || aob_paper_judge(row, &outcome.result) == AOB_PAPER_NOT_JUDGED;
    }
    return open;
}

/* Once a config: its rows share the last of its runs. What the journal of that holds, or the text of what went wrong. */
static const json_t *run_config(struct papers *papers, const char *name, const char *folder)
{
    const json_t *records = json_object_get(papers->runs.ran, name);
    const int runs = records ? 0 : papers->desc->quick ? 1 : AOB_PAPERS_RUNS;
    for (int patience = 0; patience < runs; patience++) {
        records = aob_paper_runs_run(&papers->runs, name, patience);
        const struct aob_paper_run run = {records, folder};
        if (json_is_string(records) || !is_open(papers, name, &run))
            break;
    }
    return records;
}

static void keep_fingerprint(struct papers *papers, const json_t *records)
{
    json_t *fingerprint = json_object_get(json_array_get(records, 0), "fingerprint");
    if (!papers->fingerprint && json_object_get(fingerprint, "driver"))
        papers->fingerprint = json_incref(fingerprint);
}

/* The row's figures and what is said of them. */
static enum aob_paper_verdict judge_row(struct papers *papers, struct aob_paper_outcome *outcome,
                                        struct aob_text *reason)
{
    struct aob_error error = {{0}};
    char *folder = aob_paper_runs_folder(&papers->runs, outcome->row->config ? outcome->row->config : "");
    const json_t *records = outcome->row->config ? run_config(papers, outcome->row->config, folder) : NULL;
    struct aob_paper_run run = {records, folder};
    outcome->run = &run;
    keep_fingerprint(papers, records);
    if (json_is_string(records))
        aob_fail(&error, "%s", json_string_value(records));
    else if (records)
        measure_row(&run, outcome, &error);
    aob_text_add(reason, "%s", error.text);
    if (!*error.text)
        aob_paper_explain(outcome, reason);
    outcome->run = NULL;
    free(folder);
    return *error.text ? AOB_PAPER_NOT_RUN : aob_paper_judge(outcome->row, &outcome->result);
}

static void add_texts_figures(struct aob_text *text, const struct aob_paper_row *row)
{
    for (size_t i = 0; i < row->count && row->figures[0] != 0; i++)
        aob_text_add(text, "%s%.3g", i ? ", " : ": ", row->figures[i]);
}

static json_t *texts_figures_to_json(const struct aob_paper_row *row)
{
    json_t *array = json_array();
    for (size_t i = 0; i < row->count && row->figures[0] != 0; i++)
        json_array_append_new(array, aob_json_number(row->figures[i]));
    return array;
}

static json_t *values_to_json(const struct aob_paper_figure *figures, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, aob_json_number(figures[i].value));
    return array;
}

static json_t *intervals_to_json(const struct aob_paper_figure *figures, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, aob_json_vector((double[]){figures[i].low, figures[i].high}, 2));
    return array;
}

static json_t *row_to_json(const struct aob_paper_outcome *outcome, size_t count, const char *verdict,
                           const char *reason)
{
    const struct aob_paper_row *row = outcome->row;
    const struct aob_paper_figure *measured = outcome->result.measured;
    return json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:s, s:s, s:s}", "name", row->name, "text",
                     row->text, "claim", row->claim, "unit", row->unit, "figures", texts_figures_to_json(row),
                     "measured", values_to_json(measured, count), "intervals",
                     intervals_to_json(measured, count), "setup", row->setup ? row->setup : "", "verdict",
                     verdict, "reason", reason);
}

static void add_row(struct papers *papers, const struct aob_paper_row *row)
{
    struct aob_paper_outcome outcome = {.row = row};
    struct aob_text reason = {0}, *table = &papers->table;
    enum aob_paper_verdict verdict = judge_row(papers, &outcome, &reason);
    size_t count = row->config && verdict != AOB_PAPER_NOT_RUN ? row->count : 0;
    papers->failed += verdict == AOB_PAPER_NOT_RUN;
    aob_text_add(table, "| %s | %s: %s | %s", row->name, row->text, row->claim, row->unit);
    add_texts_figures(table, row);
    aob_text_add(table, " | ");
    for (size_t i = 0; i < count; i++) {
        aob_text_add(table, "%s", i ? ", " : "");
        aob_paper_figure_print(outcome.result.measured[i], table);
    }
    aob_text_add(table, " | %s | %s |", row->setup ? row->setup : "", aob_paper_verdicts[verdict]);
    aob_paper_cell(table, reason.data ? reason.data : "");
    aob_text_add(table, "\n");
    json_array_append_new(papers->rows, row_to_json(&outcome, count, aob_paper_verdicts[verdict],
                                                    reason.data ? reason.data : ""));
    aob_text_finish(&reason);
}

static const char words[] =
    "\n\nCosts are processor time in units of a fixed pass. Where a row has several, they are in units of "
    "its first;\n"
    "`a / b` is a quotient. In brackets is what the intervals of 95 % of its times allow. A verdict needs "
    "whole\n"
    "intervals on one side of each bar; where one holds a bar, the row's cases are timed again for twice as "
    "long, and\n"
    "once more (not with --quick).\n\n"
    "- *reproduced*: each figure lies within 25 % of the text's; where the text has none, the claim holds.\n"
    "- *shape only*: the figures lie in the text's order, as far as its digits tell them apart, each on its "
    "side of 1.\n"
    "- *not reproduced*: neither. The last column gives a reason where a measured figure shows it.\n"
    "- *not judged*: an interval still holds a bar after the last run, or the text leaves open what a "
    "verdict would\n"
    "  depend on.\n\n"
    "The 25 % are ours and the same for all rows. The text's own devices do not agree better: in the figures "
    "that are\n"
    "taken from HBAO's table its three devices differ from each other by 7 to 50 %. Where a text says\n"
    "\"indistinguishable\", \"corrected\", \"matches\" or \"exact\" and gives no figure, the bar is 1/255, "
    "the step of an\n"
    "image of 8 bits; that bar is ours as well.\n";

/* Whose times they are, what the words mean, the table. */
static void write_page(const struct papers *papers, const struct aob_modelled_table *modelled,
                       struct aob_text *page)
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
    aob_text_add(page, "%s", words);
    if (json_array_size(papers->rows))
        aob_text_add(page, "\n%s", papers->table.data);
    if (modelled->text.size)
        aob_text_add(page, "%s", modelled->text.data);
}

static bool write_all(const struct papers *papers, const struct aob_modelled_table *modelled,
                      struct aob_error *error)
{
    const struct aob_papers_desc *desc = papers->desc;
    char *path = aob_path_join(papers->out, "papers.md");
    struct aob_text page = {0};
    write_page(papers, modelled, &page);
    bool ok = aob_file_write(path, page.data, page.size, error);
    free(path);
    if (ok && !desc->quiet && !(desc->json && strcmp(desc->json, "-") == 0))
        ok = aob_output_write(page.data, page.size, error);
    aob_text_finish(&page);
    if (!ok || !desc->json)
        return ok;
    json_t *document = json_pack("{s:b, s:O?, s:O, s:O}", "quick", desc->quick, "fingerprint",
                                 papers->fingerprint, "rows", papers->rows, "modelled", modelled->document);
    ok = aob_json_write(document, desc->json, error);
    json_decref(document);
    return ok;
}

/* The table's rows, then the modelled ones. */
static bool measure_all(struct papers *papers, struct aob_error *error)
{
    struct aob_modelled_table modelled;
    for (const struct aob_paper_row *row = aob_paper_rows; row->name; row++)
        if (is_wanted(papers, row->name))
            add_row(papers, row);
    aob_modelled_table_init(&modelled,
                            &(struct aob_modelled_table_desc){aob_modelled_rows, aob_modelled_pairs,
                                                              &papers->runs, papers->desc->filter});
    papers->failed += modelled.failed;
    bool ok = write_all(papers, &modelled, error);
    aob_modelled_table_finish(&modelled);
    return ok;
}

enum aob_exit aob_papers(const struct aob_papers_desc *desc, struct aob_error *error)
{
    struct papers papers = {
        .desc = desc, .out = aob_strdup(desc->out ? desc->out : "results/papers"), .rows = json_array()};
    aob_paper_runs_init(&papers.runs, desc, papers.out);
    aob_text_add(&papers.table,
                 "| row | text and claim | figures of the text | measured | set-up | verdict | why not |\n"
                 "|---|---|---|---|---|---|---|\n");
    bool ok = check_rows(&papers, error) && check_modules(&papers, error) &&
              aob_folder_create(papers.out, error) && aob_json_check(desc->json, error) &&
              measure_all(&papers, error);
    json_decref(papers.rows);
    json_decref(papers.fingerprint);
    aob_text_finish(&papers.table);
    aob_paper_runs_finish(&papers.runs);
    free(papers.out);
    return !ok ? AOB_EXIT_USAGE : papers.failed ? AOB_EXIT_PART : AOB_EXIT_OK;
}
