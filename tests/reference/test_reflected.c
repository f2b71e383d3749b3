/* Incident light after reflections against a series and a quadrature: bounces have to count, fade and colour as they
 * should. */
#include "incident_shot.h"
#include "reference/oracle.h"

/* From inside a sphere of radius 1 a direction at the angle a to the normal has the chord 2 cos(a), so of all
 * cosine-distributed directions (R/2)^2 are blocked within R, at every point and after every bounce. */
static double series(double albedo, double radius, int bounces)
{
    double blocked = radius * radius / 4, sum = 0, factor = 1;
    for (int k = 0; k <= bounces; k++, factor *= albedo * blocked)
        sum += factor;
    return (1 - blocked) * sum;
}

static void spheres_have_a_geometric_series(void **state)
{
    (void)state;
    static const float albedo[3] = {0.3f, 0.8f, 1};
    static const double radii[] = {0.4, 1.2, 1.9};
    static const int bounces[] = {0, 1, 2, 8};
    struct aob_mesh mesh = {0};
    struct shot shot;
    paint(&mesh, albedo[0], albedo[1], albedo[2]);
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 400);
    cast_shot(&shot, &mesh,
              (struct aob_camera){.eye = {0.3, 0.2, 0.4}, .target = {-1, 0.1, -0.5}, .fov_deg = 80}, 64, 48);
    for (size_t r = 0; r < AOB_COUNT(radii); r++)
        for (size_t b = 0; b < AOB_COUNT(bounces); b++) {
            struct aob_incident light = light_shot(
                &shot, (struct aob_incident_desc){.radius = radii[r], .bounces = bounces[b], .spp = 256});
            struct light_mean mean = mean_light(&shot, &light, NULL);
            for (int c = 0; c < 3; c++) {
                double wanted = series((double)albedo[c], radii[r], bounces[b]);
                print_message("           r %g, %d bounces, albedo %g: %.5f for %.5f, se %.5f\n", radii[r],
                              bounces[b], (double)albedo[c], mean.rgb[c], wanted, mean.se[c]);
                assert_near(mean.rgb[c], wanted, 4 * mean.se[c] / sqrt(mean.pixels) + 5e-4);
            }
            aob_incident_finish(&light);
        }
    finish_shot(&shot);
}

enum { SIDE = 400, BINS = 8 };

/* What one reflection adds at distance `d` from a white wall: over the unit disc, which cosine-weighted directions cover
 * evenly (Nusselt), the visibility at the height where the ray meets the wall. */
static double reflected(double d, double radius)
{
    double sum = 0;
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k < SIDE; k++) {
            double across = (i + 0.5) / SIDE, aside = 2 * (k + 0.5) / SIDE - 1;
            double square = 1 - across * across - aside * aside;
            if (square > 0 && d < radius * across)
                sum += aob_oracle_corner(d / across * sqrt(square), radius);
        }
    return sum * 2 / ((double)SIDE * SIDE) / M_PI;
}

static const float floor_colour[3] = {1, 0.8f, 0.6f}, wall_colour[3] = {0.9f, 0.2f, 0.05f};

static void painted_corner_shot(struct shot *shot)
{
    struct aob_mesh mesh = {0};
    paint(&mesh, floor_colour[0], floor_colour[1], floor_colour[2]);
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(0, 0, 20), aob_vec(40, 0, 0));
    paint(&mesh, wall_colour[0], wall_colour[1], wall_colour[2]);
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(40, 0, 0), aob_vec(0, 20, 0));
    cast_shot(shot, &mesh,
              (struct aob_camera){.eye = {0.2, 1.2, 1.4}, .target = {0, 0.3, 0.2}, .fov_deg = 60}, 128, 96);
}

/* Sums of one plane's pixels in one range of distances from the other. */
struct bin {
    double traced[3], wanted[3], square[3], pixels;
};

static void add_pixel(struct bin *bin, const struct aob_incident *light, size_t pixel, double open,
                      double more, const float albedo[3])
{
    bin->pixels++;
    for (int c = 0; c < 3; c++) {
        bin->traced[c] += (double)light->rgb[pixel][c];
        bin->square[c] += (double)light->se[pixel][c] * (double)light->se[pixel][c];
        bin->wanted[c] += open + (double)albedo[c] * more;
    }
}

static void check_bin(const struct bin *bin, int number)
{
    assert_true(bin->pixels > 50);
    for (int c = 0; c < 3; c++) {
        double off = (bin->traced[c] - bin->wanted[c]) / bin->pixels, se = sqrt(bin->square[c]) / bin->pixels;
        print_message("           bin %d, channel %d: %.5f, off by %+.6f, se %.6f\n", number, c,
                      bin->traced[c] / bin->pixels, off, se);
        assert_true(fabs(off) <= 4 * se + 1e-4);
    }
}

static void one_bounce_in_a_corner_takes_the_other_colour(void **state)
{
    (void)state;
    const double radius = 1;
    enum { TABLE = 256 };
    double table[TABLE + 1];
    struct bin bins[2][BINS] = {{{{0}, {0}, {0}, 0}}};
    struct shot shot;
    painted_corner_shot(&shot);
    struct aob_incident light =
        light_shot(&shot, (struct aob_incident_desc){.radius = radius, .bounces = 1, .spp = 512});
    for (int i = 0; i <= TABLE; i++)
        table[i] = reflected(radius * i / TABLE, radius);
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        struct aob_vec3 p = pixel_point(&shot, i);
        bool on_floor = p.y < p.z;
        double d = fmax(p.y, p.z), at = d / radius * TABLE;
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE || d >= radius)
            continue;
        double part = at - floor(at), more = table[(int)at] * (1 - part) + table[(int)at + 1] * part;
        add_pixel(&bins[on_floor][(int)(d / radius * BINS)], &light, i, aob_oracle_corner(d, radius), more,
                  on_floor ? wall_colour : floor_colour);
    }
    for (int f = 0; f < 2; f++)
        for (int b = 0; b < BINS; b++)
            check_bin(&bins[f][b], f * BINS + b);
    aob_incident_finish(&light);
    finish_shot(&shot);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spheres_have_a_geometric_series),
        cmocka_unit_test(one_bounce_in_a_corner_takes_the_other_colour),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
