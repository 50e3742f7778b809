// Clips the large triangles of one surface that triangles.comp has listed, an invocation each. COUNTED.
#include "draw/exact/triangles/surface_triangle.glsl"
#include "draw/exact/view_block.glsl"
#define MAKES_FANS
#include "draw/exact/triangles/fans.glsl"
layout(local_size_x = 64) in;
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
uniform int draw_;

void main() {
  int entry = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (entry >= min(int(texelFetch(counters, draw_).x), fanRoom)) return;
  ivec3 corners = cornersOf(int(texelFetch(large, firstIndex / 3 + entry).x));
  uvec4 a = vertexOf(corners.x), b = vertexOf(corners.y), c = vertexOf(corners.z);
  makeFan(entry, placeOf(a), placeOf(b), placeOf(c), vec2(view.size), view.near);
}
