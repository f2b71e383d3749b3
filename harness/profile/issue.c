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

/* Lines of a quad, and those of the bank that has most of them. */
struct lookups {
    uint32_t lines, fullest;
};

/* Of four numbers or fewer, which nearly all quads have. The banks' counts stand side by side in one word. */
static struct lookups look_up_four(const struct aob_issue_quad *quad, uint32_t mask)
{
    static const uint64_t ones = 0x1111111111111111u;
    uint32_t line[AOB_ISSUE_LANES];
    for (size_t i = 0; i < AOB_ISSUE_LANES; i++)
        line[i] = quad->numbers[i < quad->count ? i : 0] >> quad->line_shift;
    uint32_t second = line[1] != line[0], third = (line[2] != line[0]) & (line[2] != line[1]),
             fourth = (line[3] != line[0]) & (line[3] != line[1]) & (line[3] != line[2]);
    uint64_t banks = ((uint64_t)1 << 4 * (line[0] & mask)) + ((uint64_t)second << 4 * (line[1] & mask)) +
                     ((uint64_t)third << 4 * (line[2] & mask)) + ((uint64_t)fourth << 4 * (line[3] & mask));
    uint32_t two = (banks & 2 * ones) != 0, three = (banks & banks >> 1 & ones) != 0,
             four = (banks & 4 * ones) != 0;
    return (struct lookups){1 + second + third + fourth, four ? 4 : 1 + two + three};
}

static struct lookups look_up(const struct aob_issue_quad *quad, uint32_t tags)
{
    uint32_t lines[AOB_ISSUE_MAX];
    if (quad->count <= AOB_ISSUE_LANES)
        return look_up_four(quad, tags - 1);
    size_t count = list_lines(quad, lines);
    return (struct lookups){(uint32_t)count, fullest(lines, count, tags)};
}

void aob_issue_add(struct aob_issue *issue, const struct aob_rates *rates, const struct aob_issue_quad *quad)
{
    if (!quad->count)
        return;
    struct lookups lookups = look_up(quad, (uint32_t)rates->tags);
    uint64_t texels = (uint64_t)AOB_ISSUE_LANES * cost_of(rates, quad);
    issue->least += texels;
    issue->banked += texels * lookups.fullest;
    issue->most += texels * lookups.lines;
}
