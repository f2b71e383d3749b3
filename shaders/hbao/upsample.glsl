#include "common/upsample.glsl"
