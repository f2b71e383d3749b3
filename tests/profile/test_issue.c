/* What quads cost a texture unit, worked out by hand. */
#include "base/memory.h"
#include "check.h"
#include "profile/issue.h"

struct row {
    const char *what;
    uint32_t numbers[AOB_ISSUE_MAX];
    size_t count;
    uint32_t shift, bytes;
    bool filtered;
    double tags, point_64;
    uint64_t least, banked, most;
};
static const struct row rows[] = {
    {"one line", {8, 8, 8, 8}, 4, 0, 4, false, 4, 2, 4, 4, 4},
    {"one lane of four takes the quad's time", {8}, 1, 0, 4, false, 4, 2, 4, 4, 4},
    {"no lane fetches", {0}, 0, 0, 4, false, 4, 2, 0, 0, 0},
    {"four lines, a bank each", {0, 1, 2, 3}, 4, 0, 4, false, 4, 2, 4, 4, 16},
    {"four lines of one bank", {0, 4, 8, 16}, 4, 0, 4, false, 4, 2, 4, 16, 16},
    {"two and two, one twice", {0, 4, 1, 4}, 4, 0, 4, false, 4, 2, 4, 8, 12},
    {"without banks one after the other", {0, 1, 2, 3}, 4, 0, 4, false, 1, 2, 4, 16, 16},
    {"of two banks the fuller one counts", {0, 2, 4, 1}, 4, 0, 4, false, 2, 2, 4, 12, 16},
    {"three of one bank and one", {4, 8, 12, 1}, 4, 0, 4, false, 4, 2, 4, 12, 16},
    {"three lanes of four", {5, 6, 5}, 3, 0, 4, false, 1, 2, 4, 8, 8},
    {"the last of sixteen banks", {0, 15, 31, 47}, 4, 0, 4, false, 16, 2, 4, 12, 16},
    {"all of the last of sixteen", {15, 31, 47, 63}, 4, 0, 4, false, 16, 2, 4, 16, 16},
    {"two pairs of banks", {0, 4, 1, 5}, 4, 0, 4, false, 4, 2, 4, 8, 16},
    {"a bilinear quad of one bank",
     {0, 0, 4, 4, 0, 0, 4, 4, 8, 8, 12, 12, 8, 8, 12, 12},
     16,
     0,
     4,
     true,
     4,
     2,
     4,
     16,
     16},
    {"five lines, three of one bank", {0, 4, 8, 1, 2}, 5, 0, 4, true, 4, 2, 4, 12, 20},
    {"sectors of one line", {12, 13, 14, 15}, 4, 2, 4, false, 4, 2, 4, 4, 4},
    {"sectors of two lines", {3, 4, 3, 4}, 4, 2, 4, false, 4, 2, 4, 4, 8},
    {"a byte costs as much as four", {0}, 1, 0, 1, false, 4, 2, 4, 4, 4},
    {"64 bits", {0}, 1, 0, 8, false, 4, 2, 8, 8, 8},
    {"64 bits where they cost nothing", {0}, 1, 0, 8, false, 4, 1, 4, 4, 4},
    {"that holds unfiltered only", {0}, 1, 0, 8, true, 4, 1, 8, 8, 8},
    {"128 bits", {0, 1}, 2, 0, 16, true, 4, 1, 16, 16, 32},
    {"a bilinear quad over four lines",
     {0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3},
     16,
     0,
     4,
     true,
     4,
     2,
     4,
     4,
     16},
};

static void test_quads(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct row *row = &rows[i];
        struct aob_rates rates = {.tags = row->tags, .point_64 = row->point_64};
        struct aob_issue issue = {100, 200, 300};
        aob_issue_add(
            &issue, &rates,
            &(struct aob_issue_quad){row->numbers, row->count, row->shift, row->bytes, row->filtered});
        if (issue.least != 100 + row->least || issue.banked != 200 + row->banked ||
            issue.most != 300 + row->most)
            fail_msg("%s: %d, %d, %d", row->what, (int)issue.least - 100, (int)issue.banked - 200,
                     (int)issue.most - 300);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_quads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
