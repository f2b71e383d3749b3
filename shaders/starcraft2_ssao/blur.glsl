#include "common/gaussian.glsl"
