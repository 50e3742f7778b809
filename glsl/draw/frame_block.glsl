#include "draw/bindings.glsl"
#include "draw/frame.glsl"
#ifdef EXACT_PICTURE
layout(std140, binding = frameBinding) uniform FrameBlock {
  Frame frameBlock;
};
Frame frame = frameBlock;  // once: software drivers read a block again in each turn of a loop
#else
layout(std140, binding = frameBinding) uniform FrameBlock {
  Frame frame;
};
#endif
