// Adds the light of the coarser bloom levels to one level. A tent filter of 3 by 3 bilinear taps enlarges the coarser
// light. One invocation writes one texel.
#include "draw/exact/screen/light_read.glsl"
#include "draw/exact/screen/twice_as_large.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
LIGHT_PICTURE(sceneUnit, lightImage, coarse);
LIGHT_PICTURE(bloomUnit, scatteredImage, fine);
layout(rgba32f, binding = sumImage) writeonly restrict uniform image2D sum_;
uniform ivec2 size;        // size of the result in texels
uniform ivec2 coarseSize;
uniform vec2 fraction;     // x: weight of the fine level; y: weight of the coarse level

// Returns the weights of four texels on one axis. The filter has three taps of weights 1, 2, 1, one texel apart, each
// interpolated between two texels.
vec4 weights(int i) {
  float second = secondWeight(i);
  precise vec4 w = vec4(1, 2, 1, 0) * (1.0f - second) + vec4(0, 1, 2, 1) * second;
  return w;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  vec4 across = weights(at.x), down = weights(at.y);
  ivec2 first = ivec2(firstHalfTexel(at.x), firstHalfTexel(at.y)) - 1;
  precise vec3 tent = vec3(0);
  for (int y = 0; y < 4; ++y) {
    precise vec3 row = vec3(0);
    for (int x = 0; x < 4; ++x)
      row = row + across[x] * LIGHT_AT(coarse, clamp(first + ivec2(x, y), ivec2(0), coarseSize - 1)).rgb;
    tent = tent + down[y] * row;
  }
  precise vec3 light = fraction.x * LIGHT_AT(fine, at).rgb + (fraction.y * 0.0625f) * tent;
  imageStore(sum_, at, vec4(light, 1.0f));
}
