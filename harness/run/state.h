/* Where a planned case stands while its run goes on. */
#ifndef AOB_RUN_STATE_H
#define AOB_RUN_STATE_H
#include <jansson.h>
#include <stdbool.h>
#include "base/hash.h"

struct aob_state {
    enum { AOB_PENDING, AOB_DONE, AOB_REFUSED } stage;
    char status[16], reason[640]; /* where refused: unsupported, invalid or failed */
    char graph[AOB_KEY_SIZE];     /* digest of its pass graph, once it is laid out */
    unsigned outputs;             /* that it gives; bits 1 << enum aob_output */
    bool triangles;               /* a pass of it draws the scene's */
    json_t *definition;           /* what it claims to compute, a term (job/term.h); NULL: nothing */
    bool mapped;                  /* the definition's value is mapped */
    json_t *stored; /* while it is not done: its record, of which only the cache figures are not those that
                                   * are wanted; NULL: there is none */
};
#endif
