/* The truth of an output, as a term of a view's job. */
#include "check.h"
#include "base/memory.h"
#include "job/send.h"
#include "job/term.h"

/* What a truth depends on travels with it, and nothing else does. */
static void a_term_of_an_output(void **state)
{
    static const struct {
        enum aob_output output;
        bool bounces, light;
    } rows[] = {{AOB_OUT_VISIBILITY_RGB, true, false},
                {AOB_OUT_SPECULAR, false, false},
                {AOB_OUT_IRRADIANCE, false, true},
                {AOB_OUT_LIT, true, true}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_term term = {
            .radius = 0.5, .output = rows[i].output, .bounces = 8, .light = {.sh = {{1, 2, 3}}}};
        struct aob_term read;
        struct aob_error error = {{0}};
        json_t *message = send(aob_term_to_json(&term));
        assert_true(aob_term_from_json(message, &read, &error));
        assert_int_equal(read.output, rows[i].output);
        assert_int_equal(read.bounces, rows[i].bounces ? 8 : 0);
        assert_true(read.light.sh[0][1] == (rows[i].light ? 2 : 0));
        json_object_del(message, "light");
        assert_true(aob_term_from_json(message, &read, &error) == !rows[i].light);
        json_decref(message);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_term_of_an_output)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
