#include "blame.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"

static bool moved(enum aob_verdict verdict)
{
    return verdict == AOB_VERDICT_FASTER || verdict == AOB_VERDICT_SLOWER;
}

/* The median ratio of the couples of one build; 1 where there is none. */
static double common_ratio(const struct aob_blame_couple *couples, size_t count, size_t *used)
{
    double *ratios = AOB_NEW_ARRAY(double, count + 1);
    *used = 0;
    for (size_t i = 0; i < count; i++)
        if (couples[i].same_build && couples[i].verdict != AOB_VERDICT_INVALID)
            ratios[(*used)++] = couples[i].cost.ratio;
    double median = *used ? aob_median(ratios, *used) : 1;
    free(ratios);
    return median;
}

/* Would it still have its verdict if that ratio were its 1? */
static bool moved_beyond(const struct aob_blame_couple *couple, double common)
{
    double ratio = couple->cost.ratio / common;
    return couple->verdict == AOB_VERDICT_SLOWER
               ? couple->cost.low / common > 1 && ratio > 1 + couple->delta
               : couple->cost.high / common < 1 && ratio < 1 / (1 + couple->delta);
}

void aob_blame_find(const struct aob_blame_couple *couples, size_t count, bool same_program,
                    struct aob_blame *blames)
{
    size_t used;
    double common = common_ratio(couples, count, &used);
    for (size_t i = 0; i < count; i++) {
        const struct aob_blame_couple *couple = &couples[i];
        struct aob_blame *blame = &blames[i];
        *blame = (struct aob_blame){{0}, false};
        if (!moved(couple->verdict))
            continue;
        if (couple->same_build) {
            blame->excused = same_program;
            aob_line_print(blame->text, sizeof blame->text,
                           same_program
                               ? "program and technique are the same: the machine is to blame"
                               : "the technique is the same: the machine or the harness is to blame");
        } else if (used && !moved_beyond(couple, common)) {
            blame->excused = true;
            aob_line_print(blame->text, sizeof blame->text,
                           "%zu cases whose technique is the same moved as well (x %.3f): the machine or the "
                           "harness is to blame, not the module",
                           used, common);
        }
    }
}
