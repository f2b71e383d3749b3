#include "common/cross5.glsl"
