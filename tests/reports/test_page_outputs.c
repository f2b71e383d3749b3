/* What the page shows of outputs besides visibility. A plotter that keeps its job stands in for aobudget-plot. */
#include "check.h"
#include <jansson.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/member.h"
#include "base/memory.h"
#include "base/text.h"
#include "reports/page/page.h"

struct fixture {
    char folder[128], out[160];
    char *page;
    json_t *figures;
};

static void put(const struct fixture *f, const char *name, const char *text)
{
    char *path = aob_path_join(f->folder, name);
    assert_true(aob_file_write(path, text, strlen(text), NULL));
    chmod(path, 0755);
    free(path);
}

static char *get(const char *folder, const char *name)
{
    char *path = aob_path_join(folder, name), *text = aob_file_read(path, 1 << 24, NULL, NULL);
    assert_non_null(text);
    free(path);
    return text;
}

/* The page of a journal, and the figures that the plotter was asked for. */
static void make(struct fixture *f, const char *journal)
{
    struct aob_error error = {{0}};
    struct aob_text script = {0};
    struct aob_page_summary summary;
    const char *const folders[] = {f->folder, NULL};
    put(f, "journal.jsonl", journal);
    put(f, "run.json", "{\"name\":\"outputs\",\"cases\":2}");
    aob_text_add(&script, "#!/bin/sh\ncat >'%s/job.json'\n", f->folder);
    put(f, "aobudget-plot", script.data);
    aob_text_finish(&script);
    char *program = aob_path_join(f->folder, "aobudget");
    if (!aob_page_write(&(struct aob_page_desc){folders, f->out, program, &summary}, &error))
        fail_msg("%s", error.text);
    char *job = get(f->folder, "job.json");
    json_t *object = json_loads(job, 0, NULL);
    f->page = get(f->out, "index.html");
    f->figures = json_incref(json_object_get(object, "figures"));
    json_decref(object);
    free(program);
    free(job);
}

/* The one figure whose file ends so; NULL: there is none. */
static const json_t *figure_of(const struct fixture *f, const char *end)
{
    const json_t *found = NULL;
    json_t *figure;
    size_t i;
    json_array_foreach(f->figures, i, figure)
    {
        const char *out = aob_member_text(figure, "out");
        if (strlen(out) < strlen(end) || strcmp(out + strlen(out) - strlen(end), end) != 0)
            continue;
        assert_null(found);
        found = figure;
    }
    return found;
}

static void assert_member(const json_t *object, const char *name, const char *text)
{
    if (strcmp(aob_member_text(object, name), text) != 0)
        fail_msg("%s is '%s', not '%s'", name, aob_member_text(object, name), text);
}

/* A case of an image of its own; `more` goes into the record, `error` into its score. */
static void add_case(struct aob_text *journal, const char *key, const char *more, const char *error)
{
    aob_text_add(
        journal,
        "{\"key\":\"%s\",\"scene\":\"gallery\",\"view\":\"hall\",\"technique\":\"gtao\",\"backend\":"
        "\"vulkan\",\"width\":64,\"height\":32,\"status\":\"ok\",\"image\":\"images/%s.exr\","
        "\"time\":{\"clock\":\"cpu\",\"cpu_ms\":3.5,\"passes\":[{\"name\":\"horizon\",\"cpu_ms\":2.25,"
        "\"wall_ms\":9},{\"name\":\"<lobe>\",\"cpu_ms\":1.25}]}%s,\"error\":{\"rmse\":%s}}\n",
        key, key, more, error);
}

static const char OUTPUTS[] =
    ",\"outputs\":[\"visibility\",\"bent_normal\",\"visibility_rgb\",\"specular\",\"irradiance\",\"lit\"]";

/* The case `a` is the nearer one in visibility, irradiance and the lit image, `b` in the three others. */
static void make_both(struct fixture *f)
{
    struct aob_text journal = {0};
    add_case(&journal, "a", OUTPUTS,
             "0.01,\"band_rmse\":0.01,\"bent_band\":9,\"bounce_band\":0.09,\"specular_band\":0.08,"
             "\"irradiance_band\":0.01,\"lit_band\":0.01,\"lit_exposure\":0.25");
    add_case(&journal, "b", OUTPUTS,
             "0.02,\"band_rmse\":0.02,\"bent_band\":8,\"bounce_band\":0.03,\"specular_band\":0.04,"
             "\"irradiance_band\":0.05,\"lit_band\":0.05,\"lit_exposure\":0.5");
    make(f, journal.data);
    aob_text_finish(&journal);
}

static void assert_image(const struct fixture *f, const char *end, const char *key)
{
    char image[192];
    snprintf(image, sizeof image, "%s/images/%s.exr", f->folder, key);
    const json_t *figure = figure_of(f, end);
    assert_non_null(figure);
    assert_member(figure, "image", image);
}

