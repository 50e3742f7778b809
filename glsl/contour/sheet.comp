// Writes the vertices of the samples, and two triangles for each uniform square (four corners of one class). If FRESH
// is defined, also writes the samples' normals, which do not change afterwards. One invocation per sample.
#include "common/words.glsl"
#include "contour/samples.glsl"
#include "contour/squares.glsl"
#include "contour/vertices.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
INPUT_WORDS(classesBinding, ClassBlock, classes)
INPUT_WORDS(talliesBinding, TallyBlock, tallies)
layout(std430, binding = indicesBinding) restrict writeonly buffer IndexBlock { uvec2 indexPairs[]; };

layout(std430, binding = normalsBinding) restrict writeonly buffer NormalBlock { vec4 normals[]; };

void square(uint place, uint a, uint b, uint below, uint beyond) {
  indexPairs[place] = uvec2(a, below);
  indexPairs[place + 1u] = uvec2(b, b);
  indexPairs[place + 2u] = uvec2(below, beyond);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= samples.x || at.y >= samples.y) return;
  int element = at.y * rowElements + (at.x >> 4), k = at.x & 15;
  int class_ = int(byteOf(LOAD_INPUT_WORDS(classes, element), k));
  uint me = cornerIndex(at), row = uint(samples.x);
  vec2 place = placeAt(vec2(at));
#ifdef CEILING
  uint above = uint(samples.x * samples.y);
  positions[me] = vec4(place.x, heights[0], place.y, float(faceColor));
  positions[me + above] = vec4(place.x, heights[1], place.y, float(classColors + faceColor));
#else
  positions[me] = vec4(place.x, heights[class_], place.y, float(classColors * class_ + faceColor));
#endif
#ifdef FRESH
  normals[me] = vec4(0, 1, 0, 0);
#ifdef CEILING
  normals[me + above] = vec4(0, -1, 0, 0);
#endif
#endif
  uvec4 tally = LOAD_INPUT_WORDS(tallies, element);
  if ((tally.w >> uint(k) & 1u) == 0u) return;
  uint number = tally.y + uint(bitCount(tally.w & ((1u << uint(k)) - 1u)));
#ifdef CEILING
  uint pair = (fixedIndices >> 1u) + 6u * number;
  if (2u * pair + 12u > indexRoom) return;
  square(pair, me, me + 1u, me + row, me + row + 1u);
  square(pair + 3u, me + above, me + above + row, me + above + 1u, me + above + row + 1u);
#else
  uint pair = (fixedIndices >> 1u) + 3u * number;
  if (2u * pair + 6u > indexRoom) return;
  square(pair, me, me + 1u, me + row, me + row + 1u);
#endif
}
