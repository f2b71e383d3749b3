#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "numbers.h"
#include "sets.h"
#include "technique/param.h"

/* The eye at the origin looks along -Z, so view space is the world's: what stands in pixel i at depth 1. */
static struct aob_vec3 ray_of(const struct aob_exhibit *exhibit, size_t i)
{
    struct aob_vec3 origin, direction;
    size_t width = (size_t)exhibit->width;
    aob_camera_ray(&exhibit->camera, &exhibit->gbuffer.projection, (double)(i % width) + 0.5,
                   (double)(i / width) + 0.5, &origin, &direction);
    return direction;
}

/* Turns the normals of all pixels: with `edge_on` to be perpendicular to the view ray, else along it; and by `turn`, an
 * angle, from there. `up` is no line of pixels, but the y axis: then a column of the image lies in an edge-on surface. */
static void set_normals(struct aob_exhibit *exhibit, bool edge_on, double turn, struct aob_vec3 up)
{
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
        struct aob_vec3 v = aob_vec_scale(aob_vec_normalize(ray_of(exhibit, i)), -1);
        struct aob_vec3 side = aob_vec_normalize(aob_vec_cross(up, v));
        double a = edge_on ? M_PI / 2 - turn : turn;
        struct aob_vec3 n =
            aob_vec_add(aob_vec_scale(v, a == M_PI / 2 ? 0 : cos(a)), aob_vec_scale(side, sin(a)));
        exhibit->gbuffer.normal[4 * i] = (float)n.x;
        exhibit->gbuffer.normal[4 * i + 1] = (float)n.y;
        exhibit->gbuffer.normal[4 * i + 2] = (float)n.z;
    }
}

/* A bowl about the eye, seen straight in each pixel; or with `edge_on` a plane whose normals lie across the view. */
static struct aob_exhibit *make_bowl(struct aob_trial *trial, bool edge_on)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 24);
    struct aob_exhibit *exhibit = aob_trial_exhibit(
        trial,
        &(struct aob_exhibit_desc){
            .mesh = &mesh, .camera = {.target = {0, 0, -1}, .fov_deg = 60}, .width = 49, .height = 33});
    for (size_t i = 0; exhibit && i < aob_exhibit_pixels(exhibit); i++) {
        struct aob_vec3 d = ray_of(exhibit, i);
        exhibit->gbuffer.depth[i] = edge_on ? 1 : (float)(1 / sqrt(aob_vec_dot(d, d)));
    }
    return exhibit;
}

/* Turned by next to nothing the image hardly changes. Of a column that lies in its surface only the range is asked: how much
 * of it is in front has no answer there. */
static void ask_turns(struct aob_trial *trial, bool edge_on)
{
    static const double turns[] = {0, 1e-7, 1e-5};
    static const struct aob_vec3 oblique = {0.37, 1, 0}, column = {0, 1, 0};
    struct aob_exhibit *exhibit = make_bowl(trial, edge_on);
    const struct aob_shot shot = {.exhibit = exhibit, .radius = 0.3};
    const float *wanted = NULL;
    for (size_t k = 0; exhibit && k < AOB_COUNT(turns); k++) {
        set_normals(exhibit, edge_on, turns[k], column);
        aob_trial_draw(trial, &shot);
        set_normals(exhibit, edge_on, turns[k], oblique);
        const float *image = aob_trial_draw(trial, &shot);
        wanted = wanted ? wanted : image;
        if (!image)
            return;
        struct aob_difference d = aob_difference_of(exhibit, image, wanted, NULL);
        aob_trial_take(trial, d.rmse, &(struct aob_seen){&shot, image, wanted}, "%s, turned by %g",
                       edge_on ? "seen along the surface" : "seen along the normal", turns[k]);
    }
}

void aob_ask_view_ray_sample(struct aob_trial *trial)
{
    ask_turns(trial, false);
    ask_turns(trial, true);
}

