#include "draw/exact/bindings.glsl"
#include "draw/exact/types.glsl"
layout(std140, binding = viewBinding) uniform ViewBlock {
  ExactView view;
};
