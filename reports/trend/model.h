/* What the trend page draws: lines beside the nights of their configs, with their levels. Pure functions of structs that
 * stay the caller's. */
#ifndef AOB_REPORTS_TREND_MODEL_H
#define AOB_REPORTS_TREND_MODEL_H
#include "history/level.h"
#include "history/line.h"
#include "history/night.h"

/* The nights of one config, in the order of their ids. */
struct aob_trend_calendar {
    const char *name; /* the config's */
    size_t index;     /* its place in the model */
    const struct aob_night **nights;
    double
        *days; /* when each began, in days since 1970; where the date is none, a day after the night before */
    size_t count, capacity;
};

/* A point of a line whose night is known. */
struct aob_trend_dot {
    const struct aob_point *point;
    size_t night; /* its place in the calendar */
    size_t level; /* that it lies in, or beside as an outlier; SIZE_MAX: it has no ratio, and so no level */
};

struct aob_trend_series {
    const struct aob_line *line;
    const struct aob_trend_calendar *calendar;
    struct aob_trend_dot *dots;
    size_t count;
    struct aob_levels levels; /* starts: places of dots; values: ratios to the fixed pass */
};

struct aob_trend_model {                  /* zero it first */
    struct aob_trend_calendar *calendars; /* in the order in which lines and nights first name them */
    size_t calendar_count;
    struct aob_trend_series *series; /* one a line, in the lines' order */
    size_t count;
};

void aob_trend_model_make(const struct aob_lines *lines, const struct aob_nights *nights,
                          struct aob_trend_model *model);
void aob_trend_model_finish(struct aob_trend_model *model);

/* The night's place in the calendar; SIZE_MAX: it has none. */
size_t aob_trend_calendar_place(const struct aob_trend_calendar *calendar, int64_t night);

/* When a dot's night began, as in the history. */
const char *aob_trend_dot_date(const struct aob_trend_series *series, size_t dot);
#endif
