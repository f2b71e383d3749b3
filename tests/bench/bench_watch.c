/* bench_watch NIGHTS.tsv PAIRS.tsv HISTORIES: how the watch of a history does on 90 nights of 200 series whose noise was
 * recorded (watch_recorded.h; watch_record.sh writes the two files). A block of as many series as were recorded takes the noise
 * of one recorded night, drawn for each block and night, so what moved the cases of a night together moves them together
 * here. What is suspected, and what it is set beside, is chosen by aob_suspects_choose. It is measured again with successive
 * recorded processes of two builds of equal code, times the step between the old build and tonight's, and judged as settle.c
 * does. What the new build alone costs then has the noise of the recorded night after tonight's. A study of the held-out
 * nights, and two of those that the rule was chosen on. Lines "NAME VALUE". */
#include <inttypes.h>
#include "compare/compare.h"
#include "compare/quotient.h"
#include "compare/verdict.h"
#include "nightly/nightly.h"
#include "nightly/suspect.h"
#include "random.h"
#include "timing/estimate.h"
#include "timing/processes.h"
#include "watch_recorded.h"

enum { NIGHTS = 90, SERIES = 200, PLANTED = 20, FIRST_STEP = 10, WITHIN = 2 };
enum { PROCESSES_MOST = (int)(AOB_COMPARE_SECONDS / AOB_PROCESS_SECONDS) };
static const double least = AOB_COMPARE_PRECISION;
static const uint32_t first_seed = 1;

enum noise { RECORDED, TOGETHER, STUDENT, LAPLACE };

struct study {
    const struct record *record;
    enum noise noise;
    double step; /* logarithm; 0: none is planted */
    uint32_t seed;
    size_t histories, suspects, processes, false_nights, steps, quiet_steps, quiet_named, told, in_time,
        named, delay, open, machine, outlier;
};

struct history {
    char ok[3];
    struct aob_night nights[NIGHTS];
    struct aob_line lines[SERIES];
    struct aob_point points[SERIES][NIGHTS];
    double truth[SERIES][NIGHTS];
    size_t rows[SERIES]; /* recorded night that tonight has the noise of */
    size_t step[SERIES]; /* its night; NIGHTS: none */
    bool told[SERIES];
    struct aob_comparison again[SERIES]; /* of what was measured again; the interval is one of 95 % */
    double alone[SERIES];                /* what the new build costs then, in fixed passes */
};

/* Of the same 1.4826 MAD as the recorded noise of the series. */
static double drawn_noise(struct study *s, size_t series)
{
    double sigma = s->record->sigmas[series];
    if (s->noise == LAPLACE)
        return sigma / 1.0277 * (random_unit(&s->seed) < .5 ? -1 : 1) * -log(1 - random_unit(&s->seed));
    double square = -2 * log((1 - random_unit(&s->seed)) * (1 - random_unit(&s->seed))); /* chi^2 of 4 */
    return sigma / 1.0984 * random_normal(&s->seed) / sqrt(square / 4);
}

static double noise_of(struct study *s, size_t row, size_t column)
{
    bool drawn = s->noise == STUDENT || s->noise == LAPLACE;
    return drawn ? drawn_noise(s, column) : s->record->deviations[row * s->record->series + column];
}

static void draw_night(struct study *s, struct history *h, size_t night)
{
    const struct record *r = s->record;
    size_t row = 0;
    for (size_t i = 0; i < SERIES; i++) {
        size_t column = i % r->series;
        if (column == 0 && (i == 0 || s->noise != TOGETHER))
            row = random_below(&s->seed, r->nights);
        double half = r->halves[row * r->series + column];
        double value = h->truth[i][night] + noise_of(s, row, column);
        h->rows[i] = row;
        h->points[i][night] = (struct aob_point){.night = (int64_t)night + 1,
                                                 .status = h->ok,
                                                 .ratio = exp(value),
                                                 .low = exp(value - half),
                                                 .high = exp(value + half)};
        h->lines[i] = (struct aob_line){.id = (int64_t)i + 1, .points = h->points[i], .count = night + 1};
    }
    h->nights[night] = (struct aob_night){.id = (int64_t)night + 1, .whole = true, .summary = h->ok};
}

static void plant(struct study *s, struct history *h)
{
    memset(h, 0, sizeof *h);
    strcpy(h->ok, "ok");
    for (size_t i = 0; i < SERIES; i++)
        h->step[i] = NIGHTS;
    for (size_t k = 0; k < PLANTED && s->step != 0; k++) {
        size_t i = k * (SERIES / PLANTED) + random_below(&s->seed, SERIES / PLANTED);
        h->step[i] = FIRST_STEP + random_below(&s->seed, NIGHTS - WITHIN - FIRST_STEP);
        for (size_t n = h->step[i]; n < NIGHTS; n++)
            h->truth[i][n] = s->step;
        s->steps++;
        s->quiet_steps += s->record->quiet[i % s->record->series];
    }
}

