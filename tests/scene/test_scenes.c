/* Procedural scenes are what their titles say, solid where they should be, and in view; the user's folder is read. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "reference/tracer.h"
#include "scene/light.h"
#include "scene/mesh_solids.h"
#include "scene/scene.h"
#include "scene/scene_folder.h"
#include "title.h"

struct edge {
    int64_t from[3], to[3];
    int64_t sign; /* +1 as stored, -1 turned round */
};

static void weld(struct aob_vec3 p, int64_t place[3])
{
    const double v[3] = {p.x, p.y, p.z};
    for (int k = 0; k < 3; k++) /* the share keeps round numbers away from the borders of the grid */
        place[k] = (int64_t)floor(v[k] * 1e6 + 0.31);
}

static struct edge make_edge(struct aob_vec3 a, struct aob_vec3 b)
{
    struct edge edge = {.sign = 1};
    weld(a, edge.from);
    weld(b, edge.to);
    if (memcmp(edge.from, edge.to, sizeof edge.from) > 0) {
        struct edge turned = {.sign = -1};
        memcpy(turned.from, edge.to, sizeof turned.from);
        memcpy(turned.to, edge.from, sizeof turned.to);
        return turned;
    }
    return edge;
}

static int compare_edges(const void *a, const void *b)
{
    return memcmp(a, b, offsetof(struct edge, sign));
}

/* Edges that are not run through once each way: 0 for closed solids with one orientation. */
static size_t open_edges(const struct aob_mesh *mesh)
{
    size_t count = 3 * mesh->triangle_count, open = 0;
    struct edge *edges = AOB_NEW_ARRAY(struct edge, count);
    for (size_t i = 0; i < count; i++) {
        const uint32_t *t = mesh->triangles[i / 3];
        edges[i] = make_edge(mesh->positions[t[i % 3]], mesh->positions[t[(i + 1) % 3]]);
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (size_t i = 0, next; i < count; i = next) {
        int64_t sum = 0;
        for (next = i; next < count && compare_edges(&edges[i], &edges[next]) == 0; next++)
            sum += edges[next].sign;
        open += (size_t)llabs(sum);
    }
    free(edges);
    return open;
}

/* By the divergence theorem; fails for a triangle that is next to a line. */
static double volume(const struct aob_mesh *mesh)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        struct aob_vec3 a = mesh->positions[t[0]], b = mesh->positions[t[1]], c = mesh->positions[t[2]];
        struct aob_vec3 u = aob_vec_sub(b, a), v = aob_vec_sub(c, a), n = aob_vec_cross(u, v);
        double longest = fmax(aob_vec_dot(u, u), aob_vec_dot(v, v));
        if (!(aob_vec_length(n) > 1e-5 * longest))
            fail_msg("triangle %zu has hardly an area", i);
        sum += aob_vec_dot(n, a) / 6;
    }
    return sum;
}

