/* How long the texture units of a device are busy with what quads ask for, as multiples of one texel of 32 bits. A quad's
 * fetch takes four, whatever of its lanes are idle, times the cost of the texels' width, times the rounds in which its
 * lines are found. How many lines a texture unit finds at once no source says of any device, so there are three sums. */
#ifndef AOB_PROFILE_ISSUE_H
#define AOB_PROFILE_ISSUE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "rates.h"

struct aob_issue {
    uint64_t least;  /* all lines of a quad at once */
    uint64_t banked; /* lines whose numbers differ modulo `tags` at once */
    uint64_t most;   /* one line after the other */
};

enum {
    AOB_ISSUE_LANES = 4,
    AOB_ISSUE_MAX = 4 * AOB_ISSUE_LANES
}; /* of a quad; numbers of its bilinear fetch */

struct aob_issue_quad {
    const uint32_t *numbers; /* that its lanes ask for, AOB_ISSUE_MAX at most */
    size_t count;            /* 0: no lane fetches, which costs nothing */
    uint32_t line_shift;     /* a line is a number >> this */
    uint32_t bytes;          /* of a texel, the widest that a lane asks for */
    bool filtered;           /* a lane's fetch is bilinear */
};
void aob_issue_add(struct aob_issue *issue, const struct aob_rates *rates, const struct aob_issue_quad *quad);
#endif
