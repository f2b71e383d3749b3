#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "compare/noise.h"
#include "random.h"

enum { PROCESSES = 40, ROUNDS = 200 };

struct made {
    double cost[PROCESSES][ROUNDS], fixed[PROCESSES][ROUNDS];
    struct aob_rounds processes[PROCESSES];
};

/* Levels of sd `between`, rounds of sd `within` about them, and a speed that both sides share and that changes slowly. */
static struct made *make(double within, double between, double lag)
{
    struct made *made = AOB_NEW(struct made);
    uint32_t seed = 99;
    for (int p = 0; p < PROCESSES; p++) {
        double level = between * random_normal(&seed), speed = 0, own = 0;
        for (int r = 0; r < ROUNDS; r++) {
            speed = 0.9 * speed + 0.1 * random_normal(&seed);
            own = r ? lag * own + sqrt(1 - lag * lag) * random_normal(&seed) : random_normal(&seed);
            made->fixed[p][r] = 2 * exp(speed);
            made->cost[p][r] = 3 * exp(speed + level + within * own);
        }
        made->processes[p] = (struct aob_rounds){made->cost[p], made->fixed[p], ROUNDS};
    }
    return made;
}

/* The parts are what they were made of. 40 levels know their sd to 1/sqrt(78) = 11 %; bars are three of these, and three
 * of the like for the others. */
static void test_parts(void **state)
{
    (void)state;
    struct made *made = make(0.05, 0.02, 0);
    struct aob_noise noise = aob_noise_of(made->processes, PROCESSES);
    assert_near(noise.within, 0.05, 0.0025);
    assert_near(noise.between, 0.02, 0.0068);
    assert_near(noise.lag, 0, 0.035);
    assert_true(noise.raw_lag > 0.8);
    assert_int_equal(noise.processes, PROCESSES);
    assert_true(noise.rounds == (size_t)PROCESSES * ROUNDS);
    free(made);
    made = make(0.05, 0, 0.5);
    noise = aob_noise_of(made->processes, PROCESSES);
    assert_near(noise.lag, 0.5, 0.035);
    free(made);
    made = make(0.05, 0, 0);
    noise = aob_noise_of(made->processes, PROCESSES);
    assert_true(noise.between < 0.003); /* medians of 200 rounds scatter by .0044 themselves */
    free(made);
}

static void test_too_few(void **state)
{
    (void)state;
    struct made *made = make(0.05, 0.02, 0);
    assert_true(isnan(aob_noise_of(made->processes, 1).within));
    made->processes[3].count = 1;
    assert_true(isnan(aob_noise_of(made->processes, 5).between));
    made->processes[0].count = made->processes[1].count = made->processes[2].count = 7;
    struct aob_noise few = aob_noise_of(made->processes, 3);
    assert_true(!isnan(few.between) && isnan(few.lag));
    made->processes[2].count = 8;
    assert_true(!isnan(aob_noise_of(made->processes, 3).lag));
    free(made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_parts), cmocka_unit_test(test_too_few)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
