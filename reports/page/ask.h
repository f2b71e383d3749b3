/* What is asked of the cases of a run: how much time there is, and which cases and costs count. */
#ifndef AOB_REPORTS_PAGE_ASK_H
#define AOB_REPORTS_PAGE_ASK_H
#include "budget/budget.h"
#include "costs.h"

struct aob_ask {
    double ms; /* for ambient occlusion, where there is no budget */
    /* What its frame leaves beside G-buffer and composite counts in place of `ms`; NULL: none. It must outlive the ask. */
    const struct aob_budget *budget;
    double error;        /* that will do; INFINITY: any */
    const char *profile; /* that modelled times are judged on; NULL: times measured here are judged */
    const char *scene;   /* NULL: all */
    double radius;       /* of the targets, scene units; NAN: all */
    int width, height;   /* 0: all */
};

/* What a budget asks of all scenes and targets. */
struct aob_ask aob_ask_of(const struct aob_budget *budget);

/* Of a record: whether its case is of the scene and size that are asked for; whether it is good as well; whether it may be
 * chosen, which `none` (the floor of a cost) and `deferred` (G-buffer and composite) may not; and the cost that is
 * judged. */
bool aob_ask_is_about(const struct aob_ask *ask, const json_t *record);
bool aob_ask_has(const struct aob_ask *ask, const json_t *record);
bool aob_ask_may_choose(const json_t *record);
struct aob_interval aob_ask_cost(const struct aob_ask *ask, const json_t *record);

/* G-buffer and composite of one run, backend and size, record by record; nothing happens if the record is of another module
 * or has no cost. `frame` begins as AOB_NO_FRAME, and has the largest of the points and of the ends. The upper end of a
 * case without an interval is its point. */
#define AOB_NO_FRAME ((struct aob_interval){NAN, NAN, NAN})
void aob_ask_take_frame(const struct aob_ask *ask, const json_t *record, struct aob_interval *frame);

/* Milliseconds for ambient occlusion beside these: what the budget leaves beside their upper end. 0 or less: nothing is
 * left. */
double aob_ask_ms(const struct aob_ask *ask, const struct aob_interval *frame);
#endif
