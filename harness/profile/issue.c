#include "issue.h"

/* Textures of 64 bits are read at half the rate, of 128 at a quarter. */
static uint32_t cost_of(const struct aob_rates *rates, const struct aob_issue_quad *quad)
{
    if (quad->bytes <= 4)
        return 1;
    if (quad->bytes > 8)
        return 4;
    return quad->filtered ? 2 : (uint32_t)rates->point_64;
}

/* Writes each line once and returns how many there are. */
static size_t list_lines(const struct aob_issue_quad *quad, uint32_t lines[AOB_ISSUE_MAX])
{
    size_t count = 0;
    for (size_t i = 0; i < quad->count; i++) {
        size_t at = 0;
        lines[count] = quad->numbers[i] >> quad->line_shift;
        while (lines[at] != lines[count])
            at++;
        count += at == count;
    }
    return count;
}

/* Lines of the bank that has most of them. */
static uint32_t fullest(const uint32_t *lines, size_t count, uint32_t tags)
{
    uint32_t most = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t same = 0;
        for (size_t j = 0; j < count; j++)
            same += (lines[j] & (tags - 1)) == (lines[i] & (tags - 1));
        most = same > most ? same : most;
    }
    return most;
}

void aob_issue_add(struct aob_issue *issue, const struct aob_rates *rates, const struct aob_issue_quad *quad)
{
    uint32_t lines[AOB_ISSUE_MAX];
    size_t count = list_lines(quad, lines);
    if (!count)
        return;
    uint64_t texels = (uint64_t)AOB_ISSUE_LANES * cost_of(rates, quad);
    issue->least += texels;
    issue->banked += texels * fullest(lines, count, (uint32_t)rates->tags);
    issue->most += texels * count;
}
