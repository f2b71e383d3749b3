/* bench_watch NIGHTS.tsv PAIRS.tsv HISTORIES: how the watch of a history does on 90 nights of 200 series whose noise was
 * recorded (watch_record.sh writes the two files). A block of as many series as were recorded takes the noise of one recorded
 * night, drawn for each block and night, so what moved the cases of a night together moves them together here. What is
 * suspected is measured again: five to ten successive recorded processes of two equal builds, times the step between the module
 * before `since` and tonight's. An alarm needs a discovery at 5 % and a ratio beyond 2 % and the noise floor. Lines "NAME VALUE". */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/statistics.h"
#include "compare/quotient.h"
#include "compare/verdict.h"
#include "history/watch.h"
#include "random.h"
#include "timing/estimate.h"

enum { NIGHTS = 90, SERIES = 200, PLANTED = 20, FIRST_STEP = 10, WITHIN = 2 };
enum { PROCESSES = 5, PROCESSES_MOST = 10, ROUNDS_MAX = 200 };
static const double least = 0.02, discovery = 0.05;

struct process {
    char recording[64], series[64];               /* "pair-3", "gtao vulkan" */
    double cost[ROUNDS_MAX], control[ROUNDS_MAX]; /* ratios of the two builds, and of the two fixed passes */
    size_t rounds;
};

struct record {
    size_t nights, series;
    double *deviations, *halves; /* [night * series + series]: logarithms */
    double *sigmas;              /* of each series, 1.4826 MAD */
    bool *
        fine; /* 5 % is beyond the bar of a night: three times that, and what one night in twenty is beyond */
    char **names;
    struct process *processes;
    size_t process_count, process_capacity;
};

enum noise { RECORDED, TOGETHER, STUDENT, LAPLACE };

struct study {
    const struct record *record;
    enum noise noise;
    double step; /* logarithm; 0: none is planted */
    uint32_t seed;
    size_t histories, suspects, processes, false_nights, steps, fine_steps, fine_named, told, in_time, named,
        delay;
};

struct history {
    struct aob_point points[SERIES][NIGHTS];
    double truth[SERIES][NIGHTS];
    size_t step[SERIES]; /* its night; NIGHTS: none */
    bool told[SERIES];
    struct aob_watch watches[SERIES];
    struct aob_ratio costs[SERIES], controls[SERIES];
    double p[SERIES];
    bool found[SERIES];
};

static FILE *open_text(const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file) {
        perror(path);
        exit(2);
    }
    return file;
}

static void read_names(char *line, struct record *r)
{
    size_t capacity = 0, count = 0;
    for (char *rest = line, *name; (name = strsep(&rest, "\t\n"));)
        if (*name)
            *AOB_PUSH(r->names, count, capacity) = aob_strdup(name);
}

/* Behind the names a row is a night: deviation and half the interval of each series, in 1e-5. */
static void read_nights(const char *path, struct record *r)
{
    FILE *file = open_text(path);
    char *line = NULL;
    size_t room = 0, count = 0, capacity_d = 0, capacity_h = 0, halves = 0;
    while (getline(&line, &room, file) > 0) {
        if (*line == '#')
            continue;
        if (!r->names) {
            read_names(line, r);
            continue;
        }
        char *at = line, *end;
        for (double value = strtod(at, &end); end != at; at = end, value = strtod(at, &end), count++)
            *(count % 2 ? AOB_PUSH(r->halves, halves, capacity_h)
                        : AOB_PUSH(r->deviations, r->series, capacity_d)) = value * 1e-5;
        r->nights++;
    }
    r->series = r->nights ? r->series / r->nights : 0;
    free(line);
    fclose(file);
}

/* "1,-2,3" in 1e-4 becomes exp of each. */
static size_t read_list(char *text, double *values)
{
    size_t count = 0;
    for (char *rest = text, *part; count < ROUNDS_MAX && (part = strsep(&rest, ",\n"));)
        if (*part)
            values[count++] = exp(1e-4 * atof(part));
    return count;
}

