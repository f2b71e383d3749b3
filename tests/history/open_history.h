/* For tests that have one history open for writing, and look at its lines. */
#ifndef AOB_TESTS_HISTORY_OPEN_HISTORY_H
#define AOB_TESTS_HISTORY_OPEN_HISTORY_H
#include "night_folder.h"

static struct aob_history *history; /* of the test, open for writing */
static struct aob_lines lines;      /* as read last */

static inline int history_make(void **state)
{
    lines = (struct aob_lines){0};
    int made = night_folder_make(state);
    history = history_open(AOB_HISTORY_WRITE);
    return made;
}

static inline int history_remove(void **state)
{
    aob_lines_finish(&lines);
    aob_history_close(history);
    return night_folder_remove(state);
}

static inline void lines_read(bool figures)
{
    aob_lines_finish(&lines);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.figures = figures}, &lines, &error));
}

/* One record as the journal of a night. */
static inline int64_t record_keep(json_t *record)
{
    journal_write(&record, 1);
    info_write(json_pack("[o]", json_of(technique_text)));
    return night_keep(history, "nightly", true);
}
#endif
