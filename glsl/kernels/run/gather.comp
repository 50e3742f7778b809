// Up to four numbers of each element of a user's buffer, as what draws them reads them.
#include "common/memory.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer WordsBlock { uint words[]; };
STATE_ARRAY(1, DrawnBlock, drawn)
uniform int count;     // elements
uniform int start;     // word of the first one
uniform int stride;    // words from one to the next
uniform ivec4 places;  // words of the numbers in an element; -1: `fill` in its place
uniform vec4 fill;
uniform int number;    // type of the numbers: 0 float, 1 int, 2 uint
uniform int alive;     // word that is above 0 in elements that are drawn; -1: all are
uniform int aliveNumber;

float numberAt(int word, int type) {
  uint bits = words[word];
  return type == 0 ? uintBitsToFloat(bits) : type == 1 ? float(int(bits)) : float(bits);
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int element = start + i * stride;
  vec4 result = fill;
  for (int c = 0; c < 4; ++c)
    if (places[c] >= 0) result[c] = numberAt(element + places[c], number);
  if (alive >= 0 && !(numberAt(element + alive, aliveNumber) > 0.0)) result.w = -1.0;
  STORE_STATE(drawn, i, result);
}
