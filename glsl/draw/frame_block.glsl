#include "draw/bindings.glsl"
#include "draw/frame.glsl"
layout(std140, binding = frameBinding) uniform FrameBlock {
  Frame frame;
};
