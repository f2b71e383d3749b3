/* Passes that draw triangles, one body for all backends: test_geometry vulkan|gl-egl|gl-osmesa|null. Sizes are powers
 * of two and corners lie on sixteenths of a pixel, so that every position is exact in clip space and on the
 * rasteriser's grid, and integers say which pixel centres a triangle covers. */
#include "check.h"
#include <stdlib.h>
#include "base/memory.h"
#include "gpu/gpu.h"
#include "rig.h"

enum { WIDTH = 64, HEIGHT = 32, TEXELS = WIDTH * HEIGHT, GRID = 16, MOST = 8 };

struct corner {
    int x, y; /* sixteenths of a pixel, y down */
    float z;
};
struct triangle {
    struct corner corner[3];
};

static const char vertex_text[] = "layout(BIND(1)) uniform sampler2D corners;\n"
                                  "layout(location = 0) flat out float number;\n"
                                  "void main() {\n"
                                  "    vec3 p = texelFetch(corners, ivec2(VERTEX_ID, 0), 0).xyz;\n"
                                  "    number = float(VERTEX_ID / 3 + 1);\n"
                                  "    gl_Position = vec4(p.x / 32.0 - 1.0, p.y / 16.0 - 1.0, p.z, 1.0); }\n";
static const char fragment_text[] = "layout(location = 0) flat in float number;\n"
                                    "layout(location = 0) out float r;\n"
                                    "void main() { r = number; }\n";

static const struct aob_gpu_texture_desc image = {
    .format = AOB_R32F, .width = WIDTH, .height = HEIGHT, .uses = AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK};

static bool draws(const struct aob_gpu *gpu)
{
    return !gpu->info.draws_nothing;
}

static struct aob_gpu_texture *upload(struct aob_gpu *gpu, const struct triangle *triangles, size_t count)
{
    float texels[MOST * 3][4] = {{0}};
    for (size_t i = 0; i < 3 * count; i++) {
        const struct corner *c = &triangles[i / 3].corner[i % 3];
        texels[i][0] = (float)c->x / GRID;
        texels[i][1] = (float)c->y / GRID;
        texels[i][2] = c->z;
    }
    struct aob_error error = {{0}};
    struct aob_gpu_texture *made =
        aob_gpu_texture_create(gpu,
                               &(struct aob_gpu_texture_desc){.format = AOB_RGBA32F,
                                                              .width = (int)(3 * count),
                                                              .height = 1,
                                                              .uses = AOB_GPU_USE_SAMPLED,
                                                              .texels = texels},
                               &error);
    if (!made)
        fail_msg("%s", error.text);
    return made;
}

