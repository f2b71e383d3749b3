/* The colours that FLIP compares (see flip.h). The primaries are those of sRGB, and X, Y and Z are relative to those of the
 * white of the three at full strength. No function keeps a state. */
#ifndef AOB_SCORE_FLIP_SPACE_H
#define AOB_SCORE_FLIP_SPACE_H

/* Opponents are the luminance Y, X - Y and Y - Z: the paper's YCxCz as (Y + 16) / 116, Cx / 500 and Cz / 200. They are
 * linear in the light, and its filters keep constants, so they may filter either. A grey has its luminance and two
 * zeros. */
enum { AOB_FLIP_SPACE_OPPONENTS = 3 };

/* Opponents of linear light R, G, B, each cut to 0..1. */
void aob_flip_space_opponents(const double rgb[3], double opponents[AOB_FLIP_SPACE_OPPONENTS]);

/* L*, a*, b* of what a screen shows of opponents, each primary cut to 0..1, with a* and b* adjusted after Hunt: times
 * L* / 100. */
void aob_flip_space_lab(const double opponents[AOB_FLIP_SPACE_OPPONENTS], double lab[3]);

/* The same of a grey of that luminance, whose a* and b* are exactly 0. */
void aob_flip_space_lab_of_grey(double luminance, double lab[3]);

/* Difference of two colours: of L*, and the Euclidean one of a* and b*. */
double aob_flip_space_hyab(const double one[3], const double other[3]);

/* The largest HyAB that the paper knows, that of green and blue at full strength. */
double aob_flip_space_largest(void);
#endif
