/* A regular polygon of SIDES sides with the area of a disc of radius 1: how far its corners and its sides are out. */
const float TURN = 2.0 * AOB_PI / float(SIDES);
const float CORNER_OUT = sqrt(TURN / sin(TURN));
const float SIDE_OUT = CORNER_OUT * cos(0.5 * TURN);
#define RADIUS_OUT (FALLOFF == 0 ? param.radius * CORNER_OUT : param.radius)
