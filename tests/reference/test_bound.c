/* The screen-space bound: a closed form, and what must hold on every scene. */
#include "bound_shot.h"
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "reference/bound_mesh.h"
#include "reference/oracle.h"

/* --- Closed form: half a sheet above a floor, from straight above. Solid below, it is a wall on the floor. ---
 */

enum { SHEET_WIDTH = 48, SHEET_HEIGHT = 48 };
static const double sheet_height = 1.5, sheet_view = 3;

/* The edge, x = 0, lies between the pixel columns 23 and 24. */
static void sheet_shot(struct shot *shot)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-40, 0, -40), aob_vec(0, 0, 80), aob_vec(80, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-40, sheet_height, -40), aob_vec(0, 0, 80), aob_vec(40, 0, 0));
    struct aob_camera camera = {.eye = {0, 3, 0}, .ortho_height = sheet_view};
    cast_shot(shot, &mesh, camera, SHEET_WIDTH, SHEET_HEIGHT);
}

/* In the middle row, where the wall is longer than the radius on both sides; on the floor only. */
static void check_wall(const struct shot *shot, const struct aob_visibility *visibility, double r)
{
    double square = 0, se = 0, closed = 0, n = 0;
    for (size_t x = SHEET_WIDTH / 2; x < SHEET_WIDTH; x++) {
        size_t i = SHEET_HEIGHT / 2 * SHEET_WIDTH + x;
        double d = pixel_point(shot, i).x, e = visibility->ao[i] - aob_oracle_corner(d, r);
        square += e * e;
        se += (double)visibility->se[i] * visibility->se[i];
        closed += 1 - visibility->ao[i];
        n++;
    }
    print_message("           r %g: rmse %.5f, se %.5f over %g pixels\n", r, sqrt(square / n), sqrt(se / n),
                  n);
    assert_true(closed > 0.5 && sqrt(square / n) <= 0.003);
}

static void check_open(const struct shot *shot, const struct aob_visibility *visibility)
{
    for (size_t i = 0; i < pixel_count(shot); i++)
        assert_true(fabsf(visibility->ao[i] - 1) <= 1e-4f);
}

static void a_sheet_from_above_is_a_wall(void **state)
{
    (void)state;
    const struct aob_visibility_term terms[] = {{.radius = 0.5}, {.radius = 1}};
    struct aob_visibility bound[2];
    struct shot shot;
    sheet_shot(&shot);
    trace_shot(&shot, terms, 2, 64);
    check_open(&shot, &shot.visibility[1]); /* the sheet hangs farther away than the radius */
    const struct aob_bound_desc solid[] = {
        {0}, {.kind = AOB_BOUND_SLAB, .thickness = 1.6}, {.kind = AOB_BOUND_SLAB, .thickness = 1e9}};
    for (size_t k = 0; k < AOB_COUNT(solid); k++) {
        bound_shot(&shot, &solid[k], terms, 2, 1024, bound);
        check_wall(&shot, &bound[0], 0.5);
        check_wall(&shot, &bound[1], 1);
        aob_visibility_finish(&bound[0]);
        aob_visibility_finish(&bound[1]);
    }
    const struct aob_bound_desc open[] = {{.kind = AOB_BOUND_THIN},
                                          {.kind = AOB_BOUND_SLAB, .thickness = 0.45}};
    for (size_t k = 0; k < AOB_COUNT(open); k++) {
        bound_shot(&shot, &open[k], terms, 2, 64, bound);
        check_open(&shot, &bound[0]);
        check_open(&shot, &bound[1]);
        aob_visibility_finish(&bound[0]);
        aob_visibility_finish(&bound[1]);
    }
    finish_shot(&shot);
}

/* --- What must hold on every scene. --- */

struct sums {
    double pixels, mean[KINDS], truth, square[KINDS], darker, slab_out;
};

