/* The mean open direction against closed forms, in view space, at 1024 rays a pixel. */
#include "check.h"
#include "shot.h"

static const struct aob_visibility_term terms[] = {{.radius = INFINITY, .bent = true},
                                                   {.radius = INFINITY, .uniform = true, .bent = true},
                                                   {.radius = INFINITY}};

static struct aob_vec3 to_world(const struct shot *shot, const float v[3])
{
    struct aob_frame_axes axes = aob_camera_axes(&shot->camera);
    return aob_vec_add(aob_vec_add(aob_vec_scale(axes.right, v[0]), aob_vec_scale(axes.up, v[1])),
                       aob_vec_scale(axes.back, v[2]));
}

static void trace_one(struct shot *shot, struct aob_mesh *mesh, const struct aob_visibility_term *term)
{
    struct aob_camera camera = {.eye = {3, 5, 4}, .target = {0, 0, 0.5}, .fov_deg = 30};
    cast_shot(shot, mesh, camera, 48, 32);
    trace_shot(shot, term, 1, 1024);
}

/* On an open plane the mean is the normal times 2/3 with the cosine, times 1/2 without. The sampler is stratified, so each
 * pixel is within a thousandth or two; a wrong axis, sign or weight is not. */
static void open_plane(void **state)
{
    (void)state;
    static const double lengths[] = {2.0 / 3, 0.5};
    for (int t = 0; t < 2; t++) {
        struct aob_mesh mesh = {0};
        struct shot shot;
        aob_mesh_add_quad(&mesh, aob_vec(-500, 0, -500), aob_vec(0, 0, 1000), aob_vec(1000, 0, 0));
        trace_one(&shot, &mesh, &terms[t]);
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
                continue;
            struct aob_vec3 b = to_world(&shot, shot.visibility[0].bent[i]);
            assert_float_equal(b.x, 0, 0.004);
            assert_float_equal(b.y, lengths[t], 0.004);
            assert_float_equal(b.z, 0, 0.004);
        }
        finish_shot(&shot);
    }
}

/* At the foot of an endless wall half the hemisphere is open: its mean is 1/3 up, 2/(3 pi) away from the wall, by
 * integrating direction times cosine / pi over azimuths of half a turn. */
static void foot_of_a_wall(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct shot shot;
    double x = 0, y = 0, z = 0, count = 0;
    aob_mesh_add_quad(&mesh, aob_vec(-5000, 0, 0), aob_vec(0, 0, 10000), aob_vec(10000, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-5000, 0, 0), aob_vec(10000, 0, 0), aob_vec(0, 10000, 0));
    trace_one(&shot, &mesh, &terms[0]);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i);
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE || p.y > 1e-3)
            continue;
        struct aob_vec3 b = to_world(&shot, shot.visibility[0].bent[i]);
        x += b.x;
        y += b.y;
        z += b.z;
        count++;
    }
    assert_true(count > 300);
    assert_float_equal(x / count, 0, 0.002);
    assert_float_equal(y / count, 1.0 / 3, 0.002);
    assert_float_equal(z / count, 2 / (3 * M_PI), 0.002);
    finish_shot(&shot);
}

/* Sums of traced vectors and of their closed forms, in frames of their own: (along the normal, across, the third). */
struct sums {
    double traced[3], form[3], count;
};

static void add(struct sums *sums, struct aob_vec3 traced, struct aob_vec3 normal, struct aob_vec3 across,
                double along_normal, double along_across)
{
    struct aob_vec3 third = aob_vec_cross(normal, across);
    const double parts[3] = {aob_vec_dot(traced, normal), aob_vec_dot(traced, across),
                             aob_vec_dot(traced, third)};
    for (int c = 0; c < 3; c++)
        sums->traced[c] += parts[c];
    sums->form[0] += along_normal;
    sums->form[1] += along_across;
    sums->count++;
}

static double degrees_off(const struct sums *sums)
{
    double dot = 0, a = 0, b = 0;
    for (int c = 0; c < 3; c++) {
        dot += sums->traced[c] * sums->form[c];
        a += sums->traced[c] * sums->traced[c];
        b += sums->form[c] * sums->form[c];
    }
    return acos(fmin(1, dot / sqrt(a * b))) * 180 / M_PI;
}

/* Directions are points of the unit disc on the floor (Nusselt), and a wall at distance d closes the segment beyond t = d/R:
 * the mean of all, 2/3 of the normal, less the segment's own two integrals over pi. */
static void corner_at_every_distance(void **state)
{
    (void)state;
    enum { BINS = 10 };
    struct sums bins[BINS] = {{{0}, {0}, 0}};
    struct shot shot;
    corner_shot(&shot, "front", 192, 108);
    trace_shot(&shot, &(struct aob_visibility_term){.radius = 1, .bent = true}, 1, 1024);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i);
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE || (p.y > 1e-3 && p.z > 1e-3))
            continue;
        bool floor = p.z > p.y;
        double t = floor ? p.z : p.y;
        if (t >= 1)
            continue;
        add(&bins[(int)(t * BINS)], to_world(&shot, shot.visibility[0].bent[i]),
            floor ? aob_vec(0, 1, 0) : aob_vec(0, 0, 1), floor ? aob_vec(0, 0, 1) : aob_vec(0, 1, 0),
            2.0 / 3 - 0.5 * (2.0 / 3 - t + t * t * t / 3), 2 / (3 * M_PI) * pow(1 - t * t, 1.5));
    }
    for (int b = 0; b < BINS; b++) {
        printf("corner, %d tenths of the radius away: %.0f pixels, %.3f degrees off\n", b, bins[b].count,
               degrees_off(&bins[b]));
        assert_true(bins[b].count > 100);
        assert_true(degrees_off(&bins[b]) <= 0.3);
    }
    finish_shot(&shot);
}