/* A row is a process: its recording and series, the rounds of B / A, and of the control. */
static void read_pairs(const char *path, struct record *r)
{
    FILE *file = open_text(path);
    char *line = NULL;
    size_t room = 0;
    while (getline(&line, &room, file) > 0) {
        char *rest = line, *recording = strsep(&rest, "\t"), *series = strsep(&rest, "\t");
        char *costs = strsep(&rest, "\t");
        if (*line == '#' || !costs || !rest)
            continue;
        struct process *process = AOB_PUSH(r->processes, r->process_count, r->process_capacity);
        snprintf(process->recording, sizeof process->recording, "%s", recording);
        snprintf(process->series, sizeof process->series, "%s", series);
        process->rounds = read_list(costs, process->cost);
        read_list(rest, process->control);
    }
    free(line);
    fclose(file);
}

/* Whether PROCESSES of one recording begin here, of that series. */
static bool is_pair(const struct record *r, size_t first, size_t series)
{
    const struct process *begin = &r->processes[first], *end = begin + PROCESSES - 1;
    return strcmp(begin->recording, end->recording) == 0 && strcmp(begin->series, r->names[series]) == 0;
}

/* The first process of the recording. */
static const struct process *recording_of(const struct record *r, size_t process)
{
    const struct process *first = &r->processes[process];
    while (first > r->processes && strcmp(first[-1].recording, first->recording) == 0)
        first--;
    return first;
}

/* Whether each series has a pair to be measured again with. */
static bool is_whole(const struct record *r)
{
    size_t found = 0;
    for (size_t i = 0; i < r->series; i++)
        for (size_t first = 0, had = found; first + PROCESSES <= r->process_count && found == had; first++)
            found += is_pair(r, first, i);
    return r->nights && found == r->series;
}

static void describe(struct record *r, size_t series)
{
    double *values = AOB_NEW_ARRAY(double, r->nights), middle;
    for (size_t n = 0; n < r->nights; n++)
        values[n] = r->deviations[n * r->series + series];
    middle = aob_median(values, r->nights);
    for (size_t n = 0; n < r->nights; n++)
        values[n] = fabs(values[n] - middle);
    r->sigmas[series] = 1.4826 * aob_median(values, r->nights);
    r->fine[series] = fmax(3 * r->sigmas[series], aob_quantile(values, r->nights, 0.95)) < 0.05;
    free(values);
}

/* Of the same 1.4826 MAD as the recorded noise of the series. */
static double drawn_noise(struct study *s, size_t series)
{
    double sigma = s->record->sigmas[series];
    if (s->noise == LAPLACE)
        return sigma / 1.0277 * (random_unit(&s->seed) < .5 ? -1 : 1) * -log(1 - random_unit(&s->seed));
    double square = -2 * log((1 - random_unit(&s->seed)) * (1 - random_unit(&s->seed))); /* chi^2 of 4 */
    return sigma / 1.0984 * random_normal(&s->seed) / sqrt(square / 4);
}

static void draw_night(struct study *s, struct history *h, size_t night)
{
    const struct record *r = s->record;
    size_t row = 0;
    for (size_t i = 0; i < SERIES; i++) {
        size_t column = i % r->series;
        if (column == 0 && (i == 0 || s->noise != TOGETHER))
            row = random_below(&s->seed, r->nights);
        bool drawn = s->noise == STUDENT || s->noise == LAPLACE;
        double half = r->halves[row * r->series + column];
        double error = drawn ? drawn_noise(s, column) : r->deviations[row * r->series + column];
        double value = h->truth[i][night] + error;
        h->points[i][night] = (struct aob_point){.night = (int64_t)night + 1,
                                                 .status = "ok",
                                                 .ratio = exp(value),
                                                 .low = exp(value - half),
                                                 .high = exp(value + half)};
    }
}

