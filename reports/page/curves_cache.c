#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "cache_figures.h"
#include "curves.h"

/* A figure that is drawn of each profile. */
struct figure {
    const char *name;  /* in the record */
    const char *file;  /* in the figure's name */
    const char *title; /* behind the profile's */
    const char *label;
    int level; /* -1: the last one, before memory */
    double scale;
    bool knee;
};
static const struct figure figures[] = {
    {"miss_ratio", "misses", "misses of the first level", "misses (% of texels", 0, 100, true},
    {"fills_per_pixel", "fills", "fills of the first level", "fills a pixel (count", 0, 1, false},
    {"bytes_per_pixel", "bytes", "bytes from memory", "read from memory a pixel (bytes", -1, 1, false},
};

struct wanted {
    const struct figure *figure;
    const char *profile;
};

static bool measure(const struct aob_row *row, const void *user, struct aob_curve_point *point)
{
    const struct wanted *wanted = user;
    const json_t *level = aob_row_cache_level(row, wanted->profile, wanted->figure->level);
    double one =
               wanted->figure->scale * aob_member_number(json_object_get(level, "one"), wanted->figure->name),
           most = wanted->figure->scale *
                  aob_member_number(json_object_get(level, "most"), wanted->figure->name);
    point->y = one;
    point->low = fmin(one, most);
    point->high = fmax(one, most);
    return isfinite(one) && isfinite(most);
}

double aob_curve_knee(const struct aob_curve_point *points, size_t count)
{
    double plateau = 0;
    for (size_t i = 0; i < count; i++)
        plateau = fmax(plateau, points[i].y);
    double half = plateau / 2;
    if (count < 3 || points[0].y >= half || points[count - 1].y - points[count - 2].y > plateau / 10)
        return NAN;
    for (size_t i = 1; i < count; i++) {
        const struct aob_curve_point *a = &points[i - 1], *b = &points[i];
        if (b->y >= half)
            return a->x * pow(b->x / a->x, (half - a->y) / (b->y - a->y));
    }
    return NAN;
}

/* Of one end of the band. */
static double knee_of(const struct aob_curve_point *points, size_t count, bool most)
{
    struct aob_curve_point *end = AOB_NEW_ARRAY(struct aob_curve_point, count);
    for (size_t i = 0; i < count; i++) /* the y is that of one warp, and the other end is the bar's */
        end[i] = (struct aob_curve_point){.x = points[i].x,
                                          .y = !most || points[i].high == points[i].low ? points[i].y
                                               : points[i].y == points[i].low           ? points[i].high
                                                                                        : points[i].low};
    double knee = aob_curve_knee(end, count);
    free(end);
    return knee;
}

static void note_knee(const struct aob_curve_point *points, size_t count, struct aob_text *text)
{
    double one = knee_of(points, count, false), most = knee_of(points, count, true);
    if (isfinite(one) && isfinite(most))
        aob_text_add(text, "knee at %.3g (one warp) and %.3g (most)", one, most);
    else if (isfinite(one) || isfinite(most))
        aob_text_add(text, "knee at %.3g (%s)", isfinite(one) ? one : most,
                     isfinite(one) ? "one warp" : "most");
}

static void add_chart(struct aob_gallery *gallery, const struct aob_panel *panel,
                      const struct aob_curve_axis *axis, const struct wanted *wanted)
{
    struct aob_text name = {0}, title = {0};
    aob_text_add(&name, "%s-%s-%s", wanted->profile, wanted->figure->file, axis->name);
    aob_text_add(&title, "%s: %s", wanted->profile, wanted->figure->title);
    bool knee = wanted->figure->knee && axis == aob_curve_axes;
    aob_curves_add(gallery, panel,
                   &(struct aob_curves_desc){.name = name.data,
                                             .kind = AOB_FIGURE_CACHE,
                                             .axis = axis,
                                             .title = title.data,
                                             .label = wanted->figure->label,
                                             .bars = "from one warp in flight (marker) to the most",
                                             .measure = measure,
                                             .user = wanted,
                                             .note = knee ? note_knee : NULL});
    aob_text_finish(&name);
    aob_text_finish(&title);
}

void aob_curves_add_cache(struct aob_gallery *gallery, const struct aob_panel *panel)
{
    json_t *profiles = aob_section_profiles(gallery->rows, panel->section), *value;
    const char *profile;
    json_object_foreach(profiles, profile, value) for (const struct aob_curve_axis *axis = aob_curve_axes;
                                                       axis->name;
                                                       axis++) for (size_t f = 0; f < AOB_COUNT(figures); f++)
        add_chart(gallery, panel, axis, &(struct wanted){&figures[f], profile});
    json_decref(profiles);
}