/* The lower half of the unit sphere, whose inside is seen from above. */
static void add_bowl(struct aob_mesh *mesh)
{
    enum { RINGS = 200, SEGMENTS = 400 };
    for (int ring = 0; ring <= RINGS; ring++)
        for (int segment = 0; segment < SEGMENTS; segment++) {
            double theta = M_PI / 2 * ring / RINGS, phi = 2 * M_PI * segment / SEGMENTS;
            aob_mesh_add_vertex(mesh, aob_vec(cos(theta) * sin(phi), -sin(theta), cos(theta) * cos(phi)));
        }
    for (uint32_t ring = 0; ring < RINGS; ring++)
        for (uint32_t segment = 0; segment < SEGMENTS; segment++) {
            uint32_t a = ring * SEGMENTS + segment, b = ring * SEGMENTS + (segment + 1) % SEGMENTS;
            aob_mesh_add_triangle(mesh, a, b, b + SEGMENTS);
            if (ring + 1 < RINGS) /* else the lower edge is a point */
                aob_mesh_add_triangle(mesh, a, b + SEGMENTS, a + SEGMENTS);
        }
}

/* The mean open direction of point (0, -sin b, cos b) of the bowl along its normal, and across towards the rim: a direction is open
 * where the chord of the sphere along it ends above the rim. Directions are midpoints of the unit disc on the tangent plane
 * (Nusselt), each of which weighs the same. */
static void through_rim(double below, double form[2])
{
    enum { SIDE = 1000 };
    double sum[2] = {0, 0};
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++) {
            double across = 2 * (i + 0.5) / SIDE - 1, aside = 2 * (k + 0.5) / SIDE - 1;
            double square = 1 - across * across - aside * aside, up = square > 0 ? sqrt(square) : 0;
            double end = -sin(below) + 2 * up * (up * sin(below) + across * cos(below));
            if (up > 0 && end > 0) {
                sum[0] += up;
                sum[1] += across;
            }
        }
    for (int c = 0; c < 2; c++)
        form[c] = sum[c] * 4 / ((double)SIDE * SIDE) / M_PI;
}

static void bowl_sees_its_rim(void **state)
{
    (void)state;
    enum { BINS = 8 };
    struct sums bins[BINS] = {{{0}, {0}, 0}};
    double forms[BINS * 8][2];
    struct aob_mesh mesh = {0};
    struct shot shot;
    struct aob_camera camera = {.eye = {0, 4, 1e-3}, .target = {0, -0.5, 0}, .fov_deg = 30};
    add_bowl(&mesh);
    cast_shot(&shot, &mesh, camera, 96, 96);
    trace_shot(&shot, &terms[0], 1, 1024);
    for (int i = 0; i < BINS * 8; i++)
        through_rim((i + 0.5) * M_PI / 2 / (BINS * 8), forms[i]);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i);
        double out = hypot(p.x, p.z), below = atan2(-p.y, out) / (M_PI / 2);
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE || below >= 1 || out < 1e-3)
            continue;
        struct aob_vec3 normal = aob_vec_normalize(aob_vec_scale(p, -1)),
                        aside = aob_vec(p.z / out, 0, -p.x / out);
        const double *form = forms[(int)(below * BINS * 8)];
        add(&bins[(int)(below * BINS)], to_world(&shot, shot.visibility[0].bent[i]), normal,
            aob_vec_cross(aside, normal), form[0], form[1]);
    }
    for (int b = 0; b < BINS; b++) {
        printf("bowl, %d of %d from the rim down: %.0f pixels, %.3f degrees off, %.4f long for %.4f\n", b,
               BINS, bins[b].count, degrees_off(&bins[b]), bins[b].traced[0] / bins[b].count,
               bins[b].form[0] / bins[b].count);
        assert_true(bins[b].count > 30);
        assert_true(degrees_off(&bins[b]) <= 0.3);
        assert_near(bins[b].traced[0] / bins[b].count, bins[b].form[0] / bins[b].count, 3e-3);
    }
    finish_shot(&shot);
}

/* What asks for no direction gets none, and its visibility is the same. */
static void asking_changes_nothing(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0}, again = {0};
    struct shot with, without;
    aob_mesh_add_box(&mesh, aob_vec(-1, 0, -1), aob_vec(1, 1, 1), 2);
    aob_mesh_add_quad(&mesh, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
    aob_mesh_add_box(&again, aob_vec(-1, 0, -1), aob_vec(1, 1, 1), 2);
    aob_mesh_add_quad(&again, aob_vec(-50, 0, -50), aob_vec(0, 0, 100), aob_vec(100, 0, 0));
    trace_one(&with, &mesh, &terms[0]);
    trace_one(&without, &again, &terms[2]);
    assert_null(without.visibility[0].bent);
    assert_memory_equal(with.visibility[0].ao, without.visibility[0].ao, pixel_count(&with) * sizeof(float));
    for (size_t i = 0; i < pixel_count(&with); i++) {
        const float *b = with.visibility[0].bent[i];
        double length = sqrt((double)(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]));
        assert_true(length <= (double)with.visibility[0].ao[i] + 1e-5); /* no longer than the openness */
        if (with.hits.primitive[i] == AOB_NO_PRIMITIVE)
            assert_true(length == 0);
    }
    finish_shot(&with);
    finish_shot(&without);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(open_plane), cmocka_unit_test(foot_of_a_wall),
                                       cmocka_unit_test(corner_at_every_distance),
                                       cmocka_unit_test(bowl_sees_its_rim),
                                       cmocka_unit_test(asking_changes_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