/* Mean of an open plane at a radius that takes pixels in: what a technique calls open. */
static double open_mean(struct aob_trial *trial, const struct aob_plane_desc *plane)
{
    const struct aob_shot shot = {.exhibit = aob_set_plane(trial, plane), .radius = 0.5};
    const float *image = aob_trial_draw(trial, &shot);
    return image ? aob_mean_of(shot.exhibit, image, NULL) : NAN;
}

static void take_open(struct aob_trial *trial, const struct aob_shot *shot, double open)
{
    const float *image = aob_trial_draw(trial, shot);
    if (!image)
        return;
    double mean = aob_mean_of(shot->exhibit, image, NULL);
    aob_trial_take(trial, fabs(mean - open), &(struct aob_seen){shot, image, NULL},
                   "radius %g: mean %.4f, an open plane's %.4f", shot->radius, mean, open);
}

void aob_ask_radius_below_pixel(struct aob_trial *trial)
{
    static const double shares[] = {0.9, 0.5, 0.1, 0.01}, tilts[] = {0, 60};
    double pixel = 2 * 3 * tan(M_PI / 6) / 32;
    for (size_t t = 0; t < AOB_COUNT(tilts); t++) {
        struct aob_plane_desc plane = {.tilt_deg = tilts[t]};
        double open = open_mean(trial, &plane);
        struct aob_exhibit *exhibit = aob_set_plane(trial, &plane);
        for (size_t i = 0; i < AOB_COUNT(shares); i++)
            take_open(trial, &(struct aob_shot){.exhibit = exhibit, .radius = shares[i] * pixel}, open);
    }
}

static const struct aob_param *radius_of(const struct aob_trial *trial)
{
    const struct aob_technique *technique = trial->subject->technique;
    return aob_param_find(technique->params, technique->param_count, "radius");
}

void aob_ask_radius_smallest(struct aob_trial *trial)
{
    double open = open_mean(trial, &(struct aob_plane_desc){0});
    const double radii[] = {fmax(radius_of(trial)->min, 1e-30), 1e-5};
    for (size_t i = 0; i < AOB_COUNT(radii); i++)
        take_open(trial, &(struct aob_shot){.exhibit = aob_set_default(trial), .radius = radii[i]}, open);
}

/* The set is 45 units across: to all larger radii the truth is the same. */
void aob_ask_radius_enormous(struct aob_trial *trial)
{
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 100};
    const float *large = aob_trial_draw(trial, &shot);
    shot.radius = radius_of(trial)->max;
    const float *image = aob_trial_draw(trial, &shot);
    if (!image || !large)
        return;
    double mean = aob_mean_of(shot.exhibit, image, NULL), before = aob_mean_of(shot.exhibit, large, NULL);
    aob_trial_take(trial, aob_over(mean - before), &(struct aob_seen){&shot, image, large},
                   "radius %g: mean %.4f, %.4f at 100", shot.radius, mean, before);
}

/* The words for what fades an occluder out (docs/design.md, Parameter words). A choice has no ends. */
static const char *fade_of(const struct aob_subject *subject)
{
    static const char *const words[] = {"falloff", "attenuation"};
    const struct aob_technique *t = subject->technique;
    for (size_t i = 0; i < AOB_COUNT(words); i++) {
        const struct aob_param *param = aob_param_find(t->params, t->param_count, words[i]);
        if (param && param->type == AOB_FLOAT && !param->choices)
            return words[i];
    }
    return NULL;
}

const char *aob_excuse_no_fade(const struct aob_subject *subject)
{
    return fade_of(subject) ? NULL : "it has no parameter that fades an occluder out by degrees";
}

