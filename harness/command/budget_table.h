/* What `budget` prints of an answer. */
#ifndef AOB_COMMAND_BUDGET_TABLE_H
#define AOB_COMMAND_BUDGET_TABLE_H
#include "base/text.h"
#include "reports/page/answer.h"

enum { AOB_BAR_CELLS = 30, AOB_BAR_BUDGET = 20 };
/* A bar of AOB_BAR_CELLS cells, of which AOB_BAR_BUDGET are the budget, with '|' behind them: '#' up to the point, '-' from there
 * to the upper end. The last cell is '>' where a bar goes on, as every bar does where nothing is left. */
void aob_budget_bar(char bar[AOB_BAR_CELLS + 2], double ms, double high, double budget_ms);

/* For each view a table of the Pareto set and of what is chosen, cheapest first, and what to take in sentences; then the
 * settings over all views, where there are several, and what is not there. */
void aob_budget_table_print(const struct aob_answer *answer, struct aob_text *out);

/* {at, low, high}; null where nothing is known; both ends are null where there is no interval. */
json_t *aob_interval_to_json(const struct aob_interval *interval);

/* The document of --json: all but what the command knows alone (docs/budget.md). */
json_t *aob_budget_answer_to_json(const struct aob_answer *answer);
#endif
