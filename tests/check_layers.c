/* check_layers FILE.exr RECORD.json EYE TARGET LENS RADIUS CLAIM [PREVIOUS_EYE PREVIOUS_TARGET]: every layer of a frame
 * of the scene `corner` by the technique `known` (tests/modules/known.c) against closed forms, and every figure of its
 * record against the layers. LENS is fov:DEGREES, or ortho:HEIGHT straight down on the floor, where the wall is not
 * seen. For the tests in cli/. It computes everything itself: files, cameras, visibility, sums. */
#include <jansson.h>
#include <math.h>
#include "exr_reader.h"

enum { GRID = 100 }; /* directions each way */

struct vec {
    double x, y, z;
};
struct view {
    struct vec eye, right, up, back;
    double span; /* height of the image: at distance 1, or orthographic */
    int ortho, width, height;
};
struct form { /* of one pixel */
    double z, visibility;
    struct vec normal, bent, point; /* normal, bent: view space */
};

static int failures;

static void check(int good, const char *what, int pixel, double got, double expected)
{
    if (good)
        return;
    if (failures++ < 20)
        printf("%s, pixel %d: %.9g, expected %.9g\n", what, pixel, got, expected);
}

static void check_near(const char *what, int pixel, double got, double expected, double tolerance)
{
    check(fabs(got - expected) <= tolerance, what, pixel, got, expected);
}

