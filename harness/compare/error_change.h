/* Whether the error of an image grew, beside what is known of two truths that it is measured against.
 *
 * The truth of a pixel has a noise of its own, of standard error s, that is independent of other pixels. An RMSE against it
 * is that against the exact truth with the noise added, r^2 = e^2 + s^2, and scatters: with N pixels that show anything, r^2 has
 * the standard error 2 s r / sqrt(N). So what is compared is e^2 = r^2 - s^2 of each side, and their difference counts if
 * it is AOB_ERROR_SIGMAS of its standard errors away from 0. Where both images are compared with one truth its noise is common
 * to both, and leaves only 2 s d / sqrt(N) with d the RMS difference of the images. (Both are the variance of a mean of
 * products: of error and noise, 4 e^2 s^2 / N, and of the noise's square beside its estimate, 4 s^4 / N. The noise is taken
 * to be as strong in each of the N pixels; docs/decisions/0032 has what real truths make of that.)
 *
 * Pure functions; no state. */
#ifndef AOB_COMPARE_ERROR_CHANGE_H
#define AOB_COMPARE_ERROR_CHANGE_H
#include <stddef.h>

enum aob_error_change { AOB_ERROR_UNKNOWN, AOB_ERROR_EQUAL, AOB_ERROR_LESS, AOB_ERROR_MORE };

#define AOB_ERROR_SIGMAS 3.0
/* An RMSE that changes by less is equal: a table of four digits does not show it. */
#define AOB_ERROR_LEAST 1e-4

struct aob_error_side {
    double rmse;   /* NAN: not known */
    double se;     /* of the truth that it is against, as RMS over the pixels; 0: exact; NAN: not known */
    double pixels; /* that show anything: those in band, as open ones have neither error nor noise */
};
struct aob_error_pair {
    struct aob_error_side a, b; /* against one target, not always by one truth */
    double apart;               /* RMS of image B less image A where one truth served both; NAN: it did not */
};

/* Of B against A. UNKNOWN where a figure that it takes is. */
enum aob_error_change aob_error_change(const struct aob_error_pair *pair);

/* What its RMSE is without the noise of its truth: sqrt(r^2 - s^2), 0 where that is negative. */
double aob_error_true_rmse(const struct aob_error_side *side);

/* "RMSE 0.0412 -> 0.0455 (worse)"; where noise is all that the difference may be, how much of it there is. */
void aob_error_change_print(const struct aob_error_pair *pair, char *text, size_t size);
#endif
