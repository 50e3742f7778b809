// Halves the size of a bloom level. The filter has thirteen taps in five overlapping squares, so that small lights do
// not shimmer as they move (J. Jimenez, "Next generation post processing in Call of Duty: Advanced Warfare", SIGGRAPH
// 2014). Each tap is at a corner of four texels. One invocation writes one texel.
#include "draw/exact/screen/light_read.glsl"
#include "common/exact.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
LIGHT_PICTURE(sceneUnit, lightImage, fine);
layout(rgba32f, binding = sumImage) writeonly restrict uniform image2D coarse;
uniform ivec2 size;  // size of the source level in texels

vec3 texel(ivec2 at) {
  return LIGHT_AT(fine, clamp(at, ivec2(0), size - 1)).rgb;
}

vec3 tap(ivec2 corner) {
  precise vec3 sum = texel(corner) + texel(corner - ivec2(1, 0)) + texel(corner - ivec2(0, 1)) + texel(corner - 1);
  precise vec3 mean = 0.25f * sum;
  return mean;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), c = 2 * at + 1;
  if (2 * at.x >= size.x || 2 * at.y >= size.y) return;
  precise vec3 inner = tap(c + ivec2(-1, -1)) + tap(c + ivec2(1, -1)) + tap(c + ivec2(-1, 1)) + tap(c + ivec2(1, 1));
  precise vec3 corners = tap(c + ivec2(-2, -2)) + tap(c + ivec2(2, -2)) + tap(c + ivec2(-2, 2)) + tap(c + ivec2(2, 2));
  precise vec3 edges = tap(c + ivec2(0, -2)) + tap(c + ivec2(-2, 0)) + tap(c + ivec2(2, 0)) + tap(c + ivec2(0, 2));
  precise vec3 sum = 0.125f * (inner + tap(c)) + 0.0625f * edges + 0.03125f * corners;
  imageStore(coarse, at, vec4(sum, 1.0f));
}
