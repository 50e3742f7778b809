// Classifies the samples: a sample is inside if its value is at or above the level. One invocation per 32 samples.
#include "volume/samples.glsl"
#include "volume/values.glsl"
layout(local_size_x = 64) in;
STATE_WORDS(classesBinding, ClassBlock, classes)

void main() {
  ivec4 place = wordPlace(ivec2(gl_GlobalInvocationID.xy));
  if (place.w < 0) return;
  ivec3 cell = place.xyz - ringWidth();
  bool row = cell.y >= 0 && cell.z >= 0 && cell.y < volume.y && cell.z < volume.z;
  uint bits = 0u;
  // Four cells are loaded together; rows begin at whole elements.
  int first = row ? cellWord(ivec3(place.x, cell.yz), valueLayout) >> 2 : 0;
  int begin = ringWidth() == 0 ? 0 : -1;
  for (int j = begin; j < 8; ++j) {
    int x = place.x + 4 * j;  // Column in the field
    if (!row || x < 0 || x >= volume.x) continue;
    uvec4 four = texelFetch(valueWords, first + j);
    uint inside = 0u;
    inside |= numberOf(four.x) >= level ? 1u : 0u;
    inside |= numberOf(four.y) >= level && x + 1 < volume.x ? 2u : 0u;
    inside |= numberOf(four.z) >= level && x + 2 < volume.x ? 4u : 0u;
    inside |= numberOf(four.w) >= level && x + 3 < volume.x ? 8u : 0u;
    int shift = 4 * j + ringWidth();
    bits |= shift >= 0 ? inside << uint(shift) : inside >> uint(-shift);
  }
  STORE_WORDS(classes, place.w, uvec4(bits, 0u, 0u, 0u));
}