static double dot(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vec add(struct vec a, struct vec b, double s)
{
    return (struct vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static struct vec unit(struct vec a)
{
    return add((struct vec){0, 0, 0}, a, 1 / sqrt(dot(a, a)));
}

static struct vec cross(struct vec a, struct vec b)
{
    return (struct vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static struct vec to_view(const struct view *view, struct vec v)
{
    return (struct vec){dot(v, view->right), dot(v, view->up), dot(v, view->back)};
}

static struct vec read_vec(const char *text)
{
    struct vec v;
    exr_need(sscanf(text, "%lf,%lf,%lf", &v.x, &v.y, &v.z) == 3, "no x,y,z");
    return v;
}

static struct view make_view(const char *eye, const char *target, const char *lens)
{
    struct view view = {.eye = read_vec(eye), .ortho = strncmp(lens, "ortho:", 6) == 0};
    double number = atof(strchr(lens, ':') + 1);
    view.span = view.ortho ? number : 2 * tan(number / 2 * M_PI / 180);
    view.back = unit(add(view.eye, read_vec(target), -1));
    /* from straight above, -Z is the top of the picture */
    view.right = view.ortho ? (struct vec){1, 0, 0} : unit(cross((struct vec){0, 1, 0}, view.back));
    view.up = cross(view.back, view.right);
    return view;
}

/* The mean over the cosine-weighted hemisphere about the floor, a distance from the wall z = 0, of what meets nothing
 * within the radius; and the mean of those directions. For the wall it is the same with y and z exchanged. */
static void look_up(double distance, double radius, double *visibility, struct vec *mean)
{
    double open = 0, up = 0, away = 0;
    for (int i = 0; i < GRID; i++)
        for (int k = 0; k < GRID; k++) {
            double share = (i + 0.5) / GRID, azimuth = 2 * M_PI * (k + 0.5) / GRID;
            double y = sqrt(1 - share), z = sqrt(share) * cos(azimuth);
            if (z < 0 && distance / -z < radius)
                continue;
            open++;
            up += y;
            away += z;
        }
    *visibility = open / (GRID * GRID);
    *mean = (struct vec){0, up / (GRID * GRID), away / (GRID * GRID)};
}

static struct form form_at(const struct view *view, int pixel, double radius)
{
    struct form form;
    double across = (pixel % view->width + 0.5 - view->width / 2.0) / view->height * view->span;
    double down = (pixel / view->width + 0.5 - view->height / 2.0) / view->height * view->span;
    struct vec offset = add(add((struct vec){0, 0, 0}, view->right, across), view->up, -down);
    struct vec origin = view->ortho ? add(view->eye, offset, 1) : view->eye;
    struct vec along = view->ortho ? add(offset, offset, -1) : offset;
    along = add(along, view->back, -1);
    double floor = along.y < 0 ? -origin.y / along.y : INFINITY;
    double wall = along.z < 0 ? -origin.z / along.z : INFINITY;
    struct vec mean;
    form.z = fmin(floor, wall);
    form.point = add(origin, along, form.z);
    look_up(floor < wall ? form.point.z : form.point.y, radius, &form.visibility, &mean);
    if (floor >= wall)
        mean = (struct vec){mean.x, mean.z, mean.y};
    form.normal = to_view(view, floor < wall ? (struct vec){0, 1, 0} : (struct vec){0, 0, 1});
    form.bent = to_view(view, mean);
    return form;
}

static double at(const struct exr_file *file, const char *name, int pixel)
{
    const float *channel = exr_channel(file, name);
    exr_need(channel != NULL, name);
    return (double)channel[pixel];
}

static void check_vec(const struct exr_file *file, const char *stem, int pixel, struct vec expected,
                      double tolerance)
{
    const double values[3] = {expected.x, expected.y, expected.z};
    for (int c = 0; c < 3; c++) {
        char name[64];
        snprintf(name, sizeof name, "%s.%c", stem, 'X' + c);
        check_near(name, pixel, at(file, name, pixel), values[c], tolerance);
    }
}

/* Where the point was in the image before, in pixels. */
static void check_velocity(const struct exr_file *file, const struct view *now, const struct view *before,
                           int pixel, struct vec point)
{
    struct vec v = to_view(before, add(point, before->eye, -1));
    double scale = now->height / (now->span * -v.z);
    check_near("V.X", pixel, at(file, "V.X", pixel),
               pixel % now->width + 0.5 - (now->width / 2.0 + v.x * scale), 1e-3);
    check_near("V.Y", pixel, at(file, "V.Y", pixel),
               pixel / now->width + 0.5 - (now->height / 2.0 - v.y * scale), 1e-3);
    check_near("V.Z", pixel, at(file, "V.Z", pixel), -v.z, 1e-5);
}

struct sums {
    double square[4], bent[3], bias, absolute, most, se, product[3], angle, missing, estimator;
    double band, band_angle,
        band_normal; /* pixels in band; angles over them, of the image and of the normal */
};

/* Five standard errors of as many independent rays; the sampler's are fewer. */
static double spread(double visibility)
{
    return 5 * sqrt(visibility * (1 - visibility) / 256) + 2e-3;
}

/* Of a component of a mean of 256 independent directions, whose square is 1/4 or 1/2 on average. */
static const double bent_error = 0.0442;

static void check_pixel(const struct exr_file *file, const struct view *view, int pixel,
                        const struct form *form, double claim, struct sums *sums)
{
    double across = (pixel % view->width + 0.5) / view->width,
           down = (pixel / view->width + 0.5) / view->height;
    double image = 0.25 + 0.5 * across + 0.125 * down, truth = at(file, "reference.AO", pixel);
    double definition = at(file, "definition.AO", pixel), screen = at(file, "screen.AO", pixel);
    check_near("Z", pixel, at(file, "Z", pixel), form->z, 1e-5 * form->z);
    check_vec(file, "N", pixel, form->normal, 1e-6);
    check_near("technique.AO", pixel, at(file, "technique.AO", pixel), image, 1e-6);
    check_vec(file, "technique.bent", pixel, (struct vec){0.5 * across, -0.5 * down, 0.25}, 1e-6);
    check_near("reference.AO", pixel, truth, form->visibility, spread(form->visibility));
    check_vec(file, "reference.bent", pixel, form->bent, 5 * bent_error);
    check_near("definition.AO", pixel, definition, claim * truth, 1e-6);
    check_near("error.AO", pixel, at(file, "error.AO", pixel), image - truth, 1e-6);
    if (view->ortho) /* the wall is not in the picture: to the depth buffer the floor is open */
        check_near("screen.AO", pixel, screen, claim, 1e-4);
    check(at(file, "reference.SE", pixel) >= 0, "reference.SE", pixel, at(file, "reference.SE", pixel), 0);
    const double part[4] = {definition - truth, screen - definition, image - screen, image - truth};
    for (int k = 0; k < 4; k++)
        sums->square[k] += part[k] * part[k];
    for (int k = 0; k < 3; k++)
        sums->product[k] += part[k] * part[(k + 1) % 3];
    sums->bias += part[3];
    sums->absolute += fabs(part[3]);
    sums->most = fmax(sums->most, fabs(part[3]));
    sums->se += pow(at(file, "reference.SE", pixel), 2);
    struct vec a = {0.5 * across, -0.5 * down, 0.25},
               b = {at(file, "reference.bent.X", pixel), at(file, "reference.bent.Y", pixel),
                    at(file, "reference.bent.Z", pixel)};
    sums->bent[0] += b.x - form->bent.x;
    sums->bent[1] += b.y - form->bent.y;
    sums->bent[2] += b.z - form->bent.z;
    double angle = acos(fmin(1, dot(unit(a), unit(b)))) * 180 / M_PI;
    check_near("error.bent", pixel, at(file, "error.bent", pixel), angle, 2e-2);
    sums->angle += angle;
    sums->band += truth < 0.995;
    sums->band_angle += truth < 0.995 ? angle : 0;
    sums->band_normal += truth < 0.995 ? acos(fmin(1, dot(form->normal, unit(b)))) * 180 / M_PI : 0;
    sums->missing += pow(claim * (1 - form->visibility), 2);
    sums->estimator += pow(image - claim, 2);
}

static void check_figure(const json_t *error, const char *name, double expected, double tolerance)
{
    json_t *value = json_object_get(error, name);
    if (!value)
        value = json_object_get(json_object_get(error, "covariance"), name);
    check_near(name, -1, json_is_number(value) ? json_number_value(value) : NAN, expected, tolerance);
}

static void check_record(const json_t *error, const struct sums *sums, int pixels, const struct view *view)
{
    static const char *const roots[4] = {"definition_rmse", "missing_rmse", "estimator_rmse", "rmse"};
    static const char *const products[3] = {"definition_missing", "missing_estimator",
                                            "definition_estimator"};
    for (int k = 0; k < 4; k++)
        check_figure(error, roots[k], sqrt(sums->square[k] / pixels), 1e-5);
    for (int k = 0; k < 3; k++)
        check_figure(error, products[k], sums->product[k] / pixels, 1e-5);
    check_figure(error, "bias", sums->bias / pixels, 1e-5);
    check_figure(error, "mae", sums->absolute / pixels, 1e-5);
    check_figure(error, "max", sums->most, 1e-5);
    check_figure(error, "reference_se", sqrt(sums->se / pixels), 1e-5);
    for (int c = 0; c < 3; c++) /* the errors of the pixels are independent */
        check_near("mean of reference.bent", -1, sums->bent[c] / pixels, 0, 5 * bent_error / sqrt(pixels));
    check_figure(error, "bent_mean", sums->angle / pixels, 1e-2);
    check_figure(error, "bent_band", sums->band_angle / sums->band, 1e-2);
    check_figure(error, "bent_band_normal", sums->band_normal / sums->band, 1e-2);
    check_figure(error, "bent_band_pixels", sums->band, 0);
    if (!view->ortho)
        return;
    check_figure(error, "missing_rmse", sqrt(sums->missing / pixels), 2e-3);
    check_figure(error, "estimator_rmse", sqrt(sums->estimator / pixels), 1e-4);
}

int main(int argc, char **argv)
{
    exr_need(argc == 8 || argc == 10, "usage: see the head of check_layers.c");
    struct exr_file file = exr_read(argv[1]);
    json_t *record = json_load_file(argv[2], 0, NULL);
    struct view view = make_view(argv[3], argv[4], argv[5]), before;
    double radius = atof(argv[6]), claim = atof(argv[7]), se = 0;
    struct sums sums = {.se = 0};
    view.width = file.width;
    view.height = file.height;
    if (argc == 10)
        before = make_view(argv[8], argv[9], argv[5]);
    for (int i = 0; i < file.width * file.height; i++) {
        struct form form = form_at(&view, i, radius);
        check_pixel(&file, &view, i, &form, claim, &sums);
        if (argc == 10)
            check_velocity(&file, &view, &before, i, form.point);
        se += form.visibility * (1 - form.visibility) / 256;
    }
    check(sums.se > 0 && sums.se < se, "reference.SE", -1, sums.se, se);
    check_record(json_object_get(record, "error"), &sums, file.width * file.height, &view);
    for (int c = 0; c < file.count; c++)
        printf("%s%s", file.names[c], c + 1 < file.count ? " " : "\n");
    json_decref(record);
    exr_free(&file);
    return failures > 0;
}
