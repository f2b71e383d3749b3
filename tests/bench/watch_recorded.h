/* What bench_watch draws from, as watch_record.sh writes it: nights of some series, and pairs of builds of equal code. */
#ifndef AOB_TESTS_BENCH_WATCH_RECORDED_H
#define AOB_TESTS_BENCH_WATCH_RECORDED_H
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/statistics.h"

enum { ROUNDS_MAX = 200, PROCESSES_LEAST = 10 };
/* The rule of the watch was chosen on the first nights, and on the pairs that were recorded until then: pair-0 to pair-9, each
 * after four nights, and 100 to 103, of series that had none. Pairs from pair-10 on came later. */
enum { CHOSEN_NIGHTS = 41, LATER_PAIR = 10, EARLY_PAIR = 100 };

struct process {
    double cost[ROUNDS_MAX], control[ROUNDS_MAX]; /* ratios of the two builds, and of the two fixed passes */
    size_t rounds;
};

struct recording { /* the processes of one pair */
    char name[32], series[64];
    size_t first, count;
    bool later;
};

struct record {
    size_t nights, series;
    double *deviations, *halves; /* [night * series + series]: logarithms */
    double *sigmas;              /* of each series, 1.4826 MAD */
    bool *quiet; /* 5 % is beyond the bar of a night: three times that, and what one night in twenty is off */
    char **names;
    struct process *processes;
    struct recording *recordings;
    size_t process_count, process_capacity, recording_count, recording_capacity;
    bool later; /* its nights are those that the rule was not chosen on */
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

static struct recording *recording_named(struct record *r, const char *name, const char *series)
{
    struct recording *last = r->recording_count ? &r->recordings[r->recording_count - 1] : NULL;
    if (last && strcmp(last->name, name) == 0)
        return last;
    int number = atoi(name + strcspn(name, "0123456789"));
    last = AOB_PUSH(r->recordings, r->recording_count, r->recording_capacity);
    *last =
        (struct recording){.first = r->process_count, .later = number >= LATER_PAIR && number < EARLY_PAIR};
    snprintf(last->name, sizeof last->name, "%s", name);
    snprintf(last->series, sizeof last->series, "%s", series);
    return last;
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
        recording_named(r, recording, series)->count++;
        struct process *process = AOB_PUSH(r->processes, r->process_count, r->process_capacity);
        process->rounds = read_list(costs, process->cost);
        size_t controls = read_list(rest, process->control);
        process->rounds = controls < process->rounds ? controls : process->rounds;
    }
    free(line);
    fclose(file);
}

/* Recordings of the series, with `later` only those. */
static size_t count_recordings(const struct record *r, size_t series, bool later)
{
    size_t count = 0;
    for (size_t i = 0; i < r->recording_count; i++)
        count += strcmp(r->recordings[i].series, r->names[series]) == 0 && (!later || r->recordings[i].later);
    return count;
}

/* Whether a recording of the series is of the part. One that has none later is measured again with its earlier ones. */
static bool is_of_part(const struct record *r, const struct recording *recording, size_t series)
{
    if (strcmp(recording->series, r->names[series]) != 0)
        return false;
    return r->later ? recording->later || count_recordings(r, series, true) == 0 : !recording->later;
}

/* Whether both parts have nights, each series a pair, and each pair so many processes that none is taken twice. */
static bool is_whole(const struct record *r)
{
    bool whole = r->nights > CHOSEN_NIGHTS;
    for (size_t i = 0; i < r->recording_count; i++)
        whole = whole && r->recordings[i].count >= PROCESSES_LEAST;
    for (size_t i = 0; i < r->series; i++)
        whole = whole && count_recordings(r, i, false) > count_recordings(r, i, true);
    return whole;
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
    r->quiet[series] = fmax(3 * r->sigmas[series], aob_quantile(values, r->nights, 0.95)) < 0.05;
    free(values);
}

/* The nights on which the rule was chosen, or the others. */
static struct record part_of(const struct record *whole, bool later)
{
    struct record part = *whole;
    part.later = later;
    part.nights = later ? whole->nights - CHOSEN_NIGHTS : CHOSEN_NIGHTS;
    part.deviations += later ? CHOSEN_NIGHTS * whole->series : 0;
    part.halves += later ? CHOSEN_NIGHTS * whole->series : 0;
    part.sigmas = AOB_NEW_ARRAY(double, part.series);
    part.quiet = AOB_NEW_ARRAY(bool, part.series);
    for (size_t i = 0; i < part.series; i++)
        describe(&part, i);
    return part;
}

static void record_finish(struct record *r)
{
    for (size_t i = 0; i < r->series; i++)
        free(r->names[i]);
    free(r->names);
    free(r->deviations);
    free(r->halves);
    free(r->processes);
    free(r->recordings);
}
#endif
