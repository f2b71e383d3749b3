/* Why a run has no answer to what is asked of it. */
#ifndef AOB_COMMAND_BUDGET_REASON_H
#define AOB_COMMAND_BUDGET_REASON_H
#include "reports/page/ask.h"
#include "reports/page/rows.h"

/* Whether some case has all that an answer needs. False: one line that names what the last of the cases lack, asked in this
 * order: that they are good, the scene, the size, that they may be chosen, the cost, the error. */
bool aob_budget_judge(const struct aob_rows *rows, const struct aob_ask *ask, struct aob_error *error);
#endif
