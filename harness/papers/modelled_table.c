#include "modelled_table.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "cell.h"

/* A row while the table is made. */
struct line {
    const struct aob_modelled_row *row;
    struct aob_modelled modelled;
    bool ok; /* it has a time */
};
struct lines {
    struct line *items;
    size_t count, capacity;
};

static const double near = 0.25; /* what two variants on one device may be off by */

static bool is_counted(const struct line *line)
{
    return line->ok && !line->row->open;
}

static double ratio_of(const struct line *line)
{
    return line->modelled.ms / line->row->ms;
}

static void read_line(struct aob_paper_runs *runs, struct line *line, struct aob_error *error)
{
    const struct aob_modelled_row *row = line->row;
    if (!row->config)
        return;
    const json_t *records = aob_paper_runs_get(runs, row->config);
    char *folder = aob_paper_runs_folder(runs, row->config);
    const struct aob_paper_run run = {records, folder};
    if (json_is_string(records))
        aob_fail(error, "%s", json_string_value(records));
    else
        line->ok = aob_modelled_read(row, &run, &line->modelled, error);
    free(folder);
}

static void add_number(struct aob_text *text, const char *format, double number)
{
    aob_text_add(text, " ");
    aob_text_add(text, format, number);
    aob_text_add(text, " |");
}

static void add_times(struct aob_text *text, const struct line *line)
{
    const struct aob_modelled *m = &line->modelled;
    if (line->row->ms > 0)
        aob_text_add(text, " %.3g [%.3g, %.3g] |", line->row->ms, line->row->low, line->row->high);
    else
        aob_text_add(text, " |");
    if (!line->ok) {
        aob_text_add(text, " | | |");
        return;
    }
    aob_text_add(text, " %.3g [%.3g, %.3g] |", m->ms, m->low, m->high);
    add_number(text, "%.2f", ratio_of(line));
    aob_text_add(text, " %s |", m->limit);
}

/* Why the row does not count: it could not be run, or its own reason. */
static const char *reason_of(const struct line *line, const struct aob_error *error)
{
    return *error->text ? error->text : line->row->open ? line->row->open : "";
}

static json_t *line_to_json(const struct line *line, const char *reason)
{
    const struct aob_modelled_row *row = line->row;
    const struct aob_modelled *m = &line->modelled;
    json_t *parts = json_object();
    for (int p = 0; line->ok && p < AOB_MODELLED_PARTS; p++)
        json_object_set_new(parts, aob_modelled_part_names[p], json_real(m->parts[p]));
    return json_pack("{s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:s, s:o, s:b, s:s, s:s}", "name", row->name,
                     "text", row->text, "profile", row->profile ? row->profile : "", "text_ms",
                     aob_json_vector((double[]){row->low, row->ms, row->high}, 3), "ms",
                     line->ok ? json_real(m->ms) : json_null(), "band_ms",
                     aob_json_vector((double[]){m->low, m->high}, 2), "ratio",
                     line->ok ? json_real(ratio_of(line)) : json_null(), "limit", m->limit, "parts", parts,
                     "counted", is_counted(line), "reason", reason, "setup", row->setup);
}

static void add_line(struct aob_modelled_table *table, struct aob_paper_runs *runs, struct line *line)
{
    struct aob_error error = {{0}};
    read_line(runs, line, &error);
    table->failed += *error.text != '\0';
    const char *reason = reason_of(line, &error);
    aob_text_add(&table->text, "| %s |", line->row->name);
    aob_paper_cell(&table->text, line->row->text);
    aob_paper_cell(&table->text, line->row->profile ? line->row->profile : "");
    add_times(&table->text, line);
    aob_paper_cell(&table->text, line->row->setup);
    aob_paper_cell(&table->text, reason);
    aob_text_add(&table->text, "\n");
    json_array_append_new(json_object_get(table->document, "rows"), line_to_json(line, reason));
}

/* Of the lines that count, or of all; of the point, or of one part of it alone. */
enum { POINT = AOB_MODELLED_PARTS };
static struct aob_modelled_sum sum_of(const struct lines *lines, bool all, int part)
{
    double *ratios = AOB_NEW_ARRAY(double, lines->count + 1);
    size_t count = 0;
    for (size_t i = 0; i < lines->count; i++) {
        const struct line *line = &lines->items[i];
        if (!(all ? line->ok : is_counted(line)))
            continue;
        double ms = part == POINT ? line->modelled.ms : line->modelled.parts[part];
        if (ms > 0)
            ratios[count++] = ms / line->row->ms;
    }
    struct aob_modelled_sum sum = aob_modelled_summarise(ratios, count);
    free(ratios);
    return sum;
}

static json_t *sum_to_json(const struct aob_modelled_sum *sum)
{
    return json_pack("{s:i, s:o, s:o, s:o}", "rows", (int)sum->count, "mean", aob_json_number(sum->mean),
                     "scatter", aob_json_number(sum->scatter), "within_2x", aob_json_number(sum->within));
}

static json_t *add_sum(struct aob_text *text, const char *name, const struct aob_modelled_sum *sum)
{
    if (sum->count > 1)
        aob_text_add(text, "| %s | %zu | %.2f | x%.2f | %.0f %% |\n", name, sum->count, sum->mean,
                     sum->scatter, 100 * sum->within);
    return sum_to_json(sum);
}

