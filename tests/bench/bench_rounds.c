/* bench_rounds FILE PROCESSES ROUNDS TRIALS: whether intervals hold what they say, on recorded rounds. The truth of a slot is
 * the estimate from all rounds; a trial draws PROCESSES of the recorded ones and ROUNDS successive rounds of each. Lines
 * "NAME VALUE": how many rounds there are, then for each slot but the fixed pass the share of trials in per cent whose
 * interval covers the truth, and the share over all slots. */
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"
#include "random.h"
#include "timing/estimate.h"
#include "timing/rounds.h"

enum { PROCESSES_MAX = 100 };

/* The rounds of the file as two columns for each process. */
struct record {
    struct aob_round_list list;
    double *cost, *fixed;
    size_t first[PROCESSES_MAX + 1], count; /* process p has the rounds first[p] .. first[p + 1] - 1 */
};

static void split(struct record *record)
{
    for (size_t r = 0; r < record->list.count; r++)
        if (r == 0 || record->list.items[r].process != record->list.items[r - 1].process)
            record->first[record->count++] = r;
    record->first[record->count] = record->list.count;
}

static void take_slot(struct record *record, size_t slot)
{
    for (size_t r = 0; r < record->list.count; r++) {
        const struct aob_round *round = &record->list.items[r];
        record->cost[r] = aob_slot_ms(&round->slots[slot], round->clock);
        record->fixed[r] = aob_slot_ms(&round->slots[AOB_SLOT_FIXED], round->clock);
    }
}

/* At most `rounds` successive ones of a process, from a random place. */
static struct aob_rounds some_rounds(const struct record *record, size_t process, size_t rounds,
                                     uint32_t *seed)
{
    size_t first = record->first[process], count = record->first[process + 1] - first;
    if (count > rounds) {
        first += random_below(seed, count - rounds + 1);
        count = rounds;
    }
    return (struct aob_rounds){record->cost + first, record->fixed + first, count};
}

static double true_ratio(const struct record *record)
{
    struct aob_rounds all[PROCESSES_MAX];
    uint32_t seed = 0;
    for (size_t p = 0; p < record->count; p++)
        all[p] = some_rounds(record, p, SIZE_MAX, &seed);
    return aob_estimate_ratio(all, record->count).ratio;
}

static int covered(const struct record *record, size_t processes, size_t rounds, int trials)
{
    struct aob_rounds drawn[PROCESSES_MAX];
    size_t deck[PROCESSES_MAX];
    uint32_t seed = 1;
    int count = 0;
    double truth = true_ratio(record);
    for (size_t p = 0; p < record->count; p++)
        deck[p] = p;
    for (int t = 0; t < trials; t++) {
        for (size_t i = 0; i < processes; i++) { /* the front of a shuffled deck */
            size_t j = i + random_below(&seed, record->count - i), moved = deck[i];
            deck[i] = deck[j];
            deck[j] = moved;
            drawn[i] = some_rounds(record, deck[i], rounds, &seed);
        }
        struct aob_ratio ratio = aob_estimate_ratio(drawn, processes);
        count += ratio.low <= truth && truth <= ratio.high;
    }
    return count;
}

int main(int argc, char **argv)
{
    struct record record = {.count = 0};
    struct aob_error error = {{0}};
    size_t processes = argc == 5 ? strtoul(argv[2], NULL, 10) : 0, slots = 0;
    size_t rounds = argc == 5 ? strtoul(argv[3], NULL, 10) : 0;
    int trials = argc == 5 ? atoi(argv[4]) : 0, all = 0;
    if (!processes || !rounds || trials < 1 || !aob_rounds_read(argv[1], &record.list, &error)) {
        fprintf(stderr, "bench_rounds: %s\n", *error.text ? error.text : "FILE PROCESSES ROUNDS TRIALS");
        return 2;
    }
    record.cost = AOB_NEW_ARRAY(double, record.list.count);
    record.fixed = AOB_NEW_ARRAY(double, record.list.count);
    split(&record);
    slots = record.list.items[0].slot_count;
    printf("processes %zu\nrounds %zu\n", record.count, record.list.count);
    for (size_t slot = AOB_SLOT_CONTROL; slot < slots && processes <= record.count; slot++) {
        take_slot(&record, slot);
        int count = covered(&record, processes, rounds, trials);
        printf("slot_%zu %.1f\n", slot, 100.0 * count / trials);
        all += count;
    }
    printf("all %.1f\n", 100.0 * all / trials / (double)(slots - 1));
    free(record.cost);
    free(record.fixed);
    aob_rounds_finish(&record.list);
    return 0;
}
