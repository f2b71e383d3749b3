#include <math.h>
#include <string.h>
#include "base/text.h"
#include "cell.h"

static void add_subject(const struct aob_stress_row *row, struct aob_text *text)
{
    if (!row->technique)
        aob_text_add(text, "instruments");
    else if (row->technique->module)
        aob_text_add(text, "%s (%s) on %s", row->technique->name, row->technique->module, row->backend);
    else
        aob_text_add(text, "%s on %s", row->technique->name, row->backend);
}

static void print_failure(const struct aob_stress_row *row, const struct aob_stress_cell *cell,
                          struct aob_text *out)
{
    struct aob_text who = {0}, command = {0}, much = {0};
    add_subject(row, &who);
    aob_stress_command(row, cell, &command);
    if (!isnan(cell->worst)) /* else the reason tells it all */
        aob_text_add(&much, "%.4g over a bound of %.4g: ", cell->worst, cell->bound);
    aob_text_add_line(out, "FAIL %s: %s: %s%s", who.data, cell->property->name, much.data ? much.data : "",
                      cell->reason);
    aob_text_add_line(out, "     it is shown again by: %s --out DIR", command.data);
    aob_text_finish(&who);
    aob_text_finish(&command);
    aob_text_finish(&much);
}

static void print_failures(const struct aob_stress_row *row, struct aob_text *out)
{
    for (size_t i = 0; i < row->cell_count; i++)
        if (row->cells[i].outcome == AOB_FAILS)
            print_failure(row, &row->cells[i], out);
}

/* What is worst of a property over all rows. */
static void print_worst(const struct aob_property *property, const struct aob_stress_row *rows, size_t count,
                        struct aob_text *out)
{
    size_t by[4] = {0};
    const struct aob_stress_row *at = NULL;
    double worst = -1, bound = NAN;
    for (size_t r = 0; r < count; r++)
        for (size_t i = 0; i < rows[r].cell_count; i++) {
            const struct aob_stress_cell *cell = &rows[r].cells[i];
            if (cell->property != property)
                continue;
            by[cell->outcome]++;
            if (cell->outcome != AOB_PASSES || !(cell->worst > worst))
                continue;
            at = &rows[r];
            worst = cell->worst;
            bound = cell->bound;
        }
    if (!(by[0] + by[1] + by[2] + by[3]))
        return;
    struct aob_text who = {0};
    if (at)
        add_subject(at, &who);
    aob_text_add_line(out,
                      "%-24s %3zu pass %3zu fail %3zu by definition %3zu n/a  worst pass %.4g of %.4g  %s",
                      property->name, by[AOB_PASSES], by[AOB_FAILS], by[AOB_BY_DEFINITION],
                      by[AOB_NOT_APPLICABLE], at ? worst : NAN, bound, at ? who.data : "");
    aob_text_finish(&who);
}

/* Whether an earlier row of the backend lacks it for the same reason: one line tells it for all. */
static bool is_told(const struct aob_stress_row *rows, size_t at)
{
    for (size_t i = 0; i < at; i++)
        if (rows[i].missing && rows[i].backend && rows[at].backend &&
            strcmp(rows[i].backend, rows[at].backend) == 0 && strcmp(rows[i].missing, rows[at].missing) == 0)
            return true;
    return false;
}

void aob_stress_print(const struct aob_stress_row *rows, size_t count, struct aob_text *out)
{
    struct aob_stress_counts counts = aob_stress_count(rows, count);
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++)
            print_worst(p, rows, count, out);
    for (size_t r = 0; r < count; r++) {
        if (rows[r].missing && !is_told(rows, r))
            aob_text_add_line(out, "MISSING %s", rows[r].missing);
        print_failures(&rows[r], out);
    }
    aob_text_add_line(out, "%zu pass, %zu fail, %zu by definition, %zu n/a", counts.by[AOB_PASSES],
                      counts.by[AOB_FAILS], counts.by[AOB_BY_DEFINITION], counts.by[AOB_NOT_APPLICABLE]);
}
