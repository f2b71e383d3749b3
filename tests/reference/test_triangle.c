/* Distances to triangles, and visibility by them, against a search over the triangle's points and rays that are
 * followed without Embree. */
#include "reference/triangle.h"
#include "shot.h"
#include <string.h>

enum { W = 12, H = 8, GRID = 150, CELLS = 160 };

static double random_unit(uint64_t *state)
{
    *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*state >> 40) / (double)(1 << 24);
}

static struct aob_vec3 random_point(uint64_t *state, double size)
{
    double x = random_unit(state) - 0.5, y = random_unit(state) - 0.5, z = random_unit(state) - 0.5;
    return aob_vec_scale(aob_vec(x, y, z), size);
}

/* The nearest of a grid of the triangle's points: at most half a cell's diagonal too far. */
static double searched_distance(struct aob_vec3 p, const struct aob_vec3 c[3], int grid)
{
    double nearest = INFINITY;
    for (int i = 0; i <= grid; i++)
        for (int j = 0; i + j <= grid; j++) {
            struct aob_vec3 q =
                aob_vec_add(c[0], aob_vec_add(aob_vec_scale(aob_vec_sub(c[1], c[0]), (double)i / grid),
                                              aob_vec_scale(aob_vec_sub(c[2], c[0]), (double)j / grid)));
            nearest = fmin(nearest, aob_vec_length(aob_vec_sub(p, q)));
        }
    return nearest;
}

static void distance_is_the_nearest_of_its_points(void **state)
{
    (void)state;
    uint64_t seed = 3;
    size_t over = 0;
    for (int n = 0; n < 300; n++) {
        struct aob_vec3 c[3], p = random_point(&seed, 3);
        for (int k = 0; k < 3; k++)
            c[k] = random_point(&seed, n % 3 ? 2 : 0.1);
        if (n % 5 == 0) /* a sliver */
            c[2] = aob_vec_add(c[1], random_point(&seed, 1e-3));
        double found = aob_triangle_distance(p, c), searched = searched_distance(p, c, GRID);
        double cell =
            fmax(aob_vec_length(aob_vec_sub(c[1], c[0])), aob_vec_length(aob_vec_sub(c[2], c[0]))) / GRID;
        assert_true(found <= searched + 1e-12);
        assert_true(found >= searched - 2 * cell);
        over += found < 0.98 * aob_vec_length(aob_vec_sub(p, c[0]));
    }
    assert_true(over > 100); /* not the corners alone */
}

/* Moeller and Trumbore; infinity where the ray misses. */
static double ray_hit(struct aob_vec3 o, struct aob_vec3 d, const struct aob_vec3 c[3])
{
    struct aob_vec3 a = aob_vec_sub(c[1], c[0]), b = aob_vec_sub(c[2], c[0]), q = aob_vec_cross(d, b);
    double det = aob_vec_dot(a, q);
    struct aob_vec3 s = aob_vec_sub(o, c[0]), r = aob_vec_cross(s, a);
    double u = aob_vec_dot(s, q) / det, v = aob_vec_dot(d, r) / det, t = aob_vec_dot(b, r) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 1e-6 ? t : INFINITY;
}

/* 1 - sum over the cosine-weighted hemisphere of max(0, 1 - distance of the triangle met first / radius). */
static double followed(const struct aob_mesh *mesh, struct aob_vec3 p, struct aob_vec3 n, double radius)
{
    double near[64], sum = 0;
    struct aob_vec3 x = aob_vec_normalize(
                        aob_vec_cross(fabs(n.y) < 0.9 ? aob_vec(0, 1, 0) : aob_vec(1, 0, 0), n)),
                    y = aob_vec_cross(n, x);
    assert_true(mesh->triangle_count <= 64);
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        struct aob_vec3 c[3];
        for (int k = 0; k < 3; k++)
            c[k] = mesh->positions[mesh->triangles[t][k]];
        near[t] = searched_distance(p, c, GRID);
    }
    for (int i = 0; i < CELLS * CELLS; i++) {
        double r = sqrt((i / CELLS + 0.5) / CELLS), turn = 2 * M_PI * (i % CELLS + 0.5) / CELLS,
               nearest = INFINITY;
        struct aob_vec3 d =
            aob_vec_add(aob_vec_scale(n, sqrt(1 - r * r)),
                        aob_vec_add(aob_vec_scale(x, r * cos(turn)), aob_vec_scale(y, r * sin(turn))));
        size_t met = 0;
        for (size_t t = 0; t < mesh->triangle_count; t++) {
            struct aob_vec3 c[3];
            for (int k = 0; k < 3; k++)
                c[k] = mesh->positions[mesh->triangles[t][k]];
            double hit = ray_hit(p, d, c);
            met = hit < nearest ? t : met;
            nearest = fmin(nearest, hit);
        }
        sum += isfinite(nearest) ? fmax(0, 1 - near[met] / radius) : 0;
    }
    return 1 - sum / (CELLS * CELLS);
}

