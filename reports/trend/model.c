#include "model.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "base/memory.h"
#include "base/table.h"
#include "fit.h"

static double days_of(const char *date, double otherwise)
{
    struct tm parts = {0};
    const char *end = strptime(date, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return end && !*end ? (double)timegm(&parts) / 86400 : otherwise;
}

static void add_night(struct aob_trend_calendar *calendar, const struct aob_night *night)
{
    size_t at = calendar->count;
    *AOB_PUSH(calendar->nights, calendar->count, calendar->capacity) = night;
    calendar->days = aob_realloc(calendar->days, calendar->capacity, sizeof *calendar->days);
    calendar->days[at] = days_of(night->date, at ? calendar->days[at - 1] + 1 : 0);
}

/* Calendars of all names, and the place of each line's in `of_lines`. */
static void make_calendars(struct aob_trend_model *model, const struct aob_lines *lines,
                           const struct aob_nights *nights, size_t *of_lines)
{
    struct aob_table names = {0};
    size_t capacity = 0;
    for (size_t i = 0; i < lines->count + nights->count; i++) {
        bool is_line = i < lines->count;
        const char *name = is_line ? lines->items[i].config : nights->items[i - lines->count].name;
        size_t at = aob_table_put(&names, name, model->calendar_count);
        if (at == model->calendar_count)
            *AOB_PUSH(model->calendars, model->calendar_count, capacity) =
                (struct aob_trend_calendar){.name = name, .index = at};
        if (is_line)
            of_lines[i] = at;
        else
            add_night(&model->calendars[at], &nights->items[i - lines->count]);
    }
    aob_table_finish(&names);
}

size_t aob_trend_calendar_place(const struct aob_trend_calendar *calendar, int64_t night)
{
    size_t low = 0, high = calendar->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (calendar->nights[middle]->id < night)
            low = middle + 1;
        else
            high = middle;
    }
    return low < calendar->count && calendar->nights[low]->id == night ? low : SIZE_MAX;
}

const char *aob_trend_dot_date(const struct aob_trend_series *series, size_t dot)
{
    return series->calendar->nights[series->dots[dot].night]->date;
}

static void make_series(struct aob_trend_series *series, const struct aob_line *line,
                        const struct aob_trend_calendar *calendar)
{
    *series =
        (struct aob_trend_series){line, calendar, AOB_NEW_ARRAY(struct aob_trend_dot, line->count), 0, {0}};
    for (size_t i = 0; i < line->count; i++) {
        size_t night = aob_trend_calendar_place(calendar, line->points[i].night);
        if (night != SIZE_MAX)
            series->dots[series->count++] = (struct aob_trend_dot){&line->points[i], night, SIZE_MAX};
    }
    aob_trend_fit(series);
}

void aob_trend_model_make(const struct aob_lines *lines, const struct aob_nights *nights,
                          struct aob_trend_model *model)
{
    size_t *of_lines = AOB_NEW_ARRAY(size_t, lines->count);
    make_calendars(model, lines, nights, of_lines);
    model->series = AOB_NEW_ARRAY(struct aob_trend_series, lines->count);
    model->count = lines->count;
    for (size_t i = 0; i < lines->count; i++)
        make_series(&model->series[i], &lines->items[i], &model->calendars[of_lines[i]]);
    free(of_lines);
}

void aob_trend_model_finish(struct aob_trend_model *model)
{
    for (size_t i = 0; i < model->count; i++) {
        aob_levels_finish(&model->series[i].levels);
        free(model->series[i].dots);
    }
    for (size_t i = 0; i < model->calendar_count; i++) {
        free(model->calendars[i].nights);
        free(model->calendars[i].days);
    }
    free(model->series);
    free(model->calendars);
    *model = (struct aob_trend_model){0};
}