static void add_up(const struct shot *shot, const struct aob_visibility bound[KINDS], struct sums *sums)
{
    for (size_t i = 0; i < pixel_count(shot); i++) {
        if (shot->hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        double truth = shot->visibility[0].ao[i];
        float infinite = bound[INFINITE].ao[i], slab = bound[SLAB].ao[i], thin = bound[THIN].ao[i];
        assert_true(infinite <= thin);
        sums->pixels++;
        sums->truth += truth;
        for (int k = 0; k < KINDS; k++) {
            sums->mean[k] += bound[k].ao[i];
            sums->square[k] += pow(bound[k].ao[i] - truth, 2);
        }
        sums->darker += thin < truth - 0.05;
        sums->slab_out += slab < infinite || slab > thin;
    }
}

static double radius_for(const struct shot *shot)
{
    double sum = 0, seen = 0;
    for (size_t i = 0; i < pixel_count(shot); i++) {
        sum += shot->hits.depth[i];
        seen += shot->hits.depth[i] > 0;
    }
    return 0.1 * sum / seen;
}

static void check_view(const char *scene, const struct aob_view *view)
{
    struct shot shot;
    scene_shot(&shot, scene, view->camera, 96, 54);
    const struct aob_visibility_term term = {.radius = radius_for(&shot)};
    trace_shot(&shot, &term, 1, 64);
    struct aob_visibility bound[KINDS];
    bound_kinds(&shot, term.radius / 4, &term, 64, bound);
    struct sums s = {0};
    add_up(&shot, bound, &s);
    double n = s.pixels;
    print_message("%-8s%-8s r %5.3f truth %.4f", scene, view->name, term.radius, s.truth / n);
    for (int k = 0; k < KINDS; k++)
        print_message(", %s %.4f (rmse %.4f)", kind_names[k], s.mean[k] / n, sqrt(s.square[k] / n));
    print_message(", darker %.2f %%, slab out %.2f %%\n", 100 * s.darker / n, 100 * s.slab_out / n);
    assert_true(s.mean[THIN] / n >= s.truth / n - 0.001);
    assert_true(s.darker <= 0.005 * n);
    assert_true(s.slab_out <= 0.005 * n);
    finish_kinds(bound);
    finish_shot(&shot);
}

static void bounds_hold_on_every_scene(void **state)
{
    (void)state;
    for (const struct aob_scene_info *const *scene = aob_scenes; *scene; scene++)
        for (size_t v = 0; (*scene)->build && v < (*scene)->view_count; v++)
            check_view((*scene)->name, &(*scene)->views[v]);
}

static void a_plane_is_open(void **state)
{
    (void)state;
    const struct aob_visibility_term term = {.radius = INFINITY};
    struct aob_camera cameras[] = {aob_scene_find("plane")->views[0].camera,
                                   aob_scene_view(aob_scene_find("plane"), "low")->camera,
                                   {.eye = {2, 3, 9}, .target = {0, 0, 0}, .ortho_height = 6}};
    for (size_t c = 0; c < AOB_COUNT(cameras); c++) {
        struct shot shot;
        scene_shot(&shot, "plane", cameras[c], 64, 36);
        struct aob_visibility bound[KINDS];
        bound_kinds(&shot, 0.3, &term, 256, bound);
        for (int k = 0; k < KINDS; k++)
            check_open(&shot, &bound[k]);
        finish_kinds(bound);
        finish_shot(&shot);
    }
}

/* In the room seen along its axis pixel centres lie on the edges between its walls. */
static void a_point_in_a_crease_sees_half(void **state)
{
    (void)state;
    const struct aob_visibility_term term = {.radius = 0.1};
    struct shot shot;
    size_t found = 0;
    scene_shot(&shot, "cornell", aob_scene_find("cornell")->views[0].camera, 96, 54);
    trace_shot(&shot, &term, 1, 1024);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i);
        if (fabs(fabs(p.x) - 1) > 1e-6 || fabs(fabs(p.y - 1) - 1) > 1e-6 || fabs(p.z) > 0.85)
            continue;
        assert_true(fabs(shot.visibility[0].ao[i] - 0.5) < 0.01);
        found++;
    }
    assert_true(found >= 20);
    finish_shot(&shot);
}

static void bad_input_is_refused(void **state)
{
    (void)state;
    struct shot shot;
    struct aob_error error = {""};
    scene_shot(&shot, "plane", aob_scene_find("plane")->views[0].camera, 8, 8);
    const struct aob_bound_desc slab = {.kind = AOB_BOUND_SLAB}, infinite = {0};
    assert_null(aob_bound_create(&shot.camera, &shot.projection, &shot.hits, &slab, &error));
    assert_non_null(strstr(error.text, "thickness"));
    memset(shot.hits.depth, 0, pixel_count(&shot) * sizeof *shot.hits.depth);
    struct aob_visibility_term term = {.radius = 1};
    struct aob_visibility open;
    bound_shot(&shot, &infinite, &term, 1, 4, &open);
    for (size_t i = 0; i < pixel_count(&shot); i++)
        assert_true(open.ao[i] == 1 && open.se[i] == 0);
    aob_visibility_finish(&open);
    finish_shot(&shot);
}

