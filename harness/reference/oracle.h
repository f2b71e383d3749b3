/* Closed-form visibilities; O1 to O7 in the comments are the names of these oracles. All lengths in one unit; V is 1
 * open, 0 closed, cosine-weighted, hard cutoff: rays of length r, INFINITY allowed. They follow from Nusselt's disc (the
 * unit disc that cosine-weighted directions cover evenly): V = 1 - occluded area / pi. */
#ifndef AOB_REFERENCE_ORACLE_H
#define AOB_REFERENCE_ORACLE_H

/* O2: a point on one of two infinite planes that meet at 90 degrees, at distance d from the other:
 * V = 1 - (acos t - t sqrt(1-t^2))/pi, t = d/r; 1 for t >= 1 (a segment of the disc).
 */
double aob_oracle_corner(double d, double r);

/* O3: the other plane is a wall of height h. Its upper edge is an ellipse of half axes 1 and b = d/sqrt(d^2+h^2) on the
 * disc, so V = 1 - (S(t) - b S(t/b))/pi with S(t) = acos t - t sqrt(1-t^2) (0 for t >= 1), t = d/r. With r infinite:
 * 1 - (1 - b)/2. */
double aob_oracle_wall(double d, double h, double r);

/* O4: below a half-plane sheet at height h, at distance x outside of its straight edge (below it: negative). The sheet is
 * seen within the circle of radius q, q^2 = 1 - (h/r)^2, its edge as an ellipse of half axes 1 and b = |x|/sqrt(x^2+h^2).
 * With v^2 = q^2 - (x/r)^2 the occluded area is v |x|/r + q^2 asin(v/q) - b (v sqrt(1-v^2) + asin v) where x >= 0, and pi
 * q^2 less that where x < 0; none for r <= h. At the edge (x = 0): V = 1 - (1 - (h/r)^2)/2. */
double aob_oracle_sheet(double x, double h, double r);

/* O7: a disc of radius a at height h above the point, its axis at distance x: V = 1 - (1 - (x^2+h^2-a^2)/sqrt((x^2+h^2+
 * a^2)^2 - 4 a^2 x^2))/2 (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-12) where all of the
 * disc is within reach of r; (h/r)^2 where it hides all that is; between these NAN. On the axis with r infinite:
 * 1 - a^2/(a^2+h^2). */
double aob_oracle_disc(double x, double a, double h, double r);
#endif
