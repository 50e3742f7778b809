#include "draw/frame.glsl"
layout(std140, binding = 0) uniform FrameBlock {
  Frame frame;
};
