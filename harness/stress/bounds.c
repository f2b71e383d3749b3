#include "property.h"

/* All bounds, by group. Two steps of an image of 8 bits are 1/128: what nobody sees. */
const struct aob_bound aob_bounds[] = {
    /* --- projection --- */
    {"plane_is_open", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"plane_any_fov", 0.005, 0.005,
     "An open plane has no occluder; 1/255 is one step of an 8-bit image, rounded up."},
    {"scaled_by_two", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    /* --- numbers --- */
    /* --- near --- */
    /* --- normals --- */
    /* --- resolution --- */
    /* --- edges --- */
    /* --- relations --- */
    /* --- instruments --- */
    {0},
};
