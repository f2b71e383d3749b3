#include "common/cross_bilateral.glsl"