static struct aob_vec3 world_normal(const struct shot *shot, size_t i)
{
    struct aob_frame_axes axes = aob_camera_axes(&shot->camera);
    const float *n = shot->hits.normal[i];
    return aob_vec_add(aob_vec_scale(axes.right, n[0]),
                       aob_vec_add(aob_vec_scale(axes.up, n[1]), aob_vec_scale(axes.back, n[2])));
}

/* A room in which most rays meet walls that are nearer elsewhere. */
static void room_shot(struct shot *shot, const struct aob_visibility_term *term)
{
    const struct aob_scene_info *scene = aob_scene_find("cornell");
    struct aob_camera camera = aob_scene_view(scene, "front")->camera;
    struct aob_mesh mesh = {0};
    camera.eye = aob_vec(0.0131, 1.0072, 3.4);
    scene->build(&mesh);
    cast_shot(shot, &mesh, camera, W, H);
    trace_shot(shot, term, 1, 4096);
}

/* By the ray's own length the value is another. */
static void visibility_by_triangles(void **state)
{
    (void)state;
    float falloff[257];
    for (int i = 0; i < 257; i++)
        falloff[i] = 1 - (float)(i * i) / (256 * 256);
    struct aob_visibility_term term = {
        .radius = 1.5, .falloff = falloff, .falloff_count = 257, .of_triangle = true};
    struct aob_mesh mesh = {0};
    struct shot shot, along;
    double sum = 0, apart = 0;
    size_t count = 0;
    aob_scene_find("cornell")->build(&mesh);
    room_shot(&shot, &term);
    term.of_triangle = false;
    room_shot(&along, &term);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        double value = followed(&mesh, pixel_point(&shot, i), world_normal(&shot, i), term.radius);
        sum += pow((double)shot.visibility[0].ao[i] - value, 2);
        apart += pow((double)along.visibility[0].ao[i] - value, 2);
        count++;
    }
    print_message(
        "           %zu pixels: RMSE %.5f to rays followed without Embree; along the rays it would be %.3f\n",
        count, sqrt(sum / (double)count), sqrt(apart / (double)count));
    assert_true(count > 40);
    assert_true(sqrt(sum / (double)count) <= 0.004);
    assert_true(sqrt(apart / (double)count) > 0.02);
    aob_mesh_finish(&mesh);
    finish_shot(&along);
    finish_shot(&shot);
}

static void kinds_are_not_mixed(void **state)
{
    (void)state;
    const struct aob_visibility_term terms[] = {{.radius = 1}, {.radius = 1, .of_triangle = true}};
    struct aob_visibility_desc desc = {.terms = terms, .term_count = 2, .spp = 2};
    struct aob_visibility result[2];
    struct aob_error error = {""};
    struct shot shot = {0};
    corner_shot(&shot, "front", W, H);
    assert_false(aob_tracer_visibility(shot.tracer, &shot.camera, &shot.hits, &desc, result, &error));
    assert_non_null(strstr(error.text, "terms 0 and 1"));
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(distance_is_the_nearest_of_its_points),
                                       cmocka_unit_test(visibility_by_triangles),
                                       cmocka_unit_test(kinds_are_not_mixed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
