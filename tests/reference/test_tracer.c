/* The ray tracer against closed forms, at 1024 rays a pixel. The truth of a pixel is taken at the very point
 * that the pixel shows (from its depth). */
#include "shot.h"
#include "reference/oracle.h"

/* The true visibility of a point, or NaN where there is no closed form. `r` belongs to the term. */
typedef double (*truth_fn)(struct aob_vec3 p, double r, const double *sizes);

struct bars {
    double error, square, se_square, outliers, pixels;
};

static struct bars measure(const struct shot *shot, size_t term, truth_fn truth, double r,
                           const double *sizes, double limit)
{
    struct bars bars = {0};
    const struct aob_visibility *visibility = &shot->visibility[term];
    for (size_t i = 0; i < pixel_count(shot); i++) {
        if (shot->hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        double t = truth(pixel_point(shot, i), r, sizes), e = visibility->ao[i] - t;
        if (isnan(t))
            continue;
        if (t == 1 || t == 0)
            assert_true(fabs(e) <= 1e-4);
        if (!(t > 0 && t < 0.995))
            continue;
        bars.pixels++;
        bars.error += e;
        bars.square += e * e;
        bars.se_square += (double)visibility->se[i] * visibility->se[i];
        bars.outliers += fabs(e) > limit;
    }
    return bars;
}

/* `share` of the pixels may be beyond 4 pooled errors: 1 % where the error is much the same everywhere. */
static void check_share(const struct shot *shot, size_t term, truth_fn truth, double r, const double *sizes,
                        double share)
{
    struct bars b = measure(shot, term, truth, r, sizes, INFINITY);
    assert_true(b.pixels >= 100);
    double rmse = sqrt(b.square / b.pixels), se = sqrt(b.se_square / b.pixels), mean = b.error / b.pixels;
    double outliers = measure(shot, term, truth, r, sizes, 4 * se).outliers;
    print_message(
        "           r %5g: %5.0f pixels, rmse %.5f, se %.5f, mean %+.6f (limit %.6f), %.2f %% beyond 4 se\n",
        r, b.pixels, rmse, se, mean, 3 * se / sqrt(b.pixels), 100 * outliers / b.pixels);
    assert_true(rmse <= 0.003);
    assert_true(fabs(mean) <= 3 * se / sqrt(b.pixels));
    assert_true(outliers <= share * b.pixels);
    assert_true(rmse < 1.5 * se && se < 1.5 * rmse);
}

static void check_bars(const struct shot *shot, size_t term, truth_fn truth, double r, const double *sizes)
{
    check_share(shot, term, truth, r, sizes, 0.01);
}

/* A smooth falloff is integrated far better in some pixels than in others. */
static void check_smooth(const struct shot *shot, size_t term, truth_fn truth, double r)
{
    check_share(shot, term, truth, r, NULL, 0.03);
}

static void check_constant(const struct shot *shot, float value)
{
    size_t seen = 0;
    for (size_t i = 0; i < pixel_count(shot); i++) {
        bool sky = shot->hits.primitive[i] == AOB_NO_PRIMITIVE;
        assert_true(fabsf(shot->visibility[0].ao[i] - (sky ? 1 : value)) <= 1e-4f);
        assert_true(shot->visibility[0].se[i] <= 1e-4f);
        seen += !sky;
    }
    assert_true(seen > pixel_count(shot) / 8);
}

static const struct aob_visibility_term endless = {.radius = INFINITY};

static void tilted_planes_are_open(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        double tilt = (i % 6) * 17 * M_PI / 180, turn = i * 67 * M_PI / 180;
        struct aob_vec3 n = aob_vec(sin(tilt) * cos(turn), sin(tilt) * sin(turn), cos(tilt));
        struct aob_vec3 u = aob_vec_normalize(aob_vec_cross(aob_vec(0.3, 1, 0.2), n)),
                        v = aob_vec_cross(n, u);
        struct aob_vec3 middle = aob_vec(3, -2, 1);
        struct aob_mesh mesh = {0};
        struct aob_vec3 corner = aob_vec_sub(middle, aob_vec_scale(aob_vec_add(u, v), 20));
        aob_mesh_add_quad(&mesh, corner, aob_vec_scale(u, 40), aob_vec_scale(v, 40));
        struct aob_camera camera = {.eye = aob_vec(3, -2, 4), .target = middle, .fov_deg = 60};
        struct shot shot;
        cast_shot(&shot, &mesh, camera, 40, 24);
        trace_shot(&shot, &endless, 1, 1024);
        check_constant(&shot, 1);
        finish_shot(&shot);
    }
}

static void convex_sphere_is_open(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    aob_mesh_add_sphere(&mesh, aob_vec(1, 2, 3), 1.5, 256);
    struct aob_camera camera = {.eye = aob_vec(4, 4, 6), .target = aob_vec(1, 2, 3), .fov_deg = 40};
    struct shot shot;
    cast_shot(&shot, &mesh, camera, 96, 64);
    trace_shot(&shot, &endless, 1, 1024);
    check_constant(&shot, 1);
    finish_shot(&shot);
}

