#include "error_change.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

static double true_square(const struct aob_error_side *side)
{
    return side->rmse * side->rmse - side->se * side->se;
}

double aob_error_true_rmse(const struct aob_error_side *side)
{
    double square = true_square(side);
    return square < 0 ? 0 : sqrt(square); /* not known stays so */
}

/* Of the difference of the squares. */
static double standard_error(const struct aob_error_pair *pair)
{
    const struct aob_error_side *a = &pair->a, *b = &pair->b;
    if (isfinite(pair->apart))
        return 2 * a->se * pair->apart / sqrt(a->pixels);
    return hypot(2 * a->se * a->rmse / sqrt(a->pixels), 2 * b->se * b->rmse / sqrt(b->pixels));
}

enum aob_error_change aob_error_change(const struct aob_error_pair *pair)
{
    double change = true_square(&pair->b) - true_square(&pair->a), noise = standard_error(pair);
    double shown = aob_error_true_rmse(&pair->b) - aob_error_true_rmse(&pair->a);
    if (isnan(change) || isnan(noise))
        return AOB_ERROR_UNKNOWN;
    if (fabs(shown) < AOB_ERROR_LEAST || fabs(change) <= AOB_ERROR_SIGMAS * noise)
        return AOB_ERROR_EQUAL;
    return change > 0 ? AOB_ERROR_MORE : AOB_ERROR_LESS;
}

static bool shows_noise(const struct aob_error_side *side)
{
    return side->rmse - aob_error_true_rmse(side) >= AOB_ERROR_LEAST;
}

void aob_error_change_print(const struct aob_error_pair *pair, char *text, size_t size)
{
    static const char *const words[] = {"not known which is better", "equal", "better", "worse"};
    const struct aob_error_side *a = &pair->a, *b = &pair->b;
    enum aob_error_change change = aob_error_change(pair);
    if (isnan(a->rmse) || isnan(b->rmse))
        snprintf(text, size, "the error of one is not known");
    else if (isnan(pair->apart) && (shows_noise(a) || shows_noise(b)))
        snprintf(text, size, "RMSE %.4f -> %.4f, without the noise of the truths %.4f -> %.4f (%s)", a->rmse,
                 b->rmse, aob_error_true_rmse(a), aob_error_true_rmse(b), words[change]);
    else
        snprintf(text, size, "RMSE %.4f -> %.4f (%s)", a->rmse, b->rmse, words[change]);
}
