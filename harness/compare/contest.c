#include "contest.h"
#include <stdlib.h>
#include <string.h>
#include "base/member.h"
#include "base/memory.h"
#include "compare.h"

/* The rows of each side: of its run, and of its module. */
static void choose_sides(struct aob_contest *c)
{
    for (int side = 0; side < 2; side++) {
        size_t run = c->folders[1] ? (size_t)side : 0;
        c->sides[side] = AOB_NEW_ARRAY(const struct aob_row *, c->rows.count + 1);
        for (size_t i = 0; i < c->rows.count; i++) {
            const struct aob_row *row = &c->rows.list[i];
            bool named = !c->keys || side == 0 || aob_table_find(c->keys, row->key, NULL);
            if (row->run == run && named && (!c->modules[side] || strcmp(row->module, c->modules[side]) == 0))
                c->sides[side][c->counts[side]++] = row;
        }
    }
}

/* A run that was stopped, or a journal that was cut: what it lacks cannot be seen from its cases. What its filters left out
 * it does not lack. */
static void judge_whole(struct aob_contest *c)
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

static bool read_rows(struct aob_contest *c, struct aob_error *error)
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

static bool same_program(const struct aob_contest *c)
{
    const char *a = aob_member_text(c->rows.runs[0].info, "build");
    const char *b = aob_member_text(c->rows.runs[c->rows.run_count - 1].info, "build");
    return *a && strcmp(a, b) == 0;
}

bool aob_contest_read(struct aob_contest *c, struct aob_error *error)
{
    if (!read_rows(c, error))
        return false;
    c->table =
        (struct aob_compared_table){.rows = &c->rows,
                                    .couples = &c->couples,
                                    .names = {c->names[0], c->names[1]},
                                    .folder = c->maps,
                                    .precision = c->precision > 0 ? c->precision : AOB_COMPARE_PRECISION,
                                    .same_program = same_program(c)};
    aob_compared_cost(&c->table);
    return true;
}

bool aob_contest_judge(struct aob_contest *c, double alpha, struct aob_error *error)
{
    return aob_compared_judge(&c->table, alpha, error);
}

void aob_contest_finish(struct aob_contest *c)
{
    aob_compared_finish(&c->table);
    aob_couples_finish(&c->couples);
    aob_rows_finish(&c->rows);
    free(c->sides[0]);
    free(c->sides[1]);
}