static void closed_box_is_closed(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    aob_mesh_add_box(&mesh, aob_vec(-2, 0, -3), aob_vec(2, 2.5, 3), 20);
    struct aob_camera camera = {.eye = aob_vec(1, 1.5, 1.8), .target = aob_vec(-0.4, 0.4, -1), .fov_deg = 80};
    struct shot shot;
    cast_shot(&shot, &mesh, camera, 64, 36);
    trace_shot(&shot, &endless, 1, 1024);
    check_constant(&shot, 0);
    finish_shot(&shot);
}

/* How far a point of the corner scene is from the other plane; NaN where rays of length r reach the planes'
 * ends. */
static double corner_gap(struct aob_vec3 p, double r)
{
    if (fabs(p.x) + r > 20 || p.y + r > 40 || p.z + r > 40)
        return NAN;
    return fmax(fmax(p.y, p.z), 0);
}

static double corner_truth(struct aob_vec3 p, double r, const double *sizes)
{
    (void)sizes;
    double d = corner_gap(p, r);
    return isnan(d) ? d : aob_oracle_corner(d, r);
}

static void corner_meets_the_bars(void **state)
{
    (void)state;
    static const double radii[] = {0.25, 0.5, 1, 2, 4};
    static const char *const views[] = {"front", "far"};
    struct aob_visibility_term terms[AOB_COUNT(radii)] = {{0}};
    for (size_t i = 0; i < AOB_COUNT(radii); i++)
        terms[i].radius = radii[i];
    for (size_t v = 0; v < AOB_COUNT(views); v++) {
        struct shot shot;
        corner_shot(&shot, views[v], 128, 72);
        trace_shot(&shot, terms, AOB_COUNT(terms), 1024);
        for (size_t i = 0; i < AOB_COUNT(radii); i++)
            check_bars(&shot, i, corner_truth, radii[i], NULL);
        finish_shot(&shot);
    }
}

static double wall_truth(struct aob_vec3 p, double r, const double *sizes)
{
    return p.y > 1e-3 ? NAN : aob_oracle_wall(p.z, sizes[0], r);
}

static void finite_wall_meets_the_bars(void **state)
{
    (void)state;
    const double height = 2;
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-1000, 0, 0), aob_vec(0, 0, 1000), aob_vec(2000, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-1000, 0, 0), aob_vec(2000, 0, 0), aob_vec(0, height, 0));
    struct aob_camera camera = {.eye = aob_vec(0, 5, 8), .target = aob_vec(0, 0, 2), .fov_deg = 60};
    struct shot shot;
    cast_shot(&shot, &mesh, camera, 128, 72);
    trace_shot(&shot, &endless, 1, 1024);
    check_bars(&shot, 0, wall_truth, INFINITY, &height);
    finish_shot(&shot);
}

/* A parallel disc seen from off its axis (Howell, "A Catalog of Radiation Heat Transfer Configuration
 * Factors", B-12); O7 on the axis. */
static double disc_truth(struct aob_vec3 p, double r, const double *sizes)
{
    (void)r;
    double a2 = sizes[0] * sizes[0], h2 = sizes[1] * sizes[1], x2 = p.x * p.x + p.z * p.z;
    if (p.y > 1e-3)
        return NAN;
    double z = x2 + h2 + a2;
    return 1 - 0.5 * (1 - (x2 + h2 - a2) / sqrt(z * z - 4 * a2 * x2));
}

static void disc_meets_the_bars(void **state)
{
    (void)state;
    const double sizes[] = {0.7, 0.6};
    assert_true(fabs(disc_truth(aob_vec(0, 0, 0), 0, sizes) -
                     aob_oracle_disc(0, sizes[0], sizes[1], INFINITY)) < 1e-12);
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-5, 0, -5), aob_vec(0, 0, 10), aob_vec(10, 0, 0));
    aob_mesh_add_disc(&mesh, aob_vec(0, sizes[1], 0), aob_vec(0, 1, 0), sizes[0], 1024);
    struct aob_camera axis = {.eye = aob_vec(0, 0.3, 2), .target = aob_vec(0, 0, 0), .ortho_height = 0.02};
    struct aob_camera around = {.eye = aob_vec(0, 0.5, 2), .target = aob_vec(0, 0, 0), .fov_deg = 50};
    struct aob_mesh same = {0};
    aob_mesh_add_quad(&same, aob_vec(-5, 0, -5), aob_vec(0, 0, 10), aob_vec(10, 0, 0));
    aob_mesh_add_disc(&same, aob_vec(0, sizes[1], 0), aob_vec(0, 1, 0), sizes[0], 1024);
    struct shot shot;
    cast_shot(&shot, &mesh, axis, 48, 48);
    trace_shot(&shot, &endless, 1, 1024);
    check_bars(&shot, 0, disc_truth, INFINITY, sizes);
    finish_shot(&shot);
    cast_shot(&shot, &same, around, 128, 72);
    trace_shot(&shot, &endless, 1, 1024);
    check_bars(&shot, 0, disc_truth, INFINITY, sizes);
    finish_shot(&shot);
}

