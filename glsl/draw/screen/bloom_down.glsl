// Halves the size of a bloom level. The filter has thirteen taps in five overlapping squares, so that small lights do
// not shimmer as they move (J. Jimenez, "Next generation post processing in Call of Duty: Advanced Warfare", SIGGRAPH
// 2014).
#include "draw/screen/screen.glsl"
layout(binding = sceneUnit) uniform sampler2D source;
uniform vec2 texel;  // size of a source texel in texture coordinates

vec3 tap(vec2 uv, float x, float y) {
  return texture(source, uv + vec2(x, y) * texel).rgb;
}

void main() {
  vec2 uv = 2.0 * PIXEL * texel;
  vec3 inner = tap(uv, -1, -1) + tap(uv, 1, -1) + tap(uv, -1, 1) + tap(uv, 1, 1);
  vec3 corners = tap(uv, -2, -2) + tap(uv, 2, -2) + tap(uv, -2, 2) + tap(uv, 2, 2);
  vec3 edges = tap(uv, 0, -2) + tap(uv, -2, 0) + tap(uv, 2, 0) + tap(uv, 0, 2);
  PUT(vec4(0.125 * (inner + tap(uv, 0, 0)) + 0.0625 * edges + 0.03125 * corners, 1.0));
}
