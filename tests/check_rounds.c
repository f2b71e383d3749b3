/* check_rounds FOLDER: makes the figures of each timed record of a run again from its raw rounds, and compares them with
 * those that stand in the journal. A line for each that differs; the last says how many records were compared. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "store/journal.h"
#include "timing/estimate.h"
#include "timing/forecast.h"
#include "timing/summary.h"

static int differences;

/* To the digits of a journal. */
static void compare(const json_t *time, const char *name, double again)
{
    double stored = aob_json_to_number(json_object_get(time, name));
    bool same = isfinite(again) ? fabs(stored - again) <= 1e-8 * fabs(again)
                                : stored == again || (isnan(again) && isnan(stored));
    if (!same)
        differences += printf("%s: %.17g in the journal, %.17g again\n", name, stored, again) > 0;
}

static void compare_times(const json_t *object, const struct aob_times *times, const struct aob_ratio *ratio)
{
    compare(object, "cpu_ms", times->ms[AOB_CLOCK_CPU]);
    compare(object, "wall_ms", times->ms[AOB_CLOCK_WALL]);
    compare(object, "device_ms", times->ms[AOB_CLOCK_DEVICE]);
    compare(object, "ratio_to_ref", ratio->ratio);
    compare(object, "ci_low", ratio->bounded ? ratio->low : NAN);
    compare(object, "ci_high", ratio->bounded ? ratio->high : NAN);
}

static void compare_record(const json_t *time, const struct aob_round_list *rounds, size_t slot)
{
    struct aob_summary again;
    aob_summarise(rounds, slot, &again);
    struct aob_ratio control = aob_rounds_ratio(rounds, AOB_SLOT_CONTROL);
    const json_t *passes = json_object_get(time, "passes");
    double measured = 0;
    for (size_t r = 0; r < rounds->count; r++)
        measured += aob_round_seconds(&rounds->items[r]);
    compare_times(time, &again.whole, &again.to_fixed);
    compare(time, "precision", again.to_fixed.bounded ? aob_estimate_half_width(&again.to_fixed) : NAN);
    const struct aob_processes_desc asked = {
        .precision = aob_json_to_number(json_object_get(time, "precision_wanted"))};
    compare(time, "seconds_needed", aob_seconds_needed(rounds, slot, &asked));
    compare(time, "seconds", measured / (double)(rounds->items[0].slot_count - AOB_SLOT_CASES));
    compare(time, "rounds", (double)again.rounds);
    compare(time, "clean_rounds", (double)again.clean_rounds);
    compare(time, "processes", again.processes);
    compare(time, "frames", again.frames);
    compare(time, "control_low", control.low);
    compare(time, "control_high", control.high);
    if (json_array_size(passes) != again.pass_count)
        differences += printf("%zu passes, %zu again\n", json_array_size(passes), again.pass_count) > 0;
    for (size_t p = 0; p < again.pass_count; p++)
        compare_times(json_array_get(passes, p), &again.passes[p], &again.pass_to_fixed[p]);
}

/* The record's slot is where its key stands. */
static bool check_record(const char *folder, const json_t *record, struct aob_error *error)
{
    const json_t *time = json_object_get(record, "time"), *key = json_object_get(record, "key"), *name;
    char *path = aob_path_join(folder, json_string_value(json_object_get(time, "rounds_file")));
    struct aob_round_list rounds;
    bool ok = aob_rounds_read(path, &rounds, error);
    size_t slot;
    free(path);
    if (!ok)
        return false;
    json_array_foreach(json_object_get(time, "slots"), slot, name)
    {
        if (json_equal(name, key))
            compare_record(time, &rounds, slot);
    }
    aob_rounds_finish(&rounds);
    return true;
}

int main(int argc, char **argv)
{
    struct aob_error error = {{0}};
    char *journal = aob_path_join(argc > 1 ? argv[1] : ".", "journal.jsonl");
    json_t *records = aob_journal_read(journal, NULL, &error), *record;
    size_t at, checked = 0;
    bool ok = records;
    json_array_foreach(records, at, record)
    {
        bool timed = json_is_string(json_object_get(json_object_get(record, "time"), "rounds_file"));
        ok = ok && (!timed || check_record(argv[1], record, &error));
        checked += ok && timed;
    }
    if (!ok)
        aob_error_print(&error);
    printf("%zu records, %d differences\n", checked, differences);
    json_decref(records);
    free(journal);
    return ok && !differences ? 0 : 1;
}
