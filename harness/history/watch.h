/* Whether the latest night of a line stands out against the nights before it. Pure functions.
 *
 * A value is ln(ratio) of a point whose status is "ok" and whose ratio is finite and above 0. Other points (failed, untimed)
 * are passed over. Only the latest AOB_WATCH_LINE values count. A point that was judged AOB_NIGHT_OUTLIER counts as any other:
 * medians do not follow it, and a line that is often disturbed must know that it is.
 *
 * The line restarts at the point `since` of the latest verdict SLOWER, FASTER, MOVED or MACHINE before tonight that has one:
 * what is told is not told again the next night, and a level that is told later begins later than that verdict. The values from
 * the restart to last night, cut into levels (level.h), are what tonight stands beside. The noise is that of the whole line, before
 * the restart too:
 * of the distances of earlier values from their levels' medians it is 1.4826 times the median, or a third of what one in twenty
 * is beyond, whichever is larger (of normal errors the first; the second where a few nights in twenty are far off), times
 * sqrt(n / (n - levels)), since each level has taken one of n values. It is known of AOB_WATCH_KNOWN values more than
 * there are levels.
 *
 * For each k up to AOB_WATCH_NIGHTS the last k values are set beside the level that the line had before them: the weighted
 * median of what lies between its start and them. It is the last level that has more than AOB_WATCH_NIGHTS values, tonight's
 * among them, or the first one, since a younger level is what is asked about: one outlier is no level to come back from. The
 * shift is the largest that more than half of their weight lies at or beyond. They stand out if that shift, as a logarithm, is
 * larger than each of
 *
 *     ln(1 + least),
 *     3 x noise x sqrt(1 + pi/2 / m)      for k = 1: m values before it, whose median errs as well,
 *     3 x noise x sqrt(pi/2 (1/k + 1/m))  for more: the errors of two medians,
 *     (sum of h_i^-2)^-1/2                half the width of their intervals, h_i, together,
 *
 * and tonight's value lies nearer to the new level than to the one before: what was back tonight is no level. With more nights
 * smaller shifts stand out, which a single night would hide. k above 1 needs AOB_WATCH_KNOWN values before the k. As long as the
 * noise is not known, 3 x noise is replaced: the shift must be larger than half of tonight's interval and half of the
 * widest interval before it together. A value without an interval has a wide one: alone it never stands out.
 * A weight is 1 over the width of the interval, within half and four times the line's usual width.
 *
 * `since` is the place that cuts the last AOB_WATCH_NIGHTS values in two with the least sum of w |y - level|, the first part
 * about the level before. */
#ifndef AOB_HISTORY_WATCH_H
#define AOB_HISTORY_WATCH_H
#include <stdbool.h>
#include <stddef.h>
#include "line.h"

enum { AOB_WATCH_NIGHTS = 7, AOB_WATCH_KNOWN = 4, AOB_WATCH_LINE = 365 };

struct aob_watch {
    bool suspect;  /* the cost stands out: it is to be measured again, beside the old module */
    size_t since;  /* place of the point where the new level began; the last one's if nothing stands out */
    size_t level;  /* place of the first point of the level before it */
    double before; /* the level that it stands out against, a ratio to the fixed pass; NAN: there is none */
    double shift;  /* the new level over that: 1.05 is 5 % dearer; NAN: none */
    double least;  /* the share, .05, that it is beyond: the largest of the four above; NAN: none */
};

/* Of a line whose last point is the night in question, whose own verdict does not matter. `least`: the smallest share that
 * counts, such as .02. A last point without a value, or without an earlier one, is never suspect.
 *
 * The new level of a suspect is the weighted median of the nights since `since`, or, where these alone do not stand out, of the k
 * that stand out most; else it is tonight's value. A fall is suspected from 1 / (1 + least) on. `least` is INFINITY where tonight has
 * no interval.
 *
 * A shift that lasts stays a suspect until a verdict restarts the line. So one that costs the same beside the old build, and is
 * as far from the level before when it is measured again, is best judged MACHINE, with its `since`. One that is back within
 * `least` of that level is an OUTLIER, which restarts nothing. */
void aob_watch_line(const struct aob_point *points, size_t count, double least, struct aob_watch *watch);

/* The level at which `count` p-values are discoveries of the false-discovery rate q, those that are no larger: q k / m, k the largest
 * rank whose p is at most q k / m among m that were tested (Benjamini and Hochberg, Controlling the false discovery rate, J. R.
 * Statist. Soc. B 57, 1995, equation 1). An interval at that level lies beside 1 if and only if its p is a discovery. Without a
 * discovery it is q / m; without a test q. A NAN is none and does not count as tested. */
double aob_watch_level(const double *p, size_t count, double q);
#endif
