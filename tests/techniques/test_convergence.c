#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"
#include "technique/param.h"
#include "technique/registry.h"

/* Every technique that samples, along the axis that it declares: error against its own image of 4,096 samples. */

enum { W = 96, H = 54, LEVELS = 6, FIRST = 8, CONVERGED = 4096 };

/* What is held fixed, where the defaults would be dear or would blur. */
static const char *fixed_params(const char *technique)
{
    static const char *const rows[][2] = {{"gtao", "steps=8 blur=0"},
                                          {"hbao", "steps=8 blur=0"},
                                          {"alchemy", "blur=0"},
                                          {"ray_march", "rays=2 steps=4"}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        if (strcmp(rows[i][0], technique) == 0)
            return rows[i][1];
    return "blur=0";
}

static void image_of(struct aob_gpu *gpu, const struct aob_rig *rig, const struct aob_technique *technique,
                     int samples, float *pixels)
{
    char params[160];
    snprintf(params, sizeof params, "%s %s=%d", fixed_params(technique->name), technique->sampling.param,
             samples);
    aob_rig_run(rig, gpu, technique->name, params, AOB_FETCH_SAMPLED, pixels);
}

static double rmse(const struct aob_rig *rig, const float *a, const float *b)
{
    double sum = 0;
    size_t count = 0;
    for (int i = 0; i < W * H; i++)
        if (rig->hits.depth[i] > 0) {
            sum += pow((double)a[i] - (double)b[i], 2);
            count++;
        }
    return sqrt(sum / (double)count);
}

/* Least squares through (log N, log error). */
static double slope(const double *error)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < LEVELS; i++) {
        double x = log((double)(FIRST << i)), y = log(error[i]);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (LEVELS * sxy - sx * sy) / (LEVELS * sxx - sx * sx);
}

static void test_error_falls_with_samples(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float *converged = AOB_NEW_ARRAY(float, W *H), *image = AOB_NEW_ARRAY(float, W *H);
    bool all = true;
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 0);
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++) {
        double error[LEVELS];
        if (!(*t)->sampling.param)
            continue;
        image_of(gpu, &rig, *t, CONVERGED, converged);
        printf("%s, %s 8..256:", (*t)->name, (*t)->sampling.param);
        for (int i = 0; i < LEVELS; i++) {
            image_of(gpu, &rig, *t, FIRST << i, image);
            error[i] = rmse(&rig, image, converged);
            printf(" %.4f", error[i]);
        }
        double bar = (*t)->sampling.sequence == AOB_SEQUENCE_STRATIFIED ? -0.45 : -0.40, s = slope(error);
        printf(", slope %.2f (bar %.2f)\n", s, bar);
        all = all && s <= bar;
    }
    assert_true(all);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(converged);
    free(image);
}

/* More steps along each slice: against 256 of them, from coarse to fine. Steps are bias, not noise, so no exponent. */
static void test_error_falls_with_steps(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float *fine = AOB_NEW_ARRAY(float, W *H), *image = AOB_NEW_ARRAY(float, W *H);
    double last = INFINITY;
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 0);
    aob_rig_run(&rig, gpu, "gtao", "slices=16 steps=256 blur=0", AOB_FETCH_SAMPLED, fine);
    printf("gtao, 16 slices, 2..64 steps:");
    for (int steps = 2; steps <= 64; steps *= 2) {
        char params[80];
        snprintf(params, sizeof params, "slices=16 steps=%d blur=0", steps);
        aob_rig_run(&rig, gpu, "gtao", params, AOB_FETCH_SAMPLED, image);
        double error = rmse(&rig, image, fine);
        printf(" %.4f", error);
        assert_true(error < last);
        last = error;
    }
    printf("\n");
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(fine);
    free(image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_error_falls_with_samples),
                                       cmocka_unit_test(test_error_falls_with_steps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