/* The triangle's number (from 1) in each pixel, or sums of it; 0 where none. The pass runs twice. */
static float *draw(struct aob_gpu *gpu, const struct triangle *triangles, size_t count, bool depth_test,
                   enum aob_gpu_blend blend)
{
    struct aob_error error = {{0}};
    struct aob_gpu_texture *corners = upload(gpu, triangles, count);
    struct aob_gpu_texture *target = aob_gpu_texture_create(gpu, &image, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    struct aob_gpu_program *program =
        aob_gpu_program_create_geometry(gpu, vertex_text, fragment_text, &error);
    struct aob_gpu_bind bind = {.binding = 1, .texture = corners};
    struct aob_gpu_pass *pass =
        program ? aob_gpu_pass_create(gpu,
                                      &(struct aob_gpu_pass_desc){.program = program,
                                                                  .binds = &bind,
                                                                  .bind_count = 1,
                                                                  .targets = targets,
                                                                  .target_count = 1,
                                                                  .vertex_count = (uint32_t)(3 * count),
                                                                  .depth_test = depth_test,
                                                                  .blend = blend},
                                      &error)
                : NULL;
    float *pixels = AOB_NEW_ARRAY(float, TEXELS);
    const struct aob_gpu_run_desc twice = {&pass, 1, 2};
    if (!pass || !aob_gpu_run(gpu, &twice, NULL, NULL, &error) ||
        !aob_gpu_texture_read(gpu, target, 0, pixels, &error))
        fail_msg("%s", error.text);
    aob_gpu_pass_destroy(gpu, pass);
    aob_gpu_program_destroy(gpu, program);
    aob_gpu_texture_destroy(gpu, target);
    aob_gpu_texture_destroy(gpu, corners);
    return pixels;
}

static long edge(const struct corner *a, const struct corner *b, long x, long y)
{
    return (long)(b->x - a->x) * (y - a->y) - (long)(b->y - a->y) * (x - a->x);
}

/* Whether the triangle covers the pixel's centre; and the barycentric weights times the area. */
static bool covers(const struct triangle *t, int x, int y, long weights[3])
{
    long px = x * GRID + GRID / 2, py = y * GRID + GRID / 2;
    bool above = true, below = true;
    for (int k = 0; k < 3; k++) {
        weights[k] = edge(&t->corner[(k + 1) % 3], &t->corner[(k + 2) % 3], px, py);
        assert_int_not_equal(weights[k], 0); /* else the rule for shared edges would decide */
        above = above && weights[k] > 0;
        below = below && weights[k] < 0;
    }
    return above || below;
}

static double depth_at(const struct triangle *t, const long weights[3])
{
    double sum = 0, area = 0;
    for (int k = 0; k < 3; k++) {
        sum += (double)weights[k] * (double)t->corner[k].z;
        area += (double)weights[k];
    }
    return sum / area;
}

/* Of several shapes and both windings; two leave the image, which clips them. No centre lies on an edge. */
static const struct triangle shapes[] = {
    {{{37, 21, .2f}, {901, 150, .7f}, {306, 460, .9f}}},
    {{{37, 21, .8f}, {306, 460, .8f}, {901, 150, .1f}}},
    {{{-399, 77, .3f}, {1501, 101, .6f}, {500, 1203, .4f}}},
    {{{99, 3, .5f}, {119, 501, .5f}, {112, 7, .5f}}},      /* a sliver */
    {{{700, 400, .9f}, {701, 411, .9f}, {707, 403, .9f}}}, /* between the centres */
};

static void covers_the_centres_it_should(void **state)
{
    struct aob_gpu *gpu = *state;
    for (size_t s = 0; s < AOB_COUNT(shapes); s++) {
        float *got = draw(gpu, &shapes[s], 1, false, AOB_GPU_REPLACE);
        size_t covered = 0;
        for (int i = 0; i < TEXELS; i++) {
            long weights[3];
            bool covered_here = covers(&shapes[s], i % WIDTH, i / WIDTH, weights);
            covered += covered_here;
            if (got[i] != (float)(draws(gpu) && covered_here))
                fail_msg("shape %zu, pixel %d %d: %g", s, i % WIDTH, i / WIDTH, (double)got[i]);
        }
        assert_true(s == 4 ? covered == 0 : covered >= 8);
        free(got);
    }
}

static void expect_winners(struct aob_gpu *gpu, const struct triangle *triangles, size_t count,
                           bool depth_test)
{
    float *got = draw(gpu, triangles, count, depth_test, AOB_GPU_REPLACE);
    size_t won[MOST + 1] = {0};
    for (int i = 0; i < TEXELS; i++) {
        size_t winner = 0;
        double best = 0, second = 0;
        for (size_t t = 0; t < count; t++) {
            long weights[3];
            if (!covers(&triangles[t], i % WIDTH, i / WIDTH, weights))
                continue;
            double z = depth_at(&triangles[t], weights);
            if (!depth_test || z > best) {
                winner = t + 1;
                second = best;
                best = z;
            } else if (z > second)
                second = z;
        }
        if (depth_test && best - second < 1e-5)
            continue; /* too near to call in floats */
        won[winner]++;
        if (got[i] != (float)(draws(gpu) ? winner : 0))
            fail_msg("pixel %d %d: %g, not %zu", i % WIDTH, i / WIDTH, (double)got[i], winner);
    }
    assert_true(won[1] > 10 && won[2] > 10);
    free(got);
}

/* Two that pass through each other, in both orders: nobody wins everywhere. */
static void the_greater_depth_wins(void **state)
{
    const struct triangle crossing[] = {shapes[0], shapes[1]}, swapped[] = {shapes[1], shapes[0]};
    expect_winners(*state, crossing, 2, true);
    expect_winners(*state, swapped, 2, true);
}

static void the_later_wins_without_a_test(void **state)
{
    const struct triangle both[] = {shapes[2], shapes[0]};
    expect_winners(*state, both, 2, false);
}

static void adds_what_lies_over_another(void **state)
{
    struct aob_gpu *gpu = *state;
    float *got = draw(gpu, shapes, AOB_COUNT(shapes), false, AOB_GPU_ADD);
    for (int i = 0; i < TEXELS; i++) {
        float sum = 0;
        for (size_t t = 0; t < AOB_COUNT(shapes); t++) {
            long weights[3];
            sum += covers(&shapes[t], i % WIDTH, i / WIDTH, weights) ? (float)(t + 1) : 0;
        }
        assert_true(got[i] == (draws(gpu) ? sum : 0));
    }
    free(got);
}

/* z > w is nearer than the near plane: cut along it, not squeezed onto it. */
static void cuts_what_is_too_near(void **state)
{
    struct aob_gpu *gpu = *state;
    const struct triangle slanted = {{{-4000, -3001, -6}, {6007, -2999, 8}, {900, 9001, 1}}};
    float *got = draw(gpu, &slanted, 1, true, AOB_GPU_REPLACE);
    size_t seen = 0;
    for (int i = 0; i < TEXELS; i++) {
        long weights[3];
        assert_true(covers(&slanted, i % WIDTH, i / WIDTH, weights));
        double z = depth_at(&slanted, weights);
        if (z > 0 - 1e-3 && z < 1e-3)
            continue;
        seen += z > 0 && z < 1;
        if (fabs(z - 1) > 1e-3)
            assert_true(got[i] == (draws(gpu) && z > 0 && z < 1 ? 1 : 0));
    }
    assert_true(seen > 100 && seen < TEXELS - 100);
    free(got);
}

static void refuse(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, const char *why)
{
    struct aob_error error = {{0}};
    assert_null(aob_gpu_pass_create(gpu, desc, &error));
    assert_contains(error.text, why);
}

static void refuses_what_makes_no_sense(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_error error = {{0}};
    struct aob_gpu_program *program =
        aob_gpu_program_create_geometry(gpu, vertex_text, fragment_text, &error);
    struct aob_gpu_program *screen =
        aob_gpu_program_create(gpu, "layout(location = 0) out float r;\nvoid main() { r = 1; }\n", &error);
    struct aob_gpu_texture *corners = upload(gpu, shapes, 1);
    struct aob_gpu_texture *target = aob_gpu_texture_create(gpu, &image, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    struct aob_gpu_bind bind = {.binding = 1, .texture = corners};
    struct aob_gpu_pass_desc good = {.program = program,
                                     .binds = &bind,
                                     .bind_count = 1,
                                     .targets = targets,
                                     .target_count = 1,
                                     .vertex_count = 3},
                             desc = good;
    desc.vertex_count = 0;
    refuse(gpu, &desc, "three a triangle");
    desc.vertex_count = 4;
    refuse(gpu, &desc, "three a triangle");
    desc = good;
    desc.blend = (enum aob_gpu_blend)7;
    refuse(gpu, &desc, "unknown blend 7");
    desc = good;
    desc.bind_count = 0;
    refuse(gpu, &desc, "nothing at 1"); /* which only the vertex text declares */
    desc = good;
    desc.program = screen;
    refuse(gpu, &desc, "no vertex text");
    desc.vertex_count = 0;
    desc.depth_test = true;
    refuse(gpu, &desc, "no vertex text");
    assert_null(aob_gpu_program_create_geometry(gpu, "void main() {\n x; }", fragment_text, &error));
    assert_contains(error.text, ": vertex shader, line 2: 'x' : undeclared identifier");
    aob_gpu_texture_destroy(gpu, target);
    aob_gpu_texture_destroy(gpu, corners);
    aob_gpu_program_destroy(gpu, screen);
    aob_gpu_program_destroy(gpu, program);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(covers_the_centres_it_should),  cmocka_unit_test(the_greater_depth_wins),
        cmocka_unit_test(the_later_wins_without_a_test), cmocka_unit_test(adds_what_lies_over_another),
        cmocka_unit_test(cuts_what_is_too_near),         cmocka_unit_test(refuses_what_makes_no_sense),
    };
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
