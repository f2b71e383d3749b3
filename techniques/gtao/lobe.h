/* The table of the specular occlusion (the text's GTSO): which share of a GGX lobe lies in a cone. */
#ifndef AOB_GTAO_LOBE_H
#define AOB_GTAO_LOBE_H

/* The table is GTAO_LOBE_EDGES texels wide and has GTAO_LOBE_CONES rows for each of GTAO_LOBE_SHAPES roughnesses, those from
 * GTAO_LOBE_LEAST to 1 in equal steps. With w = 4 atan(roughness^2), twice the lobe's width, and q = x / (1 + x):
 *   row:    q(alpha / w) over its value at pi/2, alpha the half-angle of the cone;
 *   column: q(|d| / w) with the sign of d = beta - alpha, from -1 to 1, beta the angle between the axes of lobe and cone.
 * So texels are dense where the cone's edge cuts the lobe. Linear look-ups are within .005 of the integral. */
enum { GTAO_LOBE_EDGES = 104, GTAO_LOBE_CONES = 36, GTAO_LOBE_SHAPES = 16 };
#define GTAO_LOBE_LEAST 0.05

/* The share, 0 to 1, of a lobe's light in a cone; radians: alpha in 0..pi/2, beta in 0..pi. The lobe is that of a GGX surface
 * with alpha = roughness^2 seen along its normal, D G (height-correlated Smith, Fresnel 1), turned so that its axis is the
 * mirrored view: it keeps this shape at all views, which is the table's assumption. */
double gtao_lobe_share(double alpha, double beta, double roughness);

/* Fills the table with 16-bit shares, for aob_tex_desc.fill. */
void gtao_lobe_fill(const void *values, void *texels);
#endif
