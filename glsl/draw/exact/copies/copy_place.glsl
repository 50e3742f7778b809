// Where a place of the scene lies on the picture: pixels times depth to the right and down, and depth (m).
#include "draw/exact/view_block.glsl"
#include "common/exact.glsl"

vec3 onPicture(vec3 p) {
  precise vec3 from = p - view.eye.xyz;
  return vec3(exactDot(from, view.across.xyz), exactDot(from, view.down.xyz), exactDot(from, view.forward.xyz));
}
