/* What a view shows, for a plan of effects: a surface a pixel, with its material as a G-buffer of 8 bits holds it, what an open surface
 * there shows of the light, and the lit truth of few rays. Read from the image of a frame without occlusion. */
#ifndef AOB_EFFECTS_SEEN_H
#define AOB_EFFECTS_SEEN_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "scene/camera.h"
#include "scene/light.h"

struct aob_seen_surface {     /* light is in its own unit, linear R G B */
    float normal[3];          /* view space, towards the eye */
    float diffuse[3];         /* what it reflects diffusely: (1 - metalness) times base colour */
    float light[3];           /* irradiance over pi where nothing occludes */
    float mirror[3], even[3]; /* what it mirrors of the light, and of one that is 1 from everywhere */
    float apart;              /* lobe.h */
    float visible;            /* true visibility, of few rays; NAN without a truth */
    float truth[3], se[3];    /* the lit truth and its standard error; NAN without one */
};
struct aob_seen {
    int width, height;
    int spp;       /* rays a pixel that `visible` and the truth are of; 0: they have no noise */
    size_t count;  /* surfaces; the sky has none */
    size_t *pixel; /* of each, counted from the top left */
    struct aob_seen_surface *surfaces;
    struct aob_light light; /* view space */
    double
        mean_light; /* of the truth's squares over surfaces and channels the root mean, its noise taken out; NAN without */
    bool has_truth;
    bool has_material; /* the image has materials; else all are aob_material_default */
};

/* An image that a frame of the harness left (docs/design.md, EXR channels). False after a line. aob_seen_finish frees. */
struct aob_seen_desc {
    const char *image;
    const struct aob_camera *camera;
    const struct aob_light *light; /* world space */
};
bool aob_seen_read(struct aob_seen *seen, const struct aob_seen_desc *desc, struct aob_error *error);
void aob_seen_finish(struct aob_seen *seen);

/* Sets mean_light from the surfaces' truth. */
void aob_seen_find_mean(struct aob_seen *seen);
#endif
