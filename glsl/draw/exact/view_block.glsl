#include "draw/exact/bindings.glsl"
#include "draw/exact/types.glsl"
layout(std140, binding = viewBinding) uniform ViewBlock {
  ExactView viewBlock;
};
ExactView view = viewBlock;  // once: software drivers read a block again in each turn of a loop

#ifdef SAMPLES
// Where the keys and the numbers of a pixel's samples begin: those of the band are kept, row by row.
int firstSample(ivec2 pixel) {
  return ((pixel.y - view.rows.x) * view.size.x + pixel.x) * SAMPLES;
}
#endif
