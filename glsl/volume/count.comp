// Counts, for 32 samples, the crossed edges and the triangles of the cubes that begin at them. If CUBES is defined,
// each crossing has a square with four points and two triangles instead of one point. One invocation per 32 samples.
#include "volume/samples.glsl"
layout(local_size_x = 64) in;
#ifndef CUBES
INPUT_WORDS(cubesBinding, CubeBlock, cubes)
#endif
INPUT_WORDS(classesBinding, ClassBlock, classes)
STATE_WORDS(talliesBinding, TallyBlock, tallies)
STATE_WORDS(masksBinding, MaskBlock, masks)

// Returns the bits of a row's word, and the bits of the samples to the right of each sample.
uvec2 rowBits(int word, bool there, bool last) {
  if (!there) return uvec2(0);
  uint here = LOAD_INPUT_WORDS(classes, word).x;
  uint next = last ? 0u : LOAD_INPUT_WORDS(classes, word + 1).x;
  return uvec2(here, here >> 1u | next << 31u);
}

void main() {
  ivec4 place = wordPlace(ivec2(gl_GlobalInvocationID.xy));
  if (place.w < 0) return;
  ivec3 samples = samplesOf();
  bool last = place.x + 32 >= samples.x, up = place.y + 1 < samples.y, back = place.z + 1 < samples.z;
  int row = rowElements, layer = rowElements * samples.y;
  uvec2 a = rowBits(place.w, true, last), b = rowBits(place.w + row, up, last);
  uvec2 c = rowBits(place.w + layer, back, last), d = rowBits(place.w + layer + row, up && back, last);
  int pairs = samples.x - 1 - place.x;  // Number of samples in the word that have a neighbour on their right
  uint within = pairs >= 32 ? 0xffffffffu : (1u << uint(max(pairs, 0))) - 1u;
  uint alongX = (a.x ^ a.y) & within;
  uint alongY = up ? a.x ^ b.x : 0u, alongZ = back ? a.x ^ c.x : 0u;
  uint points = uint(bitCount(alongX) + bitCount(alongY) + bitCount(alongZ));
#ifdef CUBES
  STORE_WORDS(masks, place.w, uvec4(alongX, alongY, alongZ, 0u));
  STORE_WORDS(tallies, place.w, uvec4(4u * points, 0u, 2u * points, 0u));
#else
  uint any = a.x | a.y | b.x | b.y | c.x | c.y | d.x | d.y, all = a.x & a.y & b.x & b.y & c.x & c.y & d.x & d.y;
  uint crossed = up && back ? any & ~all & within : 0u;
  uint triangles = 0u;
  for (uint left = crossed; left != 0u; left &= left - 1u) {
    uint k = uint(findLSB(left));
    uvec4 low = uvec4(a.x, a.y, b.x, b.y) >> k & 1u, high = uvec4(c.x, c.y, d.x, d.y) >> k & 1u;
    uint kind = low.x | low.y << 1u | low.z << 2u | low.w << 3u | high.x << 4u | high.y << 5u | high.z << 6u | high.w << 7u;
    triangles += LOAD_INPUT_WORDS(cubes, int(kind)).x;
  }
  STORE_WORDS(masks, place.w, uvec4(alongX, alongY, alongZ, crossed));
  STORE_WORDS(tallies, place.w, uvec4(points, 0u, triangles, 0u));
#endif
}