static void test_each_output_has_its_own_best_case(void **state)
{
    struct fixture *f = *state;
    make_both(f);
    assert_image(f, "gtao.png", "a");
    assert_image(f, "-bent.png", "b");
    assert_image(f, "-bounces.png", "b");
    assert_image(f, "-bounces-map.png", "b");
    assert_image(f, "-specular.png", "b");
    assert_image(f, "-irradiance.png", "a");
    assert_image(f, "-irradiance-map.png", "a");
    assert_image(f, "-lit.png", "a");
    assert_image(f, "-lit-map.png", "a");
}

static void test_channels_and_colours(void **state)
{
    struct fixture *f = *state;
    make_both(f);
    const json_t *light = figure_of(f, "-irradiance.png"), *bounces = figure_of(f, "-bounces.png"),
                 *lobe = figure_of(f, "-specular.png"), *bent = figure_of(f, "-bent.png");
    assert_member(light, "technique", "technique.irradiance");
    assert_member(light, "reference", "reference.irradiance");
    assert_member(light, "error", "error.irradiance");
    assert_true(json_is_true(json_object_get(light, "colour")));
    assert_null(json_object_get(light, "exposure"));
    assert_true(json_number_value(json_object_get(bounces, "exposure")) == 1);
    /* As the score's FLIP was taken. */
    assert_true(json_number_value(json_object_get(figure_of(f, "-lit.png"), "exposure")) == 0.25);
    assert_member(figure_of(f, "-lit.png"), "technique", "technique.lit");
    assert_true(json_is_true(json_object_get(figure_of(f, "-lit.png"), "colour")));
    assert_member(bounces, "error", "error.visibility_rgb");
    assert_member(lobe, "technique", "technique.specular");
    assert_null(json_object_get(lobe, "colour"));
    assert_member(lobe, "quantity", "specular occlusion");
    assert_member(bent, "kind", "map");
    assert_member(bent, "amount", "degrees");
    assert_null(json_object_get(bent, "quantity"));
    /* The map has the scale of the pictures, no other output has. */
    assert_member(figure_of(f, "-irradiance-map.png"), "limit_group", aob_member_text(light, "limit_group"));
    assert_string_not_equal(aob_member_text(lobe, "limit_group"), aob_member_text(light, "limit_group"));
}

static void test_a_case_says_what_it_gives(void **state)
{
    struct fixture *f = *state;
    make_both(f);
    assert_contains(f->page,
                    "<summary>gives visibility, bent_normal, visibility_rgb, specular, irradiance, lit in "
                    "2 passes: 3.50 ms</summary><ol class=front>\n<li>horizon: 2.25 ms</li>\n"
                    "<li>&lt;lobe&gt;: 1.25 ms</li>\n</ol></details>");
    assert_contains(f->page, "<button>outputs</button>");
    assert_contains(f->page, "<td class=params><span class=clip>visibility, bent_normal, visibility_rgb, "
                             "specular, irradiance, lit</span></td>");
    assert_contains(f->page, "<button>relative RMSE of irradiance in band</button>");
    assert_contains(f->page, "<h4>Irradiance of the scene\u2019s light</h4>");
}

/* Who wants none of them sees nothing of them, whether the record lists visibility or, an older one, nothing. */
static void test_without_outputs(void **state)
{
    static const char *const words[] = {"gives ", "<button>outputs", "of irradiance", "specular", "bounces"};
    struct fixture *f = *state;
    struct aob_text journal = {0};
    add_case(&journal, "a", ",\"outputs\":[\"visibility\"]", "0.01,\"band_rmse\":0.01");
    add_case(&journal, "b", "", "0.02,\"band_rmse\":0.02");
    make(f, journal.data);
    for (size_t i = 0; i < AOB_COUNT(words); i++)
        if (strstr(f->page, words[i]))
            fail_msg("the page says '%s'", words[i]);
    assert_null(figure_of(f, "-bent.png"));
    assert_null(figure_of(f, "-irradiance.png"));
    aob_text_finish(&journal);
}

static int set_up(void **state)
{
    struct fixture *f = AOB_NEW(struct fixture);
    snprintf(f->folder, sizeof f->folder, "/tmp/aob-test-page-outputs-%ld", (long)getpid());
    snprintf(f->out, sizeof f->out, "%s/report", f->folder);
    *state = f;
    return aob_folder_create(f->folder, NULL) ? 0 : -1;
}

static int tear_down(void **state)
{
    struct fixture *f = *state;
    char command[256];
    snprintf(command, sizeof command, "rm -r '%s'", f->folder);
    int code = system(command);
    json_decref(f->figures);
    free(f->page);
    free(f);
    return code;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_each_output_has_its_own_best_case, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_channels_and_colours, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_case_says_what_it_gives, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_without_outputs, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
