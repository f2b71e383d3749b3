/* What a night says: its page, the trend of all nights, the summaries, and the document. */
#ifndef AOB_NIGHTLY_TELL_H
#define AOB_NIGHTLY_TELL_H
#include "base/text.h"
#include "nightly.h"
#include "start.h"
#include "suspect.h"

struct aob_night_told {
    const struct aob_nightly_desc *desc;
    const struct aob_night_start *start;
    const struct aob_suspects *suspects;
    struct aob_history *history;
    bool partial; /* the run lacks cases */
};

/* {"line": "2 slower, 1 moved; 198 of 200 ok", ...}: what the history keeps as the night's summary; a new object. */
json_t *aob_night_summary(const struct aob_night_told *told);

/* Writes the night's page and the trend page, Markdown and document where they are wanted, and adds one screen to `out`. The trend
 * shows the verdicts that the history has. False after a line. */
bool aob_night_tell(const struct aob_night_told *told, struct aob_text *out, struct aob_error *error);
enum aob_exit aob_night_code(const struct aob_night_told *told);
#endif
