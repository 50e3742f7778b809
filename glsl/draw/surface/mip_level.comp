// Computes one mip level of a number texture from the level above. Each texel is the mean of the area that it covers.
// If the level above has 2n texels, each of n texels covers two. If it has 2n + 1, texel i covers (n - i) / n of the
// first, all of the second and (i + 1) / n of the third of three texels, as in src/draw/surface/mip_levels.cpp. FORMAT:
// image format of both levels. One invocation writes one texel.
#include "draw/bindings.glsl"
#include "draw/half.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(FORMAT, binding = fieldImage) uniform readonly restrict image2D above;
layout(FORMAT, binding = reliefImage) uniform writeonly restrict image2D below;
uniform ivec2 aboveSize;

// Returns the weights of the first, second and third texel.
vec3 barycentricWeights(int i, int count) {
  if (count == 1) return vec3(1, 0, 0);
  if (count % 2 == 0) return vec3(0.5, 0.5, 0);
  int n = count / 2;
  precise vec3 shares = vec3(n - i, n, i + 1) * exactReciprocal(float(count));
  return shares;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, max(aboveSize / 2, 1)))) return;
  vec3 across = barycentricWeights(at.x, aboveSize.x), down = barycentricWeights(at.y, aboveSize.y);
  ivec2 taken = min(aboveSize, 2 + aboveSize % 2);
  precise vec4 sum = vec4(0);
  for (int y = 0; y < taken.y; ++y)
    for (int x = 0; x < taken.x; ++x) {
      precise float share = across[x] * down[y];
      sum = sum + share * imageLoad(above, 2 * at + ivec2(x, y));
    }
  imageStore(below, at, asHalf(sum));
}
