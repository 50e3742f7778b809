// Clipped large triangles, stored as triangle fans. clip_large.comp writes their corners once for all workgroups that
// rasterize them. If there is no room for a triangle, each workgroup clips it again.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/clip.glsl"
#include "draw/exact/triangles/triangle.glsl"
const int fanTexels = 8;  // texels per fan; each texel holds x, y, nearness and the number of corners
uniform int fanRoom;   // capacity of the buffer (fans)
#ifdef FACES
int firstFan = face_ * fanRoom;
#else
uniform int firstFan;  // index of the surface's first fan
#endif
#ifdef MAKES_FANS
layout(std430, binding = fanBinding) writeonly restrict buffer FanBlock { uvec4 fans[]; };

void makeFan(int entry, vec3 a, vec3 b, vec3 c, vec2 size, float nearest) {
  Polygon p = clippedToPicture(a, b, c, size, nearest);
  for (int k = 0; k < p.count; ++k) {
    Corner corner = cornerOf(p.corners[k], nearest);
    fans[(firstFan + entry) * fanTexels + k] = uvec4(uvec2(corner.at), floatBitsToUint(corner.near), uint(p.count));
  }
  if (p.count == 0) fans[(firstFan + entry) * fanTexels] = uvec4(0u);
}
#else
layout(binding = fanUnit) uniform usamplerBuffer fans;

int cornersOfFan(int entry) {
  return int(texelFetch(fans, (firstFan + entry) * fanTexels).w);
}

Corner cornerOfFan(int entry, int k) {
  uvec4 words = texelFetch(fans, (firstFan + entry) * fanTexels + k);
  Corner corner;
  corner.at = ivec2(words.xy);
  corner.near = uintBitsToFloat(words.z);
  return corner;
}
#endif