void aob_ask_falloff_ends(struct aob_trial *trial)
{
    static const double values[] = {0, 1e-6, 1 - 1e-6, 1};
    struct aob_exhibit *exhibit = aob_set_default(trial);
    const float *images[AOB_COUNT(values)];
    char set[AOB_COUNT(values)][64];
    struct aob_shot shots[AOB_COUNT(values)];
    for (size_t i = 0; i < AOB_COUNT(values); i++) {
        snprintf(set[i], sizeof set[i], "%s=%.9g", fade_of(trial->subject), values[i]);
        shots[i] = (struct aob_shot){.exhibit = exhibit, .radius = 0.8, .set = set[i]};
        images[i] = aob_trial_draw(trial, &shots[i]);
        if (!images[i])
            return;
    }
    for (size_t i = 0; i < AOB_COUNT(values); i += 2) {
        struct aob_difference d = aob_difference_of(exhibit, images[i + 1], images[i], NULL);
        aob_trial_take(trial, d.rmse, &(struct aob_seen){&shots[i + 1], images[i + 1], images[i]},
                       "%s against %s", set[i], set[i + 1]);
    }
    /* What counts less as it comes near the radius darkens less. */
    double hard = aob_mean_of(exhibit, images[0], NULL), soft = aob_mean_of(exhibit, images[3], NULL);
    aob_trial_take(trial, aob_over(hard - soft), &(struct aob_seen){&shots[0], images[0], images[3]},
                   "%s is brighter than %s, %.4f and %.4f", set[0], set[3], hard, soft);
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Largest distance of neighbours among the values from the 5th to the 95th of a hundred. */
static double largest_gap(float *values, size_t count)
{
    double gap = 0;
    qsort(values, count, sizeof *values, compare_floats);
    for (size_t i = count / 20; i + 1 < count - count / 20; i++)
        gap = aob_worse(gap, (double)values[i + 1] - (double)values[i]);
    return gap;
}

/* Visibility rises from the crease without a step, and does so at every radius: an image of 8 bits has all its levels there.
 * The camera looks a little aside, so that no two columns are the same. */
void aob_ask_gradation(struct aob_trial *trial)
{
    enum { RADII = 25 };
    struct aob_mesh mesh = {0};
    aob_set_corner(&mesh, 20);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = {.eye = {0.5, 2, 2}, .fov_deg = 30}, .width = 96, .height = 64};
    struct aob_shot shot = {.exhibit = aob_trial_exhibit(trial, &desc)};
    if (!shot.exhibit)
        return;
    size_t pixels = aob_exhibit_pixels(shot.exhibit), drawn = 0;
    float *values = AOB_NEW_ARRAY(float, RADII *pixels);
    for (const float *image; drawn < RADII; drawn++) {
        shot.radius = 0.3 * pow(2, (double)drawn / 16);
        image = aob_trial_draw(trial, &shot);
        if (!image)
            break;
        memcpy(values + drawn * pixels, image, pixels * sizeof *values);
    }
    if (drawn == RADII)
        aob_trial_take(trial, largest_gap(values, RADII * pixels), &(struct aob_seen){&shot, NULL, NULL},
                       "no pixel of %d images has a value in a gap of this size", RADII);
    free(values);
}

/* A plane that faces the camera is the same wherever the axis meets it: shifted by whole pixels, the axis goes through other
 * ones. */
void aob_ask_optical_axis(struct aob_trial *trial)
{
    static const int sizes[][2] = {{33, 25}, {49, 33}, {5, 3}};
    for (size_t i = 0; i < AOB_COUNT(sizes); i++) {
        struct aob_plane_desc plane = {.width = sizes[i][0], .height = sizes[i][1]};
        struct aob_shot shot = {.exhibit = aob_set_plane(trial, &plane), .radius = 0.5}, shifted = shot;
        plane.shift[0] = 4.0 / plane.height;
        plane.shift[1] = 3.0 / plane.height;
        shifted.exhibit = aob_set_plane(trial, &plane);
        const float *image = aob_trial_draw(trial, &shot), *wanted = aob_trial_draw(trial, &shifted);
        if (!image || !wanted)
            return;
        struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, NULL);
        aob_trial_take(trial, d.most, &(struct aob_seen){&shot, image, wanted}, "%dx%d, at (%zu, %zu)",
                       plane.width, plane.height, d.at % (size_t)plane.width, d.at / (size_t)plane.width);
    }
}
