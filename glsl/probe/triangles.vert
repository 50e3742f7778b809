// Draws triangles in perspective. Like the vertices of surfaces, their vertices are pulled from a texel buffer.
#include "draw/bindings.glsl"
layout(binding = positionUnit) uniform samplerBuffer vertices;  // Two texels per vertex: position and u; normal and v
uniform mat4 projection;
out vec3 place;
out vec3 normal;
out vec2 uv;

void main() {
  vec4 first = texelFetch(vertices, 2 * gl_VertexID);
  vec4 second = texelFetch(vertices, 2 * gl_VertexID + 1);
  place = first.xyz;
  normal = second.xyz;
  uv = vec2(first.w, second.w);
  gl_Position = projection * vec4(first.xyz, 1.0);
}
