/* What an effect can change in the lit image of a view at most, from the materials, the light and the true visibility: without a frame of
 * it. Two images that differ by a share w of the light have errors that differ by w at most, so of the sets without an effect whose
 * bound is w the best is within w of the best of all. */
#ifndef AOB_EFFECTS_BOUND_H
#define AOB_EFFECTS_BOUND_H
#include "effect_row.h"
#include "seen.h"

/* Relative to the root mean square of the truth, as lit_rmse is; 0: nothing at all; INFINITY: no rule bounds it. They hold of an
 * effect that is right, beside any of the others:
 *
 * multi_bounce: light gains f(V) - V by bounces at visibility V, f the fit of score/effect.h, and no direction shines brighter than
 *     the light's brightest. Of the lobe it stands in for what is closed, which specular may find more of.
 * bent_normal, directional: by Cauchy and Schwarz V times the open surface's light is off by at most sqrt(V (1 - V)) times the
 *     deviation of the light over the cosine's hemisphere, which is nothing where the light is the same from everywhere. Bounces multiply
 *     it by f(V) / V.
 * specular: the open share of the lobe differs from V by at most the variation between lobe and cosine (lobe.h), where anything is
 *     closed; what it weighs is the mirrored light, or the bounced one that stands in for what is closed.
 *
 * temporal: no bound, so INFINITY, until the mean is drawn of a view in which nothing moves: then what it gains at most (look.c).
 *
 * V is known by few rays, so each surface counts with the larger of what its own rays and those of its neighbourhood say. */
struct aob_effect_bounds {
    double most[AOB_EFFECT_COUNT];
};
void aob_effect_bounds_find(const struct aob_seen *seen, struct aob_effect_bounds *bounds);

/* The effects that the bounds leave: those whose bounds add up to no more than AOB_EFFECT_RULED of the tolerance are taken out, the least
 * first. Bent normal and directional light count once, since no set has both. A set with one of these can be cheaper than the one taken only
 * where that set without it misses the tolerance by no more than that share. */
#define AOB_EFFECT_RULED 0.25
unsigned aob_effect_bounds_open(const struct aob_effect_bounds *bounds, double tolerance);

/* What those that were taken out leave of that share. */
double aob_effect_bounds_left(const struct aob_effect_bounds *bounds, double tolerance);
#endif
