#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/types.glsl"
#ifdef FACES
// All of some lamps' maps in one dispatch: FACES is which coordinate of a group says which.
layout(std140, binding = viewBinding) uniform ViewBlock {
  ExactView viewBlocks[maxFaceViews];
};
uniform int firstView;
int face_ = int(gl_WorkGroupID[FACES]);
#define viewBlock viewBlocks[firstView + face_]
#else
layout(std140, binding = viewBinding) uniform ViewBlock {
  ExactView viewBlock;
};
#endif
ExactView viewOnce() {  // each member of ExactView
  ExactView one;
  one.eye = once(viewBlock.eye);
  one.across = once(viewBlock.across);
  one.down = once(viewBlock.down);
  one.forward = once(viewBlock.forward);
  one.ray = once(viewBlock.ray);
  one.rayAcross = once(viewBlock.rayAcross);
  one.rayDown = once(viewBlock.rayDown);
  one.size = once(viewBlock.size);
  one.near = once(viewBlock.near);
  one.nearOverFar = once(viewBlock.nearOverFar);
  one.rows = once(viewBlock.rows);
  return one;
}
ExactView view = viewOnce();

#ifdef SAMPLES
// Where the keys and the numbers of a pixel's samples begin: those of the band are kept, row by row.
int firstSample(ivec2 pixel) {
  return ((pixel.y - view.rows.x) * view.size.x + pixel.x) * SAMPLES;
}
#endif