/* The judgement of its memory begins with these counts. */
static void its_size_is_foretold(void **state)
{
    (void)state;
    for (const struct aob_scene_info *const *scene = aob_scenes; *scene; scene++)
        for (size_t v = 0; (*scene)->build && v < (*scene)->view_count; v++)
            for (int kind = AOB_BOUND_INFINITE; kind <= AOB_BOUND_SLAB; kind++) {
                const struct aob_bound_desc desc = {.kind = (enum aob_bound_kind)kind, .thickness = 0.1};
                struct aob_mesh mesh = {0};
                struct shot shot;
                scene_shot(&shot, (*scene)->name, (*scene)->views[v].camera, 64, 36);
                struct aob_bound_size size =
                    aob_bound_mesh_size(&shot.camera, &shot.projection, &shot.hits, &desc);
                assert_true(aob_bound_mesh(&shot.camera, &shot.projection, &shot.hits, &desc, &mesh));
                assert_int_equal(size.vertices, mesh.vertex_count);
                assert_int_equal(size.triangles, mesh.triangle_count);
                aob_mesh_finish(&mesh);
                finish_shot(&shot);
            }
}

static double peak_gb(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)usage.ru_maxrss * 1024e-9;
}

/* What a process of its own takes for it at most, in gigabytes. */
static double measure_memory(const struct shot *shot, struct aob_bound_desc desc)
{
    int ends[2];
    double taken = 0;
    assert_int_equal(pipe(ends), 0);
    pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        double before = peak_gb();
        struct aob_bound *bound =
            aob_bound_create(&shot->camera, &shot->projection, &shot->hits, &desc, NULL);
        taken = bound ? peak_gb() - before : NAN;
        _exit(write(ends[1], &taken, sizeof taken) != sizeof taken);
    }
    close(ends[1]);
    assert_int_equal(read(ends[0], &taken, sizeof taken), sizeof taken);
    close(ends[0]);
    assert_int_equal(waitpid(pid, NULL, 0), pid);
    return taken;
}

/* Too little memory is told with what is needed, which is what it really takes; and with so much it is built. */
static void it_keeps_to_its_memory(void **state)
{
    (void)state;
    static const struct {
        const char *scene;
        enum aob_bound_kind kind;
        int width,
            height; /* so large that some 10 MB of threads and arenas, which nothing foretells, are little */
    } rows[] = {{"plane", AOB_BOUND_SLAB, 800, 450},
                {"plane", AOB_BOUND_INFINITE, 1280, 720},
                {"grass", AOB_BOUND_SLAB, 320, 180},
                {"grass", AOB_BOUND_INFINITE, 320, 180}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_bound_desc desc = {.kind = rows[i].kind, .thickness = 0.1, .memory = 1};
        struct aob_error error = {""};
        struct shot shot;
        double needed;
        scene_shot(&shot, rows[i].scene, aob_scene_find(rows[i].scene)->views[0].camera, rows[i].width,
                   rows[i].height);
        assert_null(aob_bound_create(&shot.camera, &shot.projection, &shot.hits, &desc, &error));
        const char *number = strstr(error.text, " triangles need ");
        assert_non_null(number);
        assert_int_equal(sscanf(number, " triangles need %lf GB of memory", &needed), 1);
        assert_non_null(strstr(error.text, "lower the resolution or the guard band"));
        desc.memory = (size_t)(1.01e9 * needed); /* it is printed with three digits */
        double taken = measure_memory(&shot, desc);
        printf("%s, kind %d: needs %.3f GB, takes %.3f\n", rows[i].scene, (int)rows[i].kind, needed, taken);
        assert_true(taken > 0.5 * needed && taken < 1.5 * needed);
        desc.memory = (size_t)(0.99e9 * needed);
        assert_null(aob_bound_create(&shot.camera, &shot.projection, &shot.hits, &desc, &error));
        finish_shot(&shot);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_keeps_to_its_memory),
        cmocka_unit_test(its_size_is_foretold),
        cmocka_unit_test(a_plane_is_open),
        cmocka_unit_test(a_point_in_a_crease_sees_half),
        cmocka_unit_test(bounds_hold_on_every_scene),
        cmocka_unit_test(bad_input_is_refused),
        cmocka_unit_test(a_sheet_from_above_is_a_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
