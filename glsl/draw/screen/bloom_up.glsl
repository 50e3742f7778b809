// Adds the light of the coarser bloom levels to one level. A tent filter of 3 by 3 taps enlarges the coarser light.
#include "draw/screen/screen.glsl"
layout(binding = sceneUnit) uniform sampler2D coarse;
layout(binding = bloomUnit) uniform sampler2D fine;
uniform vec2 coarseTexel;  // size of a texel of the coarse level in texture coordinates
uniform vec2 fraction;        // x: weight of the fine level; y: weight of the coarse level

vec3 tap(vec2 uv, float x, float y) {
  return texture(coarse, uv + vec2(x, y) * coarseTexel).rgb;
}

void main() {
  vec2 uv = 0.5 * PIXEL * coarseTexel;
  vec3 tent = 4.0 * tap(uv, 0, 0) + 2.0 * (tap(uv, -1, 0) + tap(uv, 1, 0) + tap(uv, 0, -1) + tap(uv, 0, 1)) +
              tap(uv, -1, -1) + tap(uv, 1, -1) + tap(uv, -1, 1) + tap(uv, 1, 1);
  PUT(vec4(fraction.x * texelFetch(fine, ivec2(PIXEL), 0).rgb + (fraction.y / 16.0) * tent, 1.0));
}
