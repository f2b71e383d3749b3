/* The verdict on one case of two: B against A. The rule, which docs/decisions explains:
 *
 * INVALID    its times cannot be compared, or too few of them were taken, or the control is no measurement
 * SLOWER     the interval of B / A lies above 1, and the ratio is beyond the difference that is asked for
 * FASTER     the same below 1
 * SAME       the whole interval lies within `resolution`, whatever the noise floor
 * AMBIGUOUS  anything else
 * MOVED      the images differ. What the times say then is the cost of another image, which is never a speed-up: the
 *            case has moved on the plane of cost and error.
 *
 * Pure functions; no state. */
#ifndef AOB_COMPARE_VERDICT_H
#define AOB_COMPARE_VERDICT_H
#include <stdbool.h>
#include <stddef.h>
#include "base/statistics.h"
#include "error_change.h"

enum aob_verdict {
    AOB_VERDICT_FASTER,
    AOB_VERDICT_SLOWER,
    AOB_VERDICT_SAME,
    AOB_VERDICT_AMBIGUOUS,
    AOB_VERDICT_INVALID,
    AOB_VERDICT_MOVED,
    AOB_VERDICT_COUNT
};
extern const char *const aob_verdict_names[]; /* in capitals */

enum { AOB_COMPARE_ROUNDS = 20, AOB_COMPARE_PROCESSES = 3 }; /* fewer have no verdict */

struct aob_comparison {
    struct aob_ratio cost;    /* B / A, with the interval that decides (quotient.h) */
    struct aob_ratio control; /* the fixed pass against itself in the same blocks, 95 % */
    double lasting; /* half-width of cost's interval, on logarithms, that few processes are not to blame for
                                 (aob_lasting_half_width); 0: all of it */
    double resolution;            /* the difference that is asked for, a share: .02 */
    size_t rounds, processes;     /* of the one that has fewer */
    const char *invalid;          /* why the times cannot be compared; NULL: they can */
    bool moved;                   /* the images differ */
    struct aob_error_pair errors; /* of the two images, against the same target */
    /* B lies beside A only because of what both do not share with the module: blame.h. NULL: nothing of that is known */
    const char *elsewhere;
};

struct aob_judgement {
    enum aob_verdict verdict;
    enum aob_verdict cost;       /* what the times alone say; never MOVED */
    enum aob_error_change error; /* of an image that moved; else EQUAL */
    double delta; /* the difference that was judged by: what was asked for, or the noise floor */
    double
        rounds_needed; /* after which the interval reaches half of delta to each side; NAN: not known, or the
                                    verdict does not wait for rounds */
    char reason[600];  /* one sentence */
};
struct aob_judgement aob_judge(const struct aob_comparison *comparison);

/* What the control cannot resolve: the share by which the farther end of its interval lies beside 1. */
double aob_noise_floor(const struct aob_ratio *control);

/* Of the two intervals of a control, the one whose noise floor is larger. */
const struct aob_ratio *aob_wider_control(const struct aob_ratio *a, const struct aob_ratio *b);

/* What a table says as a whole, which is a command's exit code: something is worse (a case is slower and the module may be
 * the cause, or its error is larger); nothing is worse, but a case is undecided; neither. */
enum aob_outcome { AOB_OUTCOME_GOOD, AOB_OUTCOME_WORSE, AOB_OUTCOME_OPEN };
enum aob_outcome aob_judgement_outcome(const struct aob_judgement *judgement, bool elsewhere);
#endif