static const struct recording *draw_recording(struct study *s, size_t series)
{
    const struct record *r = s->record;
    const struct recording *drawn;
    do
        drawn = &r->recordings[random_below(&s->seed, r->recording_count)];
    while (!is_of_part(r, drawn, series));
    return drawn;
}

/* Processes of one recording from any of them on, each once, where B costs exp(truth) times as much as they found: as many as
 * the timing takes until it is precise, or as the seconds or the recording allow. */
static void measure_again(struct study *s, size_t column, double truth, struct aob_comparison *again)
{
    const struct recording *recording = draw_recording(s, column);
    struct aob_rounds costs[PROCESSES_MOST], controls[PROCESSES_MOST];
    double ones[ROUNDS_MAX], parts[ROUNDS_MAX];
    size_t at = random_below(&s->seed, recording->count), count = 0;
    for (size_t i = 0; i < ROUNDS_MAX; i++) {
        ones[i] = 1;
        parts[i] = exp(-truth);
    }
    *again = (struct aob_comparison){.resolution = least};
    while (count < PROCESSES_MOST && count < recording->count) {
        const struct process *p = &s->record->processes[recording->first + (at + count) % recording->count];
        costs[count] = (struct aob_rounds){p->cost, parts, p->rounds};
        controls[count++] = (struct aob_rounds){p->control, ones, p->rounds};
        again->rounds += p->rounds;
        again->cost = aob_estimate_ratio(costs, count);
        if (count >= AOB_COMPARE_PROCESSES_AB && again->rounds >= AOB_PROCESSES_ROUNDS &&
            aob_estimate_half_width(&again->cost) <= 0.5 * least)
            break;
    }
    again->control = aob_estimate_ratio(controls, count);
    again->processes = count;
    s->processes += count;
}

/* A shift that is told with the wrong sign is as false as one that is none. */
static void tell(struct study *s, struct history *h, size_t i, const struct aob_suspect *suspect,
                 bool *false_alarm)
{
    size_t night = suspect->line->count - 1, since = suspect->watch.since, step = h->step[i];
    bool right = suspect->cost.verdict == (s->step > 0 ? AOB_NIGHT_SLOWER : AOB_NIGHT_FASTER);
    if (step > night || h->told[i] || !right) {
        *false_alarm = true;
        return;
    }
    h->told[i] = true;
    s->told++;
    s->delay += night - step;
    bool named = night - step <= WITHIN && since + WITHIN >= step && since <= step + WITHIN;
    s->in_time += night - step <= WITHIN;
    s->named += named;
    s->quiet_named += named && s->record->quiet[i % s->record->series];
}

/* As judge_cost and judge_same of settle.c. `level`: that of the night. */
static enum aob_night_verdict verdict_of(const struct aob_suspect *suspect,
                                         const struct aob_comparison *again, double alone, double level)
{
    struct aob_comparison wide = *again;
    wide.cost = aob_widen(&again->cost, again->processes, level);
    enum aob_verdict cost = aob_judge(&wide).cost;
    if (cost == AOB_VERDICT_SLOWER || cost == AOB_VERDICT_FASTER)
        return cost == AOB_VERDICT_SLOWER ? AOB_NIGHT_SLOWER : AOB_NIGHT_FASTER;
    bool gone = fabs(log(alone / suspect->watch.before)) <= log1p(suspect->watch.least);
    return cost != AOB_VERDICT_SAME ? AOB_NIGHT_OPEN : gone ? AOB_NIGHT_OUTLIER : AOB_NIGHT_MACHINE;
}

static void judge(struct study *s, struct history *h, size_t i, struct aob_suspect *suspect, double level,
                  bool *false_alarm)
{
    struct aob_point *point = &h->points[i][suspect->line->count - 1];
    suspect->cost.verdict = verdict_of(suspect, &h->again[i], h->alone[i], level);
    point->verdict = suspect->cost.verdict;
    point->since = aob_suspect_since(suspect);
    s->open += point->verdict == AOB_NIGHT_OPEN;
    s->machine += point->verdict == AOB_NIGHT_MACHINE;
    s->outlier += point->verdict == AOB_NIGHT_OUTLIER;
    if (point->verdict == AOB_NIGHT_SLOWER || point->verdict == AOB_NIGHT_FASTER)
        tell(s, h, i, suspect, false_alarm);
}

/* As is_tested and night_level of settle.c: p, or NAN where it does not count. */
static double p_of(const struct aob_comparison *again)
{
    bool tested = again->rounds >= AOB_COMPARE_ROUNDS && again->processes >= AOB_COMPARE_PROCESSES;
    return tested ? aob_ratio_p(&again->cost, again->processes) : NAN;
}

