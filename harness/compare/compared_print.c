#include <math.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "compared.h"
#include "plane.h"
#include "quotient.h"

static double level_percent(const struct aob_compared_table *table)
{
    return 100 * (1 - table->alpha);
}

static void print_item(const struct aob_compared *item, struct aob_text *out)
{
    const struct aob_judgement *j = &item->judgement;
    struct aob_text line = {0};
    bool known = item->wide.ratio > 0 && !*item->unfit.text;
    aob_text_add(&line, "%-9s ", aob_verdict_names[j->verdict]);
    if (known && item->wide.bounded)
        aob_text_add(&line, "%6.3f [%.3f, %.3f] %6zu ", item->wide.ratio, item->wide.low, item->wide.high,
                     item->cost.rounds);
    else
        aob_text_add(&line, "%6s %-14s %6s ", "-", "-", "-");
    if (isnan(j->rounds_needed))
        aob_text_add(&line, "%6s  ", "-");
    else
        aob_text_add(&line, "%6.0f  ", j->rounds_needed);
    aob_row_describe(item->couple->a, &line);
    aob_text_add_line(out, "%s: %s", line.data, j->reason);
    aob_text_finish(&line);
}

static void print_map(const struct aob_compared_table *table, const struct aob_compared *item,
                      struct aob_text *out)
{
    if (item->image_read && item->image.moved)
        aob_text_add_line(out,
                          "          image: largest difference %.4f, RMSE %.4f, %.2f %% of pixels by more "
                          "than 1/255; map %s/%s.png",
                          item->image.max, item->image.rmse, 100 * item->image.share, table->folder,
                          item->map);
}

static void print_alone(const struct aob_couples *couples, int side, struct aob_text *out)
{
    for (size_t i = 0; i < couples->alone_count[side]; i++) {
        struct aob_text name = {0};
        aob_row_describe(couples->alone[side][i], &name);
        aob_text_add_line(out, "only in %c: %s", "AB"[side], name.data);
        aob_text_finish(&name);
    }
}

static void count(const struct aob_compared_table *table, size_t counts[AOB_VERDICT_COUNT])
{
    for (size_t i = 0; i < table->couples->count; i++)
        counts[table->items[i].judgement.verdict]++;
}

static void print_counts(const struct aob_compared_table *table, struct aob_text *out)
{
    size_t counts[AOB_VERDICT_COUNT] = {0};
    struct aob_text line = {0};
    count(table, counts);
    for (int v = 0; v < AOB_VERDICT_COUNT; v++)
        if (counts[v])
            aob_text_add(&line, "%s%zu %s", line.size ? ", " : "", counts[v], aob_verdict_names[v]);
    aob_text_add_line(out, "%zu case%s: %s; without a partner: %zu of A, %zu of B", table->couples->count,
                      table->couples->count == 1 ? "" : "s", line.data ? line.data : "none",
                      table->couples->alone_count[0], table->couples->alone_count[1]);
    aob_text_finish(&line);
}

/* The median over the couples of how much longer the fixed pass took; NAN where all were timed in one block. */
static double fixed_change(const struct aob_compared_table *table)
{
    double *ratios = AOB_NEW_ARRAY(double, table->couples->count + 1);
    size_t used = 0;
    for (size_t i = 0; i < table->couples->count; i++)
        if (!table->items[i].cost.paired && table->items[i].cost.fixed > 0)
            ratios[used++] = table->items[i].cost.fixed;
    double median = used ? aob_median(ratios, used) : NAN;
    free(ratios);
    return median;
}

void aob_compared_print(const struct aob_compared_table *table, struct aob_text *out)
{
    double fixed = fixed_change(table);
    aob_text_add_line(out, "A: %s; B: %s", table->names[0], table->names[1]);
    aob_text_add_line(
        out,
        "Ratios are B / A. Their intervals hold at %.4g %% each, so that all of them hold at %.4g "
        "%%. A difference counts from %.3g %%.",
        level_percent(table), 100 * (1 - AOB_COMPARE_ALPHA), 100 * table->precision);
    if (fabs(log(fixed)) > log1p(table->precision))
        aob_text_add_line(out,
                          "The fixed pass itself took x %.3f: the machine ran at another speed. Ratios to it "
                          "allow for that.",
                          fixed);
    aob_text_add_line(out, "%-9s %6s %-14s %6s %6s  %s", "verdict", "ratio", "interval", "rounds", "needed",
                      "case: reason");
    for (size_t i = 0; i < table->couples->count; i++) {
        print_item(&table->items[i], out);
        print_map(table, &table->items[i], out);
    }
    print_alone(table->couples, 0, out);
    print_alone(table->couples, 1, out);
    if (aob_plane_any(table))
        aob_text_add_line(out, "cost and error of what moved, from A to B: %s/" AOB_PLANE_FILE,
                          table->folder);
    print_counts(table, out);
}

