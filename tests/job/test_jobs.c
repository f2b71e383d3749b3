/* Each message, written and read again without a process: every field comes back, and what is missing is said. */
#include "check.h"
#include "job/send.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/json.h"
#include "job/block_job.h"
#include "job/check_job.h"
#include "job/layout_job.h"
#include "job/mesh_job.h"
#include "job/modules.h"

/* Paths travel as absolute ones. */
static void assert_path(const char *got, const char *relative)
{
    char folder[1024], wanted[1200];
    assert_non_null(getcwd(folder, sizeof folder));
    snprintf(wanted, sizeof wanted, "%s/%s", folder, relative);
    assert_string_equal(got, wanted);
}

static const struct aob_camera camera = {.eye = {1, 2, 3.25},
                                         .target = {0.1, 0, -4},
                                         .fov_deg = 47,
                                         .shift = {0.25, -0.5},
                                         .moves = true,
                                         .previous_eye = {1, 2, 3.5},
                                         .previous_target = {0.2, 0, -4}};
static const struct aob_job_view view = {.mesh = "/cache/a.mesh",
                                         .camera = camera,
                                         .width = 320,
                                         .height = 180,
                                         .frame = 7,
                                         .seed = 1,
                                         .guard = 16,
                                         .light = {.sh = {{1, 2, 3}, [8] = {0, 0, -0.25}}},
                                         .gbuffer = "/cache/g.exr"};

static void check_view(const struct aob_job_view *v)
{
    assert_string_equal(v->mesh, "/cache/a.mesh");
    assert_null(v->scene);
    assert_string_equal(v->gbuffer, "/cache/g.exr");
    assert_int_equal(v->width, 320);
    assert_int_equal(v->height, 180);
    assert_true(v->guard == 16 && v->frame == 7 && v->seed == 1);
    assert_false(v->captured);
    assert_memory_equal(&v->light, &view.light, sizeof view.light);
    assert_true(v->camera.eye.z == 3.25 && v->camera.target.x == 0.1 && v->camera.target.z == -4);
    assert_true(v->camera.fov_deg == 47 && v->camera.ortho_height == 0);
    assert_true(v->camera.shift[0] == 0.25 && v->camera.shift[1] == -0.5);
    assert_true(v->camera.moves && v->camera.previous_eye.z == 3.5 && v->camera.previous_target.x == 0.2);
}

static const float falloff[3] = {1, 0.3f, 0};

static void check_terms(const struct aob_term *a, const struct aob_term *b)
{
    assert_true(a->radius == 0.7 && a->uniform && !a->of_triangle && !a->bound);
    assert_int_equal(a->falloff_count, 3);
    assert_memory_equal(a->falloff, falloff, sizeof falloff);
    assert_true(isinf(b->radius) && !b->uniform && b->of_triangle && b->bound && isinf(b->thickness));
    assert_true(!a->bent && b->bent);
    assert_null(b->falloff);
    assert_false(aob_term_same_trace(a, b));
    assert_true(aob_term_same_trace(a, a));
    /* linear in the root of the distance: half way between the first two rows at 1/16 of the radius */
    assert_near(aob_term_falloff(a, 1.0 / 16), 0.65, 1e-6);
    assert_near(aob_term_falloff(b, 0.5), 1, 0);
}