static void solids_are_closed_and_face_out(void **state)
{
    (void)state;
    const struct aob_turning ring[] = {{2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0}};
    const struct aob_vec3 outer[] = {{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}, {0, -2, 0}};
    const struct aob_vec3 inner[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    const struct aob_vec3 line[] = {{0, 0, 0}, {0, 4, 0}, {3, 4, 0}, {3, 4, -5}, {6, 7, -8}};
    struct aob_mesh mesh = {0};
    aob_mesh_add_lathe(&mesh, aob_vec(1, 2, 3), aob_vec(1, -2, 0.5), ring, AOB_COUNT(ring), 200);
    assert_int_equal(open_edges(&mesh), 0);
    assert_near(volume(&mesh), 5 * M_PI, 0.01);
    aob_mesh_finish(&mesh);
    aob_mesh_add_cylinder(&mesh, aob_vec(1, 1, 1), aob_vec(1, 1, -4), 2, 200);
    assert_int_equal(open_edges(&mesh), 0);
    assert_near(volume(&mesh), 20 * M_PI, 0.02);
    aob_mesh_finish(&mesh);
    for (int closed = 0; closed < 2; closed++) { /* a square frame, whole and with a quarter left out */
        aob_mesh_add_band(&mesh, outer, inner, 4, aob_vec(0, 0, 3), closed);
        assert_int_equal(open_edges(&mesh), 0);
        assert_near(volume(&mesh), closed ? 18 : 13.5, 1e-9);
        aob_mesh_finish(&mesh);
    }
    aob_mesh_add_pipe(&mesh, line, AOB_COUNT(line), 0.2, 0.5, 64);
    assert_int_equal(open_edges(&mesh), 0);
    /* Pappus: area of the section times the length of its middle, arcs for corners. */
    double turn = acos(1 / sqrt(3)), length = 12 + sqrt(27) - 4 * 0.5 * 1 + 2 * 0.5 * M_PI_2;
    length += 0.5 * turn - 2 * 0.5 * tan(turn / 2);
    assert_near(volume(&mesh), M_PI * 0.04 * length, 0.01);
    aob_mesh_finish(&mesh);
}

static const struct expected {
    const char *name;
    struct aob_vec3 low, high;
    size_t open_edges;  /* of floors, the room of cornell, and what has no thickness: they are no solids */
    size_t front_count; /* of the first so many triangles only fronts are seen; 0: of all */
} rows[] = {
    {"plane", {-20, 0, -20}, {20, 0, 20}, 4, 0},
    {"corner", {-20, 0, 0}, {20, 40, 40}, 6, 0},
    {"spheres", {-20, 0, -20}, {20, 2, 20}, 4, 0},
    {"cornell", {-1, 0, -1}, {1, 2, 1}, 4, 0},
    {"plates", {-4, 0, -4}, {4, 0.91, 4}, 4, 0},
    {"atrium", {-10, 0, -21}, {10, 8, 21}, 4, 0},
    {"machine", {-6, 0, -6}, {6, 3.1, 6}, 4, 0},
    {"grass", {-10, -0.273737, -10}, {10, 0.648417, 10}, 4 + 5 * 26013, 95705 - 3 * 26013},
    {"wall", {-20, 0, 0}, {20, 0.25, 40}, 6, 0},
    {"sheet", {-20, 0, -20}, {20, 0.2, 20}, 8, 2},
    {"sphere", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 0, 0},
    {"room", {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, 0, 0},
    {"disc", {-20, 0, -20}, {20, 0.15, 20}, 4 + 256, 2},
    {"matte_white_room", {-3, 0, -2.5}, {3, 3, 2.5}, 0, 0},
    {"matte_dark_room", {-3, 0, -2.5}, {3, 3, 2.5}, 0, 0},
    {"gallery", {-3, 0, -9}, {3, 4.4, 9}, 4, 0},
    {"coloured_walls", {-2.5, 0, -2}, {2.5, 3, 2}, 0, 0},
    {"window_room", {-3.3, 0, -2.5}, {3, 2.8, 2.5}, 4, 0},
    {"rocks", {-150, -0.520640, -150}, {150, 1.002969, 150}, 4, 0},
    {"scattered_rocks", {-150, -0.402305, -150}, {150, 1.038625, 150}, 4, 0},
    {"thicket", {-10, -0.062766, -10}, {10, 2.507403, 10}, 4, 0},
    {"open_sky", {-150, 0, -150}, {150, 0, 150}, 4, 0},
    {"passing_box", {-6, 0, 0}, {6, 4, 8}, 6, 0},
};

static void titles_and_solids_are_right(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_scene_info *scene = aob_scene_find(rows[i].name);
        struct aob_mesh mesh = {0}, again = {0};
        char key[AOB_KEY_SIZE], same[AOB_KEY_SIZE];
        scene->build(&mesh);
        scene->build(&again);
        assert_true(aob_mesh_check(&mesh, scene->name, NULL));
        aob_mesh_digest(&mesh, key);
        aob_mesh_digest(&again, same);
        assert_string_equal(key, same);
        volume(&mesh);
        if (title_triangles(scene->title))
            assert_int_equal(title_triangles(scene->title), mesh.triangle_count);
        struct aob_vec3 low, high;
        aob_mesh_bounds(&mesh, &low, &high);
        assert_true(aob_vec_length(aob_vec_sub(low, rows[i].low)) < 1e-5);
        assert_true(aob_vec_length(aob_vec_sub(high, rows[i].high)) < 1e-5);
        assert_int_equal(open_edges(&mesh), rows[i].open_edges);
        aob_mesh_finish(&mesh);
        aob_mesh_finish(&again);
    }
}

/* Whether the camera sees the front of the triangle that pixel i hits. */
static bool sees_front(const struct aob_mesh *mesh, const struct aob_hits *hits,
                       const struct aob_frame_axes *axes, size_t i)
{
    const uint32_t *t = mesh->triangles[hits->primitive[i]];
    struct aob_vec3 a = mesh->positions[t[0]];
    struct aob_vec3 front =
        aob_vec_cross(aob_vec_sub(mesh->positions[t[1]], a), aob_vec_sub(mesh->positions[t[2]], a));
    const float *n = hits->normal[i];
    return aob_vec_dot(front, axes->right) * n[0] + aob_vec_dot(front, axes->up) * n[1] +
               aob_vec_dot(front, axes->back) * n[2] >
           0;
}

static void check_view(const struct expected *row, const struct aob_mesh *mesh,
                       const struct aob_tracer *tracer, const struct aob_view *view)
{
    struct aob_projection projection = aob_camera_projection(&view->camera, 160, 90, 0);
    struct aob_frame_axes axes = aob_camera_axes(&view->camera);
    struct aob_hits hits;
    size_t seen = 0, pixels = 160 * 90;
    size_t fronts = row->front_count ? row->front_count : mesh->triangle_count;
    aob_tracer_cast(tracer, &view->camera, &projection, &hits);
    for (size_t i = 0; i < pixels; i++) {
        if (hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        seen++;
        if (hits.primitive[i] < fronts && !sees_front(mesh, &hits, &axes, i))
            fail_msg("%s/%s: pixel %zu sees the back of triangle %u", row->name, view->name, i,
                     hits.primitive[i]);
    }
    if (seen * 5 < pixels && strcmp(row->name, "open_sky") != 0)
        fail_msg("%s/%s sees only %zu of %zu pixels", row->name, view->name, seen, pixels);
    aob_hits_finish(&hits);
}

static void every_view_sees_fronts(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_scene_info *scene = aob_scene_find(rows[i].name);
        struct aob_mesh mesh = {0};
        struct aob_error error = {""};
        scene->build(&mesh);
        struct aob_tracer *tracer = aob_tracer_create(&mesh, &error);
        assert_string_equal(error.text, "");
        for (size_t v = 0; v < scene->view_count; v++)
            check_view(&rows[i], &mesh, tracer, &scene->views[v]);
        aob_tracer_destroy(tracer);
        aob_mesh_finish(&mesh);
    }
}

static double sky_share(const struct aob_tracer *tracer, const struct aob_camera *camera)
{
    struct aob_projection projection = aob_camera_projection(camera, 320, 180, 0);
    struct aob_hits hits;
    size_t sky = 0, pixels = 320 * 180;
    aob_tracer_cast(tracer, camera, &projection, &hits);
    for (size_t i = 0; i < pixels; i++)
        sky += hits.primitive[i] == AOB_NO_PRIMITIVE;
    aob_hits_finish(&hits);
    return (double)sky / (double)pixels;
}

static void skies_are_as_large_as_they_should_be(void **state)
{
    (void)state;
    static const struct sky {
        const char *scene;
        size_t view;
        double least, most;
    } skies[] = {
        {"rocks", 0, 0.4, 0.5},        {"rocks", 1, 0, 0.1},          {"scattered_rocks", 0, 0, 0.1},
        {"open_sky", 0, 0.9, 0.95},    {"thicket", 0, 0.1, 0.4},      {"matte_white_room", 0, 0, 0},
        {"matte_white_room", 1, 0, 0}, {"coloured_walls", 0, 0, 0},   {"coloured_walls", 1, 0, 0},
        {"window_room", 0, 0.01, 0.2}, {"window_room", 1, 0.01, 0.2}, {"gallery", 0, 0.01, 0.1},
    };
    for (size_t i = 0; i < AOB_COUNT(skies); i++) {
        const struct aob_scene_info *scene = aob_scene_find(skies[i].scene);
        struct aob_mesh mesh = {0};
        struct aob_error error = {""};
        scene->build(&mesh);
        struct aob_tracer *tracer = aob_tracer_create(&mesh, &error);
        double share = sky_share(tracer, &scene->views[skies[i].view].camera);
        if (share < skies[i].least || share > skies[i].most)
            fail_msg("%s/%s: %g of the view is sky", scene->name, scene->views[skies[i].view].name, share);
        aob_tracer_destroy(tracer);
        aob_mesh_finish(&mesh);
    }
}

static void lights_of_scenes_have_names(void **state)
{
    (void)state;
    size_t lit = 0;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++) {
        assert_true(!(*s)->light || aob_light_find((*s)->light));
        lit += (*s)->light != NULL;
    }
    assert_int_equal(lit, 9);
}

