/* Parts of taking a night, used by take.c, in its transaction. Each fails with a line. */
#ifndef AOB_HISTORY_TAKE_H
#define AOB_HISTORY_TAKE_H
#include <jansson.h>
#include "database.h"
#include "night.h"

/* What a night's run folder holds. */
struct aob_taking {
    struct aob_history *history;
    int64_t night;
    char *folder, *config; /* of the run; name of its config */
    json_t *info;          /* run.json */
    json_t *records;       /* those of its plan */
    char *journal;         /* the journal's bytes */
    size_t journal_size;
};

/* The night's folder is known; an ended night is refused. Reads what it holds. aob_taking_finish frees. */
bool aob_taking_read(struct aob_taking *taking, struct aob_error *error);
void aob_taking_finish(struct aob_taking *taking);

bool aob_take_points(struct aob_taking *taking, struct aob_error *error);
bool aob_take_rounds(struct aob_taking *taking, struct aob_error *error);
bool aob_take_modules(struct aob_taking *taking, struct aob_error *error);
#endif
