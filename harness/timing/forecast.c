#include "forecast.h"
#include <math.h>
#include "sides.h"
#include "summary.h"
#include "timing.h"

#define SECONDS_MOST 1e6

static bool scatter_of(const struct aob_round_list *rounds, size_t slot, struct aob_scatter *scatter)
{
    struct aob_sides sides;
    aob_sides_init(&sides, rounds, &(struct aob_sides_desc){slot, AOB_SLOT_FIXED, AOB_SIDES_WHOLE});
    bool ok = aob_estimate_scatter(sides.processes, sides.count, scatter);
    aob_sides_finish(&sides);
    return ok;
}

static double seconds_of(const struct aob_round_list *rounds)
{
    double seconds = 0;
    for (size_t r = 0; r < rounds->count; r++)
        seconds += aob_round_seconds(&rounds->items[r]);
    return seconds;
}

bool aob_forecast_init(struct aob_forecast *forecast, const struct aob_round_list *rounds, size_t slot,
                       int least)
{
    struct aob_scatter scatter;
    *forecast = (struct aob_forecast){.least = least};
    if (!rounds->count)
        return false;
    const size_t slots = rounds->items[0].slot_count;
    forecast->round_s = seconds_of(rounds) / (double)rounds->count / (double)(slots - AOB_SLOT_CASES);
    for (size_t s = AOB_SLOT_CASES; s < slots; s++) {
        if (!scatter_of(rounds, s, &scatter))
            return false;
        forecast->noisiest = fmax(forecast->noisiest, scatter.round);
    }
    if (!scatter_of(rounds, slot, &scatter))
        return false;
    forecast->within = scatter.round;
    forecast->between = aob_scatter_between(&scatter);
    return true;
}

/* How the seconds are shared out. */
struct shape {
    double processes, rounds; /* rounds: of each */
};

/* Behind so many rounds the sign-test interval of the noisiest case is narrow: about that of a median of normal values. */
static double rounds_until_narrow(const struct aob_forecast *f, double precision)
{
    double wanted = log1p(precision) / 1.959964;
    double rounds = ceil(fmin(M_PI / 2 * f->noisiest * f->noisiest / (wanted * wanted), 1e9));
    return (double)aob_timing_check_point((size_t)rounds);
}

static struct shape shape_of(const struct aob_forecast *f, double seconds, double precision)
{
    const struct aob_processes_desc desc = {.least = f->least, .seconds = seconds};
    const double rounding = 1 - 1e-9; /* of a quotient that is whole */
    struct shape shape;
    shape.rounds = ceil(aob_process_describe(&desc, 0).seconds / f->round_s * rounding);
    shape.rounds = fmin(fmax(shape.rounds, AOB_ROUNDS_LEAST), rounds_until_narrow(f, precision));
    shape.processes = ceil(seconds / (shape.rounds * f->round_s) * rounding);
    shape.processes = fmin(fmax(shape.processes, aob_processes_least(&desc)), AOB_PROCESSES_MOST);
    return shape;
}

static bool is_reached(const struct aob_forecast *f, double seconds, double precision)
{
    const struct shape shape = shape_of(f, seconds, precision);
    double explained = aob_scatter_of_median(f->within, shape.rounds);
    const struct aob_scatter scatter = {f->within, hypot(f->between, explained), explained};
    return shape.processes * shape.rounds >= AOB_PROCESSES_ROUNDS &&
           aob_scatter_half_width(&scatter, shape.processes, (size_t)shape.processes) <= log1p(precision);
}

double aob_forecast_seconds(const struct aob_forecast *f, double precision)
{
    double low = f->round_s, high = SECONDS_MOST;
    if (!(f->round_s > 0) || !is_reached(f, high, precision))
        return INFINITY;
    while (high / low > 1 + 1e-9) {
        double middle = sqrt(low * high);
        if (is_reached(f, middle, precision))
            high = middle;
        else
            low = middle;
    }
    const struct shape shape = shape_of(f, high, precision);
    return shape.processes * shape.rounds * f->round_s;
}

double aob_seconds_needed(const struct aob_round_list *rounds, size_t slot,
                          const struct aob_processes_desc *asked)
{
    struct aob_forecast forecast;
    struct aob_ratio ratio = aob_rounds_ratio(rounds, slot);
    if (aob_estimate_half_width(&ratio) <= asked->precision ||
        !aob_forecast_init(&forecast, rounds, slot, asked->least))
        return NAN;
    double spent = seconds_of(rounds) / (double)(rounds->items[0].slot_count - AOB_SLOT_CASES);
    double next = aob_process_describe(asked, 0).seconds;
    return fmax(aob_forecast_seconds(&forecast, asked->precision), spent + next);
}