static void plant(struct study *s, struct history *h)
{
    memset(h, 0, sizeof *h);
    for (size_t i = 0; i < SERIES; i++)
        h->step[i] = NIGHTS;
    for (size_t k = 0; k < PLANTED && s->step != 0; k++) {
        size_t i = k * (SERIES / PLANTED) + random_below(&s->seed, SERIES / PLANTED);
        h->step[i] = FIRST_STEP + random_below(&s->seed, NIGHTS - WITHIN - FIRST_STEP);
        for (size_t n = h->step[i]; n < NIGHTS; n++)
            h->truth[i][n] = s->step;
        s->steps++;
        s->fine_steps += s->record->fine[i % s->record->series];
    }
}

/* Successive processes of one recording of the series, where B costs exp(truth) times as much as they found: five, and more as
 * long as the interval reaches farther than half of the difference that counts. */
static size_t measure_again(struct study *s, size_t column, double truth, struct aob_ratio *cost,
                            struct aob_ratio *control)
{
    const struct record *r = s->record;
    struct aob_rounds costs[PROCESSES_MOST], controls[PROCESSES_MOST];
    double ones[ROUNDS_MAX], parts[ROUNDS_MAX];
    size_t first, count = 0;
    do
        first = random_below(&s->seed, r->process_count - PROCESSES + 1);
    while (!is_pair(r, first, column));
    for (size_t i = 0; i < ROUNDS_MAX; i++) {
        ones[i] = 1;
        parts[i] = exp(-truth);
    }
    for (const struct process *p = r->processes + first; count < PROCESSES_MOST; p++) {
        if (p == r->processes + r->process_count || strcmp(p->recording, r->processes[first].recording) != 0)
            p = recording_of(r, first);
        costs[count] = (struct aob_rounds){p->cost, parts, p->rounds};
        controls[count++] = (struct aob_rounds){p->control, ones, p->rounds};
        *cost = aob_estimate_ratio(costs, count);
        if (count >= PROCESSES && log(cost->high / cost->low) <= least)
            break;
    }
    *control = aob_estimate_ratio(controls, count);
    return count;
}

/* The level at which the interval just touches 1. */
static double p_value(const struct aob_ratio *cost, size_t processes)
{
    size_t freedom = processes - 1;
    double side = cost->ratio > 1 ? log(cost->ratio / cost->low) : log(cost->high / cost->ratio);
    double t = aob_student(.05, freedom) * fabs(log(cost->ratio)) / side, low = log(1e-9), high = 0;
    for (int i = 0; i < 40; i++) {
        double middle = .5 * (low + high);
        if (aob_student(exp(middle), freedom) > t)
            low = middle;
        else
            high = middle;
    }
    return exp(.5 * (low + high));
}

static void tell(struct study *s, struct history *h, size_t i, size_t night, bool *false_alarm)
{
    size_t since = h->watches[i].since, step = h->step[i];
    if (step > night || h->told[i]) {
        *false_alarm = true;
        return;
    }
    h->told[i] = true;
    s->told++;
    s->delay += night - step;
    bool named = night - step <= WITHIN && since + WITHIN >= step && since <= step + WITHIN;
    s->in_time += night - step <= WITHIN;
    s->named += named;
    s->fine_named += named && s->record->fine[i % s->record->series];
}

static void judge(struct study *s, struct history *h, size_t i, size_t night, bool *false_alarm)
{
    struct aob_point *point = &h->points[i][night];
    double size = fabs(log(h->costs[i].ratio)), floor = aob_noise_floor(&h->controls[i]);
    bool same = h->costs[i].low > 1 / (1 + least) && h->costs[i].high < 1 + least;
    point->since = h->points[i][h->watches[i].since].night;
    if (h->found[i] && size > log1p(fmax(least, floor))) {
        point->verdict = h->costs[i].ratio > 1 ? AOB_NIGHT_SLOWER : AOB_NIGHT_FASTER;
        tell(s, h, i, night, false_alarm);
    } else if (same && h->watches[i].since < night)
        point->verdict = AOB_NIGHT_MACHINE;
    else {
        point->verdict = same ? AOB_NIGHT_OUTLIER : AOB_NIGHT_OPEN;
        point->since = 0;
    }
}

