/* The specular truths of one picture, as several tests need them, and a GGX that is not the tracer's. */
#ifndef AOB_TESTS_REFERENCE_SPECULAR_SHOT_H
#define AOB_TESTS_REFERENCE_SPECULAR_SHOT_H
#include "check.h"
#include "reference/specular.h"
#include "shot.h"

static inline struct aob_specular specular_shot(const struct shot *shot, struct aob_specular_desc desc)
{
    struct aob_error error = {""};
    struct aob_specular specular;
    bool done = aob_tracer_specular(shot->tracer, &shot->camera, &shot->hits, &desc, &specular, &error);
    assert_string_equal(error.text, "");
    assert_true(done);
    return specular;
}

/* Walter et al. 2007, equation 33, as a function of the squared cosine. */
static inline double ggx_density(double cosine, double alpha)
{
    double square = cosine * cosine, t = square * (alpha * alpha - 1) + 1;
    return alpha * alpha / (M_PI * t * t);
}

static inline double ggx_lambda(double cosine, double alpha)
{
    double tangent = tan(acos(cosine));
    return (sqrt(1 + alpha * alpha * tangent * tangent) - 1) / 2;
}

/* The reflected share of the light from `l`, times its cosine. */
static inline double ggx_lobe(struct aob_vec3 n, struct aob_vec3 v, struct aob_vec3 l, double alpha)
{
    double view = aob_vec_dot(n, v), light = aob_vec_dot(n, l);
    struct aob_vec3 h = aob_vec_normalize(aob_vec_add(v, l));
    return ggx_density(aob_vec_dot(n, h), alpha) / (1 + ggx_lambda(view, alpha) + ggx_lambda(light, alpha)) /
           (4 * view * light) * light;
}

/* Whether the other plane of the corner is met within the radius. `n` is the point's own normal, (0,1,0) or (0,0,1). */
static inline bool is_blocked(struct aob_vec3 p, struct aob_vec3 n, struct aob_vec3 l, double radius)
{
    double distance = n.y > 0.5 ? p.z : p.y, towards = n.y > 0.5 ? -l.z : -l.y;
    return towards > 0 && distance < radius * towards;
}

static inline struct aob_vec3 pixel_normal(struct aob_vec3 p)
{
    return p.y < p.z ? aob_vec(0, 1, 0) : aob_vec(0, 0, 1);
}

/* The camera looks along the wall to the floor and to the wall, so that lobes reach both open and blocked directions. */
static inline void slanted_corner_shot(struct shot *shot, int width, int height)
{
    const struct aob_scene_info *scene = aob_scene_find("corner");
    struct aob_mesh mesh = {0};
    scene->build(&mesh);
    cast_shot(shot, &mesh,
              (struct aob_camera){.eye = {1.5, 0.9, 1.2}, .target = {0, 0.2, 0.2}, .fov_deg = 60}, width,
              height);
}
#endif
