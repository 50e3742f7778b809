#include "draw/exact/bindings.glsl"
#include "draw/exact/types.glsl"
layout(std140, binding = viewBinding) uniform ViewBlock {
  ExactView viewBlock;
};
ExactView view = viewBlock;  // once: software drivers read a block again in each turn of a loop
