/* The screen-space bound. */
#include "shot.h"
#include "reference/screen.h"
#include <stdio.h>
#include <stdlib.h>

enum { INFINITE, SLAB, THIN, KINDS };

static void bound_shot(const struct shot *shot, const struct aob_screen_desc *desc,
                       const struct aob_visibility_term *term, int spp, struct aob_visibility *result)
{
    struct aob_error error = {""};
    struct aob_screen *screen = aob_screen_create(&shot->camera, &shot->projection, &shot->hits, desc, &error);
    assert_string_equal(error.text, "");
    struct aob_visibility_desc trace = {.terms = term, .term_count = 1, .spp = spp, .seed = 7};
    assert_true(aob_screen_visibility(screen, &trace, result, &error));
    aob_screen_destroy(screen);
}

static double view_radius(const struct shot *shot)
{
    double sum = 0, seen = 0;
    for (size_t i = 0; i < pixel_count(shot); i++) {
        sum += shot->hits.depth[i];
        seen += shot->hits.depth[i] > 0;
    }
    return 0.1 * sum / seen;
}

static void check_scene(const struct aob_scene_info *scene, const struct aob_view *view)
{
    struct aob_mesh mesh = {0};
    scene->build(&mesh);
    struct shot shot;
    cast_shot(&shot, &mesh, view->camera, 96, 54);
    const struct aob_visibility_term term = {.radius = view_radius(&shot)};
    trace_shot(&shot, &term, 1, 64);
    struct aob_visibility bound[KINDS];
    const struct aob_screen_desc descs[KINDS] = {
        {0}, {.kind = AOB_SCREEN_SLAB, .thickness = term.radius / 4}, {.kind = AOB_SCREEN_THIN}};
    for (int k = 0; k < KINDS; k++)
        bound_shot(&shot, &descs[k], &term, 64, &bound[k]);
    double mean[KINDS + 1] = {0}, square[KINDS] = {0}, darker = 0, n = 0, unnested = 0, slab_un = 0;
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        double truth = shot.visibility[0].ao[i];
        n++;
        mean[KINDS] += truth;
        for (int k = 0; k < KINDS; k++) {
            mean[k] += bound[k].ao[i];
            square[k] += pow(bound[k].ao[i] - truth, 2);
        }
        darker += bound[THIN].ao[i] < truth - 0.05;
        unnested += bound[INFINITE].ao[i] > bound[THIN].ao[i];
        slab_un += bound[INFINITE].ao[i] > bound[SLAB].ao[i] || bound[SLAB].ao[i] > bound[THIN].ao[i];
    }
    print_message("%-8s %-8s r %6.3f  truth %.4f  inf %.4f (%.4f)  slab %.4f (%.4f)  thin %.4f (%.4f)  darker %.2f %%  "
                  "unnested %g, slab %g\n",
                  scene->name, view->name, term.radius, mean[KINDS] / n, mean[0] / n, sqrt(square[0] / n),
                  mean[1] / n, sqrt(square[1] / n), mean[2] / n, sqrt(square[2] / n), 100 * darker / n, unnested,
                  slab_un);
    for (int k = 0; k < KINDS; k++)
        aob_visibility_finish(&bound[k]);
    finish_shot(&shot);
}

static void every_scene(void **state)
{
    (void)state;
    for (const struct aob_scene_info *const *scene = aob_scenes; *scene; scene++)
        for (size_t v = 0; (*scene)->build && v < (*scene)->view_count; v++)
            check_scene(*scene, &(*scene)->views[v]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_scene)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
