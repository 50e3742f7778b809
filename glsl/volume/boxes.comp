// Draws cells as cubes: where an inside cell meets an outside cell, there is a square that faces the outside cell and
// has four vertices of its own. For each sample, the squares towards the next sample along x, y and z are written.
// Their number equals the number of crossed edges in points.comp.
#include "volume/samples.glsl"
#include "volume/values.glsl"
#include "volume/model.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(classesBinding, ClassBlock, classes)
INPUT_WORDS(talliesBinding, TallyBlock, tallies)
INPUT_WORDS(masksBinding, MaskBlock, masks)
layout(std430, binding = positionsBinding) restrict writeonly buffer PositionBlock { vec4 positions[]; };
layout(std430, binding = normalsBinding) restrict writeonly buffer NormalBlock { vec4 normals[]; };
layout(std430, binding = boxIndicesBinding) restrict writeonly buffer IndexBlock { uint indices[]; };
uniform uint pointRoom, indexRoom;
uniform vec4 corner;  // Position of cell (0, 0, 0), m; w: cell spacing, m
#include "volume/tint.glsl"

// Writes a square between a cell and its neighbour along an axis. `point` is the index of its first point. `alive` is
// true if the cell is inside, false if the neighbour is.
void putSquare(uint point, uint index, ivec3 cell, int axis, bool alive) {
  if (point + 4u > pointRoom || index + 6u > indexRoom) return;
  ivec3 way = ivec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
  // In this order, the corners run counterclockwise around the axis.
  ivec3 right = way.zxy, up = way.yzx;
  int color = 0;
#ifdef TINTED
  float tint = tintAt(alive ? cell : cell + way);
  color = volumeColor(tint, tint, 0.0, tintRange.x, tintRange.y);
#endif
  uint vertex = uint(boxCorners) + point;
  for (int i = 0; i < 4; ++i) {
    ivec3 twice = way + right * (i == 1 || i == 2 ? 1 : -1) + up * (i >= 2 ? 1 : -1);
    precise vec3 at = vec3(cell) + vec3(twice) * 0.5;
    vec3 place = volumePlace(corner.xyz, corner.w, at);
    positions[vertex + uint(i)] = vec4(place, float(color));
    normals[vertex + uint(i)] = vec4(alive ? way : -way, 0);
  }
  uint second = alive ? 1u : 3u, last = alive ? 3u : 1u;
  indices[index] = vertex;
  indices[index + 1u] = vertex + second;
  indices[index + 2u] = vertex + 2u;
  indices[index + 3u] = vertex;
  indices[index + 4u] = vertex + 2u;
  indices[index + 5u] = vertex + last;
}

void main() {
  ivec4 place = wordPlace(ivec2(gl_GlobalInvocationID.xy));
  if (place.w < 0) return;
  uvec4 mask = LOAD_INPUT_WORDS(masks, place.w);
  uint left = mask.x | mask.y | mask.z;
  if (left == 0u) return;
  uvec4 before = LOAD_INPUT_WORDS(tallies, place.w);
  uint inside = LOAD_INPUT_WORDS(classes, place.w).x;
  uint point = before.x, index = 3u * before.z;
  for (; left != 0u; left &= left - 1u) {
    int k = findLSB(left);
    ivec3 cell = ivec3(place.x + k, place.yz) - ringWidth();
    for (int axis = 0; axis < 3; ++axis) {
      uint crossed = (axis == 0 ? mask.x : axis == 1 ? mask.y : mask.z) >> uint(k) & 1u;
      if (crossed == 0u) continue;
      putSquare(point, index, cell, axis, (inside >> uint(k) & 1u) != 0u);
      point += 4u;
      index += 6u;
    }
  }
}
