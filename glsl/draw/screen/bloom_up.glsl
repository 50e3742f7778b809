// One level's light and, through a tent of 3 by 3 taps, that of the coarser levels.
#include "draw/screen/screen.glsl"
layout(binding = sceneUnit) uniform sampler2D coarse;
layout(binding = bloomUnit) uniform sampler2D fine;
uniform vec2 coarseTexel;  // in texture coordinates
uniform vec2 fraction;        // of fine and coarse

vec3 tap(vec2 uv, float x, float y) {
  return texture(coarse, uv + vec2(x, y) * coarseTexel).rgb;
}

void main() {
  vec2 uv = 0.5 * PIXEL * coarseTexel;
  vec3 tent = 4.0 * tap(uv, 0, 0) + 2.0 * (tap(uv, -1, 0) + tap(uv, 1, 0) + tap(uv, 0, -1) + tap(uv, 0, 1)) +
              tap(uv, -1, -1) + tap(uv, 1, -1) + tap(uv, -1, 1) + tap(uv, 1, 1);
  PUT(vec4(fraction.x * texelFetch(fine, ivec2(PIXEL), 0).rgb + (fraction.y / 16.0) * tent, 1.0));
}
