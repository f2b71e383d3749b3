#include "common/tile_blur.glsl"