static json_t *ratio_to_json(const struct aob_ratio *r)
{
    bool known = r->ratio > 0;
    return json_pack("{s:o, s:o, s:o}", "ratio", aob_json_number(known ? r->ratio : NAN), "low",
                     aob_json_number(known && r->bounded ? r->low : NAN), "high",
                     aob_json_number(known && r->bounded ? r->high : NAN));
}

static json_t *image_to_json(const struct aob_compared *item)
{
    const struct aob_image_change *image = &item->image;
    if (!item->image_read)
        return json_null();
    return json_pack("{s:b, s:f, s:f, s:f, s:o}", "moved", image->moved, "max", image->max, "rmse",
                     image->rmse, "share", image->share, "map",
                     item->map ? json_string(item->map) : json_null());
}

static void add_row(json_t *object, const struct aob_row *row)
{
    struct aob_text name = {0};
    aob_row_describe(row, &name);
    json_object_set_new(object, "case", aob_json_text(name.data));
    aob_text_finish(&name);
}

static json_t *item_to_json(const struct aob_compared *item)
{
    static const char *const changes[] = {"unknown", "equal", "less", "more"};
    static const char *const outcomes[] = {"good", "worse", "open"};
    const struct aob_judgement *j = &item->judgement;
    const struct aob_cost *cost = &item->cost;
    json_t *object = json_object();
    add_row(object, item->couple->a);
    json_t *rest =
        json_pack("{s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:i, s:i, s:o, s:b, s:o, s:o, s:o, s:o, s:s, s:o, "
                  "s:s, s:s, s:s}",
                  "key_a", item->couple->a->key, "key_b", item->couple->b->key, "verdict",
                  aob_verdict_names[j->verdict], "cost", aob_verdict_names[j->cost], "interval",
                  ratio_to_json(&item->wide), "interval_95", ratio_to_json(&cost->cost), "delta",
                  aob_json_number(j->delta), "rounds", (int)cost->rounds, "processes", (int)cost->processes,
                  "rounds_needed", aob_json_number(j->rounds_needed), "paired", cost->paired, "rmse_a",
                  aob_json_number(item->errors.a.rmse), "rmse_b", aob_json_number(item->errors.b.rmse),
                  "reference_se_a", aob_json_number(item->errors.a.se), "reference_se_b",
                  aob_json_number(item->errors.b.se), "error", changes[j->error], "image",
                  image_to_json(item), "reason", j->reason, "blame", item->blame.text, "outcome",
                  outcomes[aob_judgement_outcome(j, item->blame.excused)]);
    json_object_update(object, rest);
    json_decref(rest);
    struct aob_place_on_plane a, b;
    aob_plane_find(item, &a, &b);
    json_object_set_new(object, "control", ratio_to_json(&cost->control));
    json_object_set_new(object, "plane",
                        json_pack("{s:[o, o], s:[o, o]}", "a", aob_json_number(a.cost),
                                  aob_json_number(a.error), "b", aob_json_number(b.cost),
                                  aob_json_number(b.error)));
    return object;
}

static json_t *alone_to_json(const struct aob_couples *couples, int side)
{
    json_t *array = json_array();
    for (size_t i = 0; i < couples->alone_count[side]; i++) {
        json_t *object = json_pack("{s:s}", "key", couples->alone[side][i]->key);
        add_row(object, couples->alone[side][i]);
        json_array_append_new(array, object);
    }
    return array;
}

json_t *aob_compared_to_json(const struct aob_compared_table *table)
{
    size_t counts[AOB_VERDICT_COUNT] = {0};
    json_t *cases = json_array(), *verdicts = json_object();
    count(table, counts);
    for (int v = 0; v < AOB_VERDICT_COUNT; v++)
        json_object_set_new(verdicts, aob_verdict_names[v], json_integer((json_int_t)counts[v]));
    for (size_t i = 0; i < table->couples->count; i++)
        json_array_append_new(cases, item_to_json(&table->items[i]));
    return json_pack("{s:o, s:o, s:f, s:f, s:o, s:b, s:o, s:o, s:o, s:o}", "a",
                     aob_json_text(table->names[0]), "b", aob_json_text(table->names[1]), "precision",
                     table->precision, "level", 1 - table->alpha, "fixed",
                     aob_json_number(fixed_change(table)), "same_program", table->same_program, "verdicts",
                     verdicts, "cases", cases, "only_a", alone_to_json(table->couples, 0), "only_b",
                     alone_to_json(table->couples, 1));
}
