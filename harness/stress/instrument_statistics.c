#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "chance.h"
#include "instruments.h"
#include "timing/estimate.h"

enum { PROCESSES = 5, ROUNDS = 24, SAMPLES = 40 };

/* Rounds as machines give them: processes differ, rounds scatter, and now and then one is twice as long. */
struct times {
    double cost[PROCESSES][ROUNDS], fixed[PROCESSES][ROUNDS];
    struct aob_rounds processes[PROCESSES];
};

static void draw_times(struct aob_chance *chance, struct times *times)
{
    for (size_t p = 0; p < PROCESSES; p++) {
        double level = aob_chance_log(chance, 0.9, 1.1);
        size_t count = 1 + aob_chance_below(chance, ROUNDS);
        for (size_t r = 0; r < count; r++) {
            double busy = aob_chance_once_in(chance, 12) ? 2 : 1;
            times->fixed[p][r] = busy * aob_chance_log(chance, 0.5, 0.55);
            times->cost[p][r] = busy * level * aob_chance_log(chance, 3, 3.3);
        }
        times->processes[p] = (struct aob_rounds){times->cost[p], times->fixed[p], count};
    }
}

/* The largest relative distance of two ratios and of their ends. */
static double apart(const struct aob_ratio *a, const struct aob_ratio *b)
{
    return aob_worse(fabs(a->ratio / b->ratio - 1),
                     aob_worse(fabs(a->low / b->low - 1), fabs(a->high / b->high - 1)));
}

void aob_ask_times_unit(struct aob_trial *trial)
{
    static const double factors[] = {1e-3, 3, 1e6};
    struct aob_chance chance = aob_chance_of("unit");
    for (int i = 0; i < SAMPLES; i++) {
        struct times times;
        draw_times(&chance, &times);
        struct aob_ratio before = aob_estimate_ratio(times.processes, PROCESSES);
        double factor = factors[i % 3];
        for (size_t p = 0; p < PROCESSES; p++)
            for (size_t r = 0; r < times.processes[p].count; r++) {
                times.cost[p][r] *= factor;
                times.fixed[p][r] *= factor;
            }
        struct aob_ratio after = aob_estimate_ratio(times.processes, PROCESSES);
        aob_trial_take(trial, apart(&before, &after), NULL, "times %g: %.9g (%.9g .. %.9g), was %.9g", factor,
                       after.ratio, after.low, after.high, before.ratio);
    }
}

static void swap(double *x, size_t a, size_t b)
{
    double kept = x[a];
    x[a] = x[b];
    x[b] = kept;
}

/* Rounds within their process, and the processes. */
static void shuffle(struct aob_chance *chance, struct times *times)
{
    for (size_t p = 0; p < PROCESSES; p++)
        for (size_t r = times->processes[p].count; r > 1; r--) {
            size_t other = aob_chance_below(chance, r);
            swap(times->cost[p], r - 1, other);
            swap(times->fixed[p], r - 1, other);
        }
    for (size_t p = PROCESSES; p > 1; p--) {
        size_t other = aob_chance_below(chance, p);
        struct aob_rounds kept = times->processes[p - 1];
        times->processes[p - 1] = times->processes[other];
        times->processes[other] = kept;
    }
}

void aob_ask_times_order(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("order");
    for (int i = 0; i < SAMPLES; i++) {
        struct times times;
        draw_times(&chance, &times);
        struct aob_ratio before = aob_estimate_ratio(times.processes, PROCESSES);
        shuffle(&chance, &times);
        struct aob_ratio after = aob_estimate_ratio(times.processes, PROCESSES);
        aob_trial_take(trial, apart(&before, &after), NULL, "%.12g (%.12g .. %.12g), was %.12g", after.ratio,
                       after.low, after.high, before.ratio);
    }
}

void aob_ask_times_identical(struct aob_trial *trial)
{
    for (size_t processes = 1; processes <= PROCESSES; processes++)
        for (double ratio = 0.01; ratio < 1e3; ratio *= 7) {
            struct times times;
            for (size_t p = 0; p < PROCESSES; p++) {
                for (size_t r = 0; r < ROUNDS; r++) {
                    times.fixed[p][r] = 0.37;
                    times.cost[p][r] = 0.37 * ratio;
                }
                times.processes[p] = (struct aob_rounds){times.cost[p], times.fixed[p], ROUNDS};
            }
            struct aob_ratio e = aob_estimate_ratio(times.processes, processes);
            double off = aob_worse(fabs(e.low / ratio - 1),
                                   aob_worse(fabs(e.high / ratio - 1), fabs(e.ratio / ratio - 1)));
            aob_trial_take(trial, e.bounded ? off : NAN, NULL,
                           "%zu processes of ratio %.9g: %.9g (%.9g .. %.9g)", processes, ratio, e.ratio,
                           e.low, e.high);
        }
}

