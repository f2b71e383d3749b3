/* How the properties of light ask: of visibility after bounces, specular occlusion and irradiance. Threads: as a trial. */
#ifndef AOB_STRESS_EFFECTS_H
#define AOB_STRESS_EFFECTS_H
#include "chance.h"
#include "trial.h"

/* A light by lot, of a mean radiance of 1 in each channel: none of it is negative, and each channel is dark somewhere. */
struct aob_light aob_effects_light(struct aob_chance *chance);

/* Paints each pixel by lot: a third of all numbers are 0, a third are 1. Allocates what is missing. */
void aob_effects_paint(struct aob_gbuffer *gbuffer, struct aob_chance *chance);

/* Hands out open planes, one after the other: at many tilts and places of an image, seen in perspective and without, up to 85
 * degrees from the side, and along each axis of view space. */
typedef void aob_effects_plane_fn(struct aob_trial *trial, struct aob_exhibit *exhibit, const char *text,
                                  void *user);
void aob_effects_planes(struct aob_trial *trial, aob_effects_plane_fn *take, void *user);

/* The six of them whose normals lie along the axes. */
void aob_effects_axial(struct aob_trial *trial, aob_effects_plane_fn *take, void *user);

/* An image of one channel of three, divided by `unit`. */
float *aob_effects_channel(struct aob_trial *trial, const struct aob_exhibit *exhibit, const float *pixels,
                           int channel, double unit);

/* Takes the largest difference of a pixel of two images. */
void aob_effects_take(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                      const float *wanted, const char *text);

void aob_ask_bounced_on_plane(struct aob_trial *trial);
void aob_ask_bounced_within(struct aob_trial *trial);
void aob_ask_bounced_rises(struct aob_trial *trial);
void aob_ask_bounced_black(struct aob_trial *trial);
void aob_ask_bounced_metal(struct aob_trial *trial);
void aob_ask_bounced_channels(struct aob_trial *trial);
void aob_ask_specular_on_plane(struct aob_trial *trial);
void aob_ask_specular_is_share(struct aob_trial *trial);
void aob_ask_irradiance_on_plane(struct aob_trial *trial);
void aob_ask_irradiance_turned(struct aob_trial *trial);
void aob_ask_irradiance_uniform(struct aob_trial *trial);
void aob_ask_irradiance_linear(struct aob_trial *trial);
void aob_ask_irradiance_of_sun(struct aob_trial *trial);
void aob_ask_effects_apart(struct aob_trial *trial);
void aob_ask_effects_unwanted(struct aob_trial *trial);
void aob_ask_effects_finite(struct aob_trial *trial);
#endif
