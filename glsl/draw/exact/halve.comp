// A texture's next level, of half the size rounded down: each texel is the mean of the area that it covers. Of a side of
// 2 m + 1 texels, texel i of m covers m - i parts in 2 m + 1 of texel 2 i, m of the next, and i + 1 of the one after.
// LAYOUT: of the level.
#include "draw/bindings.glsl"
#include "common/exact.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = sceneUnit) uniform sampler2D levels;
layout(LAYOUT, binding = targetImage) writeonly restrict uniform image2D next;
uniform int level;
uniform ivec2 size;   // of that level
uniform ivec2 half_;  // and of the next
uniform vec2 perSize;

vec3 shares(int i, int side, int halfSide, float perSide) {
  precise vec3 odd = vec3(halfSide - i, halfSide, i + 1) * perSide;
  return side == 1 ? vec3(1, 0, 0) : (side & 1) == 0 ? vec3(0.5f, 0.5f, 0) : odd;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= half_.x || at.y >= half_.y) return;
  vec3 across = shares(at.x, size.x, half_.x, perSize.x), down = shares(at.y, size.y, half_.y, perSize.y);
  precise vec4 sum = vec4(0);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      ivec2 from = min(2 * at + ivec2(x, y), size - 1);
      precise float share = across[x] * down[y];
      sum = sum + texelFetch(levels, from, level) * share;
    }
  imageStore(next, at, sum);
}
