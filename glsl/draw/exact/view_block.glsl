#include "common/once.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/types.glsl"
#ifdef FACES
// FACES: one dispatch handles shadow map faces of several lamps; FACES is the workgroup coordinate that selects the
// face.
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
ExactView viewOnce() {  // Reads each member of ExactView once (common/once.glsl).
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
// Returns the index of the pixel's first sample. The buffers hold the samples of the current band of picture rows in
// row-major order.
int firstSample(ivec2 pixel) {
  return ((pixel.y - view.rows.x) * view.size.x + pixel.x) * SAMPLES;
}
#endif
