// Draws the rectangles of letters. Each rectangle has two texels: its bounds in pixels and its encoded colour.
#include "draw/bindings.glsl"
layout(binding = boxUnit) uniform samplerBuffer boxes;
uniform vec2 picture;  // picture size in pixels
flat out vec3 color;

void main() {
  vec4 box = texelFetch(boxes, gl_VertexID / 6 * 2);
  color = texelFetch(boxes, gl_VertexID / 6 * 2 + 1).rgb;
  int corner = gl_VertexID % 6;
  vec2 at = vec2((corner & 1) == 0 ? box.x : box.z, corner == 0 || corner == 1 || corner == 3 ? box.y : box.w);
  gl_Position = vec4(at / picture * 2.0 - 1.0, 0.0, 1.0);
}