static double sheet_truth(struct aob_vec3 p, double r, const double *sizes)
{
    return p.y > 1e-3 ? NAN : aob_oracle_sheet(0, sizes[0], r);
}

/* A picture one pixel wide: every pixel shows a point right under the edge x = 0. */
static void sheet_edge_meets_the_bars(void **state)
{
    (void)state;
    const double height = 0.8;
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, -20), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-20, height, -20), aob_vec(0, 0, 40), aob_vec(20, 0, 0));
    struct aob_camera camera = {.eye = aob_vec(0, 0.5, 3), .target = aob_vec(0, 0, 1), .fov_deg = 20};
    const struct aob_visibility_term terms[] = {{.radius = 0.5}, {.radius = 1}, {.radius = 3}};
    struct shot shot;
    cast_shot(&shot, &mesh, camera, 1, 500);
    trace_shot(&shot, terms, AOB_COUNT(terms), 1024);
    assert_true(measure(&shot, 0, sheet_truth, terms[0].radius, &height, 1).pixels == 0);
    check_bars(&shot, 1, sheet_truth, terms[1].radius, &height);
    check_bars(&shot, 2, sheet_truth, terms[2].radius, &height);
    finish_shot(&shot);
}

/* Towards the wall, a cap of half the hemisphere: its share is (1 - t)/2. */
static double uniform_truth(struct aob_vec3 p, double r, const double *sizes)
{
    (void)sizes;
    double t = corner_gap(p, r) / r;
    return isnan(t) ? t : t < 1 ? 1 - 0.5 * (1 - t) : 1;
}

static double table_at(const float *table, size_t count, double t)
{
    double place = t * (double)(count - 1);
    size_t i = (size_t)place < count - 2 ? (size_t)place : count - 2;
    return table[i] + (table[i + 1] - (double)table[i]) * (place - (double)i);
}

static const float fade[] = {1, 0.9f, 0.4f, 0.1f, 0};

/* A direction with part y towards the wall meets it at d/y; on the unit disc, y has a chord of 2 sqrt(1-y^2).
 */
static double falloff_integral(double t, bool uniform)
{
    enum { STEPS = 400 };
    double sum = 0;
    for (int i = 0; i < STEPS && t < 1; i++) {
        double y = t + (1 - t) * (i + 0.5) / STEPS;
        sum += table_at(fade, AOB_COUNT(fade), sqrt(t / y)) * (uniform ? 0.5 : 2 / M_PI * sqrt(1 - y * y));
    }
    return 1 - sum * (1 - t) / STEPS;
}

static double falloff_truth(struct aob_vec3 p, double r, const double *sizes)
{
    (void)sizes;
    double d = corner_gap(p, r);
    return isnan(d) ? d : falloff_integral(d / r, false);
}

static double uniform_falloff_truth(struct aob_vec3 p, double r, const double *sizes)
{
    (void)sizes;
    double d = corner_gap(p, r);
    return isnan(d) ? d : falloff_integral(d / r, true);
}

static void weightings_and_falloffs_meet_the_bars(void **state)
{
    (void)state;
    const struct aob_visibility_term terms[] = {
        {.radius = 2, .uniform = true},
        {.radius = 2},
        {.radius = 1.5, .falloff = fade, .falloff_count = AOB_COUNT(fade)},
        {.radius = 1.5, .uniform = true, .falloff = fade, .falloff_count = AOB_COUNT(fade)},
    };
    struct shot shot;
    corner_shot(&shot, "front", 96, 54);
    trace_shot(&shot, terms, 4, 1024);
    check_bars(&shot, 0, uniform_truth, 2, NULL);
    check_bars(&shot, 1, corner_truth, 2, NULL);
    check_smooth(&shot, 2, falloff_truth, 1.5);
    check_smooth(&shot, 3, uniform_falloff_truth, 1.5);
    finish_shot(&shot);
    corner_shot(&shot, "front", 96, 54);
    trace_shot(&shot, &terms[2], 1, 1024);
    check_smooth(&shot, 0, falloff_truth, 1.5);
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tilted_planes_are_open),     cmocka_unit_test(convex_sphere_is_open),
        cmocka_unit_test(closed_box_is_closed),       cmocka_unit_test(corner_meets_the_bars),
        cmocka_unit_test(finite_wall_meets_the_bars), cmocka_unit_test(disc_meets_the_bars),
        cmocka_unit_test(sheet_edge_meets_the_bars),  cmocka_unit_test(weightings_and_falloffs_meet_the_bars),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
