/* The properties of the instruments hold here as well, and each of them takes an answer. */
#include "check.h"
#include <math.h>
#include "stress/groups.h"
#include "stress/trial.h"

static void all_hold(void **state)
{
    (void)state;
    size_t count = 0, broken = 0;
    for (const struct aob_property *p = aob_properties_instruments; p->name; p++, count++) {
        struct aob_trial trial;
        struct aob_answer answer;
        aob_trial_init(&trial, NULL, false);
        aob_property_ask(p, &trial, &answer);
        broken += answer.outcome != AOB_PASSES;
        if (answer.outcome != AOB_PASSES)
            print_message("%s: %g over %g: %s\n", p->name, answer.worst, answer.bound, answer.reason);
        assert_true(trial.asked > 0);
        assert_non_null(aob_bound_find(p->name));
        aob_trial_finish(&trial);
    }
    assert_true(count >= 12);
    assert_int_equal(broken, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_hold)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
