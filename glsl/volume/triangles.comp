// Writes the triangles of the cubes that begin at 32 samples. The corners of the triangles are point indices. One
// invocation per 32 samples.
#include "volume/samples.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(cubesBinding, CubeBlock, cubes)
INPUT_WORDS(classesBinding, ClassBlock, classes)
INPUT_WORDS(talliesBinding, TallyBlock, tallies)
INPUT_WORDS(masksBinding, MaskBlock, masks)
layout(std430, binding = indicesBinding) restrict writeonly buffer IndexBlock { uint indices[]; };
uniform uint indexRoom;

// A row's word: the number of points before it and its crossed edges. Both values are also stored for the word to its
// right, which the last sample's cube needs.
struct Row {
  uint first;
  uvec4 mask;
  uint nextFirst;
  uvec4 nextMask;
};

Row rowAt(int word, bool last) {
  Row row;
  row.first = LOAD_INPUT_WORDS(tallies, word).x;
  row.mask = LOAD_INPUT_WORDS(masks, word);
  row.nextFirst = 0u;
  row.nextMask = uvec4(0);
  if (!last) {
    row.nextFirst = LOAD_INPUT_WORDS(tallies, word + 1).x;
    row.nextMask = LOAD_INPUT_WORDS(masks, word + 1);
  }
  return row;
}

// Returns the indices of the points along x, y and z of sample k of a row's word; k = 32 is the first sample of the
// next word.
uvec3 pointsAt(Row row, int k) {
  uvec4 mask = k < 32 ? row.mask : row.nextMask;
  uint before = (1u << uint(k & 31)) - 1u;
  uint first = (k < 32 ? row.first : row.nextFirst) +
               uint(bitCount(mask.x & before) + bitCount(mask.y & before) + bitCount(mask.z & before));
  uint alongX = mask.x >> uint(k & 31) & 1u, alongY = mask.y >> uint(k & 31) & 1u;
  return uvec3(first, first + alongX, first + alongX + alongY);
}

void main() {
  ivec4 place = wordPlace(ivec2(gl_GlobalInvocationID.xy));
  if (place.w < 0) return;
  uint left = LOAD_INPUT_WORDS(masks, place.w).w;
  if (left == 0u) return;
  ivec3 samples = samplesOf();
  bool last = place.x + 32 >= samples.x;
  int row = rowElements, layer = rowElements * samples.y;
  Row a = rowAt(place.w, last), b = rowAt(place.w + row, last);
  Row c = rowAt(place.w + layer, last), d = rowAt(place.w + layer + row, last);
  uvec4 here, next = uvec4(0);
  here.x = LOAD_INPUT_WORDS(classes, place.w).x;
  here.y = LOAD_INPUT_WORDS(classes, place.w + row).x;
  here.z = LOAD_INPUT_WORDS(classes, place.w + layer).x;
  here.w = LOAD_INPUT_WORDS(classes, place.w + layer + row).x;
  if (!last) {
    next.x = LOAD_INPUT_WORDS(classes, place.w + 1).x;
    next.y = LOAD_INPUT_WORDS(classes, place.w + row + 1).x;
    next.z = LOAD_INPUT_WORDS(classes, place.w + layer + 1).x;
    next.w = LOAD_INPUT_WORDS(classes, place.w + layer + row + 1).x;
  }
  uvec4 beside = here >> 1u | next << 31u;
  uint index = 3u * LOAD_INPUT_WORDS(tallies, place.w).z;
  for (; left != 0u; left &= left - 1u) {
    int k = findLSB(left);
    uvec4 low = here >> uint(k) & 1u, high = beside >> uint(k) & 1u;
    uint kind = low.x | high.x << 1u | low.y << 2u | high.y << 3u | low.z << 4u | high.z << 5u | low.w << 6u | high.w << 7u;
    uvec4 cube = LOAD_INPUT_WORDS(cubes, int(kind));
    uvec3 a0 = pointsAt(a, k), a1 = pointsAt(a, k + 1), b0 = pointsAt(b, k), b1 = pointsAt(b, k + 1);
    uvec3 c0 = pointsAt(c, k), c1 = pointsAt(c, k + 1);
    uvec4 alongX = uvec4(a0.x, b0.x, c0.x, pointsAt(d, k).x);
    uvec4 alongY = uvec4(a0.y, a1.y, c0.y, c1.y);
    uvec4 alongZ = uvec4(a0.z, a1.z, b0.z, b1.z);
    for (int t = 0; t < int(3u * cube.x); ++t) {
      uint edge = (t < 8 ? cube.y : cube.z) >> uint(4 * (t & 7)) & 15u;
      uvec4 four = edge < 4u ? alongX : edge < 8u ? alongY : alongZ;
      uint point = (edge & 2u) == 0u ? ((edge & 1u) == 0u ? four.x : four.y) : ((edge & 1u) == 0u ? four.z : four.w);
      if (index < indexRoom) indices[index] = uint(boxCorners) + point;
      ++index;
    }
  }
}