static void a_view_job(void **state)
{
    (void)state;
    const struct aob_term faded = {.radius = 0.7, .uniform = true, .falloff = falloff, .falloff_count = 3},
                          bound = {.radius = INFINITY,
                                   .of_triangle = true,
                                   .bound = true,
                                   .thickness = INFINITY,
                                   .bent = true};
    json_t *terms = json_array(), *term;
    json_array_append_new(terms, term = aob_term_to_json(&faded));
    json_object_set_new(term, "out", json_string("a.exr"));
    json_array_append_new(terms, term = aob_term_to_json(&bound));
    json_object_set_new(term, "out", json_string("b.exr"));
    struct aob_view_job job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_view_job_to_json(&view, 128, true, terms));
    assert_string_equal(json_string_value(json_object_get(message, "job")), "view");
    assert_true(aob_view_job_from_json(message, &job, &error));
    check_view(&job.view);
    assert_int_equal(job.spp, 128);
    assert_true(job.cast);
    assert_int_equal(job.term_count, 2);
    assert_string_equal(job.terms[0].out, "a.exr");
    assert_string_equal(job.terms[1].out, "b.exr");
    check_terms(&job.terms[0].term, &job.terms[1].term);
    aob_view_job_finish(&job);
    json_object_del(json_array_get(json_object_get(message, "terms"), 1), "out");
    assert_false(aob_view_job_from_json(message, &job, &error));
    assert_contains(error.text, "term 1");
    json_object_del(message, "gbuffer");
    assert_false(aob_view_job_from_json(message, &job, &error));
    json_decref(message);
}

static struct aob_block_target targets[] = {
    {0.25, false, {[AOB_OUT_VISIBILITY] = "t.exr", [AOB_OUT_IRRADIANCE] = "l.exr"}, true},
    {INFINITY, true, {NULL}, false}};
static struct aob_block_case cases[] = {{.frame = {.technique = {"gtao", "one.so", "0123"},
                                                   .params = {0.5, 3},
                                                   .param_count = 2,
                                                   .options = {16, 1}},
                                         .target = 1,
                                         .definition = "d.exr",
                                         .screen = "s.exr",
                                         .image = "i.exr"},
                                        {.frame = {.technique = {"none", NULL, "4567"}}}};
static const struct aob_block_job block = {
    .drawing = {.view = view, .backend = "gl-egl", .device = "radeon", .validate = true, .triangles = true},
    .score = true,
    .error = true,
    .process = 2,
    .seed = 0xfedcba98,
    .seconds = 0.75,
    .precision = 0.015,
    .clock = "wall",
    .clock_reason = "it lies",
    .targets = targets,
    .target_count = 2,
    .cases = cases,
    .case_count = 2};

static void check_block(const struct aob_block_job *job)
{
    assert_string_equal(job->drawing.backend, "gl-egl");
    assert_string_equal(job->drawing.device, "radeon");
    assert_true(job->drawing.validate && !job->drawing.raster && job->drawing.triangles && job->score &&
                !job->time && job->error);
    assert_true(job->process == 2 && job->seed == 0xfedcba98 && job->seconds == 0.75 &&
                job->precision == 0.015);
    assert_string_equal(job->clock, "wall");
    assert_string_equal(job->clock_reason, "it lies");
    assert_int_equal(job->target_count, 2);
    assert_true(job->targets[0].radius == 0.25 && !job->targets[0].uniform && job->targets[0].bent);
    assert_path(job->targets[0].truth[AOB_OUT_VISIBILITY], "t.exr");
    assert_path(job->targets[0].truth[AOB_OUT_IRRADIANCE], "l.exr");
    assert_null(job->targets[0].truth[AOB_OUT_SPECULAR]);
    assert_true(isinf(job->targets[1].radius) && job->targets[1].uniform && !job->targets[1].bent);
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        assert_null(job->targets[1].truth[which]);
    assert_int_equal(job->case_count, 2);
    assert_string_equal(job->cases[0].frame.technique.technique, "gtao");
    assert_path(job->cases[0].frame.technique.module, "one.so");
    assert_string_equal(job->cases[0].frame.technique.digest, "0123");
    assert_string_equal(job->cases[1].frame.technique.technique, "none");
    assert_null(job->cases[1].frame.technique.module);
    assert_string_equal(job->cases[1].frame.technique.digest, "4567");
    assert_int_equal(job->cases[0].frame.param_count, 2);
    assert_true(job->cases[0].frame.params[0] == 0.5 && job->cases[0].frame.params[1] == 3);
    assert_true(job->cases[0].frame.options[0] == 16 && job->cases[0].frame.options[1] == 1 &&
                job->cases[0].frame.options[2] == 0);
    assert_int_equal(job->cases[0].target, 1);
    assert_path(job->cases[0].definition, "d.exr");
    assert_path(job->cases[0].screen, "s.exr");
    assert_path(job->cases[0].image, "i.exr");
    assert_int_equal(job->cases[1].frame.param_count, 0);
    assert_true(!job->cases[1].definition && !job->cases[1].screen && !job->cases[1].image);
}

