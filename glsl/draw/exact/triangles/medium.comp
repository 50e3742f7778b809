// Rasterizes the medium-sized triangles, which are at the end of the list of triangles.comp. Sixteen invocations handle
// one triangle. SAMPLES, PASS, SUN_MAP: as in draw/exact/visible_sample.glsl. COUNTED: the GPU has written the number
// of triangles to the draw arguments.
#include "draw/exact/triangles/raster.glsl"
#include "draw/exact/triangles/fill_blocks.glsl"
layout(local_size_x = 64) in;
layout(binding = largeUnit) uniform usamplerBuffer large;
layout(binding = counterUnit) uniform usamplerBuffer counters;
#ifdef FACES
int draw_ = face_;
#else
uniform int draw_;
#endif
uniform int draws;

void main() {
  const uint teams = 64u / teamSize;
  uint count = texelFetch(counters, draws + draw_).x, me = gl_LocalInvocationIndex;
  for (uint entry = gl_WorkGroupID.x * teams + me / teamSize; entry < count; entry += gl_NumWorkGroups.x * teams) {
    int number = int(texelFetch(large, firstIndex / 3 + triangleCount - 1 - int(entry)).x);
    seeSides(number);
    ivec3 corners = cornersOf(number);
    uvec4 a = vertexOf(corners.x), b = vertexOf(corners.y), c = vertexOf(corners.z);
    Triangle t = drawnTriangle(cornerOfVertex(a), cornerOfVertex(b), cornerOfVertex(c));
    fillBlocks(t, firstId + uint(number), me % teamSize);
  }
}
