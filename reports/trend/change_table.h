/* The first table of the trend page: what changed, by how much, since when. */
#ifndef AOB_REPORTS_TREND_CHANGE_TABLE_H
#define AOB_REPORTS_TREND_CHANGE_TABLE_H
#include "base/text.h"
#include "change.h"

void aob_trend_change_table(struct aob_text *page, const struct aob_trend_changes *changes);

/* A sentence for each config: how many changes of how many series there are, and what its latest night was told of. */
void aob_trend_change_lead(struct aob_text *page, const struct aob_trend_model *model,
                           const struct aob_trend_changes *changes);
#endif