static void one_night(struct study *s, struct history *h, size_t night)
{
    const struct record *r = s->record;
    double p[SERIES], level;
    bool false_alarm = false;
    struct aob_suspects suspects = {0};
    draw_night(s, h, night);
    aob_suspects_choose(&suspects, &(struct aob_lines){h->lines, SERIES},
                        &(struct aob_nights){h->nights, night + 1}, least);
    for (size_t i = 0; i < SERIES; i++) {
        const struct aob_suspect *suspect = &suspects.items[i];
        size_t column = i % r->series;
        p[i] = NAN;
        if (!suspect->watch.suspect)
            continue;
        double now = h->truth[i][night];
        measure_again(s, column, now - h->truth[i][suspect->old - h->points[i]], &h->again[i]);
        h->alone[i] = exp(now + noise_of(s, (h->rows[i] + 1) % r->nights, column));
        p[i] = p_of(&h->again[i]);
        s->suspects++;
    }
    level = aob_watch_level(p, SERIES, AOB_NIGHTLY_DISCOVERY);
    for (size_t i = 0; i < SERIES; i++)
        if (suspects.items[i].watch.suspect)
            judge(s, h, i, &suspects.items[i], level, &false_alarm);
    s->false_nights += false_alarm;
    aob_suspects_finish(&suspects);
}

static void print(const char *study, const char *name, double value)
{
    printf("%s_%s %.2f\n", study, name, value);
}

static void print_study(const struct study *s, const char *name)
{
    double nights = (double)(s->histories * NIGHTS), steps = (double)s->steps;
    print(name, "suspects", (double)s->suspects / nights);
    print(name, "false", 100 * (double)s->false_nights / nights);
    print(name, "processes", (double)s->processes / (double)s->suspects);
    print(name, "open", (double)s->open / nights);
    print(name, "machine", (double)s->machine / nights);
    print(name, "outlier", (double)s->outlier / nights);
    if (s->steps) {
        printf("%s_steps %zu\n%s_quiet_steps %zu\n", name, s->steps, name, s->quiet_steps);
        print(name, "named", 100 * (double)s->named / steps);
        print(name, "quiet", 100 * (double)s->quiet_named / (double)s->quiet_steps);
        print(name, "in_time", 100 * (double)s->in_time / steps);
        print(name, "told", 100 * (double)s->told / steps);
        print(name, "delay", (double)s->delay / (double)s->told);
    }
    fflush(stdout);
}

static void run_study(const struct record *record, const char *name, enum noise noise, double step,
                      size_t histories)
{
    struct study s = {
        .record = record, .noise = noise, .step = step, .seed = first_seed, .histories = histories};
    struct history *h = AOB_NEW(struct history);
    for (size_t i = 0; i < histories; i++) {
        plant(&s, h);
        for (size_t night = 0; night < NIGHTS; night++)
            one_night(&s, h, night);
    }
    print_study(&s, name);
    free(h);
}

static void describe_part(const struct record *r, const char *name)
{
    size_t quiet = 0, pairs = 0, later = 0;
    for (size_t i = 0; i < r->series; i++) {
        quiet += r->quiet[i];
        later += count_recordings(r, i, true) > 0;
    }
    for (size_t i = 0; i < r->recording_count; i++)
        pairs += r->recordings[i].later == r->later;
    printf("%s_nights %zu\n%s_pairs %zu\n%s_quiet_series %zu\n", name, r->nights, name, pairs, name, quiet);
    print(name, "sigma", 100 * aob_median(r->sigmas, r->series));
    if (r->later)
        printf("%s_paired_series %zu\n", name, later);
}

int main(int argc, char **argv)
{
    struct record whole = {0};
    size_t histories = argc == 4 ? strtoul(argv[3], NULL, 10) : 0;
    if (!histories)
        return fprintf(stderr, "usage: bench_watch NIGHTS.tsv PAIRS.tsv HISTORIES\n"), 2;
    read_nights(argv[1], &whole);
    read_pairs(argv[2], &whole);
    if (!is_whole(&whole))
        return fprintf(stderr,
                       "bench_watch: there are no later nights, or a series lacks a pair, or a pair has "
                       "fewer than %d processes\n",
                       PROCESSES_LEAST),
               2;
    struct record chosen = part_of(&whole, false), held = part_of(&whole, true);
    printf("nights %zu\nseries %zu\nprocesses %zu\nseed %" PRIu32 "\nhistories %zu\n", whole.nights,
           whole.series, whole.process_count, first_seed, histories);
    describe_part(&chosen, "chosen");
    describe_part(&held, "held");
    run_study(&held, "none", RECORDED, 0, histories);
    run_study(&held, "five", RECORDED, log(1.05), histories);
    run_study(&chosen, "chosen_none", RECORDED, 0, histories);
    run_study(&chosen, "chosen_five", RECORDED, log(1.05), histories);
    run_study(&held, "together", TOGETHER, 0, histories);
    run_study(&held, "three", RECORDED, log(1.03), histories);
    run_study(&held, "two", RECORDED, log(1.02), histories);
    run_study(&held, "student", STUDENT, log(1.05), histories);
    run_study(&held, "laplace", LAPLACE, log(1.05), histories);
    free(chosen.sigmas);
    free(chosen.quiet);
    free(held.sigmas);
    free(held.quiet);
    record_finish(&whole);
    return 0;
}
