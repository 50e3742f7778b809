// Computes the surface points and their normals: for each sample, the points on its edges along x, y and z. One
// invocation per 32 samples.
#include "volume/samples.glsl"
#include "volume/values.glsl"
#include "contour/model.glsl"
#include "volume/model.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(talliesBinding, TallyBlock, tallies)
INPUT_WORDS(masksBinding, MaskBlock, masks)
layout(std430, binding = positionsBinding) restrict writeonly buffer PositionBlock { vec4 positions[]; };
layout(std430, binding = normalsBinding) restrict writeonly buffer NormalBlock { vec4 normals[]; };
uniform uint pointRoom;
uniform vec4 corner;  // Position of cell (0, 0, 0), m; w: cell spacing, m
#include "volume/tint.glsl"

float slopeAlong(ivec3 cell, ivec3 axis) {
  ivec3 before = max(cell - axis, ivec3(0)), after = min(cell + axis, volume.xyz - 1);
  ivec3 separation = (after - before) * axis;
  return volumeSlope(valueAt(before), valueAt(after), separation.x + separation.y + separation.z == 1);
}
vec3 slopeAt(ivec3 cell) {
  return vec3(slopeAlong(cell, ivec3(1, 0, 0)), slopeAlong(cell, ivec3(0, 1, 0)), slopeAlong(cell, ivec3(0, 0, 1)));
}

void putPoint(uint point, ivec3 cell, ivec3 axis) {
  if (point >= pointRoom) return;
  ivec3 next = cell + axis;
  bool within = cell.x >= 0 && cell.y >= 0 && cell.z >= 0;
  within = within && next.x < volume.x && next.y < volume.y && next.z < volume.z;
  float first = valueAt(cell), second = valueAt(next);
  bool rises = within ? second > first : cell.x < 0 || cell.y < 0 || cell.z < 0;
  vec3 along = rises ? -vec3(axis) : vec3(axis);
  float part = 0.5;
  vec3 normal = along;
  if (within) {
    part = crossingPlace(first, second, level);
    normal = volumeNormal(slopeAt(cell), slopeAt(next), part, along);
  }
  precise vec3 at = vec3(cell) + vec3(axis) * part;
  vec3 place = volumePlace(corner.xyz, corner.w, at);
  int color = 0;
#ifdef TINTED
  color = volumeColor(tintAt(cell), tintAt(next), part, tintRange.x, tintRange.y);
#endif
  uint vertex = uint(boxCorners) + point;
  positions[vertex] = vec4(place, float(color));
  normals[vertex] = vec4(normal, 0.0);
}

void main() {
  ivec4 place = wordPlace(ivec2(gl_GlobalInvocationID.xy));
  if (place.w < 0) return;
  uvec4 mask = LOAD_INPUT_WORDS(masks, place.w);
  uint left = mask.x | mask.y | mask.z;
  if (left == 0u) return;
  uint point = LOAD_INPUT_WORDS(tallies, place.w).x;
  for (; left != 0u; left &= left - 1u) {
    int k = findLSB(left);
    ivec3 cell = ivec3(place.x + k, place.yz) - ringWidth();
    for (int axis = 0; axis < 3; ++axis) {
      uint crossed = (axis == 0 ? mask.x : axis == 1 ? mask.y : mask.z) >> uint(k) & 1u;
      if (crossed == 0u) continue;
      putPoint(point, cell, ivec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0));
      ++point;
    }
  }
}
