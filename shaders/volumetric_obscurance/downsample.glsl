#include "common/downsample.glsl"
