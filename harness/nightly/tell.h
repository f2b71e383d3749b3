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
    size_t asked, missing; /* cases of the run's plan, and those of them that it has no record of */
    size_t gone;           /* cases of the judged night before that this one does not have */
};

/* {"line": "2 slower, 1 moved; 198 of 200 ok", ...}: what the history keeps as the night's summary; a new object. */
json_t *aob_night_summary(const struct aob_night_told *told);

/* Writes the night's page, Markdown and document where they are wanted, and adds one screen to `out`. False after a line. */
bool aob_night_tell(const struct aob_night_told *told, struct aob_text *out, struct aob_error *error);

/* Writes the trend page of the config's nights, with the verdicts that the history has. False after a line. */
bool aob_night_trend(const struct aob_night_told *told, struct aob_error *error);
enum aob_exit aob_night_code(const struct aob_night_told *told);
#endif
