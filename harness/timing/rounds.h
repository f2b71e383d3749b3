/* Raw rounds: what was measured in each turn of a block's slots, before any statistics. A worker sends them as JSON, a run
 * keeps them as rounds/HASH.jsonl.zst, and whatever estimates from them (now, or by a later method) reads them back.
 *
 * The file is a line of JSON a round, compressed (`zstdcat FILE | jq`), and sealed (base/sealed.h): programs that read
 * zstd skip the seal. A line: {process, round, seed, clock, slots[{place, frames, cpu_ns, wall_ns, device_ns,
 * passes{cpu_ns[], wall_ns[], device_ns[]}, involuntary, voluntary, minor_faults, major_faults, steal_ticks}]}; what is
 * not known is null. */
#ifndef AOB_TIMING_ROUNDS_H
#define AOB_TIMING_ROUNDS_H
#include <aobudget/technique.h>
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/causes.h"
#include "base/clock.h"
#include "base/error.h"
#include "plan/plan.h"

/* Slots by their place in the arrays; a round runs them in an order of its own. */
enum {
    AOB_SLOT_FIXED,   /* the fixed pass */
    AOB_SLOT_CONTROL, /* the fixed pass again: what the block cannot resolve */
    AOB_SLOT_CASES,   /* from here on the cases */
    AOB_SLOT_MAX = AOB_SLOT_CASES + AOB_BLOCK_MAX
};
#define AOB_NO_TIME (-1) /* of a clock that the device does not have */

struct aob_spent { /* by each clock, ns; AOB_NO_TIME */
    int64_t ns[AOB_CLOCK_COUNT];
};
struct aob_slot {                                 /* one slot of a round */
    int place;                                    /* in the round, from 0 */
    int frames;                                   /* that ran in it, one after the other */
    struct aob_spent whole, passes[AOB_MAX_PASS]; /* of all its frames; passes: those that are not pruned */
    size_t pass_count;
    struct aob_causes causes; /* what happened meanwhile */
};
struct aob_round {
    int process, number;  /* both from 0; rounds of a process that was lost are nowhere */
    uint32_t seed;        /* of its process, for the order */
    enum aob_clock clock; /* that costs are judged by */
    size_t slot_count;
    struct aob_slot slots[AOB_SLOT_MAX];
};
struct aob_round_list { /* the rounds of each process together; free with aob_rounds_finish */
    struct aob_round *items;
    size_t count, capacity;
};
void aob_rounds_finish(struct aob_round_list *rounds);

/* Milliseconds a frame, positive, as ratios are taken of it. NAN where the clock has no time. Of the whole frame, or of a
 * pass by its place. */
double aob_slot_ms(const struct aob_slot *slot, enum aob_clock clock);
double aob_slot_pass_ms(const struct aob_slot *slot, size_t pass, enum aob_clock clock);

/* No context switch against the process' will, and no processor taken by the host as far as that is known. */
bool aob_slot_is_clean(const struct aob_slot *slot);

double aob_round_seconds(const struct aob_round *round); /* of wall time inside its slots */

/* Whether two rounds are of one block: the same slots with as many passes, by one clock. */
bool aob_round_fits(const struct aob_round *round, const struct aob_round *first);

json_t *aob_round_to_json(const struct aob_round *round);
bool aob_round_from_json(const json_t *object, struct aob_round *round, struct aob_error *error);

/* A file that is whole or not there. */
bool aob_rounds_write(const struct aob_round_list *rounds, const char *path, struct aob_error *error);

/* False after a line that names the file: it is missing, damaged, or holds no rounds of one block. The list is empty
 * then. */
bool aob_rounds_read(const char *path, struct aob_round_list *rounds, struct aob_error *error);
#endif