static void a_block_job(void **state)
{
    (void)state;
    struct aob_block_job job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_block_job_to_json(&block));
    assert_string_equal(json_string_value(json_object_get(message, "job")), "block");
    assert_true(aob_block_job_from_json(message, &job, &error));
    check_view(&job.drawing.view);
    check_block(&job);
    assert_int_equal(job.pose_count, 0);
    aob_block_job_finish(&job);
    json_object_del(json_object_get(message, "timing"), "clock_reason");
    assert_false(aob_block_job_from_json(message, &job, &error));
    assert_contains(error.text, "why it has its clock");
    json_object_set_new(json_object_get(message, "timing"), "clock", json_null());
    assert_true(aob_block_job_from_json(message, &job, &error));
    assert_null(job.clock);
    aob_block_job_finish(&job);
    json_object_set_new(json_array_get(json_object_get(message, "cases"), 1), "target", json_integer(2));
    assert_false(aob_block_job_from_json(message, &job, &error));
    assert_contains(error.text, "target 2 of 2");
    json_object_set_new(json_array_get(json_object_get(message, "cases"), 1), "target", json_integer(1));
    json_object_del(json_object_get(json_array_get(json_object_get(message, "cases"), 1), "technique"),
                    "digest");
    assert_false(aob_block_job_from_json(message, &job, &error));
    assert_contains(error.text, "no digest");
    json_array_clear(json_object_get(message, "cases"));
    assert_false(aob_block_job_from_json(message, &job, &error));
    assert_contains(error.text, "0 cases");
    json_decref(message);
}

static void modules_to_describe(void **state)
{
    (void)state;
    static const char *const paths[] = {"one.so", "two.so"};
    struct aob_modules back;
    json_t *message = send(aob_modules_to_json(&(struct aob_modules){paths, paths, 2, 2}));
    aob_modules_from_json(message, &back);
    assert_int_equal(back.count, 2);
    assert_path(back.paths[1], "two.so");
    aob_modules_finish(&back);
    json_decref(message);
}

static void a_layout_job(void **state)
{
    (void)state;
    double params[] = {0.5, 3, 1, 9};
    unsigned wanted[] = {0, 1u << AOB_OUT_BENT_NORMAL | AOB_WANT_THRIFT};
    struct aob_layout_job out = {.technique = {"gtao", "two.so", "89"},
                                 .case_count = 2,
                                 .param_count = 2,
                                 .params = params,
                                 .wanted = wanted},
                          job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_layout_job_to_json(&out));
    assert_true(aob_layout_job_from_json(message, &job, &error));
    assert_string_equal(job.technique.technique, "gtao");
    assert_path(job.technique.module, "two.so");
    assert_string_equal(job.technique.digest, "89");
    assert_true(job.case_count == 2 && job.param_count == 2);
    assert_memory_equal(job.params, params, sizeof params);
    assert_memory_equal(job.wanted, wanted, sizeof wanted);
    aob_layout_job_finish(&job);
    json_t *second = json_array_get(json_object_get(message, "cases"), 1);
    json_array_append_new(json_object_get(second, "params"), json_real(1));
    assert_false(aob_layout_job_from_json(message, &job, &error));
    assert_contains(error.text, "case 1");
    json_array_remove(json_object_get(second, "params"), 2);
    json_object_del(second, "wanted");
    assert_false(aob_layout_job_from_json(message, &job, &error));
    assert_contains(error.text, "the outputs it wants");
    json_decref(message);
}

