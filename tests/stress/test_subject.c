/* What the words of a shot make of a technique's values and of the options. */
#include "stress/subject.h"
#include "stress/chosen.h"
#include "check.h"
#include <string.h>

struct values {
    float radius, thin, share;
    int32_t taps, mode;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .min = 0.01, .max = 100, .initial = 0.5),
    AOB_PARAM(struct values, thin, .unit = AOB_UNIT_LENGTH, .min = 0, .max = 10, .initial = 0.2),
    AOB_PARAM(struct values, share, .min = 0, .max = 1, .initial = 0.3),
    AOB_PARAM(struct values, taps, .min = 1, .max = 9, .rule = AOB_ODD, .initial = 5),
    AOB_PARAM(struct values, mode, .choices = (const char *const[]){"plain", "fancy", NULL}),
};
static const struct aob_technique technique = {
    .name = "made", .params = params, .param_count = 5, .values_size = sizeof(struct values)};
static const struct aob_subject subject = {.technique = &technique};

static struct values set(double radius, const char *words, struct aob_options *options)
{
    unsigned char bytes[4 * AOB_MAX_PARAM];
    struct values values;
    struct aob_error error = {{0}};
    const struct aob_shot shot = {.radius = radius, .set = words};
    if (!aob_subject_values(&subject, &shot, bytes, options, &error))
        fail_msg("%s", error.text);
    memcpy(&values, bytes, sizeof values);
    return values;
}

static void lengths_keep_their_proportion(void **state)
{
    (void)state;
    struct aob_options options;
    struct values v = set(0, NULL, &options);
    assert_near((double)v.radius, 0.5, 1e-7);
    assert_near((double)v.thin, 0.2, 1e-7);
    v = set(5, NULL, &options);
    assert_near((double)v.radius, 5, 1e-6);
    assert_near((double)v.thin, 2, 1e-6);
    assert_near((double)v.share, 0.3, 1e-7);
    v = set(200, NULL, &options); /* both are over their ends */
    assert_near((double)v.radius, 100, 0);
    assert_near((double)v.thin, 10, 0);
}

static void words_set_what_there_is(void **state)
{
    (void)state;
    struct aob_options options;
    struct values v = set(1, "share=0.75 blur=3 mode=fancy taps=99 depth_encoding=r16f", &options);
    assert_near((double)v.share, 0.75, 0);
    assert_near((double)v.radius, 1, 0);
    assert_int_equal(v.mode, 1);
    assert_int_equal(v.taps, 9);
    assert_int_equal(options.depth_encoding, AOB_DEPTH_R16F);
    v = set(1, "radius=3", &options); /* that one length alone */
    assert_near((double)v.radius, 3, 0);
    assert_near((double)v.thin, 0.4, 1e-7);
}

static void refuse(const char *words, const char *line)
{
    unsigned char bytes[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_error error = {{0}};
    const struct aob_shot shot = {.set = words};
    assert_false(aob_subject_values(&subject, &shot, bytes, &options, &error));
    if (!strstr(error.text, line))
        fail_msg("'%s' says: %s", words, error.text);
}

static void what_is_no_value_is_refused(void **state)
{
    (void)state;
    refuse("share", "NAME=VALUE");
    refuse("mode=grand", "mode");
    refuse("taps=4", "taps: 4 is not odd");
    refuse("share=x", "share");
    refuse("blurr=3", "'blurr' is no run option");
}

/* The line is for a shell. */
static void a_command_asks_the_same_subject(void **state)
{
    (void)state;
    const struct aob_technique_info info = {.name = (char *)"made", .module = (char *)"it's/a b.so"};
    struct aob_text text = {0};
    aob_chosen_command(&info, "vulkan", "My GPU", &text);
    assert_string_equal(text.data, "aobudget stress --technique made --backend vulkan --module "
                                   "'it'\\''s/a b.so' --device 'My GPU'");
    aob_text_finish(&text);
    aob_chosen_command(NULL, NULL, "My GPU", &text);
    assert_string_equal(text.data, "aobudget stress"); /* the instruments have no device */
    aob_text_finish(&text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_keep_their_proportion), cmocka_unit_test(words_set_what_there_is),
        cmocka_unit_test(what_is_no_value_is_refused), cmocka_unit_test(a_command_asks_the_same_subject)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
