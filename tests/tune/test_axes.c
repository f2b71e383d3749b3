/* Which parameters are fitted, and where the search looks. */
#include "check.h"
#include "tune/axes.h"

static char radius[] = "radius", strength[] = "strength", share[] = "share", seed[] = "seed", cap[] = "cap",
            host[] = "host", taps[] = "taps", mode[] = "mode", lobe[] = "lobe";
static const char *const modes[] = {"off", "on", NULL};
static struct aob_param params[] = {
    {.name = radius, .unit = AOB_UNIT_LENGTH, .min = 1e-6, .max = 1e6},
    {.name = strength, .min = 0, .max = 100},
    {.name = share, .min = 0, .max = 1},
    {.name = seed, .min = 0, .max = 1e6},
    {.name = cap, .unit = AOB_UNIT_PIXEL, .min = 0, .max = 100},
    {.name = host, .stage = AOB_HOST, .min = 0.5, .max = 2},
    {.name = taps, .type = AOB_INT, .min = 1, .max = 9},
    {.name = mode, .type = AOB_INT, .choices = modes},
    {.name = lobe, .min = 0, .max = 1, .output = AOB_OUT_SPECULAR},
};
enum { RADIUS, STRENGTH, SHARE, SEED, CAP, HOST, TAPS, MODE, LOBE, COUNT };
static const double start[COUNT] = {2, 1, 0.5, 0, 0, 1, 5, 0, 0};
static const struct aob_technique_info technique = {.name = radius, .params = params, .param_count = COUNT};

static bool choose(struct aob_tune_axes *axes, const char *names, const bool *stated, struct aob_error *error)
{
    static const bool none[COUNT] = {false};
    return aob_tune_axes_choose(
        axes,
        &(struct aob_tune_axes_desc){
            .technique = &technique, .start = start, .names = names, .stated = stated ? stated : none},
        error);
}

static void what_is_fitted_by_itself(void **state)
{
    (void)state;
    struct aob_tune_axes axes;
    struct aob_error error = {{0}};
    bool stated[COUNT] = {[STRENGTH] = true};
    assert_true(choose(&axes, NULL, NULL, &error));
    assert_int_equal(axes.count, 3);
    for (size_t i = 0; i < 3; i++)
        assert_int_equal(axes.items[i].index, i);
    assert_true(choose(&axes, NULL, stated, &error));
    assert_int_equal(axes.count, 2);
    assert_int_equal(axes.items[1].index, SHARE);
    stated[RADIUS] = stated[SHARE] = true;
    assert_false(choose(&axes, NULL, stated, &error));
    assert_contains(error.text, "--params");
}

static void names(void **state)
{
    (void)state;
    struct aob_tune_axes axes;
    struct aob_error error = {{0}};
    const bool stated[COUNT] = {[STRENGTH] = true};
    assert_true(choose(&axes, "cap,strength,host,lobe", stated, &error));
    const size_t wanted[] = {CAP, STRENGTH, HOST, LOBE};
    assert_int_equal(axes.count, 4);
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(axes.items[i].index, wanted[i]);
    const struct {
        const char *names, *says;
    } bad[] = {{"strenght", "no parameter 'strenght'; what can be fitted of it: radius, strength, share"},
               {"radius,", "no parameter ''"},
               {"taps", "'taps' of radius is a whole number"},
               {"mode", "'mode' of radius is a choice"},
               {"share,share", "'share' stands there twice"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(choose(&axes, bad[i].names, NULL, &error));
        assert_contains(error.text, bad[i].says);
    }
}

static void where_it_looks(void **state)
{
    (void)state;
    struct aob_tune_axes axes;
    assert_true(choose(&axes, NULL, NULL, NULL));
    const struct aob_tune_axis *r = &axes.items[0], *s = &axes.items[1], *p = &axes.items[2];
    assert_true(r->log && s->log && !p->log);
    assert_near(r->low, 2.0 / 16, 1e-12);
    assert_near(r->high, 32, 1e-12);
    assert_near(s->low, 1.0 / 16, 1e-12);
    assert_near(s->high, 16, 1e-12);
    assert_near(p->low, 0, 0);
    assert_near(p->high, 1, 0);
    assert_near(aob_tune_axis_value(r, 0.5), 2, 1e-6); /* the middle of its logarithm */
    assert_near(aob_tune_axis_value(r, 0.75), 8, 1e-6);
    assert_near(aob_tune_axis_value(p, 0.75), 0.75, 1e-6);
    for (double place = 0; place <= 1; place += 0.125)
        for (size_t i = 0; i < 3; i++)
            assert_near(aob_tune_axis_place(&axes.items[i], aob_tune_axis_value(&axes.items[i], place)),
                        place, 1e-6);
}

static void centred_within_the_table(void **state)
{
    (void)state;
    struct aob_tune_axes axes;
    assert_true(choose(&axes, NULL, NULL, NULL));
    struct aob_tune_axis *s = &axes.items[1];
    aob_tune_axis_centre(s, &params[STRENGTH], 50);
    assert_near(s->start, 50, 0);
    assert_near(s->low, 50.0 / 16, 1e-12);
    assert_near(s->high, 100, 0); /* of the table */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_fitted_by_itself),
        cmocka_unit_test(names),
        cmocka_unit_test(where_it_looks),
        cmocka_unit_test(centred_within_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