static void every_procedural_scene_has_a_row(void **state)
{
    (void)state;
    size_t count = 0;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        count += (*s)->build != NULL;
    assert_int_equal(count, AOB_COUNT(rows));
}

static void packaged_files_have_their_sha256(void **state)
{
    (void)state;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++) {
        char command[512], digest[65] = "";
        if (!(*s)->file || !aob_file_exists((*s)->file))
            continue;
        snprintf(command, sizeof command, "sha256sum '%s'", (*s)->file);
        FILE *pipe = popen(command, "r");
        assert_non_null(pipe);
        assert_int_equal(fread(digest, 1, 64, pipe), 64);
        pclose(pipe);
        assert_string_equal(digest, (*s)->sha256);
        assert_true((*s)->licence[0]);
    }
}

static void the_folder_gives_names(void **state)
{
    (void)state;
    static const char *const files[] = {"hall.ply", "hall.glb", "Tree.OBJ",  "corner.obj",
                                        "read.me",  ".obj",     "two.a.stl", "noending"};
    static const char *const names[] = {"Tree", "hall", "two.a"};
    char folder[64], path[128];
    struct aob_error error = {""};
    struct aob_scene_folder own;
    snprintf(folder, sizeof folder, "/tmp/aob_test_scenes_%ld", (long)getpid());
    assert_true(aob_folder_create(folder, &error));
    for (size_t i = 0; i < AOB_COUNT(files); i++) {
        snprintf(path, sizeof path, "%s/%s", folder, files[i]);
        assert_true(aob_file_write(path, "x", 1, &error));
    }
    setenv("AOBUDGET_SCENES", folder, 1);
    assert_true(aob_scene_folder_read(&own, &error));
    assert_int_equal(own.count, AOB_COUNT(names));
    for (size_t i = 0; i < own.count; i++)
        assert_string_equal(own.files[i].name, names[i]);
    snprintf(path, sizeof path, "%s/hall.glb", folder);
    assert_string_equal(aob_scene_folder_find(&own, "hall"), path);
    assert_null(aob_scene_folder_find(&own, "corner"));
    assert_null(aob_scene_folder_find(&own, "../hall"));
    aob_scene_folder_finish(&own);
    for (size_t i = 0; i < AOB_COUNT(files); i++) {
        snprintf(path, sizeof path, "%s/%s", folder, files[i]);
        unlink(path);
    }
    rmdir(folder);
}