/* Student's t is the half-width of an interval of the level 1 - alpha, in standard errors. */
void aob_ask_times_level(struct aob_trial *trial)
{
    static const double alphas[] = {0.5, 0.2, 0.1, 0.05, 0.01, 0.001};
    for (size_t freedom = 1; freedom < 60; freedom++)
        for (size_t i = 1; i < AOB_COUNT(alphas); i++) {
            double narrow = aob_student(alphas[i - 1], freedom), wide = aob_student(alphas[i], freedom);
            double more = aob_student(alphas[i], freedom + 1);
            aob_trial_take(trial, aob_over(aob_worse(narrow - wide, more - wide)), NULL,
                           "%zu degrees of freedom: t %.9g at alpha %g, %.9g at %g, %.9g with one more",
                           freedom, narrow, alphas[i - 1], wide, alphas[i], more);
        }
}

/* With one degree of freedom it is Cauchy's distribution; with two the quantile is a root. */
void aob_ask_times_student(struct aob_trial *trial)
{
    static const double alphas[] = {0.9, 0.5, 0.2, 0.1, 0.05, 0.01, 0.001};
    for (size_t i = 0; i < AOB_COUNT(alphas); i++) {
        double a = alphas[i], one = 1 / tan(M_PI * a / 2), two = (1 - a) * sqrt(2 / (a * (2 - a)));
        double off = aob_worse(fabs(aob_student(a, 1) / one - 1), fabs(aob_student(a, 2) / two - 1));
        aob_trial_take(trial, off, NULL, "alpha %g: %.9g for %.9g, %.9g for %.9g", a, aob_student(a, 1), one,
                       aob_student(a, 2), two);
    }
}

/* P(Bin(n, 1/2) < k), summed from the smallest term. */
static double below(size_t n, size_t k)
{
    double term = ldexp(1, -(int)n), sum = 0;
    for (size_t i = 0; i < k; i++) {
        sum += term;
        term *= (double)(n - i) / (double)(i + 1);
    }
    return sum;
}

/* Of 1, 2, ... n the ends are their own ranks. They cover the median at 95 % of the time, and one rank less would not. */
void aob_ask_times_median(struct aob_trial *trial)
{
    double x[64];
    for (size_t n = 6; n <= AOB_COUNT(x); n++) {
        double low, high;
        for (size_t i = 0; i < n; i++)
            x[i] = (double)(n - i);
        bool bounded = aob_median_interval(x, n, &low, &high);
        size_t k = (size_t)low;
        double tail = below(n, k), next = below(n, k + 1);
        double off =
            aob_worse(aob_over(tail - 0.025), aob_over(0.025 - next)) + fabs(high - (double)(n + 1 - k));
        aob_trial_take(trial, bounded ? off : NAN, NULL, "%zu rounds: ranks %g .. %g miss %.4f on each side",
                       n, low, high, tail);
    }
}

/* About normal, of mean 0 and variance 1: the sum of twelve even values. */
static double draw_normal(struct aob_chance *chance)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += aob_chance_unit(chance);
    return sum;
}

/* Whether the interval of some processes of nine rounds holds the ratio that they were made from, which is 1. */
static bool covers(struct aob_chance *chance, size_t processes, double between, double within)
{
    struct times times;
    for (size_t p = 0; p < processes; p++) {
        double level = between * draw_normal(chance);
        for (size_t r = 0; r < 9; r++) {
            times.fixed[p][r] = 1;
            times.cost[p][r] = exp(level + within * draw_normal(chance));
        }
        times.processes[p] = (struct aob_rounds){times.cost[p], times.fixed[p], 9};
    }
    struct aob_ratio estimate = aob_estimate_ratio(times.processes, processes);
    return estimate.low <= 1 && 1 <= estimate.high;
}

/* Where rounds make all of the noise, where processes make most of it, and between. */
void aob_ask_times_coverage(struct aob_trial *trial)
{
    static const double between[] = {0, 0.01, 0.04};
    enum { DRAWS = 3600 };
    struct aob_chance chance = aob_chance_of("coverage");
    for (size_t b = 0; b < AOB_COUNT(between); b++)
        for (size_t processes = 3; processes <= PROCESSES; processes++) {
            int covered = 0;
            for (int i = 0; i < DRAWS; i++)
                covered += covers(&chance, processes, between[b], 0.02);
            aob_trial_take(trial, aob_over(0.9 - (double)covered / DRAWS), NULL,
                           "%zu processes that differ by %g: %.3f covered", processes, between[b],
                           (double)covered / DRAWS);
        }
}
