/* What thrift does to an image of the rig, W x H, for the tests of the clearance. */
#ifndef AOB_TESTS_THRIFTY_H
#define AOB_TESTS_THRIFTY_H
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "frame/left_out.h"
#include "rig.h"
#include "technique/registry.h"

enum { W = 160, H = 90, PIXELS = W * H };

static inline const struct aob_technique *technique_of(const char *name)
{
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (strcmp((*t)->name, name) == 0)
            return *t;
    fail_msg("there is no technique %s", name);
    return NULL;
}

/* The image without thrift and with it. */
static inline void draw_both(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                             const char *params, float *images[2])
{
    char text[512];
    for (int on = 0; on < 2; on++) {
        images[on] = AOB_NEW_ARRAY(float, (size_t)(rig->width * rig->height));
        snprintf(text, sizeof text, "%s thrift=%s", params, on ? "on" : "off");
        aob_rig_run(rig, gpu, technique, text, AOB_FETCH_SAMPLED, images[on]);
    }
}

/* The largest difference of a pixel that thrift makes. */
static inline double difference(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                                const char *params)
{
    float *images[2];
    double worst = 0;
    draw_both(rig, gpu, technique, params, images);
    for (int i = 0; i < rig->width * rig->height; i++)
        worst = fmax(worst, fabs((double)images[1][i] - (double)images[0][i]));
    free(images[0]);
    free(images[1]);
    return worst;
}

/* A frame that has run, and its screen. */
struct drawn {
    struct aob_screen screen;
    struct aob_frame frame;
};

static inline void draw_technique(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                                  const char *params, struct drawn *drawn)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_error error = {{0}};
    aob_rig_params(technique_of(technique), params, values, &options);
    const struct aob_frame_desc desc = {
        .technique = technique_of(technique), .values = values, .wanted = aob_options_wanted(&options)};
    bool ok = aob_screen_init(&drawn->screen, gpu, &rig->gbuffer, &options, &error) &&
              aob_frame_init_desc(&drawn->frame, &drawn->screen, &desc, &error) &&
              aob_frame_run(&drawn->frame, 1, NULL, &error);
    assert_string_equal(error.text, "");
    assert_true(ok);
}

static inline void drawn_finish(struct drawn *drawn)
{
    aob_frame_finish(&drawn->frame);
    aob_screen_finish(&drawn->screen);
    free(drawn);
}

/* The share of the surfaces that a technique leaves out. */
static inline double share_of(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                              const char *params)
{
    struct drawn *drawn = AOB_NEW(struct drawn);
    double share;
    draw_technique(rig, gpu, technique, params, drawn);
    assert_true(aob_frame_left_out(&drawn->frame, &share, NULL));
    drawn_finish(drawn);
    return share;
}

/* A floor left of x = 0, and right of it one that rises by `slope`, or lies `step` higher. */
static inline void ramp_rig(struct aob_rig *rig, double slope, double step, const struct aob_camera *camera)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, -20), aob_vec(0, 0, 40), aob_vec(20, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(0, step, -20), aob_vec(0, 0, 40), aob_vec(20, 20 * slope, 0));
    aob_rig_init(rig, &mesh, camera, W, H, 0);
    aob_mesh_finish(&mesh);
}
#endif