static void a_missing_folder_is_an_error_and_none_is_empty(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_scene_folder own;
    setenv("AOBUDGET_SCENES", "/nonexistent/scenes", 1);
    assert_false(aob_scene_folder_read(&own, &error));
    assert_contains(error.text, "/nonexistent/scenes");
    assert_int_equal(own.count, 0);
    setenv("AOBUDGET_SCENES", "", 1);
    assert_true(aob_scene_folder_read(&own, &error));
    assert_int_equal(own.count, 0);
    unsetenv("AOBUDGET_SCENES");
    assert_true(aob_scene_folder_read(&own, &error));
    assert_int_equal(own.count, 0);
}

static void known_scenes_are_not_listed_ones(void **state)
{
    (void)state;
    for (const struct aob_known_scene *k = aob_known_scenes; k->name; k++) {
        assert_null(aob_scene_find(k->name));
        assert_true(k->title[0] && k->source[0] && k->licence[0]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids_are_closed_and_face_out),
        cmocka_unit_test(titles_and_solids_are_right),
        cmocka_unit_test(every_view_sees_fronts),
        cmocka_unit_test(skies_are_as_large_as_they_should_be),
        cmocka_unit_test(lights_of_scenes_have_names),
        cmocka_unit_test(every_procedural_scene_has_a_row),
        cmocka_unit_test(packaged_files_have_their_sha256),
        cmocka_unit_test(the_folder_gives_names),
        cmocka_unit_test(a_missing_folder_is_an_error_and_none_is_empty),
        cmocka_unit_test(known_scenes_are_not_listed_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