static void one_night(struct study *s, struct history *h, size_t night)
{
    bool false_alarm = false;
    draw_night(s, h, night);
    for (size_t i = 0; i < SERIES; i++) {
        struct aob_watch *watch = &h->watches[i];
        aob_watch_line(h->points[i], night + 1, least, watch);
        h->p[i] = NAN;
        if (!watch->suspect)
            continue;
        double before = watch->since ? h->truth[i][watch->since - 1] : 0;
        size_t processes = measure_again(s, i % s->record->series, h->truth[i][night] - before, &h->costs[i],
                                         &h->controls[i]);
        h->p[i] = p_value(&h->costs[i], processes);
        s->processes += processes;
        s->suspects++;
    }
    aob_watch_discover(h->p, SERIES, discovery, h->found);
    for (size_t i = 0; i < SERIES; i++)
        if (h->watches[i].suspect)
            judge(s, h, i, night, &false_alarm);
    s->false_nights += false_alarm;
}

static void run_study(const struct record *record, const char *name, enum noise noise, double step,
                      size_t histories)
{
    struct study s = {.record = record, .noise = noise, .step = step, .seed = 1, .histories = histories};
    struct history *h = AOB_NEW(struct history);
    for (size_t i = 0; i < histories; i++) {
        plant(&s, h);
        for (size_t night = 0; night < NIGHTS; night++)
            one_night(&s, h, night);
    }
    double nights = (double)(histories * NIGHTS), steps = (double)s.steps;
    printf("%s_suspects %.2f\n%s_false %.2f\n", name, (double)s.suspects / nights, name,
           100 * (double)s.false_nights / nights);
    printf("%s_processes %.1f\n", name, (double)s.processes / (double)s.suspects);
    if (s.steps) {
        printf("%s_steps %zu\n%s_named %.1f\n", name, s.steps, name, 100 * (double)s.named / steps);
        printf("%s_fine %.1f\n%s_in_time %.1f\n", name, 100 * (double)s.fine_named / (double)s.fine_steps,
               name, 100 * (double)s.in_time / steps);
        printf("%s_told %.1f\n%s_delay %.2f\n", name, 100 * (double)s.told / steps, name,
               (double)s.delay / (double)s.told);
    }
    fflush(stdout);
    free(h);
}

int main(int argc, char **argv)
{
    struct record record = {0};
    size_t histories = argc == 4 ? strtoul(argv[3], NULL, 10) : 0;
    size_t fine = 0;
    if (!histories)
        return fprintf(stderr, "usage: bench_watch NIGHTS.tsv PAIRS.tsv HISTORIES\n"), 2;
    read_nights(argv[1], &record);
    read_pairs(argv[2], &record);
    if (!is_whole(&record))
        return fprintf(stderr, "bench_watch: a series has no recorded pair of five processes\n"), 2;
    record.sigmas = AOB_NEW_ARRAY(double, record.series);
    record.fine = AOB_NEW_ARRAY(bool, record.series);
    for (size_t i = 0; i < record.series; i++)
        describe(&record, i);
    for (size_t i = 0; i < record.series; i++)
        fine += record.fine[i];
    printf("fine %zu\n", fine);
    printf("nights %zu\nseries %zu\nprocesses %zu\nsigma %.2f\n", record.nights, record.series,
           record.process_count, 100 * aob_median(record.sigmas, record.series));
    run_study(&record, "none", RECORDED, 0, histories);
    run_study(&record, "together", TOGETHER, 0, histories);
    run_study(&record, "five", RECORDED, log(1.05), histories);
    run_study(&record, "three", RECORDED, log(1.03), histories);
    run_study(&record, "two", RECORDED, log(1.02), histories);
    run_study(&record, "student", STUDENT, log(1.05), histories);
    run_study(&record, "laplace", LAPLACE, log(1.05), histories);
    free(record.deviations);
    free(record.halves);
    for (size_t i = 0; i < record.series; i++)
        free(record.names[i]);
    free(record.names);
    free(record.sigmas);
    free(record.fine);
    free(record.processes);
    return 0;
}