static void add_sums(struct aob_modelled_table *table, const struct lines *lines)
{
    json_t *alone = json_object();
    struct aob_text *text = &table->text;
    struct aob_modelled_sum sum = sum_of(lines, true, POINT);
    if (sum.count > 1)
        aob_text_add(text, "\n| of modelled / text | rows | geometric mean | scatter (1 sd) | within 2x |\n"
                           "|---|---|---|---|---|\n");
    json_object_set_new(table->document, "all", add_sum(text, "all rows with a time", &sum));
    sum = sum_of(lines, false, POINT);
    json_object_set_new(table->document, "counted", add_sum(text, "the rows that count", &sum));
    for (int part = 0; part < AOB_MODELLED_PARTS; part++) {
        struct aob_text name = {0};
        aob_text_add(&name, "the rows that count, by %s alone", aob_modelled_part_names[part]);
        sum = sum_of(lines, false, part);
        json_object_set_new(alone, aob_modelled_part_names[part], add_sum(text, name.data, &sum));
        aob_text_finish(&name);
    }
    json_object_set_new(table->document, "alone", alone);
}

static const struct line *find_line(const struct lines *lines, const char *name)
{
    for (size_t i = 0; i < lines->count; i++)
        if (strcmp(lines->items[i].row->name, name) == 0)
            return lines->items[i].ok ? &lines->items[i] : NULL;
    return NULL;
}

/* Whether the two are as far apart as in the text. */
static bool add_pair(struct aob_modelled_table *table, const struct line *a, const struct line *b)
{
    const double text = a->row->ms / b->row->ms, modelled = a->modelled.ms / b->modelled.ms;
    const double off = modelled / text - 1;
    aob_text_add(&table->text, "| %s / %s | %.2f | %.2f | %+.0f %% |\n", a->row->name, b->row->name, text,
                 modelled, 100 * off);
    json_array_append_new(json_object_get(table->document, "pairs"),
                          json_pack("{s:s, s:s, s:f, s:f}", "row", a->row->name, "to", b->row->name, "text",
                                    text, "modelled", modelled));
    return fabs(off) <= near;
}

static void add_pairs(struct aob_modelled_table *table, const struct lines *lines,
                      const struct aob_modelled_pair *pairs)
{
    size_t count = 0, hit = 0;
    for (const struct aob_modelled_pair *pair = pairs; pair->row; pair++) {
        const struct line *a = find_line(lines, pair->row), *b = find_line(lines, pair->to);
        if (!a || !b)
            continue;
        if (!count++)
            aob_text_add(&table->text,
                         "\n| variants on one device | text | modelled | off |\n|---|---|---|---|\n");
        hit += add_pair(table, a, b);
    }
    if (count)
        aob_text_add(&table->text, "\n%zu of %zu lie within %.0f %% of the text's.\n", hit, count,
                     100 * near);
    json_object_set_new(table->document, "pairs_within",
                        count ? json_real((double)hit / (double)count) : json_null());
}

static const char words[] = "\n## The texts' milliseconds, modelled\n\n"
                            "These times are *modelled*: each row's case is traced here, at the text's size, "
                            "and the device model turns what\n"
                            "was fetched and executed into milliseconds of the text's device "
                            "([model.md](model.md)). In brackets stand what the\n"
                            "text's digits leave open, and the model's band. Nothing is fitted for a row, a "
                            "device or a technique. The passes are\n"
                            "this program's, which read and reckon more than some texts' did; the set-up "
                            "says where that is known. A row counts\n"
                            "if the text gives all that its time depends on, but for the scene; else the "
                            "last column says what is missing.\n",
                  quick_words[] =
                      "This was a look at the middle columns of each picture: each stands for several of the "
                      "text's, and nothing is\nsummed up.\n",
                  head[] = "\n| row | text | profile | text, ms | modelled, ms | ratio | limit | set-up | "
                           "why it does not count |\n"
                           "|---|---|---|---|---|---|---|---|---|\n";

static void add_lines(struct aob_modelled_table *table, const struct aob_modelled_table_desc *desc,
                      struct lines *lines)
{
    for (const struct aob_modelled_row *row = desc->rows; row->name; row++) {
        if (desc->filter && !strstr(row->name, desc->filter))
            continue;
        if (!lines->count)
            aob_text_add(&table->text, "%s%s%s", words, desc->runs->desc->quick ? quick_words : "", head);
        struct line *line = AOB_PUSH(lines->items, lines->count, lines->capacity);
        *line = (struct line){.row = row};
        add_line(table, desc->runs, line);
    }
}

void aob_modelled_table_init(struct aob_modelled_table *table, const struct aob_modelled_table_desc *desc)
{
    struct lines lines = {0};
    *table = (struct aob_modelled_table){.document = json_pack("{s:[], s:[]}", "rows", "pairs")};
    add_lines(table, desc, &lines);
    if (!desc->runs->desc->quick) {
        add_sums(table, &lines);
        add_pairs(table, &lines, desc->pairs);
    }
    free(lines.items);
}

void aob_modelled_table_finish(struct aob_modelled_table *table)
{
    aob_text_finish(&table->text);
    json_decref(table->document);
    *table = (struct aob_modelled_table){0};
}
