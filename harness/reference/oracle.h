/* Closed-form visibilities; O1 to O7 in the comments are the names of these oracles. All lengths in one unit; V is 1
 * open, 0 closed, cosine-weighted, hard cutoff. */
#ifndef AOB_REFERENCE_ORACLE_H
#define AOB_REFERENCE_ORACLE_H

/* O2: a point on one of two infinite planes that meet at 90 degrees, at distance d from the other; rays of
 * length r: V = 1 - (acos t - t sqrt(1-t^2))/pi, t = d/r; 1 for t >= 1 (Nusselt: a segment of the unit disc).
 */
double aob_oracle_corner(double d, double r);

/* O3: the other plane is a wall of height h, r infinite: V = 1 - (1 - d/sqrt(d^2+h^2))/2. */
double aob_oracle_wall(double d, double h);

/* O4: below the straight edge of a half-plane sheet at height h: V = 1 - (1 - (h/r)^2)/2 for r > h, else 1.
 */
double aob_oracle_sheet_edge(double h, double r);

/* O7: a coaxial disc of radius a at height h above the point, r infinite: V = 1 - a^2/(a^2+h^2). */
double aob_oracle_disc(double a, double h);
#endif
