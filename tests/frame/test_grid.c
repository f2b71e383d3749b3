#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

/* Divided targets and depths: where a pass of one size finds its surface in a depth of another, and tables. Odd sizes,
 * so that nothing divides evenly. */

enum { W = 161, H = 91 };

struct values {
    int32_t divisor, depth_divisor;
};
static const struct aob_shader shaders[] = {
    {"downsample", "void main() { depth = aob_view_z(aob_pixel * AOB_DIVISOR); }\n"},
    /* distance between a pixel's surface and what the divided depth holds under its place, and between that place
     * and the projection of the surface; 1 where all is well */
    {"agree", "void main() {\n"
              "    ivec2 p = aob_pixel;\n"
              "    vec2 at = aob_image(p), back = aob_project(aob_surface(p));\n"
              "    float far = max(abs(at.x - back.x), abs(at.y - back.y));\n"
              "    vec3 found = aob_position_at(at, aob_surface_z(p));\n"
              "    far = max(far, length(found - aob_surface(p)));\n"
              "    ivec2 own = ivec2(floor(at));\n"
              "    bool same = vec2(own) + 0.5 == at;\n"
              "    if (same && !aob_surface_is_sky(p))\n"
              "        far = max(far, length(aob_position(own) - aob_surface(p)));\n"
              "    o = same ? 1.0 - far : 2.0 - far;\n}\n"},
    {"spread", "void main() { o = aob_fetch_low(aob_pixel / AOB_DIVISOR_LOW); }\n"},
    {"surface", "void main() { o = aob_surface_is_sky(aob_pixel) ? 0.0 : -aob_surface(aob_pixel).z; }\n"},
    {"size", "void main() { o = float(aob_size.x) + float(aob_target_size.y) / 1000.0; }\n"},
    {"table", "void main() { o = aob_fetch_table(ivec2(aob_pixel.x, aob_pixel.y)); }\n"},
    {NULL, NULL}};
static const char *chosen;

static void fill(const void *values, void *texels)
{
    float *t = texels;
    for (int i = 0; i < 12; i++)
        t[i] = (float)(i + ((const struct values *)values)->divisor * 100);
}

static bool build(struct aob_graph *graph, const void *data)
{
    const struct values *v = data;
    aob_tex depth = {0}, table = {0};
    if (v->depth_divisor > 1) {
        depth = aob_texture(graph, .name = "low_depth", .format = AOB_R32F,
                            .divisor = (uint32_t)v->depth_divisor);
        aob_pass(graph, .name = "downsample", .shader = "downsample", .reads = AOB_DEPTH,
                 .out = {{.name = "depth", .tex = depth}});
    }
    if (!strcmp(chosen, "table"))
        table =
            aob_texture(graph, .name = "table", .format = AOB_R32F, .width = 4, .height = 3, .fill = fill);
    aob_tex low = aob_texture(graph, .name = "low", .format = AOB_R32F, .divisor = (uint32_t)v->divisor);
    aob_tex full = aob_texture(graph, .name = "full", .format = AOB_R32F);
    aob_pass(graph, .name = "low", .shader = chosen, .reads = AOB_DEPTH, .depth = depth, .border = AOB_FAR,
             .in = {{.name = table.id ? "table" : NULL, .tex = table}}, .out = {{.name = "o", .tex = low}});
    return aob_pass(graph, .name = "spread", .shader = "spread", .in = {{.name = "low", .tex = low}},
                    .out = {{.name = "o", .tex = full}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, full);
}
static const struct aob_param params[] = {
    AOB_PARAM(struct values, divisor, .stage = AOB_HOST, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM(struct values, depth_divisor, .stage = AOB_HOST, .min = 0, .max = 9, .doc = "."),
};
AOB_TECHNIQUE(grid, .title = "t", .citation = "c", .params = params, .param_count = 2,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);

static void run(const struct aob_rig *rig, const char *backend, const char *shader, struct values values,
                float *pixels)
{
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    chosen = shader;
    aob_rig_probe(rig, gpu, &aob_technique_grid, &values, &(struct aob_options){.fetch = AOB_FETCH_STORAGE},
                  pixels);
    aob_gpu_close(gpu);
}

static void rig_of(struct aob_rig *rig, double ortho)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = aob_scene_view(aob_scene_find("spheres"), "front")->camera;
    camera.ortho_height = ortho;
    aob_scene_find("spheres")->build(&mesh);
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
}

static void test_surfaces_lie_in_their_depth(void **state)
{
    (void)state;
    float pixels[W * H];
    struct aob_rig rig;
    for (int ortho = 0; ortho < 2; ortho++) {
        rig_of(&rig, ortho ? 4 : 0);
        for (int divisor = 1; divisor <= 4; divisor *= 2)
            for (int depth = 1; depth <= 4; depth *= 2) {
                size_t between = 0, on = 0;
                run(&rig, "gl-egl", "agree", (struct values){divisor, depth}, pixels);
                for (int i = 0; i < W * H; i++) {
                    on += fabs((double)pixels[i] - 1) < 1e-3;
                    between += fabs((double)pixels[i] - 2) < 1e-3;
                }
                assert_int_equal(on + between, W * H);
                assert_true(divisor % depth == 0 ? between == 0 : between > 0 && on > 0);
            }
        aob_rig_finish(&rig);
    }
}

/* Pixel p of a divided target stands for the G-buffer's pixel p * divisor, whatever depth the pass reads. */
static void test_surface_is_the_first_pixel_of_its_block(void **state)
{
    (void)state;
    float pixels[W * H];
    struct aob_rig rig;
    rig_of(&rig, 0);
    for (int divisor = 1; divisor <= 4; divisor *= 2)
        for (int depth = 1; depth <= 4; depth *= 2) {
            run(&rig, "gl-egl", "surface", (struct values){divisor, depth}, pixels);
            for (int y = 0; y < H; y++)
                for (int x = 0; x < W; x++) {
                    float z = rig.hits.depth[y / divisor * divisor * W + x / divisor * divisor];
                    assert_true(pixels[y * W + x] == z);
                }
        }
    aob_rig_finish(&rig);
}

static void test_sizes_and_tables(void **state)
{
    (void)state;
    static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};
    float pixels[W * H];
    struct aob_rig rig;
    rig_of(&rig, 0);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        run(&rig, backends[b], "size", (struct values){4, 2}, pixels);
        assert_near(pixels[0], 81 + 0.023, 1e-4);
        run(&rig, backends[b], "table", (struct values){1, 1}, pixels);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++)
                assert_true(pixels[y * W + x] == (float)(100 + (x < 3 ? x : 3) + 4 * (y < 2 ? y : 2)));
    }
    aob_rig_finish(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_surfaces_lie_in_their_depth),
                                       cmocka_unit_test(test_surface_is_the_first_pixel_of_its_block),
                                       cmocka_unit_test(test_sizes_and_tables)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
