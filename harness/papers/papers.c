#include "papers.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/output.h"
#include "base/text.h"
#include "config/config.h"
#include "row.h"
#include "run/run.h"
#include "store/journal.h"

enum { AOB_PAPERS_RUNS = 3 }; /* of a config, at most */

struct papers {
    const struct aob_papers_desc *desc;
    char *configs, *out;
    struct aob_text table; /* as Markdown */
    json_t *rows, *ran;    /* ran: config -> its records, or why it failed */
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
    bool ok = aob_dispatch_describe(&papers->desc->dispatch, &papers->desc->dispatch.modules, &list, error);
    if (ok)
        aob_technique_list_finish(&list);
    return ok;
}

/* What a config asks for, doubled with each run of it: twice the time, half the width of its intervals. */
static bool ask(const struct papers *papers, const char *path, int patience, struct aob_run_desc *desc,
                struct aob_error *error)
{
    struct aob_config config;
    if (!aob_config_read(&config, path, error))
        return false;
    desc->seconds = (papers->desc->quick ? 0.1 : config.seconds) * exp2(patience);
    desc->precision = config.precision * exp2(-patience);
    aob_config_finish(&config);
    return true;
}

/* NULL after one line. Cases that are not ok are the rows' concern. */
static json_t *run_once(struct papers *papers, const char *name, const char *folder, int patience,
                        struct aob_error *error)
{
    bool quick = papers->desc->quick;
    char *path = config_path(papers, name), *journal = aob_path_join(folder, "journal.jsonl");
    struct aob_run_desc desc = {.dispatch = papers->desc->dispatch,
                                .config = path,
                                .out = folder,
                                .fresh = true,
                                .quiet = true,
                                .no_page = true,
                                .max_width = quick ? 80 : 0,
                                .max_spp = quick ? 64 : 0};
    if (!papers->desc->quiet)
        aob_note("papers: running %s%s", name, patience ? " again, for longer" : "");
    if (ask(papers, path, patience, &desc, error))
        aob_run(&desc, error);
    json_t *records = *error->text ? NULL : aob_journal_read(journal, NULL, error);
    free(journal);
    free(path);
    return records;
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
        if (wanted(papers, row) && row->config && !row->open && strcmp(row->config, name) == 0 &&
            measure_row(run, &outcome, NULL))
            open = open || aob_paper_judge(row, &outcome.result) == AOB_PAPER_NOT_JUDGED;
    }
    return open;
}

/* Once a config: its rows share the last of its runs. What the journal of that holds, or the text of what went wrong. */
static json_t *run_config(struct papers *papers, const char *name, const char *folder)
{
    json_t *records = json_object_get(papers->ran, name);
    int runs = papers->desc->quick ? 1 : AOB_PAPERS_RUNS;
    for (int patience = 0; !records && patience < runs; patience++) {
        struct aob_error error = {{0}};
        json_t *found = run_once(papers, name, folder, patience, &error);
        const struct aob_paper_run run = {found, folder};
        json_object_set_new(papers->ran, name, found ? found : json_string(error.text));
        if (!found || patience == runs - 1 || !is_open(papers, name, &run))
            records = json_object_get(papers->ran, name);
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
    char *folder = aob_path_join(papers->out, outcome->row->config ? outcome->row->config : "");
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

/* A cell of the table; a reason may be any text. */
static void add_cell(struct aob_text *table, const char *text)
{
    aob_text_add(table, " ");
    for (; *text; text++)
        aob_text_add(table, *text == '|' ? "\\|" : "%c", *text == '\n' ? ' ' : *text);
    aob_text_add(table, " |");
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
    add_cell(table, reason.data ? reason.data : "");
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
    "  depend on.\n"
    "- *needs a device model*: nothing is measured, since it is about the text's device.\n\n"
    "The 25 % are ours and the same for all rows. The text's own devices do not agree better: in the figures "
    "that are\n"
    "taken from HBAO's table its three devices differ from each other by 7 to 50 %. Where a text says\n"
    "\"indistinguishable\", \"corrected\", \"matches\" or \"exact\" and gives no figure, the bar is 1/255, "
    "the step of an\n"
    "image of 8 bits; that bar is ours as well.\n";

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
