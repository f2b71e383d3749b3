/* Budgets of a frame. */
#include <math.h>
#include <stdlib.h>
#include "budget/budget.h"
#include "fuzz.h"

static void check_again(const struct aob_budget *budget)
{
    struct aob_budget again;
    json_t *object = aob_budget_to_json(budget);
    fuzz_require(object && aob_budget_from_json(&again, object), "a budget is read from its JSON");
    json_t *second = aob_budget_to_json(&again);
    fuzz_require(json_equal(object, second), "a budget is what its JSON says");
    json_decref(object);
    json_decref(second);
    aob_budget_finish(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct aob_budget budget;
    struct aob_error error = {{0}};
    char *path = fuzz_file("input", bytes, size);
    if (fuzz_answer(aob_budget_find(&budget, path, &error), &error, path)) {
        fuzz_require(budget.title && *budget.title && budget.source && *budget.source, "its texts are there");
        fuzz_require(budget.frame_ms >= 0.01 && budget.frame_ms <= 1e6, "a frame takes a time");
        fuzz_require(budget.rest_ms >= 0 && budget.rest_ms < budget.frame_ms, "the rest leaves something");
        fuzz_require(budget.ao_ms > 0 && budget.error >= 0, "a slice is a time, an error none below 0");
        fuzz_require(budget.width >= 0 && budget.width <= 16384 && budget.height >= 0 &&
                         budget.height <= 16384 && !budget.width == !budget.height,
                     "a picture has both sides or none");
        double left = aob_budget_left(&budget, 0);
        fuzz_require(left > 0 && left <= budget.frame_ms, "something is left of the frame");
        check_again(&budget);
        aob_budget_finish(&budget);
    }
    free(path);
    return 0;
}