static void a_layout_answer(void **state)
{
    (void)state;
    json_t *term = aob_term_to_json(&(struct aob_term){.radius = 0.5});
    struct aob_layout_answer answer = {.status = "ok",
                                       .graph = "abc",
                                       .dot = "digraph",
                                       .outputs = 1u << AOB_OUT_BENT_NORMAL | 1,
                                       .triangles = true,
                                       .definition = term,
                                       .mapped = true},
                             back;
    json_t *message = send(aob_layout_answer_to_json(&answer));
    json_decref(term);
    assert_true(aob_layout_answer_from_json(message, &back));
    assert_string_equal(back.graph, "abc");
    assert_string_equal(back.dot, "digraph");
    assert_true(back.triangles && back.mapped && !back.reason);
    assert_int_equal(back.outputs, 1u << AOB_OUT_BENT_NORMAL | 1u << AOB_OUT_VISIBILITY);
    assert_true(json_number_value(json_object_get(back.definition, "radius")) == 0.5);
    json_decref(message);
    message =
        send(aob_layout_answer_to_json(&(struct aob_layout_answer){.status = "invalid", .reason = "no"}));
    assert_true(aob_layout_answer_from_json(message, &back));
    assert_string_equal(back.reason, "no");
    assert_true(!back.definition && !back.triangles);
    json_decref(message);
}

static void a_mesh_job(void **state)
{
    (void)state;
    struct aob_mesh_job job;
    struct aob_mesh_answer answer = {{-1, -2, -3}, {1, 2, 3}, 8, 12, NULL}, back;
    struct aob_error error = {{0}};
    json_t *message = send(aob_mesh_job_to_json(&(struct aob_mesh_job){"a.ply", "a.mesh", true}));
    assert_true(aob_mesh_job_from_json(message, &job, &error));
    assert_string_equal(job.file, "a.ply");
    assert_path(job.out, "a.mesh");
    assert_true(job.cached);
    json_object_del(message, "out");
    assert_false(aob_mesh_job_from_json(message, &job, &error));
    json_decref(message);
    message = send(aob_mesh_answer_to_json(&answer));
    assert_true(aob_mesh_answer_from_json(message, &back));
    assert_true(back.low.y == -2 && back.high.z == 3 && back.vertices == 8 && back.triangles == 12);
    json_object_del(message, "low");
    assert_false(aob_mesh_answer_from_json(message, &back));
    json_decref(message);
}

static void a_check_job(void **state)
{
    (void)state;
    struct aob_check_job job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_check_job_to_json(&(struct aob_check_job){.view = view, .radius = INFINITY}));
    assert_string_equal(json_string_value(json_object_get(message, "job")), "check");
    assert_true(aob_check_job_from_json(message, &job, &error));
    check_view(&job.view);
    assert_true(isinf(job.radius));
    json_object_del(message, "radius");
    assert_false(aob_check_job_from_json(message, &job, &error));
    json_decref(message);
    struct aob_check_answer answer;
    message = send(aob_check_answer_to_json(
        &(struct aob_check_answer){.triangles = 72, .doubled = 24, .backs = 0.03125}));
    assert_true(aob_check_answer_from_json(message, &answer));
    assert_true(answer.triangles == 72 && answer.doubled == 24 && answer.backs == 0.03125);
    json_object_del(message, "backs");
    assert_false(aob_check_answer_from_json(message, &answer));
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_view_job),          cmocka_unit_test(a_check_job),
        cmocka_unit_test(a_block_job),         cmocka_unit_test(a_layout_job),
        cmocka_unit_test(a_mesh_job),          cmocka_unit_test(a_layout_answer),
        cmocka_unit_test(modules_to_describe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
