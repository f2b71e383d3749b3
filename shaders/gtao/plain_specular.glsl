/* The visibility in place of a specular occlusion: what renderers do that have nothing else, for comparison. */
#include "common/open.glsl"

void main() { specular = open_share(aob_fetch_open(aob_pixel)); }
