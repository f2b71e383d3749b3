#include "oracle_score.h"
#include <math.h>
#include "score.h"

static struct aob_vec3 to_world(const struct aob_frame_axes *axes, const float n[4])
{
    return aob_vec_add(aob_vec_add(aob_vec_scale(axes->right, n[0]), aob_vec_scale(axes->up, n[1])),
                       aob_vec_scale(axes->back, n[2]));
}

/* Returns NAN in the sky too. x and y are places in the whole G-buffer. */
static double closed_form(const struct aob_oracle_desc *desc, const struct aob_frame_axes *axes, int x, int y)
{
    const struct aob_gbuffer *g = desc->gbuffer;
    size_t i = (size_t)y * (size_t)g->projection.width + (size_t)x;
    struct aob_vec3 origin, direction;
    if (!(g->depth[i] < 0.5f * AOB_GBUFFER_SKY))
        return NAN;
    aob_camera_ray(desc->camera, &g->projection, x + 0.5, y + 0.5, &origin, &direction);
    return desc->oracle->visibility(aob_vec_add(origin, aob_vec_scale(direction, g->depth[i])),
                                    to_world(axes, g->normal + 4 * i), desc->radius);
}

void aob_oracle_score(const struct aob_oracle_desc *desc, const float *image, struct aob_oracle_score *score)
{
    const struct aob_gbuffer *g = desc->gbuffer;
    struct aob_frame_axes axes = aob_camera_axes(desc->camera);
    int width = g->projection.width - 2 * g->guard, height = g->projection.height - 2 * g->guard;
    double square = 0, sum = 0, band = 0;
    *score = (struct aob_oracle_score){0};
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            double truth = closed_form(desc, &axes, x + g->guard, y + g->guard);
            double e = (double)image[(size_t)y * (size_t)width + (size_t)x] - truth;
            if (!isfinite(e))
                continue;
            bool in_band = truth < AOB_BAND_LIMIT;
            square += e * e;
            sum += e;
            band += in_band ? e * e : 0;
            score->pixels++;
            score->band_pixels += in_band;
        }
    score->rmse = sqrt(square / (double)score->pixels); /* 0/0 where no pixel counts: NAN */
    score->bias = sum / (double)score->pixels;
    score->band_rmse = sqrt(band / (double)score->band_pixels);
}
