// Heights of the mesh onto which cloth and particles fall, if HEIGHTS is 1. Otherwise, nothing is bound or read.
#ifndef HEIGHTS
#define HEIGHTS 0
#endif
#include "mesh/height_types.glsl"
uniform HeightGrid heightGrid;
#if HEIGHTS
INPUT_ARRAY(heightsBinding, HeightBlock, heights)
vec4 loadHeights(int i) {
  return LOAD_INPUT(heights, i);
}
#else
vec4 loadHeights(int i) {
  return vec4(0.0f);
}
#endif
#include "mesh/height_model.glsl"
