/* The lit composite: the harness's own pass behind those of a technique, where the output `lit` is wanted. It is the last pass
 * of a frame with ambient occlusion, so an effect costs its own passes and what the composite takes more with it than
 * without.
 *
 *     lit = (1 - metalness) * base colour * E + SO * S + (1 - SO) * D * C
 *
 * E is irradiance over pi: the output `irradiance` where that is wanted and given; else visibility times what an open
 * surface gets, about the bent normal where that is wanted and given (Landis 2002), else about the normal. Where visibility
 * after bounces is wanted and given, E is multiplied by its quotient to visibility. SO is the output `specular`, else
 * visibility. C is the mean light of what is closed: what bounces add to E, over 1 - visibility; without them what is closed
 * is black.
 *
 * S is what an open surface mirrors of the nine coefficients of the light: the integral of L f cos with the GGX lobe of
 * reference/specular.h and Schlick's Fresnel factor F0 + (1 - F0)(1 - h.v)^5, F0 = .04 of what is no metal and the base
 * colour of a metal (glTF 2.0, appendix B). D is S of a light that is 1 from everywhere. It needs no fit: f cos has six
 * moments of degree 0 to 2 about the normal, which depend on roughness and on the cosine of the view direction alone, and
 * lie in a table. So the lit image of an open surface is right, and its error elsewhere is that of the occlusion. Diffuse
 * and mirrored light are added up, as Karis has it (Real Shading in Unreal Engine 4, 2013). Sky is 0.
 *
 * Units: as the light's. Threads: const data. */
#ifndef AOB_TECHNIQUE_COMPOSITE_H
#define AOB_TECHNIQUE_COMPOSITE_H
#include "graph.h"

enum { AOB_COMPOSITE_COSINES = 32, AOB_COMPOSITE_SHAPES = 32 };

/* Lays the pass `lit_composite`, its table `lit_lobes` and its target `lit_image` behind what build() laid, and gives the output.
 * False after a line in graph->error: a graph without room, or with one of these names. */
bool aob_composite_lay(struct aob_pass_graph *graph);

/* Moments of f cos over the hemisphere, in a frame whose z is the normal and whose x-z plane holds the view direction,
 * (sine, 0, cosine): with Fresnel's factor 1 in [0], and with (1 - h.v)^5 in [1]. */
struct aob_composite_lobe {
    double one, z, zz;
    double x, xz; /* over the sine */
    double xx_yy; /* of xx - yy, over the squared sine */
};

/* roughness 0..1, cosine of view direction and normal 0..1. By midpoints over the visible half vectors (Heitz 2018); right to
 * .003 of the light, the quotients times what they are quotients of. */
void aob_composite_moments(double roughness, double cosine, struct aob_composite_lobe lobe[2]);

/* Adds what the lit image depends on besides the technique's outputs, for the key of cases that want it: a version, raised when
 * this file's values should change, and the hash of the pass's text. */
void aob_composite_identify(struct aob_text *text);
#endif
