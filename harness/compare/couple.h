/* Which case of B stands beside which of A. */
#ifndef AOB_COMPARE_COUPLE_H
#define AOB_COMPARE_COUPLE_H
#include "base/text.h"
#include "reports/page/rows.h"

struct aob_couple {
    const struct aob_row *a, *b;
    bool same_key; /* both are the same question to the same build of the technique */
};
struct aob_couples { /* zero it first; aob_couples_finish frees */
    struct aob_couple *items;
    size_t count, capacity;
    const struct aob_row **alone[2]; /* of A and of B: what has no partner */
    size_t alone_count[2], alone_capacity[2];
};

/* One side: `count` of the rows. */
struct aob_side {
    const struct aob_row *const *rows;
    size_t count;
};

/* Cases of one key are couples. Of the others those are that differ in the build of their technique only, or in what they
 * were compared with: scene, view, camera, technique by name, every parameter and option, backend and size are the same. Where several of
 * one side could be meant, none is. In the order of A. */
void aob_couples_find(struct aob_couples *couples, const struct aob_side *a, const struct aob_side *b);
void aob_couples_finish(struct aob_couples *couples);

/* "corner/front gtao radius=0.5 vulkan 480x270": what a table calls the case. */
void aob_row_describe(const struct aob_row *row, struct aob_text *text);
#endif
